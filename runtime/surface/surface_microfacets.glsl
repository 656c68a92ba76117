// Microfacet reflection, coats and fuzz: lobes, and polynomials that approximate their integrals.
// tests/fits/principled.c prints the polynomials; test_principled.c and test_principled_lobes.c
// compare them with the integrals.
#if defined(SURFACE_HAS_coat) && !defined(SURFACE_MISSING_coat)
#define LIT_COAT
#if defined(SURFACE_HAS_coatNormal) && !defined(SURFACE_MISSING_coatNormal)
#define LIT_COAT_NORMAL
#endif
#endif
#if defined(SURFACE_HAS_fuzz) && !defined(SURFACE_MISSING_fuzz)
#define LIT_FUZZ
#endif
#if defined(SURFACE_HAS_transmission) && !defined(SURFACE_MISSING_transmission)
#define LIT_CLEAR
#endif
#if defined(SURFACE_HAS_film) && !defined(SURFACE_MISSING_film)
#define LIT_FILM
#endif
#ifdef LIT_FILM
#define TONE vec3 // type of a share of light per component
#else
#define TONE float
#endif
#if defined(SURFACE_HAS_diffuseTransparency) && !defined(SURFACE_MISSING_diffuseTransparency)
#define LIT_BEHIND
#endif
#if defined(SURFACE_HAS_diffuseRoughness) && !defined(SURFACE_MISSING_diffuseRoughness)
#define LIT_GRAIN
#endif
#if defined(LIT_COAT) || defined(LIT_FUZZ)
#define LIT_LAYERS
#endif

// Coefficients of a polynomial of degree 5, from the constant on.
struct Row {
    vec4 low;
    vec2 high;
};

float rowAt(Row a, float x)
{
    return a.low.x + x * (a.low.y + x * (a.low.z + x * (a.low.w + x * (a.high.x + x * a.high.y))));
}

// Part of GGX's albedos that depends on the roughness only: polynomials in a function of the angle,
// evaluated by albedo().
struct Roughness {
    float alpha, rough;
    Row loss, grazing;
};

Row lossOf(float alpha)
{
    vec4 p = vec4(1.0, alpha, alpha * alpha, alpha * alpha * alpha);
    vec2 q = p.zw * p.z; // powers alpha^4 and alpha^5
    return Row(vec4(dot(p, vec4(0.00541417324, -0.0802598988, 0.331120234, -0.549823251)) +
        dot(q, vec2(0.412405132, -0.114975581)),
                    dot(p, vec4(0.0490225499, 2.36567246, -6.3156039, 14.0076693)) +
                        dot(q, vec2(-11.1162599, 3.0406926)),
                    dot(p, vec4(1.03763889, -19.3840807, 76.0973214, -142.107111)) +
                        dot(q, vec2(108.540868, -29.8151354)),
                    dot(p, vec4(-1.21144156, 50.948669, -236.742035, 456.215017)) +
                        dot(q, vec2(-360.753228, 102.821782))),
               vec2(dot(p, vec4(-1.10015173, -50.1714478, 280.583884, -571.944723)) +
                   dot(q, vec2(470.757091, -139.104376)),
                    dot(p, vec4(1.2209995, 16.2630829, -112.33339, 244.772749)) +
                        dot(q, vec2(-210.325806, 64.3963559))));
}

Row grazingOf(float rough)
{
    vec4 p = vec4(1.0, rough, rough * rough, rough * rough * rough);
    vec2 q = p.zw * p.z;
    return Row(vec4(dot(p, vec4(1.00224032, -0.0662290637, -7.94384868, 12.296826)) +
        dot(q, vec2(87.1399725, -147.642713)),
                    dot(p, vec4(-0.0744141474, 6.807808, 34.2218858, -329.730659)) +
                        dot(q, vec2(139.481849, 483.915005)),
                    dot(p, vec4(-0.927768838, -46.9780731, 164.191096, 708.135015)) +
                        dot(q, vec2(-1141.46066, -473.420831)),
                    dot(p, vec4(1.54931621, 98.8533863, -718.783035, 65.237189)) +
                        dot(q, vec2(1357.76862, 115.638134))),
               vec2(dot(p, vec4(-4.1182924, -73.4273809, 847.482319, -1057.4753)) +
                   dot(q, vec2(-194.466002, -46.7178094)),
                    dot(p, vec4(2.82127544, 11.1127891, -302.8796, 575.312636)) +
                        dot(q, vec2(-229.887532, 63.4033289))));
}

