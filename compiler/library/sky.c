/* Preetham's sky, semantics.md 4.5, and its normalization.
 *
 * The paper says only "total irradiance of sky + sun". The interpretation here: irradiance of
 * the horizontal plane, averaged over linear red, green and blue, at radiance factor 1
 * (otherwise the factor would cancel). It is the sky's radiance integrated over the upper
 * hemisphere with the cosine, plus the sun's disc of 32 arc minutes attenuated as in the paper
 * by Rayleigh scattering, aerosol, ozone and water vapor. The mixed gases absorb only above 759
 * nm, outside the spectrum used here. The tables are those of the paper's appendix; published
 * programs use the same numbers. The color matching functions are the sums of Gaussians of
 * Wyman, Sloan and Shirley (2013), a fit to CIE 1931. */
#include "compiler/library/sky.h"
#include "compiler/library/reference.h"

enum {
    ZENITH,
    A,
    B,
    C,
    D,
    E,
    SUN, /* rows of the coefficients */
    SKY_ROWS,
    SLOPES = 32,   /* steps of the integral in cos(angle to the zenith) */
    AZIMUTHS = 32, /* samples of azimuth over half the circle; the other half is symmetric */
    FIRST_NM = 380,
    LAST_NM = 750,
    STEP_NM = 10 /* samples of the sun's spectrum */
};
#define MIN_TURBIDITY       1.7
#define GREATEST_TURBIDITY  64.
#define LUMINOUS_EFFICACY   683.002
#define MATERIAL_IRRADIANCE 10.
#define MIN_SLOPE           .001
#define MIN_Y               .001
#define DEGREE              (M_PI / 180)
#define SUN_RADIUS          (16. / 60 * DEGREE)

/* A quantity sampled at wavelengths (nm), linear between samples, 0 outside. */
typedef struct {
    int count;
    const double (*points)[2];
} Curve;
#define CURVE(points) ((Curve){(int)(sizeof(points) / sizeof *(points)), points})

/* The sun's radiance above the atmosphere, W/(cm2 um sr), starting at FIRST_NM. */
static const double solar[] = {
    165.5, 162.3, 211.2, 258.8, 258.2, 242.3, 267.6, 296.6, 305.4, 300.6, 306.6, 288.3, 287.1,
    278.2, 271.0, 272.3, 263.6, 255.0, 250.6, 253.1, 253.5, 251.3, 246.3, 241.7, 236.8, 232.1,
    228.2, 223.4, 219.7, 215.3, 211.0, 207.3, 202.4, 198.7, 194.3, 190.7, 186.3, 182.6,
};
#define SOLAR_UNIT 100. /* factor that converts the table's radiance to W/(m2 nm sr) */
/* Table of the absorption coefficient of ozone in 1/cm. */
static const double ozone[][2] = {
    {355, 0},    {445, .003}, {450, .003}, {455, .004}, {460, .006}, {465, .008}, {470, .009},
    {475, .012}, {480, .014}, {485, .017}, {490, .021}, {495, .025}, {500, .03},  {505, .035},
    {510, .04},  {515, .045}, {520, .048}, {525, .057}, {530, .063}, {535, .07},  {540, .075},
    {545, .08},  {550, .085}, {555, .095}, {560, .103}, {565, .11},  {570, .12},  {575, .122},
    {580, .12},  {585, .118}, {590, .115}, {595, .12},  {600, .125}, {605, .13},  {610, .12},
    {620, .105}, {630, .09},  {640, .079}, {650, .067}, {660, .057}, {670, .048}, {680, .036},
    {690, .028}, {700, .023}, {710, .018}, {720, .014}, {730, .011}, {740, .01},  {750, .009},
};
/* Absorption coefficient of water vapor, 1/cm. The band of the mixed gases, 759 to 771 nm, is
 * outside the spectrum above. */
static const double water[][2] = {
    {689, 0}, {690, .016}, {700, .024}, {710, .0125},
    {720, 1}, {730, .87},  {740, .061}, {750, .001},
};

static double curve_at(Curve curve, double nm)
{
    for (int i = 1; i < curve.count; i++) {
        const double *low = curve.points[i - 1], *high = curve.points[i];
        if (nm >= low[0] && nm <= high[0])
            return low[1] + (high[1] - low[1]) * (nm - low[0]) / (high[0] - low[0]);
    }
    return 0;
}

/* Returns a Gaussian with different widths below and above its peak. */
static double lobe(double nm, double peak, double below, double above)
{
    double t = (nm - peak) / (nm < peak ? below : above);
    return exp(-t * t / 2);
}

