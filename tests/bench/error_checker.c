/* A checker on a plane up to its horizon: the cost of filtering, and the error against 4096
 * samples per pixel. */
#include "error.h"
#include "matbench.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    WIDTH = 480,
    HEIGHT = 270,
    YAWS = 3,
    SAMPLES_SIDE = 64,
    QUICK_SIDE = 16,
    ROUNDS = 25,
    QUICK_ROUNDS = 7,
    MOST = 16
};
static const double yaws[YAWS] = {0, 0.3, 0.785};

/* u and v per unit of height, chosen so that unfiltered values have the error of the table in
 * numerics.md: 0.165. */
static const double checker_scale = 0.78;

static const char checker_document[] =
    "material: Phong\ndiffuse: { map: Checker, color1: 1, color2: 0 }\n";

/* Supersampling within the shader, the alternative to filtering. */
static const char samples_text[] = "#version 330 core\n"
                                   "in vec2 uv;\n"
                                   "layout(location = 0) out vec4 fragment0;\n"
                                   "void main() {\n"
                                   "    vec2 x = dFdx(uv), y = dFdy(uv);\n"
                                   "    float sum = 0.0;\n"
                                   "    for (int i = 0; i < 16; i++) {\n"
                                   "        vec2 at = (vec2(i & 3, i >> 2) - 1.5) * 0.25;\n"
                                   "        vec2 f = fract(uv + x * at.x + y * at.y);\n"
                                   "        sum += (0.5 <= f.x) != (0.5 <= f.y) ? 1.0 : 0.0;\n"
                                   "    }\n"
                                   "    fragment0 = vec4(vec3(sum * 0.0625), 1.0);\n"
                                   "}\n";

typedef struct {
    char name[VARIANT_NAME];
    Material material;
    double squares, maximum, nanoseconds;
} Method;

typedef struct {
    ErrorBench *bench;
    Method methods[MOST];
    int count;
    Field views[YAWS];
    Framebuffer picture, half;
} Checker;

/* Sixteen samples first, then every choice of the axis aa. */
static void make_methods(Checker *c, const MatcDocument *document)
{
    Variant base, variant;
    MatcOptions options;
    matc_options_init(&options);
    variant_of(&options, &base);
    strcpy(c->methods[0].name, "16 samples in the shader");
    c->count =
        field_material(c->bench->meter->store, NULL,
                       &(FieldText){TARGET_glsl330, samples_text, NULL}, &c->methods[0].material);
    for (int i = 0; i < axis_choices(AXIS_aa) && c->count < MOST; i++) {
        variant = base;
        variant.choice[AXIS_aa] = axis_table[AXIS_aa].first + i;
        snprintf(c->methods[c->count].name, VARIANT_NAME, "aa=%s",
                 choice_table[variant.choice[AXIS_aa]].name);
        if (error_material(c->bench, document, &variant, &c->methods[c->count].material))
            c->count++;
    }
}

static bool make_views(Checker *c)
{
    GlContext *gl = c->bench->meter->gl;
    FramebufferSpec full = {.width = WIDTH,
                            .height = HEIGHT,
                            .color_count = 1,
                            .color_format = GL_RGBA32F},
                    half = full;
    half.color_format = GL_RGBA16F;
    half.width *= c->bench->factor;
    half.height *= c->bench->factor;
    for (int i = 0; i < YAWS; i++) {
        FieldVertex plane[PLANE_VERTICES];
        sample_plane(plane,
                     &(PlaneView){yaws[i], checker_scale, (double)WIDTH / HEIGHT, HEIGHT, {0, 0}});
        if (!field_make(gl, plane, PLANE_VERTICES, GL_TRIANGLE_STRIP, &c->views[i]))
            return false;
    }
    return framebuffer_make(gl, &full, &c->picture) && framebuffer_make(gl, &half, &c->half);
}

/* Errors of all methods at one yaw. `plain` is the unfiltered method. */
static bool add_errors(Checker *c, int yaw, Material *plain, float *wanted, float *found)
{
    Meter *m = c->bench->meter;
    int side = c->bench->quick ? QUICK_SIDE : SAMPLES_SIDE;
    if (!meter_draw_mean(m, &(MeterDraw){plain, &c->views[yaw], &c->picture}, side, wanted))
        return false;
    for (int k = 0; k < c->count; k++) {
        const MeterDraw draw = {&c->methods[k].material, &c->views[yaw], &c->picture};
        if (!meter_draw_mean(m, &draw, 1, found))
            return false;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            double d = fabs((double)found[4 * i] - wanted[4 * i]);
            c->methods[k].squares += d * d / (WIDTH * HEIGHT * YAWS);
            c->methods[k].maximum = fmax(c->methods[k].maximum, d);
        }
    }
    return true;
}

