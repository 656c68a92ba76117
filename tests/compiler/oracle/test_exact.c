/* The oracle's functions against arithmetic of 200 bits: waves, exponents, rotations, the sky;
 * the formulas are written from semantics.md alone. */
/* ctest: quick alone */
#include "tests/exact.h"
#include <stdio.h>

static R id(R v) { return v; }
static R times_pi(R v) { return times(pi(), v); }
static R times_e(R v) { return times(power_e(num(1)), v); }
static R times_phi(R v) { return times(over(plus(num(1), root(num(5))), num(2)), v); }
static R round_up(R v) { return minus(whole(minus(v))); }
static R square(R v) { return times(v, v); }
static R sine_of_turns(R v) { return sine(times(times(num(2), pi()), v)); }
static R ramp(R v) { return less(times(num(2), part(v)), num(1)); }
static R cubic(R v)
{
    R t = part(v);
    return less(times(times(t, t), less(num(6), times(num(4), t))), num(1));
}
static R triangle(R v)
{
    R t = times(num(4), part(v));
    return below(t, num(1)) ? t : below(t, num(3)) ? less(num(2), t) : less(t, num(4));
}
static R scallop(R v) { return less(times(num(2), size(sine(times(pi(), v)))), num(1)); }

typedef struct {
    const char *name;
    R (*exact)(R v);
    double low, high; /* of the arguments; the wave takes others there */
} WaveCase;
static const WaveCase waves[] = {
    {"Id", id, -1e5, 1e5},
    {"Abs", size, -1e5, 1e5},
    {"Acos", arc_cosine, -1, 1},
    {"Asin", arc_sine, -1, 1},
    {"Atan", arc_tangent, -1e5, 1e5},
    {"Ceil", round_up, -1e5, 1e5},
    {"Floor", whole, -1e5, 1e5},
    {"Cos", cosine, -1e5, 1e5},
    {"Cosh", hyper_cosine, -88, 88},
    {"E", times_e, -1e5, 1e5},
    {"Exp", power_e, -1e5, 88},
    {"Expm1", power_e_less_1, -1e5, 88},
    {"Exp2", power_2, -1e5, 127},
    {"Log", natural_log, WAVE_LEAST, 1e5},
    {"Log10", decimal_log, WAVE_LEAST, 1e5},
    {"Phi", times_phi, -1e5, 1e5},
    {"Pi", times_pi, -1e5, 1e5},
    {"Sin", sine, -1e5, 1e5},
    {"Sinh", hyper_sine, -88, 88},
    {"Sqr", square, -1e5, 1e5},
    {"Sqrt", root, 0, 1e5},
    {"Tan", tangent, -1e5, 1e5},
    {"Tanh", hyper_tangent, -1e5, 1e5},
    {"Sin01", sine_of_turns, -1e5, 1e5},
    {"Ramp", ramp, -1e5, 1e5},
    {"Cubic", cubic, -1e5, 1e5},
    {"Triangle", triangle, -1e5, 1e5},
    {"Scallop", scallop, -1e5, 1e5},
};
enum { WAVES = sizeof waves / sizeof *waves };

/* Spread evenly, and some where functions change their course. */
static double argument(int i)
{
    static const double special[] = {0,     -0.,   1,        -1,     0.5,  -0.5,     0.25, -0.25,
                                     0.75,  1e-8,  -1e-8,    1e-300, 1e-4, 3.75,     -2,   88.5,
                                     -88.5, 127.5, 0.999999, 5e4,    -1e5, 12345.678};
    enum { SPECIALS = sizeof special / sizeof *special };
    return i < SPECIALS ? special[i] : 40 * fraction(i * 0.6180339887498949) - 20;
}

static void waves_are_exact(void **state)
{
    (void)state;
    assert_int_equal(WAVES, WAVE_COUNT);
    for (int w = 0; w < WAVES; w++) {
        Read read;
        char text[160];
        snprintf(text, sizeof text, "material: Phong\nemissive: { map: Gradient, waveForm: %s }\n",
                 waves[w].name);
        read_open(&read, text, REFERENCE_LATTICE);
        for (int i = 0; i < 400; i++) {
            Surface surface;
            SlotValues values;
            double x = argument(i), taken = clamp(x, waves[w].low, waves[w].high);
            oracle_surface_default(&surface);
            oracle_surface_set(&surface, "x", x);
            read_values(&read, &surface, &values);
            R want = waves[w].exact(num(taken));
            /* near a pole a double's own rounding is what errs most */
            double slope = !strcmp(waves[w].name, "Tan") ? 1 + fabs(value(want)) : 1;
            agrees(waves[w].name, values.component[SLOT_emissive][0], want, 2e-15 * slope);
            exact_forget();
        }
        read_close(&read);
    }
}