static void color_matching(double nm, double xyz[3])
{
    xyz[0] = 1.056 * lobe(nm, 599.8, 37.9, 31) + .362 * lobe(nm, 442, 16, 26.7) -
             .065 * lobe(nm, 501.1, 20.4, 26.2);
    xyz[1] = .821 * lobe(nm, 568.8, 46.9, 40.5) + .286 * lobe(nm, 530.9, 16.3, 31.1);
    xyz[2] = 1.217 * lobe(nm, 437, 11.8, 36) + .681 * lobe(nm, 459, 26, 13.8);
}

/* Converts to linear sRGB; a color outside the gamut is moved toward white until no component is
 * below 0. */
static void rgb_of_xyz(const double xyz[3], double rgb[3])
{
    static const double matrix[3][3] = {{3.2404542, -1.5371385, -.4985314},
                                        {-.9692660, 1.8760108, .0415560},
                                        {.0556434, -.2040259, 1.0572252}};
    for (int i = 0; i < 3; i++)
        rgb[i] = matrix[i][0] * xyz[0] + matrix[i][1] * xyz[1] + matrix[i][2] * xyz[2];
    double least = fmin(fmin(fmin(rgb[0], rgb[1]), rgb[2]), 0);
    for (int i = 0; i < 3; i++)
        rgb[i] -= least;
}

static double mean(const double rgb[3]) { return (rgb[0] + rgb[1] + rgb[2]) / 3; }

/* Returns the transmittance of sunlight through air of relative optical mass m. */
static double transmittance(double nm, double m, double turbidity)
{
    const double ozone_depth = .35, water_depth = 2; /* thickness in cm */
    double um = nm / 1000, steam = curve_at(CURVE(water), nm) * water_depth * m;
    double depth = m * .008735 * pow(um, -4.08)                        /* Rayleigh scattering */
                   + m * (.04608 * turbidity - .04586) * pow(um, -1.3) /* aerosol extinction */
                   + m * curve_at(CURVE(ozone), nm) * ozone_depth +
                   .2385 * steam / pow(1 + 20.07 * steam, .45);
    return exp(-depth);
}

/* Irradiance of a plane that faces the sun's disc; 0 after sunset. */
static void sun_irradiance(double slope, double turbidity, double rgb[3])
{
    rgb[0] = rgb[1] = rgb[2] = 0;
    if (slope <= 0)
        return;
    double angle = acos(fmin(slope, 1)),
           m = 1 / (slope + .15 * pow(93.885 - angle / DEGREE, -1.253));
    double xyz[3] = {0};
    for (int nm = FIRST_NM, i = 0; nm <= LAST_NM; nm += STEP_NM, i++) {
        double matching[3], radiance = solar[i] * SOLAR_UNIT * transmittance(nm, m, turbidity);
        color_matching(nm, matching);
        for (int component = 0; component < 3; component++)
            xyz[component] += radiance * matching[component] * STEP_NM;
    }
    rgb_of_xyz(xyz, rgb);
    for (int component = 0; component < 3; component++)
        rgb[component] *= 2 * M_PI * (1 - cos(SUN_RADIUS));
}

/* Perez' function of one component, given the cosine of the zenith angle and the angle to the
 * sun. */
