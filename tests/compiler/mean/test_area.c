/* --aa=box and --aa=aniso against means of the unfiltered map over the same footprints, in
 * double by ir_eval. AREA_ONLY=part-of-a-name in the environment selects rows; AREA_SEED=N takes
 * other footprints, to which the bounds of areas.def do not apply. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "compiler/pipeline.h"
#include "compiler/library/java_random.h"
#include "tests/stress/generate.h"
#include "tests/value/evaluate.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    POINTS = 300,      /* footprints of a map */
    SIDE = 24,         /* samples of a footprint, an axis */
    EXACT_POINTS = 16, /* footprints along the axes */
    PIECES = 4,        /* of a period: between their borders every map of an EXACT row is smooth */
    NODES = 5,         /* of a piece */
    MAX_SHOWN = 3,     /* faults of a map that are printed */
    LONGEST = 1024
};
/* How near to the map itself a pixel without extent is: boxes are 1e-7 at least. */
static const double unfiltered = 3e-7;
static const double rounding = 1e-9; /* beyond a range */

typedef enum { AA_none, AA_box, AA_aniso, AA_COUNT } Aa;
static const char *const aa_names[] = {"none", "box", "aniso"};

typedef struct {
    const char *name;
    double period;
    const char *slot;
    double box, gain, aniso, low, high;
    const char *map;
    double exact; /* 0: none */
} Area;

static const Area areas[] = {
#define AREA(name, ...) {name, __VA_ARGS__},
#include "tests/areas.def"
};
enum { AREA_COUNT = sizeof areas / sizeof *areas };

/* A surface that is flat around the point: how uv and the position change to the right and up. */
typedef struct {
    double u[2], x[3], u_by[2][2], x_by[2][3];
} Footprint;

typedef struct {
    const Area *row;
    Arena arena;
    MatcOptions options;
    Session session;
    const Ir *ir[AA_COUNT];
    ReferenceTexture textures[AA_COUNT][EVALUATE_TEXTURES];
    uint64_t state;
    int faults;
} Test;

static double uniform(Test *t, double low, double high)
{
    return low + (high - low) * (.5 + .5 * (double)java_random_signed(&t->state));
}

static void open_map(Test *t)
{
    char text[LONGEST];
    int size = snprintf(text, sizeof text, "material: Phong\n%s: %s\n", t->row->slot, t->row->map);
    Tree *tree;
    t->arena = (Arena){0};
    matc_options_init(&t->options);
    t->options.pixels = true;
    t->options.read_file = generate_file;
    t->options.pass = "value";
    t->options.slot = t->row->slot;
    t->session =
        (Session){.options = &t->options, .arena = &t->arena, .optimize = 2, .check = true};
    Source source = {.name = "area.yaml", .text = text, .size = (size_t)size};
    ARENA_PUSH(&t->arena, t->session.sources, t->session.source_count, t->session.source_capacity,
               source);
    Graph *graph = compile_front(&t->session, 0, &tree);
    if (!graph || t->session.diags.errors)
        fail_msg("%s\n%s", text, t->session.diags.count ? t->session.diags.at[0].message : "");
    for (int i = 0; i < AA_COUNT; i++) {
        Job job;
        t->options.aa = aa_names[i];
        assert_null(choice_job(&t->options, &job));
        t->ir[i] = compile_ir(&t->session, graph, graph->materials[0].node, &job);
        assert_non_null(t->ir[i]);
        assert_true(evaluate_textures(&t->arena, t->ir[i], t->textures[i]));
    }
}

/* The value at a part of the way to the neighbors. */
static double value_at(Test *t, Aa aa, const Footprint *f, double right, double up)
{
    double inputs[INPUT_COUNT][4] = {{0}}, result[MAX_OUTPUTS][4];
    ReferenceContext context = {t->ir[aa]->noise, t->textures[aa]};
    for (int i = 0; i < 2; i++) {
        inputs[INPUT_U][i] = f->u[i] + right * f->u_by[0][i] + up * f->u_by[1][i];
        inputs[INPUT_UX][i] = f->u_by[0][i];
        inputs[INPUT_UY][i] = f->u_by[1][i];
    }
    for (int i = 0; i < 3; i++) {
        inputs[INPUT_X][i] = inputs[INPUT_P][i] =
            f->x[i] + right * f->x_by[0][i] + up * f->x_by[1][i];
        inputs[INPUT_XX][i] = inputs[INPUT_PX][i] = f->x_by[0][i];
        inputs[INPUT_XY][i] = inputs[INPUT_PY][i] = f->x_by[1][i];
    }
    inputs[INPUT_N][2] = inputs[INPUT_DU][0] = inputs[INPUT_DV][1] = 1;
    inputs[INPUT_front][0] = inputs[INPUT_IOR][0] = 1;
    ir_eval(t->ir[aa], &context, (const double(*)[4])inputs, result);
    return result[0][0];
}