Roughness roughnessOf(float rough)
{
    return Roughness(rough * rough, rough, lossOf(rough * rough), grazingOf(rough));
}

// Albedos of the lobe with a Fresnel term of 1: x is 1 - E, the multiple-scattering loss; y is the
// part of E weighted by Schlick's (1 - cosine)^5. Fitted to integrals of the lobe: within 0.0055
// and 0.0035 for all roughnesses and angles (tests/renderer/light/test_principled.c).
vec2 albedo(float cosine, Roughness g)
{
    float loss = clamp(rowAt(g.loss, cosine * (1.0 + g.alpha) / (cosine + g.alpha)), 0.0, 1.0);
    float q = clamp(rowAt(g.grazing, sqrt(cosine + 0.5 * g.alpha)), 0.0, 1.0);
    return vec2(loss, (1.0 - loss) * q * q * q * q * q);
}

// Returns the directional albedo of the dielectric, with multiple scattering.
TONE reflectedOf(vec2 albedo, float reflectance, TONE again)
{
    return mix(albedo.y, 1.0 - albedo.x, reflectance) + albedo.x * again;
}

#ifdef LIT_GRAIN
// Rough diffuse base: Fujii's form of the Oren-Nayar lobe (2012), once (1 + rough s / t), s = l.v -
// n.l n.v, t the greater of n.l and n.v if s is above 0, else 1. The energy missing relative to a
// Lambertian base is added uniformly, in the color of light scattered within, as in OpenPBR 1.1
// (Portsmouth, Kutz and Hill 2025). Here both are below the microfacets and layers: light enters
// and leaves with high - tilt x - low x^5 of the mean transmittance, x = 1 - cosine, like Schlick's
// formula, and nearly like fuzz.
//   Worked example, nothing above it and rough 1: high is 1, the others 0; along the normal it
//   scatters 0.78 of all once, and 0.22 are uniform.
struct Grain {
    float rough, once;
    // `all` is the single-scattering albedo for light from all directions
    TONE high, tilt, low, all;
};

// Makes a Grain from the transmittance along the normal, at cosine 1/4, and in the mean: the means
// of x and x^5 are 1/3 and 1/21.
Grain grainOf(float rough, TONE along, TONE aside, TONE mean)
{
    Grain g;
    g.rough = rough;
    g.once = 1.0 / (1.0 + 0.287793409 * rough); // 0.287793409 = 1/2 - 2 / (3 pi)
    g.high = along / mean;
    g.low = (2.25 - 1.25 * g.high - aside / mean) / 0.130162;
    g.tilt = 3.0 * (g.high - 1.0) - g.low / 7.0;
    TONE twice = g.high * (0.0724882 * g.high - 0.079926 * g.tilt - 0.0192424 * g.low);
    twice += g.tilt * (0.0230228 * g.tilt + 0.0120406 * g.low) + 0.00189903 * g.low * g.low;
    g.all = min(g.once * (1.0 + rough * twice), TONE(0.99999));
    return g;
}

// Returns the share of a direction's light that single scattering loses: 1 - the integral, within
// 0.001 (tests/fits/diffuse.c prints the polynomials).
TONE grainLost(Grain g, float cosine)
{
    float x = 1.0 - cosine, even =
        x * (0.0513992761 + x * (0.522664541 + x * (-0.380763677 + x * 0.0949094912)));
    float tilted = x * (0.0213192591 + x * (0.212938029 + x * (-0.0119260548 - x * 0.0215686333)));
    float grazing = x * (0.000861711141 +
        x * (0.0627187395 + x * (-0.0857491434 + x * 0.11174924)));
    return max(1.0 - g.once * (1.0 + g.rough * (g.high * even - g.tilt * tilted - g.low * grazing)),
        TONE(0.0));
}

// Returns the color of the light scattered repeatedly within, over the mean single-scattering loss.
vec3 grainAgain(Grain g, vec3 color)
{
    return color * color * g.all / ((1.0 - color * (1.0 - g.all)) * (1.0 - g.all));
}

// Returns the reflection from l toward v, relative to that of a Lambertian base of color 1.
vec3 grained(Grain g, vec3 color, vec3 again, float between, vec2 cosines, TONE lost)
{
    float s = between - cosines.x * cosines.y, t = s > 0.0 ? max(cosines.x, cosines.y) : 1.0;
    return color * g.once * (1.0 + g.rough * s / t) + again * lost;
}
#endif

