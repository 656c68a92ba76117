/* Whole materials against arithmetic of 200 bits: each a document and its formulas, written from
 * semantics.md and not from the oracle. */
/* ctest: quick alone */
#include "tests/exact.h"

/* The point that is shaded, as exact numbers. */
typedef struct {
    R u, v, p[3], n[3], du[3], dv[3], by_u[3], by_v[3]; /* the last two: how p changes by u and v */
} At;

typedef struct {
    const char *name, *document;
    Slot slot;
    void (*exact)(const At *at, R *want); /* three components, or one */
    double bound;
    int derivatives; /* of bumps: a Choice */
} Material;

static R odd(R sum) { return num(value(part(over(sum, num(2)))) > 0.25); }
static R between(R t, R low, R high, R a, R b)
{
    return over(plus(times(a, less(high, t)), times(b, less(t, low))), less(high, low));
}
static R square(R v) { return times(v, v); }
static void gray(R v, R *want) { want[0] = want[1] = want[2] = v; }

/* u' = scaleU q1 - shear scaleV q2, v' = scaleV q2, q the turned offset coordinate. */
static void checker(const At *at, R *want)
{
    R a = num(0.5), c = cosine(a), s = sine(a), x = less(at->u, num(0.25)),
      y = less(at->v, num(-0.5));
    R q1 = plus(times(c, x), times(s, y)), q2 = less(times(c, y), times(s, x));
    R v = times(num(2), q2), u = less(times(num(4), q1), times(num(0.125), v));
    bool first = value(odd(plus(whole(times(num(2), u)), whole(times(num(2), v))))) > 0.25;
    for (int i = 0; i < 3; i++)
        want[i] = num(first ? (double[]){0.25, 0.5, 1}[i] : (double[]){0.125, 0, 0.75}[i]);
}

/* sin(2 pi (3 x + 0.5 y + 0.125)) mixed from (1, 0, 0) at -1 over (0, 1, 0) at 0 to (0.5, 0.5, 1)
 * at 1. */
