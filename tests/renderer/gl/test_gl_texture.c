/* Textures of the GL layer on a software driver: their texels, sRGB codes, footprints.
 * test_gl_texture egl: by EGL, whose drivers take more anisotropic samples; exit status 77
 * without EGL. */
#include "tests/test.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "runtime/gl/texture.h"
#include "tests/gl_texts.h"
#include <math.h>
#include <string.h>

/* Looks a texture up at (u, v). */
static void look_up(GlContext *gl, const TextureSpec *spec, const float uv[2], float rgba[4])
{
    static const char fragment[] =
        "#version 330 core\nuniform sampler2D image; uniform vec2 at; out vec4 c;"
        "void main() { c = texture(image, at); }";
    GLuint program =
        program_make(gl, &(ProgramText){.vertex = {languages[1].vertex}, .fragment = {fragment}});
    GLuint texture = texture_make(gl, spec);
    Framebuffer target;
    Mesh plane;
    assert_true(program && texture);
    assert_true(mesh_make(gl, SHAPE_plane, &plane));
    assert_true(framebuffer_make(gl, &(FramebufferSpec){1, 1, 1, GL_RGBA32F, false}, &target));
    texture_bind(gl, texture, 3);
    assert_true(set(gl, program, "image", &(float){3}));
    assert_true(set(gl, program, "at", uv));
    mesh_draw(gl, &plane);
    assert_true(framebuffer_read(gl, &target, 0, rgba));
    framebuffer_delete(gl, &target);
    mesh_delete(gl, &plane);
    gl->DeleteTextures(1, &texture);
    gl->DeleteProgram(program);
}

static void textures_keep_their_numbers(void **state)
{
    (void)state;
    GlContext *gl = open_context(true);
    const float floats[3] = {-2, 0.1f, 1e6f};
    const uint8_t bytes[2 * 4] = {0, 51, 102, 255, 255, 204, 153, 0};
    float found[4];
    look_up(gl, &(TextureSpec){.width = 3, .height = 1, .components = 1, .floats = floats},
            (float[]){5, 0.5f}, found);
    assert_true(found[0] == 1e6f); /* clamped */
    look_up(gl,
            &(TextureSpec){
                .width = 3, .height = 1, .components = 1, .floats = floats, .wrap = GL_REPEAT},
            (float[]){4.1f, 0.5f}, found);
    assert_true(found[0] == -2); /* repeated */
    look_up(gl, &(TextureSpec){.width = 1, .height = 2, .components = 4, .bytes = bytes},
            (float[]){0.5f, 0.25f}, found);
    assert_float_equal(found[1], 0.2, 1e-6); /* row 0 is the bottom */
    look_up(
        gl,
        &(TextureSpec){.width = 1, .height = 2, .components = 4, .bytes = bytes, .linear = true},
        (float[]){0.5f, 0.5f}, found);
    assert_float_equal(found[0], 0.5, 1e-2); /* the middle between */
    gl_close(gl);
}

/* All codes of an sRGB texture, by the driver, against IEC 61966-2-1: tests/bounds.def states the
 * worst, and no mix of texels errs by more. */
static void every_code_of_srgb_is_decoded(void **state)
{
    (void)state;
    enum { CODES = 256 };
    const double stated = 1.3e-3;
    static const char fragment[] =
        "#version 330 core\nuniform sampler2D image; out vec4 c;"
        "void main() { c = texelFetch(image, ivec2(gl_FragCoord.xy), 0); }";
    GlContext *gl = open_context(true);
    uint8_t texels[CODES * 4];
    float rgba[CODES * 4];
    Framebuffer target;
    Mesh plane;
    double worst = 0;
    int at = 0;
    for (int i = 0; i < CODES * 4; i++)
        texels[i] = (uint8_t)(i / 4);
    GLuint program =
        program_make(gl, &(ProgramText){.vertex = {languages[1].vertex}, .fragment = {fragment}});
    GLuint texture = texture_make(gl, &(TextureSpec){.width = CODES,
                                                     .height = 1,
                                                     .components = 4,
                                                     .bytes = texels,
                                                     .format = texture_format("SRGB8_ALPHA8")});
    assert_true(program && texture);
    assert_true(mesh_make(gl, SHAPE_plane, &plane));
    assert_true(framebuffer_make(gl, &(FramebufferSpec){CODES, 1, 1, GL_RGBA32F, false}, &target));
    texture_bind(gl, texture, 0);
    assert_true(set(gl, program, "image", &(float){0}));
    mesh_draw(gl, &plane);
    assert_true(framebuffer_read(gl, &target, 0, rgba));
    for (int code = 0; code < CODES; code++) {
        const double v = code / 255.,
                     linear = v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
        for (int component = 0; component < 4; component++) {
            const double off =
                fabs((double)rgba[4 * code + component] - (component == 3 ? v : linear));
            at = off > worst ? code : at;
            worst = fmax(worst, off);
        }
    }
    print_message("%s: sRGB codes err by %.2e, most at %d\n", gl->renderer, worst, at);
    assert_true(worst <= stated);
    framebuffer_delete(gl, &target);
    mesh_delete(gl, &plane);
    gl->DeleteTextures(1, &texture);
    gl->DeleteProgram(program);
    gl_close(gl);
}

