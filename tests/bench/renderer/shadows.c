/* matbench shadows: every shadow technique of a light, by the error of its shadow boundaries and
 * by frame time. Exact shadows are the reference here, which tests compare with Embree's rays;
 * so the benchmark runs without Embree. */
#include "tests/bench/matbench.h"
#include "shadows.h"
#include "shadows_error.h"
#include "runtime/mesh_import/model.h"
#include "tests/meshes/meshes.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- errors */

static bool measure_receiver(const Shadows *s, ShadowsScene which,
                             double errors[SHADOWS_METHODS_MAX])
{
    enum { EDGE = 512 };
    const ShadowsTarget target = {s->gl, &s->compile, EDGE, s->map_size};
    ShadowsPlace place;
    ShadowsPicture picture = {0};
    bool fine = shadows_open(which, &s->mesh, &s->compile, &place) &&
                shadows_picture_open(&target, &place, &picture);
    bench_show(shadows_receivers[which]);
    for (int i = 1; fine && i < s->method_count; i++) {
        ShadowsError error = {0};
        fine = shadows_picture_error(&picture, &s->methods[i], s->map_size, &error);
        errors[i] = error.distance;
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
    static double errors[SHADOWS_RECEIVERS][SHADOWS_METHODS_MAX];
    for (int i = 0; i < SHADOWS_RECEIVERS; i++)
        if (!measure_receiver(s, (ShadowsScene)i, errors[i]))
            return false;
    printf("\nerrors: mean distance of shadows' ends from the true ones, in texels of a map of %d "
           "x %d\n%-19s",
           s->map_size, s->map_size, "shadows on");
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

/* Time of shadows alone: that of a frame minus that of one without shadows. */
static void put_times(const Shadows *s, const ShadowsTime times[SHADOWS_METHODS_MAX])
{
    const ShadowsTime none = times[0], pcf = times[s->pcf];
    printf("\ntimes: least milliseconds of a frame, and what shadows take more than none, over "
           "what PCF 3x3 takes "
           "more\n%-19s %11s %11s %11s %11s\n",
           "shadows", "still", "/ PCF", "moving", "/ PCF");
    for (int method = 0; method < s->method_count; method++) {
        const ShadowsTime time = times[method];
        put_name(s, method);
        printf(" %11s %11s", NUMBER(3, 1e3 * time.still),
               NUMBER(2, (time.still - none.still) / (pcf.still - none.still)));
        printf(" %11s %11s\n", NUMBER(3, 1e3 * time.moving),
               NUMBER(2, (time.moving - none.moving) / (pcf.moving - none.moving)));
    }
    fflush(stdout);
}

static bool measure_times(const Shadows *s)
{
    const ShadowsTiming timing = {s->methods, s->method_count, s->map_size, &s->mesh, {0, 0}, 4};
    ShadowsTime times[SHADOWS_METHODS_MAX];
    bench_show("times");
    const bool fine = shadows_time(s, &timing, times);
    bench_show("");
    if (fine)
        put_times(s, times);
    return fine;
}

/* -- the command */

static const struct {
    const char *name;
    bool (*measure)(const Shadows *s);
} tables[] = {{"errors", measure_errors},     {"steps", shadows_steps},
              {"times", measure_times},       {"paths", shadows_paths},
              {"polygons", shadows_polygons}, {"claims", shadows_claims},
              {"table1", shadows_table1}};
enum {
    TABLES = sizeof tables / sizeof *tables,
    TABLE_1 = 1 << (TABLES - 1) /* only if it is named */
};

const char *bench_shadows_table(const void *user, int i)
{
    (void)user;
    return i < TABLES ? tables[i].name : NULL;
}

const Option bench_shadows_options[] = {
    BENCH_UNTIMED,
    BENCH_GL,
    BENCH_INT("--triangles", triangles, "=N", 100, 4000000, "a number from 100 to 4000000",
              "about as many of a ball with bumps: 8000"),
    BENCH_TEXT("--mesh", mesh, "=FILE|NAME", "a mesh instead, a file or a name of tests/meshes"),
    BENCH_INT("--maps", maps, "=TEXELS", 16, 8192, "a number from 16 to 8192",
              "along an edge of a shadow map: 256"),
    BENCH_TEXT("--only", only, "=METHOD", "beside PCF"),
    BENCH_TEXT("--plot", plot, "=BASENAME", "charts beside the table"),
    BENCH_FLAG("--quick", quick, "polygons: times of few alone"),
    BENCH_HELP,
};

static bool open_mesh(const BenchOptions *options, Shape *made)
{
    char error[4096];
    if (!options->mesh)
        return shadows_ball(options->triangles ? options->triangles : 8000, made) ||
               fputs("matbench: out of memory\n", stderr) < 0;
    char *known = meshes_path(options->mesh);
    const bool fine = model_read(known ? known : options->mesh, made, error, sizeof error);
    if (!fine)
        fprintf(stderr, "matbench: %s%s\n", error,
                strpbrk(options->mesh, "./")
                    ? ""
                    : "; sh tests/meshes/fetch.sh BUILD_FOLDER fetches those with a name");
    free(known);
    return fine;
}

/* Keeps none, PCF, and the methods with that name in a light's `shadows:`. */
static bool keep_only(const char *name, Shadows *s)
{
    int count = 0, pcf = 0;
    bool found = !name;
    for (int i = 0; i < s->method_count; i++) {
        const bool named = !name || !strcmp(scene_shadows_name(s->methods[i].shadows), name);
        found |= named;
        if (i == s->pcf)
            pcf = count;
        if (i == 0 || i == s->pcf || named)
            s->methods[count++] = s->methods[i];
    }
    s->method_count = count;
    s->pcf = pcf;
    return found || fprintf(stderr, "matbench: no light casts shadows by '%s'\n", name) < 0;
}

int bench_shadows(const BenchOptions *options)
{
    const unsigned chosen =
        options->tables ? options->tables : ((1u << TABLES) - 1) & ~(unsigned)TABLE_1;
    char error[4096];
    Shadows s = {.timed = options->timed,
                 .quick = options->quick,
                 .map_size = options->maps ? options->maps : 256,
                 .plot = options->plot};
    matc_options_init(&s.compile);
    s.compile.pixels = true;
    if (!open_mesh(options, &s.mesh))
        return 1;
    s.gl = gl_open(options->timed ? options->gl : GL_KIND_osmesa, true, error, sizeof error);
    bool fine = s.gl || fprintf(stderr, "matbench: %s\n", error) < 0;
    s.method_count = shadows_methods(s.methods, &s.pcf);
    fine = fine && keep_only(options->only, &s);
    if (fine && options->timed)
        printf("%s, ", s.gl->renderer);
    if (fine)
        printf("%d triangles\n", s.mesh.index_count / 3);
    for (int i = 0; fine && i < TABLES; i++)
        fine = !(chosen >> i & 1) || tables[i].measure(&s);
    gl_close(s.gl);
    shape_free(&s.mesh);
    return !fine;
}