/* -2 / ln(x (2 - x)), at most 65504. */
static R exact_exponent(double x)
{
    R y = times(num(x), less(num(2), num(x)));
    if (!below(num(0), y))
        return num(0);
    if (!below(y, num(1)))
        return num(65504);
    return lesser(over(num(-2), natural_log(y)), num(65504));
}

static void exponents_are_exact(void **state)
{
    (void)state;
    Read read;
    read_open(&read, "material: Phong\nshininess: { map: Gradient }\n", REFERENCE_LATTICE);
    for (int i = 0; i < 2000; i++) {
        Surface surface;
        SlotValues values;
        double x = i < 1000 ? 2.2 * i / 999. - 0.1 : 1 - pow(10, -9. * (i - 1000) / 999);
        oracle_surface_default(&surface);
        oracle_surface_set(&surface, "x", x);
        read_values(&read, &surface, &values);
        agrees("exponent", values.component[SLOT_shininess][0], exact_exponent(x), 4e-15);
        exact_forget();
    }
    read_close(&read);
}

/* q' = T Rz Ry Rx S H q, one step after the other. */
static void turn(R *q, int axis, double angle)
{
    int i = (axis + 1) % 3, k = (axis + 2) % 3;
    R c = cosine(num(angle)), s = sine(num(angle)), a = q[i], b = q[k];
    q[i] = less(times(c, a), times(s, b));
    q[k] = plus(times(s, a), times(c, b));
}

static void rotations_are_exact(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        double m[4][3], p[3]; /* translation, rotation, scale, shear */
        char text[512];
        for (int i = 0; i < 12; i++)
            m[i / 3][i % 3] =
                floor(512 * (8 * fraction((n * 12 + i) * 0.7548776662466927) - 4)) / 512;
        for (int i = 0; i < 3; i++)
            p[i] = 10 * fraction((n * 3 + i) * 0.5698402909980532) - 5;
        snprintf(text, sizeof text,
                 "material: Phong\nemissive: { map: Gradient, direction: [1, 0.5, -2], input: { "
                 "map: XYZTransform, "
                 "transform: { translation: [%.9f, %.9f, %.9f], rotation: [%.9f, %.9f, %.9f], "
                 "scale: [%.9f, %.9f, "
                 "%.9f], shear: [%.9f, %.9f, %.9f] } } }\n",
                 m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2], m[2][0], m[2][1], m[2][2],
                 m[3][0], m[3][1], m[3][2]);
        Read read;
        Surface surface;
        SlotValues values;
        read_open(&read, text, REFERENCE_LATTICE);
        oracle_surface_default(&surface);
        for (int i = 0; i < 3; i++)
            surface.root[channel_id(GROUP_X, i)] = p[i];
        read_values(&read, &surface, &values);
        R x = num(p[0]), y = num(p[1]), z = num(p[2]);
        R q[3] = {plus(plus(x, times(num(m[3][0]), y)), times(num(m[3][1]), z)),
                  plus(y, times(num(m[3][2]), z)), z};
        for (int i = 0; i < 3; i++)
            q[i] = times(q[i], num(m[2][i]));
        for (int axis = 0; axis < 3; axis++)
            turn(q, axis, m[1][axis]);
        for (int i = 0; i < 3; i++)
            q[i] = plus(q[i], num(m[0][i]));
        R want = less(plus(q[0], times(num(0.5), q[1])), times(num(2), q[2]));
        agrees("rotation", values.component[SLOT_emissive][0], want, 2e-14);
        exact_forget();
        read_close(&read);
    }
}

/* a t + b of the table of semantics.md 4.5, rows Y, x, y. */
static const char *const perez[5][3][2] = {
    {{".17872", "-1.46303"}, {"-.01925", "-.25922"}, {"-.01669", "-.26078"}},
    {{"-.35540", ".42749"}, {"-.06651", ".00081"}, {"-.09495", ".00921"}},
    {{"-.02266", "5.32505"}, {"-.00041", ".21247"}, {"-.00792", ".21023"}},
    {{".12064", "-2.57705"}, {"-.06409", "-.89887"}, {"-.04405", "-1.65369"}},
    {{"-.06696", ".37027"}, {"-.00325", ".04517"}, {"-.01092", ".05291"}},
};
static const char *const zenith[2][3][4] = {
    {{".00165", "-.00374", ".00208", "0"},
     {"-.02902", ".06377", "-.03202", ".00394"},
     {".11693", "-.21196", ".06052", ".25885"}},
    {{".00275", "-.00610", ".00316", "0"},
     {"-.04212", ".08970", "-.04153", ".00515"},
     {".15346", "-.26756", ".06669", ".26688"}},
};

static R decimal(const char *text)
{
    R r = fresh();
    mpfr_set_str(r, text, 10, MPFR_RNDN);
    return r;
}

