/* matbench shadows: every way in which a light casts shadows, by how far their ends are from where they should be, and by what a frame takes. What should be
 * is what exact shadows are, which tests compare with rays of Embree: so it runs where there is none. */
#include "matbench.h"
#include "shadows_error.h"
#include "runtime/scene/model.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    GlKind kind;
    const char *mesh; /* a file, or NULL */
    int triangles;    /* else, of a ball with bumps, about */
    int map_size;
    bool timed;
    unsigned tables;
} Arguments;

typedef struct {
    GlContext *gl;
    MatcOptions compile;
    Arguments arguments;
    Shape mesh;
    ShadowsMethod methods[SHADOWS_METHODS_MOST];
    int method_count, pcf;
} Shadows;

/* -- errors */

static bool measure_receiver(const Shadows *s, ShadowsScene which, double errors[SHADOWS_METHODS_MOST])
{
    enum { EDGE = 512 };
    const ShadowsTarget target = {s->gl, &s->compile, EDGE, s->arguments.map_size};
    ShadowsPlace place;
    ShadowsPicture picture = {0};
    bool fine = shadows_open(which, &s->mesh, &s->compile, &place) && shadows_picture_open(&target, &place, &picture);
    bench_show(shadows_receivers[which]);
    for (int i = 1; fine && i < s->method_count; i++) {
        errors[i] = shadows_picture_error(&picture, &s->methods[i]);
        fine = !isnan(errors[i]);
    }
    bench_show("");
    shadows_picture_close(&picture);
    shadows_close(&place);
    return fine;
}

static void put_name(const Shadows *s, int method)
{
    printf("%-9s %-9s", s->methods[method].name[0], s->methods[method].name[1]);
}

static bool measure_errors(const Shadows *s)
{
    static double errors[SHADOWS_RECEIVERS][SHADOWS_METHODS_MOST];
    for (int i = 0; i < SHADOWS_RECEIVERS; i++)
        if (!measure_receiver(s, (ShadowsScene)i, errors[i]))
            return false;
    printf("\nerrors: mean distance of shadows' ends from the true ones, in texels of a map of %d x %d\n%-19s",
           s->arguments.map_size, s->arguments.map_size, "shadows on");
    for (int i = 0; i < SHADOWS_RECEIVERS; i++)
        printf(" %11s", shadows_receivers[i]);
    putchar('\n');
    for (int method = 1; method < s->method_count; method++) {
        put_name(s, method);
        for (int i = 0; i < SHADOWS_RECEIVERS; i++)
            printf(" %11.3f", errors[i][method]);
        putchar('\n');
    }
    fflush(stdout);
    return true;
}

/* -- times */

enum { MOST_FRAMES = 64, FEWEST_FRAMES = 5 };

/* A method's own scene, as each light has one method, and its frames' seconds: of a scene that stands still, and of light that moves. */
typedef struct {
    ShadowsPlace place;
    Render *render;
    double seconds[2][MOST_FRAMES];
} Timed;

static bool open_timed(const Shadows *s, int method, Timed *timed)
{
    const int *const size = s->gl->hardware ? (const int[]){1920, 1080} : (const int[]){480, 270};
    const RenderOptions options = {.compile = &s->compile, .view = "light", .width = size[0], .height = size[1]};
    if (!shadows_open(SHADOWS_frame, &s->mesh, &s->compile, &timed->place))
        return false;
    shadows_use(timed->place.scene, &s->methods[method], s->arguments.map_size);
    timed->render = render_open(s->gl, &options);
    return (timed->render && render_scene(timed->render, timed->place.scene) && render_frame(timed->render)) ||
           fprintf(stderr, "matbench: %s\n", s->gl->error) < 0;
}

/* Seconds of a frame, of so many that are finished together. */
static double draw(const Shadows *s, Timed *timed, bool moving, int frames)
{
    SceneLight *light = timed->place.scene->lights;
    const double start = bench_now();
    for (int i = 0; i < frames; i++) {
        light->direction[0] += moving ? (i % 2 ? -1e-3 : 1e-3) : 0;
        if (moving)
            render_changed(timed->render, RENDER_LIGHTS);
        render_frame(timed->render);
    }
    s->gl->Finish();
    return (bench_now() - start) / frames;
}

/* As many as take longer than it takes a GPU to tell that it has finished; an even number. */
static int frames_of(const Shadows *s, Timed *timed, bool moving)
{
    const double least = 5e-3, one = draw(s, timed, moving, 2);
    return 2 + 2 * (int)(least / (2 * fmax(one, 1e-5)));
}

static void time_all(const Shadows *s, Timed timed[SHADOWS_METHODS_MOST], bool moving)
{
    const double end = bench_now() + 4;
    int frames[SHADOWS_METHODS_MOST], count = 0;
    for (int i = 0; i < s->method_count; i++)
        frames[i] = frames_of(s, &timed[i], moving);
    for (; count < MOST_FRAMES && (count < FEWEST_FRAMES || bench_now() < end); count++)
        for (int i = 0; i < s->method_count; i++)
            timed[i].seconds[moving][count] = draw(s, &timed[i], moving, frames[i]);
    for (int i = 0; i < s->method_count; i++)
        for (int k = 1; k < count; k++)
            timed[i].seconds[moving][0] = fmin(timed[i].seconds[moving][0], timed[i].seconds[moving][k]);
}