/* A footprint without extent. */
static Footprint point(Test *t)
{
    Footprint f;
    memset(&f, 0, sizeof f);
    for (int i = 0; i < 2; i++)
        f.u[i] = uniform(t, -2, 2) * t->row->period;
    for (int i = 0; i < 3; i++)
        f.x[i] = uniform(t, -2, 2) * t->row->period;
    return f;
}

/* Two tangents of length 1 at a right angle, turned at random. */
static void random_plane(Test *t, double tangent[2][3])
{
    double z = uniform(t, -1, 1), turn = uniform(t, 0, 2 * M_PI), roll = uniform(t, 0, 2 * M_PI),
           r = sqrt(1 - z * z);
    const double a[3] = {-sin(turn), cos(turn), 0}, b[3] = {-z * cos(turn), -z * sin(turn), r};
    for (int i = 0; i < 3; i++) {
        tangent[0][i] = cos(roll) * a[i] + sin(roll) * b[i];
        tangent[1][i] = cos(roll) * b[i] - sin(roll) * a[i];
    }
}

/* Turned at random, half of them longer one way; not always at a right angle. */
static Footprint random_footprint(Test *t, int number)
{
    Footprint f = point(t);
    double tangent[2][3], size = t->row->period * pow(10, uniform(t, -2, 1)),
                          turn = uniform(t, 0, 2 * M_PI);
    double stretch = number % 2 ? pow(16, uniform(t, 0, 1)) : 1, skew = uniform(t, -.3, .3);
    random_plane(t, tangent);
    for (int way = 0; way < 2; way++) {
        double angle = turn + way * (M_PI / 2 + skew), length = size / (way ? stretch : 1);
        f.u_by[way][0] = length * cos(angle);
        f.u_by[way][1] = length * sin(angle);
        for (int i = 0; i < 3; i++)
            f.x_by[way][i] = f.u_by[way][0] * tangent[0][i] + f.u_by[way][1] * tangent[1][i];
    }
    return f;
}

/* One sample at random in each cell of a grid. */
static double mean_of_samples(Test *t, const Footprint *f)
{
    double sum = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        sum += value_at(t, AA_none, f, (i % SIDE + uniform(t, 0, 1)) / SIDE - .5,
                        (i / SIDE + uniform(t, 0, 1)) / SIDE - .5);
    return sum / (SIDE * SIDE);
}

/* Position of the next border, as a fraction of the way; borders are at multiples of a part of
 * the period. */
static double next_border(double from, double middle, double edge, double part)
{
    const double beyond = 1e-9;
    double place = middle + from * edge;
    return fmin(((floor(place / part + beyond) + 1) * part - middle) / edge, .5);
}

/* Exact: Gauss' rule on every piece between borders, along x and u; then along y and v. */
static double mean_along(Test *t, const Footprint *f, int axis, double right)
{
    static const double node[NODES] = {-.906179845938664, -.538469310105683, 0, .538469310105683,
                                       .906179845938664};
    static const double weight[NODES] = {.236926885056189, .478628670499366, .568888888888889,
                                         .478628670499366, .236926885056189};
    double sum = 0, from = -.5, edge = f->u_by[axis][axis];
    while (from < .5) {
        double to = next_border(from, f->u[axis], edge, t->row->period / PIECES);
        for (int i = 0; i < NODES; i++) {
            double at = (from + to) / 2 + node[i] * (to - from) / 2,
                   share = weight[i] * (to - from) / 2;
            sum += share * (axis ? value_at(t, AA_none, f, right, at) : mean_along(t, f, 1, at));
        }
        from = to;
    }
    return sum;
}