#ifdef LIT_FILM
struct Film {
    float weight, path, ior;
};

// Returns the response of linear sRGB to light whose intensity varies as cos(2 pi path /
// wavelength), with the path in micrometers: the color matching functions as sums of Gaussians of
// the wave number, whose Fourier transforms are Gaussians of the path (the idea of Belcour and
// Barla 2017). Within 0.06 of sums over wavelengths, 0.02 in root mean square; tests/fits/film.c
// prints the numbers.
vec3 filmResponse(float path)
{
    vec4 bells = exp(-path * path * vec4(0.273996, 0.440534, 0.0788179, 0.247647)) *
        cos(path * vec4(10.4149, 11.0117, 9.48353, 13.9191));
    return vec3(dot(bells, vec4(3.38975, -2.03478, -0.416253, 0.0612871)),
        dot(bells, vec4(-1.63704, 2.69789, 0.0687109, -0.129548)),
                dot(bells, vec4(0.0874771, -0.257019, 0.00607568, 1.16348)));
}

// Returns the reflectance of one polarization, from the reflection amplitudes a and b of both sides
// of the film: 1 - (1 - a^2) (1 - b^2) / (1 + q^2 + 2 q cos(phase)), q = a b, as a series over the
// number of internal reflections, up to three.
vec3 filmSum(float a, vec3 b, vec3 once, vec3 twice, vec3 thrice)
{
    vec3 q = a * b;
    return 1.0 - (1.0 - a * a) * (1.0 - b * b) / max(1.0 - q * q, 1e-6) *
        (1.0 + 2.0 * q * (q * (twice - q * thrice) - once));
}

// Returns the reflectance of a film on a base at an angle. The base is given by its reflectance at
// normal incidence without a film, and treated as a dielectric with that reflectance; the phase
// shift of metals is left out. Worked example, path 0 and index 1: there is no film, and the base
// follows Fresnel's formulas.
vec3 filmReflected(Film film, float cosine, vec3 base)
{
    float sine2 = 1.0 - cosine * cosine, inner2 = 1.0 - sine2 / (film.ior * film.ior), n = film.ior;
    if (inner2 <= 0.0) return vec3(1.0);
    float inner = sqrt(inner2), path = film.path * inner;
    vec3 root = sqrt(clamp(base, 0.0, 0.9998)), index = (1.0 + root) / (1.0 - root),
        deep = sqrt(1.0 - sine2 / (index * index));
    vec3 once = filmResponse(path), twice = filmResponse(2.0 * path),
        thrice = filmResponse(3.0 * path);
    vec3 across = filmSum((cosine - n * inner) / (cosine + n * inner),
        (n * inner - index * deep) / (n * inner + index * deep), once, twice, thrice);
    vec3 along = filmSum((n * cosine - inner) / (n * cosine + inner),
        (index * inner - n * deep) / (index * inner + n * deep), once, twice, thrice);
    return clamp(0.5 * (across + along), 0.0, 1.0);
}

// Angles of incidence on microfacets of a width that mirror light of a direction, by its cosine:
// two angles with the mean and spread of all, within 0.04 of sums over visible normals (Heitz
// 2018), the flatter one shifted to keep a white surface white. Smooth ones: the direction's own
// angle.
vec2 filmAngles(float cosine, float alpha)
{
    float alpha2 = alpha * alpha, along = cosine * (1.0 - alpha * (0.19 - 0.09 * alpha)),
        spread = alpha / (alpha + 0.15) * (0.33 - 0.25 * cosine);
    float mean = sqrt(along * along + (1.0 - cosine * cosine) * 0.548 * alpha2 / (alpha2 + 0.146));
    return clamp(mean + spread * vec2(-1.0, 1.15), 0.0, 1.0);
}

// Returns the mean reflectance of a film over the microfacets that mirror the light.
vec3 filmAround(Film film, float cosine, float alpha, vec3 base)
{
    vec2 angles = filmAngles(cosine, alpha);
    return 0.5 * (filmReflected(film, angles.x, base) + filmReflected(film, angles.y, base));
}

Film filmOf(Surface s)
{
    Film film = Film(clamp(s.film, 0.0, 1.0), 0.0, 1.0);
#ifdef SURFACE_HAS_filmPath
    film.path = clamp(s.filmPath, 0.0, 5.0);
#endif
#ifdef SURFACE_HAS_filmIor
    film.ior = clamp(s.filmIor, 0.5, 3.0);
#endif
    return film;
}