/* What the shadows take alone is what a frame takes more than one without. */
static void put_times(const Shadows *s, const Timed timed[SHADOWS_METHODS_MOST])
{
    printf("\ntimes: least milliseconds of a frame, and what shadows take more than none, over what PCF 3x3 takes "
           "more\n%-19s "
           "%11s %11s %11s %11s\n",
           "shadows", "still", "/ PCF", "moving", "/ PCF");
    for (int method = 0; method < s->method_count; method++) {
        put_name(s, method);
        for (int moving = 0; moving < 2; moving++) {
            const double none = timed[0].seconds[moving][0], time = timed[method].seconds[moving][0];
            printf(" %11s %11s", NUMBER(3, 1e3 * time),
                   NUMBER(2, (time - none) / (timed[s->pcf].seconds[moving][0] - none)));
        }
        putchar('\n');
    }
    fflush(stdout);
}

static bool measure_times(const Shadows *s)
{
    static Timed timed[SHADOWS_METHODS_MOST];
    bool fine = true;
    memset(timed, 0, sizeof timed);
    bench_show("times");
    for (int i = 0; fine && i < s->method_count && s->arguments.timed; i++)
        fine = open_timed(s, i, &timed[i]);
    for (int moving = 0; fine && moving < 2; moving++)
        if (s->arguments.timed)
            time_all(s, timed, moving);
        else
            for (int i = 0; i < s->method_count; i++)
                timed[i].seconds[moving][0] = NAN;
    bench_show("");
    fine = fine && (gl_check(s->gl, "drawing frames") || fprintf(stderr, "matbench: %s\n", s->gl->error) < 0);
    if (fine)
        put_times(s, timed);
    for (int i = 0; i < s->method_count; i++) {
        render_close(timed[i].render);
        shadows_close(&timed[i].place);
    }
    return fine;
}

/* -- the command */

static const struct {
    const char *name;
    bool (*measure)(const Shadows *s);
} tables[] = {{"errors", measure_errors}, {"times", measure_times}};
enum { TABLES = sizeof tables / sizeof *tables };

static bool read_argument(const char *text, Arguments *made)
{
    for (int i = 0; i < TABLES; i++)
        if (!strcmp(text, tables[i].name)) {
            made->tables |= 1u << i;
            return true;
        }
    if (!strncmp(text, "--mesh=", 7))
        made->mesh = text + 7;
    return made->mesh == text + 7 || (!strncmp(text, "--gl=", 5) && gl_kind_find(text + 5, &made->kind)) ||
           sscanf(text, "--triangles=%d", &made->triangles) == 1 || sscanf(text, "--maps=%d", &made->map_size) == 1;
}

static bool read_arguments(int argc, char **argv, Arguments *made)
{
    *made =
        (Arguments){.kind = GL_KIND_osmesa, .triangles = 8000, .map_size = 256, .timed = !bench_untimed(argc, argv)};
    for (int i = made->timed ? 1 : 2; i < argc; i++)
        if (!read_argument(argv[i], made))
            return false;
    made->tables = made->tables ? made->tables : (1u << TABLES) - 1;
    return made->triangles >= 100 && made->triangles <= 4000000 && made->map_size >= 16 && made->map_size <= 8192;
}

static bool open_mesh(const Arguments *arguments, Shape *made)
{
    char error[4096];
    if (!arguments->mesh)
        return shadows_ball(arguments->triangles, made) || fputs("matbench: out of memory\n", stderr) < 0;
    return model_read(arguments->mesh, made, error, sizeof error) || fprintf(stderr, "matbench: %s\n", error) < 0;
}

static int run(const Arguments *arguments)
{
    char error[4096];
    Shadows s = {.arguments = *arguments};
    matc_options_init(&s.compile);
    s.compile.pixels = true;
    if (!open_mesh(arguments, &s.mesh))
        return 1;
    s.gl = gl_open(arguments->kind, true, error, sizeof error);
    bool fine = s.gl || fprintf(stderr, "matbench: %s\n", error) < 0;
    s.method_count = shadows_methods(s.methods, &s.pcf);
    if (fine && arguments->timed)
        printf("%s, ", s.gl->renderer);
    if (fine)
        printf("%d triangles\n", s.mesh.index_count / 3);
    for (int i = 0; fine && i < TABLES; i++)
        fine = !(arguments->tables >> i & 1) || tables[i].measure(&s);
    gl_close(s.gl);
    shape_free(&s.mesh);
    return !fine;
}

int bench_shadows(int argc, char **argv)
{
    Arguments arguments;
    if (read_arguments(argc, argv, &arguments))
        return run(&arguments);
    fputs(
        "usage: matbench shadows [--untimed] [--gl=osmesa|egl] [--triangles=N] [--mesh=FILE] [--maps=TEXELS] [errors] "
        "[times]\n",
        stderr);
    return 2;
}