static double perez(double rows[SKY_ROWS][3], int component, double slope, double angle)
{
    double cosine = cos(angle);
    return (1 + rows[A][component] * exp(rows[B][component] / slope)) *
           (1 + rows[C][component] * exp(rows[D][component] * angle) +
            rows[E][component] * cosine * cosine);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Normalizes a vector of any length; (0, 0, 1) for zero. */
static void unit(const double v[3], double result[3])
{
    double greatest = fmax(fmax(fabs(v[0]), fabs(v[1])), fabs(v[2]));
    bool directed = greatest >= 1e-37;
    for (int i = 0; i < 3; i++)
        result[i] = directed ? v[i] / greatest : i == 2;
    double length = sqrt(dot(result, result));
    for (int i = 0; i < 3; i++)
        result[i] /= length;
}

static double angle_between(const double a[3], const double b[3])
{
    const double cross[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                             a[0] * b[1] - a[1] * b[0]};
    return atan2(sqrt(dot(cross, cross)), dot(a, b));
}

static void radiance(double rows[SKY_ROWS][3], const double direction[3], double rgb[3])
{
    double view[3], sky[3];
    rgb[0] = rgb[1] = rgb[2] = 0;
    unit(direction, view);
    if (view[2] < 0)
        return;
    view[2] = fmax(view[2], MIN_SLOPE);
    unit(view, view);
    double angle = angle_between(view, rows[SUN]);
    for (int component = 0; component < 3; component++)
        sky[component] = rows[ZENITH][component] * perez(rows, component, view[2], angle);
    double scale = fmax(sky[0], 0) / fmax(sky[2], MIN_Y);
    const double xyz[3] = {scale * sky[1], scale * sky[2], scale * (1 - sky[1] - sky[2])};
    rgb_of_xyz(xyz, rgb);
}

/* Returns the irradiance of the horizontal plane by the sky: midpoint rule over the half circle
 * on one side of the sun. */
static double sky_irradiance(double rows[SKY_ROWS][3])
{
    double sum = 0, start = atan2(rows[SUN][1], rows[SUN][0]);
    for (int i = 0; i < SLOPES; i++)
        for (int j = 0; j < AZIMUTHS; j++) {
            double slope = (i + .5) / SLOPES, across = sqrt(1 - slope * slope),
                   azimuth = start + M_PI * (j + .5) / AZIMUTHS;
            const double view[3] = {across * cos(azimuth), across * sin(azimuth), slope};
            double rgb[3];
            radiance(rows, view, rgb);
            sum += mean(rgb) * slope;
        }
    return sum * 2 * M_PI / (SLOPES * AZIMUTHS);
}

/* Luminance (kcd/m2) and chromaticity of the zenith, for a sun at zenith angle s. */
static void zenith(double turbidity, double s, double result[3])
{
    double t = turbidity, chi = (4. / 9 - t / 120) * (M_PI - 2 * s);
    result[0] = fmax((4.0453 * t - 4.9710) * tan(chi) - .2155 * t + 2.4192, 0);
    result[1] = t * t * (((.00165 * s - .00374) * s + .00208) * s) +
                t * (((-.02902 * s + .06377) * s - .03202) * s + .00394) +
                ((.11693 * s - .21196) * s + .06052) * s + .25885;
    result[2] = t * t * (((.00275 * s - .00610) * s + .00316) * s) +
                t * (((-.04212 * s + .08970) * s - .04153) * s + .00515) +
                ((.15346 * s - .26756) * s + .06669) * s + .26688;
}

/* Computes the rows of sky_coefficients without the scale. */
static void make_rows(const double sun[3], double t, double out[SKY_ROWS][3])
{
    /* [row][component]: slope by turbidity, value at turbidity 0 */
    static const double linear[E - A + 1][3][2] = {
        {{.17872, -1.46303}, {-.01925, -.25922}, {-.01669, -.26078}},
        {{-.35540, .42749}, {-.06651, .00081}, {-.09495, .00921}},
        {{-.02266, 5.32505}, {-.00041, .21247}, {-.00792, .21023}},
        {{.12064, -2.57705}, {-.06409, -.89887}, {-.04405, -1.65369}},
        {{-.06696, .37027}, {-.00325, .04517}, {-.01092, .05291}},
    };
    unit(sun, out[SUN]);
    double angle = acos(clamp(out[SUN][2], -1, 1));
    for (int row = A; row <= E; row++)
        for (int component = 0; component < 3; component++)
            out[row][component] = linear[row - A][component][0] * t + linear[row - A][component][1];
    zenith(t, angle, out[ZENITH]);
    out[ZENITH][0] *= 1000 / LUMINOUS_EFFICACY;
    for (int component = 0; component < 3; component++)
        out[ZENITH][component] /= perez(out, component, 1, angle);
}

/* Scale of sky and sun that gives the horizontal plane MATERIAL_IRRADIANCE. */
static double scale_of(double rows[SKY_ROWS][3], const double sun_rgb[3])
{
    const double total = sky_irradiance(rows) + mean(sun_rgb) * fmax(rows[SUN][2], 0);
    return total > 0 ? MATERIAL_IRRADIANCE / total : 0;
}

void sky_coefficients(const double sun[3], double turbidity, double radiance_factor,
                      double out[7][3])
{
    const double t = clamp(turbidity, MIN_TURBIDITY, GREATEST_TURBIDITY);
    double sun_rgb[3];
    make_rows(sun, t, out);
    sun_irradiance(out[SUN][2], t, sun_rgb);
    out[ZENITH][0] *= radiance_factor * scale_of(out, sun_rgb);
}

void sky_sun(const double sun[3], double turbidity, double radiance_factor, double irradiance[3])
{
    const double t = clamp(turbidity, MIN_TURBIDITY, GREATEST_TURBIDITY);
    double rows[SKY_ROWS][3];
    make_rows(sun, t, rows);
    sun_irradiance(rows[SUN][2], t, irradiance);
    const double scale = radiance_factor * scale_of(rows, irradiance);
    for (int component = 0; component < 3; component++)
        irradiance[component] *= scale;
}

REFERENCE(skyRadiance)
{
    double rows[SKY_ROWS][3];
    (void)context;
    /* The function's arguments have the sun first, the rows have it last. */
    for (int component = 0; component < 3; component++) {
        rows[SUN][component] = args[3 + component];
        for (int row = ZENITH; row <= E; row++)
            rows[row][component] = args[6 + 3 * row + component];
    }
    radiance(rows, args, result);
}