// Returns the directional albedo like reflectedOf(), with a film; `at` is the cosine and the width.
vec3 filmedOf(Film film, vec2 albedo, vec2 at, float reflectance, vec3 again)
{
    vec3 plain = reflectedOf(albedo, reflectance, again);
    if (film.weight <= 0.0) return plain;
    return mix(plain, (1.0 - albedo.x) * filmAround(film, at.x, at.y, vec3(reflectance)) +
        albedo.x * again, film.weight);
}
#endif

// Returns the share of the surface that is cut out. Transmission by the dielectric does not count.
float holesOf(Surface s)
{
    float holes = 0.0;
#ifdef SURFACE_HAS_transparency
    holes = max(s.transparency.x, max(s.transparency.y, s.transparency.z));
#ifdef LIT_CLEAR
    holes -= s.transmission;
#endif
#endif
    return clamp(holes, 0.0, 1.0);
}

// Returns cosine (1 + 2 Lambda) of Smith's masking, by the direction's cosine.
float maskedOf(float alpha, float cosine)
{
    return sqrt(alpha * alpha + (1.0 - alpha * alpha) * cosine * cosine);
}

// Returns GGX's lobe with Smith's height-correlated masking and a Fresnel term of 1, divided by 4
// times the eye's cosine; h is the half vector, and `eye` the eye's cosine and its maskedOf().
float microfacets(float alpha, vec3 normal, vec3 h, float cosine, vec2 eye)
{
    float alpha2 = alpha * alpha, high = dot(normal, h);
    vec3 across = cross(normal, h);
    // the form is accurate for small angles, too
    float width = alpha2 * high * high + dot(across, across);
    float masked = cosine * eye.y + eye.x * maskedOf(alpha, cosine);
    return 0.5 * cosine * alpha2 / (width * width * masked);
}

#ifdef LIT_LAYERS
// Returns the transmittance of a layer for light reflected below it, from its transmittance for
// each direction and its mean: reciprocal in light and eye. For a mirror both directions have the
// same transmittance, which counts once; for diffuse reflection it is the product of both over the
// mean. A rough mirror is in between, by evenOf(); its missing energy is spread, see below(). For
// the eye, x is its transmittance, and y veiled() of it.
float veil(float through, vec2 eye, float mean, float even)
{
    return through * eye.x * inversesqrt(max(mix(through, mean, even) * eye.y, 1e-8));
}

// Returns the share of diffuse behavior, by roughness and angle: grazing light is spread most.
float evenOf(float rough, float cosine)
{
    return 0.86 * smoothstep(0.05, 0.35 + 0.9 * sqrt(cosine), rough);
}

vec2 veiled(float through, float mean, float rough, float cosine)
{
    return vec2(through, mix(through, mean, evenOf(rough, cosine)));
}
#endif

#ifdef LIT_COAT
// The coat's slots except its weight.
struct Coat {
    vec3 tint;
    float rough, reflectance;
};

Coat coatOf(Surface s)
{
    Coat coat = Coat(vec3(1.0), 0.0, 0.0);
#ifdef SURFACE_HAS_coatTint
    coat.tint = clamp(s.coatTint, 0.0, 1.0);
#endif
#ifdef SURFACE_HAS_coatRoughness
    coat.rough = s.coatRoughness;
#endif
#ifdef SURFACE_HAS_coatReflectance
    coat.reflectance = clamp(s.coatReflectance, 0.0, 1.0);
#endif
    coat.rough = clamp(coat.rough, 0.0316227766, 1.0);
    return coat;
}

// Returns the coat's normal; the surface's if the coat has none of its own.
vec3 coatNormalOf(Surface s, vec3 normal)
{
#ifdef LIT_COAT_NORMAL
    return dot(s.coatNormal, s.coatNormal) > 0.25 ? s.coatNormal : normal;
#else
    return normal;
#endif
}

