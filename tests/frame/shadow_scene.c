#include "tests/frame/shadow_scene.h"
#include "tests/frame_reference/shadow_ray.h"
#include "tests/test.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 6144 };

const ShadowLamp shadow_lamps[SHADOW_LAMPS] = {
    {"Directional", false, true, 6},
    {"Spot, innerAngle: 30, outerAngle: 45", true, true, 6},
    {"Spot, innerAngle: 80, outerAngle: 100", true, true, 6},
    {"Point", true, false, 6},
    {"Point", true, false, 1.8}, /* placed among the objects */
};

Scene *shadow_scene(const ShadowScene *from, const MatcOptions *options, MatcDocument **document)
{
    char text[TEXT], place[128] = "", direction[128] = "";
    double at[3];
    shadow_place(from->angle, from->lamp->distance, at);
    if (from->lamp->placed)
        snprintf(place, sizeof place, ", position: [%g, %g, %g]", at[0], at[1], at[2]);
    if (from->lamp->directed)
        snprintf(direction, sizeof direction, ", direction: [%g, %g, %g]", -at[0], -at[1], -at[2]);
    snprintf(text, sizeof text,
             "%s" SHADOW_SCENE_VIEW "lights: [{ light: %s%s%s, shadows: %s }]\n%s%s", from->head,
             from->lamp->kind, place, direction, from->method, from->objects[0], from->objects[1]);
    return frame_scene(text, options, document);
}

Scene *shadow_scene_mixed(const char *mixed, const char *through, const MatcOptions *options,
                          MatcDocument **document)
{
    char text[TEXT];
    const char *const hole = strstr(mixed, "%s");
    assert_non_null(hole);
    snprintf(text, sizeof text, "%.*s%s%s", (int)(hole - mixed), mixed, through, hole + 2);
    return frame_scene(text, options, document);
}

void shadow_scene_assert_glass(GlContext *gl, const char *mixed)
{
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    MatcDocument *documents[2];
    Scene *scenes[2];
    float *pictures[2];
    int darker = 0, twice = 0, alike = 0;
    for (int i = 0; i < 2; i++) {
        scenes[i] = shadow_scene_mixed(mixed, i ? ".5" : "1", &options, &documents[i]);
        scenes[i]->light_count = 1;
        pictures[i] = frame_floats(gl, scenes[i], &how);
    }
    for (int i = 0; i < scenes[0]->width * scenes[0]->height; i++) {
        const float clear = pictures[0][4 * i], dim = pictures[1][4 * i];
        assert_true(dim <= clear * 1.001f && dim >= .25f * clear * .999f);
        darker += fabsf(dim - .5f * clear) < 1e-3f * clear;
        twice += fabsf(dim - .25f * clear) < 1e-3f * clear;
        alike += dim == clear && clear > .01f;
    }
    print_message("%d darker, %d twice, %d alike\n", darker, twice, alike);
    assert_true(darker > 25 && twice > 8 && alike > 1000);
    for (int i = 0; i < 2; i++) {
        free(pictures[i]);
        frame_forget(scenes[i], documents[i]);
    }
}

void shadow_scene_assert_refused(GlContext *gl, const char *mixed, const char *message)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = shadow_scene_mixed(mixed, ".5", &options, &document);
    gl->major = gl->minor = 3;
    Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = &options});
    assert_non_null(renderer);
    assert_false(renderer_set_scene(renderer, scene));
    assert_non_null(strstr(gl->error, message));
    renderer_close(renderer);
    frame_forget(scene, document);
}
