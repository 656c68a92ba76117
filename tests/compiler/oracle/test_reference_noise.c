/* The C references of noise: check values of the semantics, statistics, periods. */
#include "tests/test.h"
#include "compiler/library/references.h"
#include "tests/near.h"

REFERENCE(granite);
REFERENCE(noise);
REFERENCE(turbulence);
REFERENCE(vectorTurbulence);

#define PRINTED 1e-6 /* half a step of the last digit that the semantics print, rounded up */

static void groimp_tables(void **state)
{
    (void)state;
    static const uint16_t first[] = {45307, 15849, 29946, 33524, 49951, 14194, 58546, 10363};
    static const double random[] = {-.3643425, .7616661, -.2419053, .5950150, -.2863144};
    static bool met[65536];
    for (int i = 0; i < 8; i++)
        assert_int_equal(reference_permutation()[i], first[i]);
    assert_int_equal(reference_permutation()[65535], 54233);
    for (int i = 0; i < 65536; i++)
        met[reference_permutation()[i]] = true;
    for (int i = 0; i < 65536; i++)
        assert_true(met[i]);
    for (int i = 0; i < 5; i++)
        near((double)reference_random_table()[i], random[i], 1e-7);
}

static void groimp_noise(void **state)
{
    (void)state;
    static const double rows[][7] = {
        {0, 0, 0, -.556608, -.278304, -.011699, -.213394},
        {.5, .5, .5, .508047, .254024, -.318052, .116664},
        {.25, .5, .75, .303176, .151588, -.391773, -.354758},
        {1.3, -2.7, .1, .205618, .102809, -.086406, .015883},
        {-.5, -.5, -.5, .502212, .251106, -.065384, -.227353},
        {12.34, 56.78, -90.12, -.036345, -.018172, -.053027, .130630},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        double vector[3];
        reference_lattice3(REFERENCE_GROIMP, rows[i], vector);
        near(value_of(reference_noise, rows[i][0], rows[i][1], rows[i][2]), rows[i][3], PRINTED);
        for (int component = 0; component < 3; component++)
            near(vector[component], rows[i][4 + component], PRINTED);
    }
}

static void groimp_turbulence(void **state)
{
    (void)state;
    double result[3];
    reference_turbulence(&groimp, (const double[]){.25, .5, .75, 5, 2, 1}, result);
    near(result[0], 2.173850, PRINTED);
    reference_turbulence(&groimp, (const double[]){.25, .5, .75, 5, 2, .5}, result);
    near(result[0], .529139, PRINTED);
    reference_vectorTurbulence(&groimp, (const double[]){.25, .5, .75, 5, 2, 2}, result);
    near(result[0], 8.515307, PRINTED);
    near(result[1], 8.641798, PRINTED);
    near(result[2], -2.514515, PRINTED);
    near(value_of(reference_granite, .25, .5, .75), .411586, PRINTED);
    for (int octaves = -3; octaves <= 1; octaves++) {
        reference_turbulence(&groimp, (const double[]){.25, .5, .75, octaves, 2, 1}, result);
        near(result[0], .303176, PRINTED);
    }
}

/* Every noise is spread as GroIMP's is, its outputs are unrelated, and so are cells near each other
 * or mirrored. */
static void lattice_statistics(void **state)
{
    (void)state;
    for (int noise = REFERENCE_LATTICE; noise < REFERENCE_NOISE_COUNT; noise++) {
        double sum = 0, squares = 0, products[3] = {0}, neighbours = 0, swapped[3] = {0},
               clamped = 0;
        for (int i = 0; i < SAMPLES; i++) {
            const double p[3] = {1000 * sample(), 1000 * sample(), 1000 * sample()},
                         q[3] = {p[0] + 2, p[1], p[2]};
            double l[3], n;
            reference_lattice3((ReferenceNoise)noise, p, l);
            n = clamp(2 * l[0], -1, 1);
            sum += n;
            squares += n * n;
            clamped += fabs(n) >= 1;
            for (int component = 0; component < 3; component++)
                products[component] += 4 * l[component] * l[(component + 1) % 3];
            for (int axis = 0; axis < 3; axis++) { /* the mirror image that exchanges two axes */
                double mirror[3] = {p[0], p[1], p[2]};
                mirror[axis] = p[(axis + 1) % 3];
                mirror[(axis + 1) % 3] = p[axis];
                swapped[axis] += 4 * l[0] * reference_lattice((ReferenceNoise)noise, mirror, NULL);
            }
            neighbours += 4 * l[0] * reference_lattice((ReferenceNoise)noise, q, NULL);
        }
        print_message("noise %d: mean %.4f, deviation %.4f, clamped %.2f %%\n", noise,
                      sum / SAMPLES, sqrt(squares / SAMPLES), 100 * clamped / SAMPLES);
        near(sum / SAMPLES, 0, .03);
        near(sqrt(squares / SAMPLES), .5, .02);
        near(clamped / SAMPLES, .05, .02);
        near(neighbours / SAMPLES, 0, .02);
        for (int component = 0; component < 3; component++)
            near(products[component] / SAMPLES, 0, .02);
        for (int component = 0; component < 3; component++)
            near(swapped[component] / SAMPLES, 0, .02);
    }
}

static void lattice_is_continuous_periodic_and_finite(void **state)
{
    (void)state;
    for (int noise = REFERENCE_LATTICE; noise < REFERENCE_NOISE_COUNT; noise++)
        for (int i = 0; i < 1000; i++) {
            const double p[3] = {floor(40000 * sample()), 40000 * sample(), 40000 * sample()};
            const double below[3] = {p[0] - 1e-9, p[1], p[2]},
                         far[3] = {p[0] + 3 * 65536, p[1] - 3 * 65536.,
                                   /* simplex noise repeats after three of its cells' periods */
                                   p[2]};
            const double farthest[3] = {1e30 * sample(), 1e308 * sample(), 1e-310 * sample()};
            double here = reference_lattice((ReferenceNoise)noise, p, NULL);
            near(reference_lattice((ReferenceNoise)noise, below, NULL), here, 1e-8);
            near(reference_lattice((ReferenceNoise)noise, far, NULL), here, 1e-9);
            inside(reference_lattice((ReferenceNoise)noise, farthest, NULL), -2, 2);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(groimp_tables),
        cmocka_unit_test(groimp_noise),
        cmocka_unit_test(groimp_turbulence),
        cmocka_unit_test(lattice_statistics),
        cmocka_unit_test(lattice_is_continuous_periodic_and_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