/* (1 + A e^(B/cos theta)) (1 + C e^(D gamma) + E cos^2 gamma) of component Y, x or y. */
static R perez_f(int component, R turbidity, R cos_theta, R gamma)
{
    R k[5], c = cosine(gamma);
    for (int i = 0; i < 5; i++)
        k[i] = plus(times(decimal(perez[i][component][0]), turbidity),
                    decimal(perez[i][component][1]));
    return times(
        plus(num(1), times(k[0], power_e(over(k[1], cos_theta)))),
        plus(plus(num(1), times(k[2], power_e(times(k[3], gamma)))), times(k[4], times(c, c))));
}

static R cubic_of(const char *const k[4], R t)
{
    R sum = decimal(k[0]);
    for (int i = 1; i < 4; i++)
        sum = plus(times(sum, t), decimal(k[i]));
    return sum;
}

/* Chromaticity x or y of the zenith; the luminance's own is left out, as it is scaled in any
 * case. */
static R zenith_of(int component, R turbidity, R sun)
{
    if (component == 0)
        return num(1);
    R sum = cubic_of(zenith[component - 1][0], sun);
    return plus(
        times(plus(times(sum, turbidity), cubic_of(zenith[component - 1][1], sun)), turbidity),
        cubic_of(zenith[component - 1][2], sun));
}

/* Linear sRGB along a direction, up to a factor that all directions share. */
static void sky_along(R turbidity, R *sun, R *view, R rgb[3])
{
    static const char *const matrix[3][3] = {{"3.2404542", "-1.5371385", "-.4985314"},
                                             {"-.9692660", "1.8760108", ".0415560"},
                                             {".0556434", "-.2040259", "1.0572252"}};
    R gamma = arc_cosine(dot3(view, sun)), sun_angle = arc_cosine(sun[2]), Yxy[3], XYZ[3],
      least = num(0);
    for (int i = 0; i < 3; i++)
        Yxy[i] = times(
            zenith_of(i, turbidity, sun_angle),
            over(perez_f(i, turbidity, view[2], gamma), perez_f(i, turbidity, num(1), sun_angle)));
    XYZ[0] = times(Yxy[0], over(Yxy[1], Yxy[2]));
    XYZ[1] = Yxy[0];
    XYZ[2] = times(Yxy[0], over(less(less(num(1), Yxy[1]), Yxy[2]), Yxy[2]));
    for (int i = 0; i < 3; i++) {
        R row[3] = {decimal(matrix[i][0]), decimal(matrix[i][1]), decimal(matrix[i][2])};
        rgb[i] = dot3(row, XYZ);
        least = lesser(least, rgb[i]);
    }
    for (int i = 0; i < 3; i++)
        rgb[i] = less(rgb[i], least);
}

static void radiance(Read *read, R *view, double rgb[3])
{
    Surface surface;
    SlotValues values;
    oracle_surface_default(&surface);
    for (int i = 0; i < 3; i++)
        surface.root[channel_id(GROUP_X, i)] = value(view[i]);
    read_values(read, &surface, &values);
    memcpy(rgb, values.component[SLOT_emissive], 3 * sizeof *rgb);
}

static void skies_are_exact(void **state)
{
    (void)state;
    const double turbidities[] = {2, 3.5, 6, 10};
    for (int n = 0; n < 12; n++) {
        char text[160];
        double t = turbidities[n % 4], height = 0.1 + 0.15 * (n / 2);
        snprintf(text, sizeof text, "material: SunSkyLight\nsun: [0.3, 1, %.9f]\nturbidity: %.9f\n",
                 height, t);
        Read read;
        read_open(&read, text, REFERENCE_LATTICE);
        R up[3] = {num(0), num(0), num(1)}, first[3], sun[3];
        double base[3];
        sun[0] = decimal("0.3"), sun[1] = num(1);
        snprintf(text, sizeof text, "%.9f", height);
        sun[2] = decimal(text);
        unit3(sun);
        sky_along(num(t), sun, up, first);
        radiance(&read, up, base);
        for (int i = 0; i < 40; i++) {
            double z = 0.02 + 0.96 * fraction(i * 0.618034), a = i * 2.4, rgb[3],
                   r = sqrt(1 - z * z);
            R view[3] = {num(r * cos(a)), num(r * sin(a)), num(z)}, want[3];
            unit3(view);
            sky_along(num(t), sun, view, want);
            radiance(&read, view, rgb);
            for (int component = 0; component < 3; component++) /* beside the zenith's green */
                agrees("sky", rgb[component] / base[1], over(want[component], first[1]), 3e-11);
        }
        exact_forget();
        read_close(&read);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(waves_are_exact),
        cmocka_unit_test(exponents_are_exact),
        cmocka_unit_test(rotations_are_exact),
        cmocka_unit_test(skies_are_exact),
    };
    return cmocka_run_group_tests(tests, NULL, exact_close);
}