static bool add_times(Checker *c)
{
    Material constant;
    MeterDraw draws[MOST + 1];
    double nanoseconds[MOST + 1];
    if (!meter_make_constant(c->bench->meter, &constant))
        return false;
    draws[0] = (MeterDraw){&constant, &c->views[1], &c->half};
    for (int i = 0; i < c->count; i++)
        draws[1 + i] = (MeterDraw){&c->methods[i].material, &c->views[1], &c->half};
    bool done = meter_time(c->bench->meter, draws, c->count + 1,
                           c->bench->quick ? QUICK_ROUNDS : ROUNDS, nanoseconds);
    for (int i = 0; i < c->count; i++)
        c->methods[i].nanoseconds = fmax(0, nanoseconds[1 + i] - nanoseconds[0]);
    material_delete(&constant);
    return done;
}

static Method *find(Checker *c, const char *name)
{
    for (int i = 0; i < c->count; i++)
        if (!strcmp(c->methods[i].name, name))
            return &c->methods[i];
    return NULL;
}

static void report(Checker *c)
{
    FILE *out = c->bench->part[SECTION_PART_checker];
    const Method *samples = &c->methods[0], *box = find(c, "aa=box"), *aniso = find(c, "aa=aniso");
    fputs("| method | RMSE | max | ns a pixel |\n| --- | --- | --- | --- |\n", out);
    for (int i = 0; i < c->count; i++) {
        const Method *m = &c->methods[i];
        fprintf(out, "| %s | %.4f | %.3f | %.2f |\n", m->name, sqrt(m->squares), m->maximum,
                m->nanoseconds);
        const ErrorSubject of = {"checker", "horizon", m->name};
        error_figure(c->bench, of, "rmse", sqrt(m->squares));
        error_figure(c->bench, of, "max", m->maximum);
        error_figure(c->bench, of, "ns_per_pixel", m->nanoseconds);
    }
    if (samples->nanoseconds <= 0)
        fputs("\nThe machine was busy: 16 samples took no longer than drawing nothing, so no ratio "
              "of times can be "
              "told.\n",
              out);
    if (box && samples->nanoseconds > 0)
        error_target(c->bench, "checker to the horizon, aa=box",
                     sqrt(box->squares) <= 0.0465 && box->nanoseconds <= 0.5 * samples->nanoseconds,
                     "RMSE 0.046 at half the time of 16 samples|RMSE %.4f at %.2f of it",
                     sqrt(box->squares), box->nanoseconds / samples->nanoseconds);
    if (aniso && samples->nanoseconds > 0)
        error_target(c->bench, "checker to the horizon, aa=aniso",
                     sqrt(aniso->squares) <= 0.019 && aniso->nanoseconds <= samples->nanoseconds,
                     "RMSE 0.019 at the time of 16 samples|RMSE %.4f at %.2f of it",
                     sqrt(aniso->squares), aniso->nanoseconds / samples->nanoseconds);
}

void error_checker(ErrorBench *bench)
{
    Checker *c = calloc(1, sizeof *c);
    float *wanted = calloc(WIDTH * HEIGHT * 4, sizeof *wanted),
          *found = calloc(WIDTH * HEIGHT * 4, sizeof *found);
    if (!c || !wanted || !found)
        abort();
    MatcDocument *document = error_document("checker", checker_document);
    c->bench = bench;
    bench_show("checker to the horizon");
    make_methods(c, document);
    Method *plain = find(c, "aa=none");
    bool done = plain && make_views(c);
    for (int i = 0; i < YAWS && done; i++)
        done = add_errors(c, i, &plain->material, wanted, found);
    if (done && add_times(c))
        report(c);
    for (int i = 0; i < c->count; i++)
        material_delete(&c->methods[i].material);
    for (int i = 0; i < YAWS; i++)
        field_delete(bench->meter->gl, &c->views[i]);
    framebuffer_delete(bench->meter->gl, &c->picture);
    framebuffer_delete(bench->meter->gl, &c->half);
    matc_document_free(document);
    free(wanted);
    free(found);
    free(c);
}