static void bands(const At *at, R *want)
{
    const double colour[3][3] = {{1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
    R f = plus(times(num(3), at->p[0]), times(num(0.5), at->p[1]));
    R t = sine(times(times(num(2), pi()), plus(f, num(0.125))));
    int i = value(t) >= 0;
    for (int component = 0; component < 3; component++)
        want[component] = between(t, num(i - 1), num(i), num(colour[i][component]),
                                  num(colour[i + 1][component]));
}

/* Rings: the triangle wave of 5 sqrt(x^2 + y^2) + 0.25. */
static void rings(const At *at, R *want)
{
    R r = root(plus(square(at->p[0]), square(at->p[1]))),
      t = times(num(4), part(plus(times(num(5), r), num(0.25))));
    gray(below(t, num(1)) ? t : below(t, num(3)) ? less(num(2), t) : less(t, num(4)), want);
}

/* A leopard turned about z by 0.75, then moved. */
static void leopard(const At *at, R *want)
{
    R c = cosine(num(0.75)), s = sine(num(0.75));
    R x = plus(less(times(c, at->p[0]), times(s, at->p[1])), num(1));
    R y = plus(plus(times(s, at->p[0]), times(c, at->p[1])), num(-2)), z = plus(at->p[2], num(0.5));
    gray(square(over(plus(plus(sine(x), sine(y)), sine(z)), num(3))), want);
}

/* (Tu + k n by_u) x (Tv + k n by_v) of unit length, or its opposite: to the side of n. */
static void tilt(const At *at, R k, const R by[2], R *want)
{
    R tu[3], tv[3];
    for (int i = 0; i < 3; i++) {
        tu[i] = plus(at->du[i], times(times(k, by[0]), at->n[i]));
        tv[i] = plus(at->dv[i], times(times(k, by[1]), at->n[i]));
    }
    cross3(tu, tv, want);
    unit3(want);
    const bool behind = below(dot3(want, (R *)at->n), num(0));
    for (int i = 0; i < 3; i++)
        want[i] = behind ? minus(want[i]) : want[i];
}

/* n' = (Tu + a n dh/du) x (Tv + a n dh/dv) of unit length, h = cos(2 pi 3 u) cos(2 pi 2 v), a =
 * 0.125 / |n|. */
static void waves(const At *at, R *want)
{
    R a = over(num(0.125), root(dot3((R *)at->n, (R *)at->n))), turn = times(num(2), pi());
    R wu = times(turn, num(3)), wv = times(turn, num(2)), U = times(wu, at->u),
      V = times(wv, at->v);
    R by_u = minus(times(times(wu, sine(U)), cosine(V))),
      by_v = minus(times(times(wv, cosine(U)), sine(V)));
    tilt(at, a, (R[]){by_u, by_v}, want);
}

/* k = 0.02 3 / |n|. */
static void tilted(const At *at, R by_u, R by_v, R *want)
{
    R k = over(times(num(3), over(num(2), num(100))), root(dot3((R *)at->n, (R *)at->n)));
    tilt(at, k, (R[]){by_u, by_v}, want);
}

/* A volume map under GroIMP's BumpMap: both slopes are its value, (x / 2 + z)^2. */
static void bump_finite(const At *at, R *want)
{
    R value = square(plus(times(num(0.5), at->p[0]), at->p[2]));
    tilted(at, value, value, want);
}

/* Slopes of that map, which is smooth, are 2 (x / 2 + z) times the change of x / 2 + z. */
static void bump(const At *at, R *want)
{
    R twice = plus(at->p[0], times(num(2), at->p[2]));
    R by_u = plus(times(num(0.5), at->by_u[0]), at->by_u[2]),
      by_v = plus(times(num(0.5), at->by_v[0]), at->by_v[2]);
    tilted(at, times(twice, by_u), times(twice, by_v), want);
}

/* A Blend along it, of 0 and y: y t, t the wave 1/2 + sin(2 pi x) / 2. */
static void bump_blend(const At *at, R *want)
{
    R turn = times(num(2), pi()), angle = times(turn, at->p[0]), half = num(0.5);
    R t = plus(half, times(half, sine(angle))), rate = times(times(half, turn), cosine(angle));
    R by_u = plus(times(t, at->by_u[1]), times(times(at->p[1], rate), at->by_u[0]));
    R by_v = plus(times(t, at->by_v[1]), times(times(at->p[1], rate), at->by_v[0]));
    tilted(at, by_u, by_v, want);
}

/* A checker in that Blend's place rises by 1 / 0.05 where u or v is nearer than that to the edge
 * ahead. */
static void bump_checker(const At *at, R *want)
{
    R step = over(num(1), num(20)), u = times(num(2), at->u), v = times(num(2), at->v),
      twice = times(num(2), step);
    R here = odd(plus(whole(u), whole(v)));
    R right = odd(plus(whole(plus(u, twice)), whole(v))),
      above = odd(plus(whole(u), whole(plus(v, twice))));
    tilted(at, over(less(right, here), step), over(less(above, here), step), want);
}

/* 1 + alpha (c - 1): alpha of a Checker of a clear and a solid color, c = (x, x, x). */
static void clear(const At *at, R *want)
{
    bool first = value(odd(plus(whole(times(num(2), at->u)), whole(times(num(2), at->v))))) > 0.25;
    gray(plus(num(1), times(num(first ? 0.25 : 0.75), less(at->p[0], num(1)))), want);
}

/* Exponent of the Mandelbrot map over z <- z^2 + c, laid from [-1, 1] to [0, 1] by a Chain. */
static void mandel(const At *at, R *want)
{
    R a = less(times(num(4), part(at->p[0])), num(2)),
      b = less(times(num(4), part(at->p[1])), num(2)), x = a, y = b;
    int steps = 0;
    for (; steps < 12; steps++) {
        R re = plus(less(square(x), square(y)), a), im = plus(times(num(2), times(x, y)), b);
        x = re, y = im;
        if (below(num(4), plus(square(x), square(y))))
            break;
    }
    R share = over(num(steps), num(12)); /* (f + 1) / 2 */
    R l = times(share, less(num(2), share));
    want[0] = steps == 0    ? num(0)
              : steps == 12 ? num(65504)
                            : lesser(over(num(-2), natural_log(l)), num(65504));
}

/* The mean of 27 distances from the z axis. */
static void smooth(const At *at, R *want)
{
    R sum = num(0);
    for (int i = -1; i <= 1; i++)
        for (int k = -1; k <= 1; k++)
            sum = plus(sum, root(plus(square(plus(at->p[0], num(i * 0.25))),
                                      square(plus(at->p[1], num(k * 0.5))))));
    gray(over(sum, num(9)), want); /* z does not matter */
}

/* GroIMP's tables, from semantics.md 3.1. */
typedef struct {
    uint16_t p[65536];
    double t[512];
} Tables;

static uint64_t next_random(uint64_t *state, int bits)
{
    *state = (*state * 0x5DEECE66Du + 0xB) & (((uint64_t)1 << 48) - 1);
    return *state >> (48 - bits);
}

static const Tables *tables(void)
{
    static Tables made;
    uint64_t state = 123456789 ^ 0x5DEECE66Du;
    if (made.t[0] != 0)
        return &made;
    for (int i = 0; i < 65536; i++)
        made.p[i] = (uint16_t)i;
    for (int i = 0; i < 65536; i++) {
        uint64_t j = 65536 * next_random(&state, 31) >> 31;
        uint16_t kept = made.p[i];
        made.p[i] = made.p[j];
        made.p[j] = kept;
    }
    for (int i = 0; i < 512; i++)
        made.t[i] = 2 * (double)((float)next_random(&state, 24) / (1 << 24)) - 1;
    return &made;
}

static R corner(const Tables *t, const long cell[3], const R d[3], int n)
{
    uint16_t i = (uint16_t)(cell[0] + (n & 1)), j = (uint16_t)(cell[1] + (n >> 1 & 1)),
             k = (uint16_t)(cell[2] + (n >> 2));
    int h = t->p[t->p[t->p[i] ^ j] ^ k];
    R sum = over(num(t->t[h & 511]), num(2));
    for (int axis = 0; axis < 3; axis++)
        sum = plus(sum, times(num(t->t[(h + 1 + axis) & 511]), less(d[axis], num(n >> axis & 1))));
    return sum;
}

static R noise(const R p[3])
{
    R d[3], weight[3], sum = num(0);
    long cell[3];
    for (int i = 0; i < 3; i++) {
        d[i] = part(p[i]);
        cell[i] = (long)value(whole(p[i]));
        weight[i] = times(square(d[i]), less(num(3), times(num(2), d[i])));
    }
    for (int n = 0; n < 8; n++) {
        R w = num(1);
        for (int axis = 0; axis < 3; axis++)
            w = times(w, n >> axis & 1 ? weight[axis] : less(num(1), weight[axis]));
        sum = plus(sum, times(w, corner(tables(), cell, d, n)));
    }
    return greater(num(-1), lesser(num(1), times(num(2), sum)));
}

/* Four octaves of noise of strength 2^k at 1.5 p, times 2^-3, as opposed octaves may not grow. */
static void turbulence(const At *at, R *want)
{
    R sum = num(0), p[3], strength = num(1);
    for (int i = 0; i < 3; i++)
        p[i] = times(num(1.5), at->p[i]);
    for (int k = 0; k < 4; k++) {
        sum = plus(sum, times(strength, noise(p)));
        strength = times(strength, num(2));
        for (int i = 0; i < 3; i++)
            p[i] = times(p[i], num(3));
    }
    gray(over(sum, num(8)), want);
}

/* The oracle's slopes are differences over 2^-26 of the surface's size. */
#define SLOPES 1e-7
enum {
    AUTO = CHOICE_derivatives_auto,
    FINITE = CHOICE_derivatives_finite,
    ANALYTIC = CHOICE_derivatives_analytic
};
#define SQUARED                                                                                    \
    "material: Phong\ninput: { map: BumpMap, strength: 3, displacement: { map: Gradient, "         \
    "direction: [0.5, 0, 1], "                                                                     \
    "waveForm: Sqr } }\n"

static const Material materials[] = {
    {"checker",
     "material: Phong\ndiffuse: { map: Checker, color1: [0.25, 0.5, 1], color2: [0.125, 0, 0.75], "
     "input: { map: "
     "UVTransform, offsetU: 0.25, offsetV: -0.5, scaleU: 4, scaleV: 2, angle: 0.5, shear: 0.125 } "
     "}\n",
     SLOT_diffuse, checker, 0, AUTO},
    {"bands",
     "material: Phong\nemissive: { map: Blend, blend: [{ value: -1, input: [1, 0, 0] }, { value: "
     "0, input: [0, 1, 0] "
     "}, { value: 1, input: [0.5, 0.5, 1] }], input: { map: Gradient, direction: [3, 0.5, 0], "
     "phase: 0.125, "
     "waveForm: Sin01 } }\n",
     SLOT_emissive, bands, 2e-14, AUTO},
    {"rings",
     "material: Phong\nspecular: { map: Wood, frequency: 5, phase: 0.25, waveForm: Triangle }\n",
     SLOT_specular, rings, 2e-14, AUTO},
    {"leopard",
     "material: Phong\nambient: { map: Leopard, input: { map: XYZTransform, transform: { rotation: "
     "[0, 0, 0.75], "
     "translation: [1, -2, 0.5] } } }\n",
     SLOT_ambient, leopard, 4e-15, AUTO},
    {"waves", "material: Phong\ninput: { map: WaveMap, amplitude: 0.125, uCount: 3, vCount: 2 }\n",
     SLOT_normal, waves, 2e-13, AUTO},
    {"bump, finite", SQUARED, SLOT_normal, bump_finite, 2e-13, FINITE},
    {"bump, analytic", SQUARED, SLOT_normal, bump, SLOPES, ANALYTIC},
    {"bump", SQUARED, SLOT_normal, bump, SLOPES, AUTO},
    {"bump of a blend",
     "material: Phong\ninput: { map: BumpMap, strength: 3, displacement: { map: Blend, blend: [{ "
     "value: -1, input: 0 "
     "}, { "
     "value: 1, input: { map: Gradient, direction: [0, 1, 0] } }], input: { map: Gradient, "
     "waveForm: Sin01 } } }\n",
     SLOT_normal, bump_blend, SLOPES, AUTO},
    {"bump of a checker",
     "material: Phong\ninput: { map: BumpMap, strength: 3, displacement: { map: Checker } }\n",
     SLOT_normal, bump_checker, SLOPES, AUTO},
    {"clear",
     "material: Phong\ndiffuse: { map: Checker, color1: [1, 1, 1, 0.25], color2: [0, 0, 0, 0.75] "
     "}\n"
     "transparency: { map: Gradient }\n",
     SLOT_transparency, clear, 2e-15, AUTO},
    {"mandel",
     "material: Phong\nshininess: { map: Mandel, iterations: 12, waveForm: { wave: Chain, factor: "
     "0.5, shift: 0.5 } "
     "}\n",
     SLOT_shininess, mandel, 4e-15, AUTO},
    {"smooth",
     "material: Phong\ndiffuseTransparency: { map: Smooth3D, sx: 0.5, sy: 1, sz: 3, input: { map: "
     "Wood } }\n",
     SLOT_diffuseTransparency, smooth, 2e-14, AUTO},
    {"turbulence",
     "material: Phong\ndiffuse: { map: VolumeTurbulence, size: 1.5, octaves: 4, noiseRatio: 2, "
     "frequencyRatio: 3 }\n",
     SLOT_diffuse, turbulence, 2e-13, AUTO},
};
enum { MATERIALS = sizeof materials / sizeof *materials, POINTS = 200 };

/* Multiples of 2^-20, in [-3, 3). The square keeps vectors of neighboring axes out of one plane,
 * where a normal has no side. */
static double coordinate(int point, int axis)
{
    const double turns =
        (point * 13 + axis + 1) * 0.6180339887498949 + axis * axis * 0.41421356237309503;
    return floor(6 * fraction(turns) * (1 << 20)) / (1 << 20) - 3;
}

static void make_point(int point, Surface *surface, At *at)
{
    static const Group groups[] = {GROUP_U, GROUP_X, GROUP_N, GROUP_DU, GROUP_DV};
    R *const components[] = {NULL, at->p, at->n, at->du, at->dv};
    oracle_surface_default(surface);
    for (int g = 0; g < 5; g++)
        for (int component = 0; component < (g ? 3 : 2); component++) {
            double v = coordinate(point, 3 * g + component);
            surface->root[channel_id(groups[g], component)] = v;
            *(g ? &components[g][component] : component ? &at->v : &at->u) = num(v);
        }
    for (int component = 0; component < 3; component++) {
        surface->local_u[component] = coordinate(point, 14 + component);
        surface->local_v[component] = coordinate(point, 17 + component);
        at->by_u[component] = num(surface->local_u[component]);
        at->by_v[component] = num(surface->local_v[component]);
    }
}

static void materials_are_exact(void **state)
{
    (void)state;
    for (int m = 0; m < MATERIALS; m++) {
        Read read;
        read_open(&read, materials[m].document, REFERENCE_GROIMP);
        oracle_derivatives(read.oracle, (Choice)materials[m].derivatives);
        int components = type_table[slot_table[materials[m].slot].type].components;
        for (int point = 0; point < POINTS; point++) {
            Surface surface;
            SlotValues values;
            At at;
            R want[3];
            make_point(point, &surface, &at);
            read_values(&read, &surface, &values);
            materials[m].exact(&at, want);
            for (int component = 0; component < components; component++)
                agrees(materials[m].name, values.component[materials[m].slot][component],
                       want[component], materials[m].bound);
            exact_forget();
        }
        read_close(&read);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(materials_are_exact),
    };
    return cmocka_run_group_tests(tests, NULL, exact_close);
}