// Returns the share of light that a white rough mirror loses below a coat: `share` is that coat's
// loss relative to a smooth one's.
Row coatSpread(float rough, float share)
{
    vec4 p = share * vec4(1.0, rough, rough * rough, rough * rough * rough);
    vec2 q = p.zw * rough * rough;
    return Row(vec4(dot(p, vec4(-0.00131019374, -0.417850086, 4.05985137, -11.3097669)) +
        dot(q, vec2(12.3165997, -4.62772364)),
                    dot(p, vec4(0.0231361444, 2.69628641, -39.5246106, 130.809179)) +
                        dot(q, vec2(-157.970545, 63.9086731)),
                    dot(p, vec4(-0.454077749, 9.82565964, 32.1286548, -272.806508)) +
                        dot(q, vec2(431.530642, -200.272582)),
                    dot(p, vec4(0.982518578, -45.3147833, 165.039668, -29.7389878)) +
                        dot(q, vec2(-294.584078, 204.266698))),
               vec2(dot(p, vec4(-0.42677792, 48.1933106, -273.419571, 389.066021)) +
                   dot(q, vec2(-120.234328, -44.1919578)),
                    dot(p, vec4(-0.136481722, -14.6603853, 109.882595, -201.799877)) +
                        dot(q, vec2(124.772386, -17.5993762))));
}
#endif

#ifdef LIT_FUZZ
// Returns fuzz's roughness, bounded from below, since narrower fibers of the lobe would reflect
// more than arrives.
float fuzzRoughOf(Surface s)
{
#ifdef SURFACE_HAS_fuzzRoughness
    return clamp(s.fuzzRoughness, 0.2, 1.0);
#else
    return 0.2;
#endif
}

// Returns the directional albedo of fuzz of weight 1: a polynomial, fitted to integrals of its lobe
// within 0.005 for cosines from 0.04 on.
float fuzzAlbedo(float cosine, float rough)
{
    vec4 r = vec4(1.0, rough, rough * rough, rough * rough * rough);
    float x = sqrt(cosine);
    return clamp(dot(r, vec4(1.56415816, -3.06939249, 3.85871481, -1.6926477)) +
        x * (dot(r, vec4(-2.30757704, 6.7952917, -9.34145144, 4.31469007)) +
        x * (dot(r, vec4(-0.372148166, 0.129239755, 1.2437114, -0.989127772)) +
        x * dot(r, vec4(1.08179061, -3.5441627, 4.07626323, -1.60441801)))), 0.0, 1.0);
}

// Returns the lobe of upright fibers, in the sine of the half angle (Estevez and Kulla 2017), with
// the masking of Neubelt and Pettineo.
float fibres(float rough, float high, float cosine, float eye)
{
    float power = 0.5 / rough;
    return 0.5 * cosine * (1.0 + power) * pow(max(1.0 - high * high, 1e-6), power) /
        (2.0 * (cosine + eye - cosine * eye));
}

// Returns the lost share like coatSpread(), below fuzz.
Row fuzzSpread(float rough, float share)
{
    vec4 p = share * vec4(1.0, rough, rough * rough, rough * rough * rough);
    vec2 q = p.zw * rough * rough;
    return Row(vec4(dot(p, vec4(-0.00116753484, -0.669510384, 5.6480139, -14.9195274)) +
        dot(q, vec2(15.9246078, -5.96829246)),
                    dot(p, vec4(0.12343559, 3.77617984, -43.3263677, 131.639497)) +
                        dot(q, vec2(-153.826232, 61.7059045)),
                    dot(p, vec4(-1.15076841, 8.81013093, 44.2862562, -267.583535)) +
                        dot(q, vec2(394.602461, -179.476676)),
                    dot(p, vec4(2.81994723, -49.2486912, 133.70156, -7.44530449)) +
                        dot(q, vec2(-241.921602, 163.174069))),
               vec2(dot(p, vec4(-2.46870407, 56.438446, -236.087556, 329.347657)) +
                   dot(q, vec2(-133.889061, -14.3506012)),
                    dot(p, vec4(0.666573359, -18.7508442, 93.3375412, -164.595544)) +
                        dot(q, vec2(112.207302, -22.5091751))));
}
#endif

