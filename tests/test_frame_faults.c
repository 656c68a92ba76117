/* What a driver, or the set of all materials, refuses: the material is named, and where it stands. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_draw.h"
#include <stdlib.h>
#include <string.h>

/* One white pixel. */
static char *read_picture(void *user, const char *path, size_t *size, const char **why)
{
    static const unsigned char picture[] = {
        0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44, 0x52, 0x00,
        0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3A, 0x7E, 0x9B, 0x55, 0x00,
        0x00, 0x00, 0x0A, 0x49, 0x44, 0x41, 0x54, 0x78, 0xDA, 0x63, 0xF8, 0x0F, 0x00, 0x01, 0x01, 0x01, 0x00,
        0x1C, 0xB0, 0x8C, 0x99, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
    (void)user, (void)path, (void)why;
    char *bytes = malloc(sizeof picture);
    *size = sizeof picture;
    return bytes ? memcpy(bytes, picture, sizeof picture) : NULL;
}

static const char text[] = "materials:\n"
                           "  plain: { material: Phong }\n"
                           "  busy: { material: Phong, diffuse: { map: ImageMap, image: a.png }, specular: { map: "
                           "ImageMap, image: b.png, bilinearFiltering: false } }\n"
                           "objects: [{ object: Box, material: plain }, { object: Sphere, material: busy }]\n";

/* What is said where `units` textures have room, with that layout. */
static void assert_refused(int units, const char *layout, const char *said)
{
    MatcDocument *document;
    MatcOptions options;
    GlContext *gl = frame_context();
    matc_options_init(&options);
    options.read_file = read_picture;
    Scene *scene = frame_scene(text, &options, &document);
    options.layout = layout;
    gl->max_texture_units = units;
    Render *render = render_open(gl, &(RenderOptions){.compile = &options});
    assert_non_null(render);
    assert_false(render_scene(render, scene));
    if (strncmp(gl->error, said, strlen(said)) != 0)
        fail_msg("%s", gl->error);
    render_close(render);
    gl_close(gl);
    frame_forget(scene, document);
}

static void materials_are_named(void **state)
{
    (void)state;
    assert_refused(1, NULL, "scene.yaml:3:21: the material 'busy': it has 2 textures, and the driver room for 1");
    assert_refused(32, "none", "scene.yaml:2:22: the material 'plain': ");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(materials_are_named)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
