/* Steps of a moving light: counts pixels that wrongly change from lit to dark and back, or from
 * dark to lit and back (tests/frame/flicker.h). */
#include "shadows.h"
#include "shadows_error.h"
#include "tests/bench/matbench.h"
#include "tests/frame/flicker.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 24 /* steps of half a degree around the vertical */, EDGE = 128 };

/* A renderer with shadows and one without, and their pictures. */
typedef struct {
    Scene *scene;
    Renderer *renders[2];
    float *pictures[2];
} Walk;

static bool open_walk(const ShadowsTarget *target, Walk *walk)
{
    bool fine = true;
    for (int i = 0; fine && i < 2; i++) {
        const RendererOptions options = {.compile = target->compile,
                                         .view = "light",
                                         .width = target->edge,
                                         .height = target->edge,
                                         .no_shadows = i > 0};
        walk->renders[i] = renderer_open(target->gl, &options);
        walk->pictures[i] = malloc(4 * sizeof(float) * (size_t)target->edge * (size_t)target->edge);
        fine = walk->renders[i] && walk->pictures[i] &&
               renderer_set_scene(walk->renders[i], walk->scene);
    }
    return fine;
}

static void close_walk(Walk *walk)
{
    for (int i = 0; i < 2; i++) {
        renderer_close(walk->renders[i]);
        free(walk->pictures[i]);
    }
}

static bool draw(Walk *walk)
{
    bool fine = true;
    for (int i = 0; fine && i < 2; i++)
        fine = renderer_changed(walk->renders[i], RENDERER_LIGHTS) &&
               renderer_frame(walk->renders[i]) &&
               renderer_read(walk->renders[i], walk->pictures[i]);
    return fine;
}

static void turn(double direction[3])
{
    const double angle = 3.14159265358979323846 / 360, x = direction[0], y = direction[1];
    direction[0] = cos(angle) * x - sin(angle) * y;
    direction[1] = sin(angle) * x + cos(angle) * y;
}

/* Records every pixel of a scene by one method, and restores the light. Returns false after a
 * message on standard error; *made is empty then. */
static bool walk(const ShadowsTarget *target, const ShadowsPlace *place,
                 const ShadowsMethod *method, Flicker *made)
{
    Walk walks = {.scene = place->scene};
    double *const direction = walks.scene->lights[0].direction;
    double before[3];
    memcpy(before, direction, sizeof before);
    shadows_use(walks.scene, method, target->map_size);
    bool fine = flicker_open(target->edge * target->edge, made) && open_walk(target, &walks);
    for (int i = 0; fine && i < STEPS; i++) {
        turn(direction);
        fine = draw(&walks);
        if (fine)
            flicker_add_pictures(made, walks.pictures[0], walks.pictures[1]);
    }
    memcpy(direction, before, sizeof before);
    close_walk(&walks);
    if (!fine) {
        fprintf(stderr, "matbench: %s\n", target->gl->error);
        flicker_close(made);
    }
    return fine;
}

/* Counts flickers for each method, compared with exact shadows. */
static bool count(const Shadows *s, ShadowsScene which, long flickers[SHADOWS_METHODS_MAX],
                  long *turns)
{
    const ShadowsTarget target = {s->gl, &s->compile, EDGE, s->map_size};
    ShadowsPlace place;
    Flicker truth = {0};
    bool fine = shadows_open(which, &s->mesh, &s->compile, &place) &&
                walk(&target, &place, &shadows_truth, &truth);
    *turns = fine ? flicker_turns(&truth) : 0;
    for (int i = 1; fine && i < s->method_count; i++) {
        Flicker made;
        bench_show(s->methods[i].name[0]);
        fine = walk(&target, &place, &s->methods[i], &made);
        flickers[i] = fine ? flicker_count(&made, &truth) : 0;
        flicker_close(&made);
    }
    bench_show("");
    flicker_close(&truth);
    shadows_close(&place);
    return fine;
}

static void put_row(const char *const name[2], const long *const numbers[SHADOWS_RECEIVERS], int at)
{
    printf("%-9s %-9s", name[0], name[1]);
    for (int i = 0; i < SHADOWS_RECEIVERS; i++)
        printf(" %11ld", numbers[i][at]);
    putchar('\n');
}

bool shadows_steps(const Shadows *s)
{
    static long flickers[SHADOWS_RECEIVERS][SHADOWS_METHODS_MAX];
    const long *rows[SHADOWS_RECEIVERS];
    for (int i = 0; i < SHADOWS_RECEIVERS; i++) {
        if (!count(s, (ShadowsScene)i, flickers[i], &flickers[i][0]))
            return false;
        rows[i] = flickers[i];
    }
    printf("\nsteps: pixels that turned from lit to dark and back, or the other way round, and "
           "should not have, in %d "
           "steps of the light\n%-19s",
           STEPS, "shadows on");
    for (int i = 0; i < SHADOWS_RECEIVERS; i++)
        printf(" %11s", shadows_receivers[i]);
    putchar('\n');
    put_row((const char *const[2]){"all", "turns"}, rows, 0);
    for (int method = 1; method < s->method_count; method++)
        put_row(s->methods[method].name, rows, method);
    fflush(stdout);
    return true;
}