#ifdef LIGHT_HAS_AREAS
// Returns the matrix of linearly transformed cosines (LTC; Heitz, Dupuy, Hill and Neubelt 2016): a
// matrix that maps directions l so that GGX's lobe becomes the density max(z, 0) / pi. For
// parallelograms within 0.1 of the lobe's total, 0.02 in root mean square, for roughnesses from 0.1
// and angles to 84 degrees (test_principled.c); Phong's lobe has 0.2 and 0.06. The part of the lobe
// below the horizon is lost. tests/fits/area.c prints the polynomials. X, Y and Z are orthogonal, Z
// is the lobe's mean direction, and a direction o of that density maps to X (m11 o.x + m13 o.z) + Y
// m22 o.y + Z o.z.
//   Worked example, roughness 1 along the normal: m11 = m22 = 1.1, m13 = 0: directions are spread
//   by 1.1.
mat3 areaMicrofacets(float rough, vec3 normal, vec3 eye)
{
    float cosine = clamp(dot(normal, eye), 1e-3, 1.0), alpha = rough * rough,
        x = cosine * (1.0 + alpha) / (cosine + alpha);
    vec4 p;
    p = vec4(38.927, -31.9992, 5.0907, -28.7535) +
              rough * (vec4(-172.174, 11.9175, 181.233, -127.096) +
              rough * (vec4(-49.587, 178.273, -592.802, 493.176) +
              rough * (vec4(901.969, -98.2602, 1513.31, -1173.94) +
              rough * (vec4(-1085.68, -253.537, -2055.56, 1243.96) +
              rough * (vec4(362.515, 192.772, 948.815, -450.588))))));
    p = p * x + vec4(-129.394, 100.914, -55.5658, 122.343) +
              rough * (vec4(605.089, -73.8776, -198.788, 102.21) +
              rough * (vec4(-364.863, -456.254, 262.307, -297.681) +
              rough * (vec4(-1324.06, 321.437, -923.484, 852.013) +
              rough * (vec4(1729.95, 591.901, 2236.63, -1131.55) +
              rough * (vec4(-504.511, -481.065, -1320.52, 458.248))))));
    p = p * x + vec4(160.511, -126.634, 101.68, -170.538) +
              rough * (vec4(-825.965, 180.297, -25.3049, 78.8658) +
              rough * (vec4(1213.14, 371.032, 796.199, -454.126) +
              rough * (vec4(-400.496, -522.445, -1924.85, 1044.35) +
              rough * (vec4(-74.6435, -228.874, 1012.27, -832.527) +
              rough * (vec4(-86.2431, 322.071, 38.5429, 241.05))))));
    p = p * x + vec4(-89.086, 86.4884, -66.9556, 100.548) +
              rough * (vec4(523.519, -233.211, 30.4443, -61.3089) +
              rough * (vec4(-1138.33, 84.128, -389.31, 182.597) +
              rough * (vec4(1279.59, 166.294, 1308.48, -612.156) +
              rough * (vec4(-908.002, -51.6574, -1243.55, 668.32) +
              rough * (vec4(339.506, -48.4126, 361.854, -243.779))))));
    p = p * x + vec4(20.0944, -35.0927, 29.7481, -40.1735) +
              rough * (vec4(-134.465, 156.911, -40.9809, 65.9823) +
              rough * (vec4(328.819, -301.186, 21.1095, -28.6887) +
              rough * (vec4(-402.284, 298.141, -81.5463, -9.9101) +
              rough * (vec4(269.583, -159.683, 119.349, 3.58614) +
              rough * (vec4(-83.901, 38.5643, -47.8527, 3.93457))))));
    p = p * x + vec4(0.951022, 8.32527, -13.998, 16.5782) +
              rough * (vec4(3.90407, -42.1412, 53.1832, -58.5441) +
              rough * (vec4(11.0784, 122.811, -95.7359, 103.936) +
              rough * (vec4(-53.6715, -166.806, 102.43, -98.0375) +
              rough * (vec4(63.5235, 103.261, -62.0517, 45.7668) +
              rough * (vec4(-24.1714, -23.8377, 16.1749, -8.02276))))));
    vec3 m = alpha * vec3(p.x, (cosine + alpha) * p.y, p.z); // entries m11, m22, m13 of the matrix
    float turn = alpha * p.w; // angle from the mirrored direction upwards
    vec3 flat_ = eye - dot(normal, eye) * normal;
    float sine = length(flat_);
    vec3 along = sine > 1e-4 ? flat_ / sine
        : normalize(abs(normal.z) < 0.7 ? cross(normal, vec3(0.0, 0.0, 1.0))
        : cross(normal, vec3(1.0, 0.0, 0.0)));
    float up = cosine * cos(turn) + sine * sin(turn), beside = sine * cos(turn) -
        cosine * sin(turn);
    vec3 z = up * normal - beside * along, across = up * along + beside * normal,
        y = cross(normal, along);
    return transpose(mat3((across - m.z * z) / m.x, y / m.y, z));
}
#endif