/* Stripes of four texels at a grazing angle, so that a pixel covers a quarter of a texel across
 * them and 16 along: returns the range of the pixels' values. */
static double contrast(GlContext *gl, int anisotropy)
{
    enum { SIDE = 64, STRIPE = 4 };
    static const char fragment[] =
        "#version 330 core\nuniform sampler2D image; out vec4 c;"
        "void main() { c = texture(image, gl_FragCoord.xy * vec2(0.25, 16) / 64.); }";
    static uint8_t texels[SIDE * SIDE];
    static float rgba[SIDE * SIDE * 4];
    Framebuffer target;
    Mesh plane;
    for (int i = 0; i < SIDE * SIDE; i++)
        texels[i] = i % SIDE / STRIPE % 2 ? 255 : 0;
    GLuint program =
        program_make(gl, &(ProgramText){.vertex = {languages[1].vertex}, .fragment = {fragment}});
    GLuint texture = texture_make(gl, &(TextureSpec){.width = SIDE,
                                                     .height = SIDE,
                                                     .components = 1,
                                                     .bytes = texels,
                                                     .wrap = GL_REPEAT,
                                                     .mipmaps = true,
                                                     .anisotropy = anisotropy});
    assert_true(program && texture);
    assert_true(mesh_make(gl, SHAPE_plane, &plane));
    assert_true(
        framebuffer_make(gl, &(FramebufferSpec){SIDE, SIDE, 1, GL_RGBA32F, false}, &target));
    texture_bind(gl, texture, 0);
    assert_true(set(gl, program, "image", &(float){0}));
    mesh_draw(gl, &plane);
    assert_true(framebuffer_read(gl, &target, 0, rgba));
    float low = 1, high = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        low = fminf(low, rgba[4 * i]);
        high = fmaxf(high, rgba[4 * i]);
    }
    framebuffer_delete(gl, &target);
    mesh_delete(gl, &plane);
    gl->DeleteTextures(1, &texture);
    gl->DeleteProgram(program);
    return high - low;
}

/* A footprint of 1 : 64. One sample is from mipmap 4, where no stripe is left; 16 of them are from
 * mipmap 0. */
static void footprints_are_sampled_along(void **state)
{
    char error[512] = "";
    GlContext *gl = gl_open(GL_KIND_egl, true, error, sizeof error);
    if (!gl)
        fail_msg("%s", error);
    const int most = gl->max_anisotropy;
    const double one = contrast(gl, 1), all = contrast(gl, 16);
    print_message("%s: %d samples; contrast of one %.3f, of all %.3f\n", gl->renderer, most, one,
                  all);
    gl_close(gl);
    assert_true(one < 0.1);
    if (most >= 16)
        assert_true(all > 0.9);
    else
        print_message(
            "SKIPPED: this driver takes no 16 samples along a footprint, so none was drawn\n");
    **(bool **)state = most < 16;
}

int main(int count, char **arguments)
{
    bool skipped = false;
    const struct CMUnitTest egl[] = {
        cmocka_unit_test_prestate(footprints_are_sampled_along, &skipped)};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(textures_keep_their_numbers),
        cmocka_unit_test(every_code_of_srgb_is_decoded),
    };
    if (count < 2 || strcmp(arguments[1], "egl") != 0)
        return cmocka_run_group_tests(tests, NULL, NULL);
    if (!has_egl())
        return SKIPPED;
    const int failed = cmocka_run_group_tests(egl, NULL, NULL);
    return !failed && skipped ? SKIPPED : failed;
}
