/* Silhouette shadows of a changing scene, with other lights, with glass, and on drivers without
 * the needed features. */
/* ctest: seconds=25 */
#include "tests/test.h"
#include "tests/frame/frame_change.h"
#include "tests/frame/shadow_scene.h"
#include <stdlib.h>

static const char mixed[] = SHADOW_SCENE_MIXED("shadowMaps: { size: 64 }\n", "silhouette", "", "");

static void changes(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = shadow_scene_mixed(mixed, ".5", &options, &document);
    frame_change_moves(gl, &(RendererOptions){.compile = &options, .view = "light"}, scene,
                       &(FrameMoves){3.25, 1, 0, -.5}); /* maps are fitted to the object */
    frame_forget(scene, document);
    gl_close(gl);
}

/* A moved opaque object changes the visible triangles, without a recount. */
static void microfacets(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light", .opaque = true};
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = shadow_scene_mixed(mixed, ".5", &options, &document);
    Renderer *renderer = renderer_open(gl, &how);
    assert_true(renderer && renderer_set_scene(renderer, scene));
    free(frame_change_next(renderer));
    scene->objects[1].world_from_local.m[12] += .5;
    assert_true(renderer_changed_objects(renderer, 1, 1));
    frame_change_assert(gl, &how, renderer, scene);
    renderer_close(renderer);
    frame_forget(scene, document);
    gl_close(gl);
}

/* Transparent objects color light by the maps. */
static void glass(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    shadow_scene_assert_glass(gl, mixed);
    gl_close(gl);
}

static void older_drivers(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    shadow_scene_assert_refused(gl, mixed,
                                "shadows: silhouette takes OpenGL 4.5, and the driver has 3.3");
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(changes), cmocka_unit_test(microfacets),
                                       cmocka_unit_test(glass), cmocka_unit_test(older_drivers)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