static Footprint straight_footprint(Test *t)
{
    Footprint f = point(t);
    for (int i = 0; i < 2; i++) {
        f.x[i] = f.u[i];
        f.u_by[i][i] = f.x_by[i][i] = t->row->period * pow(10, uniform(t, -2, .3));
    }
    return f;
}

static void fault(Test *t, const char *what, double is, double limit)
{
    if (t->faults++ < MAX_SHOWN)
        print_error("%s: %s %.3g, at most %.3g\n", t->row->name, what, is, limit);
}

static void check_points(Test *t)
{
    for (int i = 0; i < POINTS; i++) {
        Footprint f = point(t);
        for (int aa = AA_box; aa < AA_COUNT; aa++) {
            double apart = fabs(value_at(t, (Aa)aa, &f, 0, 0) - value_at(t, AA_none, &f, 0, 0));
            if (!(apart <= unfiltered * fmax(1, fabs(t->row->high))))
                fault(t, "a pixel without extent is off by", apart, unfiltered);
        }
    }
}

/* The greatest error of box and aniso. */
static double check_exact(Test *t)
{
    double worst = 0;
    for (int i = 0; i < EXACT_POINTS; i++) {
        Footprint f = straight_footprint(t);
        double mean = mean_along(t, &f, 0, 0);
        for (int aa = AA_box; aa < AA_COUNT; aa++)
            worst = fmax(worst, fabs(value_at(t, (Aa)aa, &f, 0, 0) - mean));
    }
    if (!(worst <= t->row->exact))
        fault(t, "along the axes it is off by", worst, t->row->exact);
    return worst;
}

static void check_range(Test *t, double value)
{
    if (!(value >= t->row->low - rounding && value <= t->row->high + rounding))
        fault(t, value < t->row->low ? "below its range is" : "above its range is", value,
              t->row->high);
}

static void check_errors(Test *t, double error[AA_COUNT])
{
    for (int i = 0; i < POINTS; i++) {
        Footprint f = random_footprint(t, i);
        double mean = mean_of_samples(t, &f);
        for (int aa = 0; aa < AA_COUNT; aa++) {
            double value = value_at(t, (Aa)aa, &f, 0, 0);
            check_range(t, value);
            error[aa] += (value - mean) * (value - mean) / POINTS;
        }
    }
    for (int aa = 0; aa < AA_COUNT; aa++)
        error[aa] = sqrt(error[aa]);
    if (!(error[AA_box] <= t->row->box))
        fault(t, "the error of box is", error[AA_box], t->row->box);
    if (!(error[AA_box] * t->row->gain <= error[AA_none]))
        fault(t, "the error of box over that of none is", error[AA_box] / error[AA_none],
              1 / t->row->gain);
    if (!(error[AA_aniso] <= t->row->aniso * error[AA_box]))
        fault(t, "the error of aniso over that of box is", error[AA_aniso] / error[AA_box],
              t->row->aniso);
}

static void show_errors(const Area *row, const double error[AA_COUNT])
{
    print_message("%-31s %7.4g %8.4g %8.4g %8.4g %8.4g %8.4g %8.4g", row->name, error[AA_none],
                  error[AA_box], row->box, error[AA_none] / error[AA_box], row->gain,
                  error[AA_aniso] / error[AA_box], row->aniso);
}

static void pixels_show_means(void **state)
{
    (void)state;
    int faults = 0;
    const char *only = getenv("AREA_ONLY"), *seed = getenv("AREA_SEED");
    const int first = seed ? AREA_COUNT * atoi(seed) : 0;
    print_message("%-31s %7s %17s %17s %17s %15s\n", "seen, and at most", "none", "box", "none/box",
                  "aniso/box", "on axes");
    for (int i = 0; i < AREA_COUNT; i++) {
        Test t = {.row = &areas[i], .state = java_random(first + i)};
        double error[AA_COUNT] = {0};
        if (only && !strstr(areas[i].name, only))
            continue;
        assert_true(areas[i].gain >= 1); /* a row that left it out would promise nothing */
        open_map(&t);
        check_points(&t);
        check_errors(&t, error);
        show_errors(&areas[i], error);
        if (areas[i].exact > 0)
            print_message(" %7.1e %7.0e", check_exact(&t), areas[i].exact);
        print_message("%s\n", t.faults ? "  TOO LARGE" : "");
        faults += t.faults;
        arena_free(&t.arena);
    }
    assert_int_equal(faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pixels_show_means),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
