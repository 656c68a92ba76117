/* The bridge from a MatcProgram to GL: shared objects exist once, a material's own objects stay
 * separate, constants are updated in their buffer, blocks are filled in the driver's layout, and
 * a failure is reported and leaks nothing. */
#include "tests/test.h"
#include "runtime/gpu_material/field.h"
#include "runtime/gpu_material/reader.h"
#include "runtime/gpu_material/screen_pass.h"
#include "runtime/gl/screen.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    GlContext *gl;
    Store *store;
    Screen screen;
    Framebuffer pixel; /* a single one, of RGBA32F */
} Fixture;

static Fixture open_fixture(bool core)
{
    char error[512] = "";
    Fixture f = {.gl = gl_open(GL_KIND_osmesa, core, error, sizeof error)};
    if (!f.gl)
        fail_msg("%s", error);
    f.store = store_new(f.gl);
    assert_non_null(f.store);
    assert_true(screen_make(f.gl, &f.screen));
    assert_true(framebuffer_make(f.gl, &(FramebufferSpec){1, 1, 1, GL_RGBA32F, false}, &f.pixel));
    return f;
}

static void close_fixture(Fixture *f)
{
    assert_int_equal(store_program_count(f->store), 0);
    assert_int_equal(store_texture_count(f->store), 0);
    assert_true(gl_check(f->gl, "all of it"));
    store_free(f->store);
    gl_close(f->gl);
}

typedef struct {
    MatcDocument *document;
    MatcProgram *program;
} Compiled;

/* Compiles the pass value: the diffuse color alone. */
static Compiled compile_by(const char *text, MatcOptions *options)
{
    options->pass = "value";
    options->pixels = true;
    MatcDocument *document =
        matc_read(SOURCE_FOLDER "/examples/test.yaml", text, strlen(text), options);
    if (matc_material_count(document) != 1)
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, options);
    if (!matc_ok(program))
        fail_msg("%s", matc_program_diagnostics(program, MATC_TEXT));
    return (Compiled){document, program};
}

static Compiled compile(const char *text, const char *target, const char *constants)
{
    MatcOptions options;
    matc_options_init(&options);
    options.target = target;
    options.constants = constants;
    return compile_by(text, &options);
}

static Compiled compile_filtered(const char *text, const char *aa)
{
    MatcOptions options;
    matc_options_init(&options);
    options.aa = aa;
    return compile_by(text, &options);
}

static void discard(const Compiled *compiled)
{
    matc_program_free(compiled->program);
    matc_document_free(compiled->document);
}

/* Compiles the fragment program with a full-screen vertex program. */
static Material make(Fixture *f, MatcProgram *program, const char *version)
{
    Material made;
    const bool old = !strcmp(version, "#version 110\n");
    const ProgramText text = {.vertex = {version, old ? screen_text_old : screen_text}};
    if (!material_make(f->store, program, &text, &made))
        fail_msg("%s", f->gl->error);
    return made;
}

static void draw(Fixture *f, Material *material, float rgba[4])
{
    framebuffer_use(f->gl, &f->pixel);
    material_use(material);
    screen_draw(f->gl, &f->screen);
    assert_true(framebuffer_read(f->gl, &f->pixel, 0, rgba));
}

static void assert_draws(Fixture *f, Material *material, float red, float green, float blue)
{
    float rgba[4], want[3] = {red, green, blue};
    draw(f, material, rgba);
    for (int component = 0; component < 3; component++)
        if (!(fabsf(rgba[component] - want[component]) < 1e-6f))
            fail_msg("(%g, %g, %g), not (%g, %g, %g)", rgba[0], rgba[1], rgba[2], red, green, blue);
}

static const char core_version[] = "#version 330 core\n";

static void what_is_alike_is_there_once(void **state)
{
    (void)state;
    Fixture f = open_fixture(true);
    static const char *const texts[] = {
        "{ material: Phong, diffuse: { map: ImageMap, image: tiles.png } }",
        "{ material: Phong, diffuse: { map: ImageMap, image: tiles.png } }",
        "{ material: Phong, diffuse: { map: ImageMap, image: tiles.png, input: { map: UVTransform, "
        "scaleU: 2 } } }",
        "{ material: Phong, diffuse: 0.25 }",
    };
    Material materials[4];
    const int programs[] = {1, 1, 2, 3}, textures[] = {1, 1, 1, 1};
    for (int i = 0; i < 4; i++) {
        Compiled compiled = compile(texts[i], "glsl330", NULL);
        if (!field_material(f.store, compiled.program, &(FieldText){.target = TARGET_glsl330},
                            &materials[i]))
            fail_msg("%s", f.gl->error);
        discard(&compiled); /* nothing of it is kept */
        assert_int_equal(store_program_count(f.store), programs[i]);
        assert_int_equal(store_texture_count(f.store), textures[i]);
    }
    assert_ptr_equal(materials[0].textures[0], materials[2].textures[0]);
    material_delete(&materials[0]);
    assert_int_equal(store_program_count(f.store), 3); /* the second one draws with it */
    material_delete(&materials[1]);
    assert_int_equal(store_program_count(f.store), 2);
    assert_int_equal(store_texture_count(f.store), 1);
    material_delete(&materials[2]);
    assert_int_equal(store_texture_count(f.store), 0);
    material_delete(&materials[3]);
    material_delete(&materials[3]); /* of an empty one it is nothing */
    close_fixture(&f);
}

/* A program that two share holds the plain uniforms of who drew last. */
static void uniforms_are_a_materials_own(void **state)
{
    (void)state;
    static const char text[] =
        "{ material: Phong, diffuse: { param: tint, default: [0.25, 0.5, 0.75] } }";
    static const float red[3] = {1, 0, 0}, black[3] = {0, 0, 0};
    Fixture f = open_fixture(true);
    Compiled compiled = compile(text, "glsl330", NULL);
    Material one = make(&f, compiled.program, core_version),
             two = make(&f, compiled.program, core_version);
    assert_int_equal(store_program_count(f.store), 1);
    assert_draws(&f, &one, 0.25f, 0.5f, 0.75f);
    assert_true(material_set(&two, &(MaterialValue){"tint", 3, red}));
    assert_draws(&f, &two, 1, 0, 0);
    assert_draws(&f, &one, 0.25f, 0.5f, 0.75f);
    assert_draws(&f, &two, 1, 0, 0);
    /* also what GL begins with */
    assert_true(material_set(&one, &(MaterialValue){"tint", 3, black}));
    assert_draws(&f, &one, 0, 0, 0);
    assert_draws(&f, &two, 1, 0, 0);
    assert_false(material_set(&two, &(MaterialValue){"tint", 4, red}));
    assert_false(material_set_number(&two, "absent", 1));
    assert_draws(&f, &two, 1, 0, 0);
    material_delete(&one);
    material_delete(&two);
    discard(&compiled);
    close_fixture(&f);
}

/* -- buffers, counted */

static PFNGLGENBUFFERSPROC gen_buffers;
static PFNGLBUFFERDATAPROC buffer_data;
static PFNGLBUFFERSUBDATAPROC buffer_sub_data;
static int made_buffers, filled_buffers, changed_buffers;

static void count_made(GLsizei count, GLuint *names)
{
    made_buffers += count, gen_buffers(count, names);
}

static void count_filled(GLenum target, GLsizeiptr size, const void *bytes, GLenum usage)
{
    filled_buffers++;
    buffer_data(target, size, bytes, usage);
}

static void count_changed(GLenum target, GLintptr from, GLsizeiptr size, const void *bytes)
{
    changed_buffers++;
    buffer_sub_data(target, from, size, bytes);
}

static void count_buffers(GlContext *gl)
{
    gen_buffers = gl->GenBuffers, buffer_data = gl->BufferData, buffer_sub_data = gl->BufferSubData;
    gl->GenBuffers = count_made, gl->BufferData = count_filled, gl->BufferSubData = count_changed;
    made_buffers = filled_buffers = changed_buffers = 0;
}

static void assert_buffers(int made, int filled, int changed)
{
    assert_int_equal(made_buffers, made);
    assert_int_equal(filled_buffers, filled);
    assert_int_equal(changed_buffers, changed);
}

/* Constants in GLSL 1.10, where they are plain uniforms. */
static void numbers_change_in_place(void **state)
{
    (void)state;
    static const char *const targets[] = {"glsl110", "glsl330", "glsl450"};
    static const char *const versions[] = {"#version 110\n", "#version 330 core\n",
                                           "#version 450 core\n"};
    for (int i = 0; i < 3; i++) {
        Fixture f = open_fixture(i > 0);
        const int blocks = i > 0;
        Compiled one =
            compile("{ material: Phong, diffuse: [0.1, 0.2, 0.3] }", targets[i], "uniform");
        Compiled two =
            compile("{ material: Phong, diffuse: [0.9, 0.8, 0.7] }", targets[i], "uniform");
        assert_true(matc_constant_count(one.program) > 0);
        Material material = make(&f, one.program, versions[i]);
        count_buffers(f.gl);
        assert_draws(&f, &material, 0.1f, 0.2f, 0.3f);
        assert_buffers(blocks, blocks, 0);
        assert_draws(&f, &material, 0.1f, 0.2f, 0.3f);
        assert_buffers(blocks, blocks, 0); /* unchanged values are not uploaded */
        assert_true(material_set_numbers(&material, two.program));
        assert_draws(&f, &material, 0.9f, 0.8f, 0.7f);
        assert_buffers(blocks, blocks, blocks);
        material_delete(&material);
        discard(&one);
        discard(&two);
        close_fixture(&f);
    }
}

/* -- anisotropy, which Mesa's software drivers have none of: the calls that are made of a driver
 * that has it */

static PFNGLTEXPARAMETERIPROC set_parameter;
static int anisotropy_calls;
static GLint anisotropy;

static void record_parameter(GLenum target, GLenum name, GLint value)
{
    if (name == GL_TEXTURE_MAX_ANISOTROPY)
        anisotropy_calls++, anisotropy = value;
    else
        set_parameter(target, name, value);
}

/* A picture requests 16 anisotropic samples by default, 1 along the pixel's own footprint; the
 * driver's maximum limits the request. */
static void anisotropy_is_what_the_driver_has(void **state)
{
    (void)state;
    static const struct {
        const char *aa;
        int most, calls;
        GLint set;
    } cases[] = {{NULL, 1, 0, 0},   {NULL, 2, 1, 2},   {NULL, 8, 1, 8},   {NULL, 16, 1, 16},
                 {NULL, 64, 1, 16}, {"box", 64, 0, 0}, {"none", 64, 0, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Fixture f = open_fixture(true);
        assert_int_equal(f.gl->max_anisotropy, 1); /* of software */
        Compiled compiled = compile_filtered(
            "{ material: Phong, diffuse: { map: ImageMap, image: tiles.png } }", cases[i].aa);
        set_parameter = f.gl->TexParameteri;
        f.gl->TexParameteri = record_parameter;
        f.gl->max_anisotropy = cases[i].most;
        anisotropy_calls = 0, anisotropy = 0;
        Material material;
        if (!field_material(f.store, compiled.program, &(FieldText){.target = TARGET_glsl330},
                            &material))
            fail_msg("%s", f.gl->error);
        assert_int_equal(anisotropy_calls, cases[i].calls);
        assert_int_equal(anisotropy, cases[i].set);
        material_delete(&material);
        discard(&compiled);
        close_fixture(&f);
    }
}

/* Every type that matc writes into a block, at the driver's offsets; bytes around a member stay
 * unchanged. */
static void blocks_hold_every_type(void **state)
{
    (void)state;
    static const char fragment[] = "layout(std140) uniform Block { float a; mat3 m; int b; vec2 c; "
                                   "uint d; bool e; mat4 n; vec3 f; };\n"
                                   "uniform vec4 weights;\nlayout(location = 0) out vec4 color;\n"
                                   "void main() { color = vec4(a + float(b) + float(d) + (e ? 1. : "
                                   "0.), c.x + c.y, (m * f).y, (n * weights).z); "
                                   "}\n";
    static const float m[9] = {1, 2, 3, 4, 5, 6, 7, 8, 9}, c[2] = {0.25f, 0.5f},
                       e[3] = {10, 100, 1000};
    static const float n[16] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16},
                       w[4] = {1, 10, 100, 1000};
    Fixture f = open_fixture(true);
    Material material;
    float rgba[4];
    const ProgramText text = {.vertex = {core_version, screen_text},
                              .fragment = {core_version, fragment}};
    assert_true(material_make(f.store, NULL, &text, &material));
    const MaterialValue values[] = {
        {"n", 16, n}, {"f", 3, e}, {"m", 9, m}, {"c", 2, c}, {"weights", 4, w}};
    for (size_t i = 0; i < sizeof values / sizeof *values; i++)
        assert_true(material_set(&material, &values[i]));
    assert_true(material_set_number(&material, "a", 0.125f) &&
                material_set_number(&material, "b", -7));
    assert_true(material_set_number(&material, "d", 65536) &&
                material_set_number(&material, "e", 1));
    draw(&f, &material, rgba);
    assert_true(rgba[0] == 0.125f - 7 + 65536 + 1);
    assert_true(rgba[1] == 0.75f);
    assert_true(rgba[2] == 2 * 10 + 5 * 100 + 8 * 1000);           /* row 1 of m, by columns */
    assert_true(rgba[3] == 3 * 1 + 7 * 10 + 11 * 100 + 15 * 1000); /* row 2 of n */
    assert_false(material_write(&material, "None", m, sizeof m));
    /* more than it holds: as much as it does */
    assert_true(material_write(&material, "Block", (char[8192]){0}, 8192));
    draw(&f, &material, rgba);
    assert_true(rgba[0] == 0 && rgba[1] == 0 && rgba[2] == 0 && rgba[3] == 0);
    material_delete(&material);
    close_fixture(&f);
}

static void faults_leave_nothing(void **state)
{
    (void)state;
    Fixture f = open_fixture(true);
    Material material;
    Framebuffer none;
    Reader reader;
    const char *const formats[] = {"RGBA8", "RGBA5"};
    const FramebufferSpec two = {.width = 4, .height = 4, .color_count = 2};
    const TextureSpec wrong = {.width = 2, .height = 2, .components = 3, .bytes = (uint8_t[12]){0}};
    ProgramText text = {.vertex = {core_version, screen_text}, .fragment = {core_version, "wrong"}};
    assert_false(material_make(f.store, NULL, &text, &material));
    assert_int_equal(strncmp(f.gl->error, "fragment: ", 10), 0);
    assert_null(material.program);
    text.fragment[1] =
        "uniform sampler2D image; out vec4 c; void main() { c = texture(image, vec2(0.)); }";
    assert_true(material_make(f.store, NULL, &text, &material));
    assert_true(material_set_texture(&material, "absent", &wrong)); /* nobody asks for it */
    assert_false(material_set_texture(&material, "image", &wrong));
    assert_string_equal(f.gl->error, "a texture has 1 or 4 components, not 3");
    assert_int_equal(store_texture_count(f.store), 0);
    material_delete(&material);
    assert_false(reader_make(
        f.store, &(ReaderSource){"wrong", TARGET_glsl330, &layout_table[0], 4, 4}, &reader));
    reader_delete(&reader);
    assert_false(framebuffer_make_named(f.gl, &two, formats, &none));
    assert_string_equal(f.gl->error, "no render target can be 'RGBA5' here");
    assert_int_equal(none.name, 0);
    close_fixture(&f);
}

/* Objects left in a store are freed with it. */
static void a_store_takes_all_with_it(void **state)
{
    (void)state;
    Fixture f = open_fixture(true);
    const uint8_t texel[4] = {1, 2, 3, 4};
    const StoreItem *texture = store_texture(
        f.store, &(TextureSpec){.width = 1, .height = 1, .components = 4, .bytes = texel});
    assert_non_null(texture);
    assert_ptr_equal(
        store_texture(f.store,
                      &(TextureSpec){.width = 1, .height = 1, .components = 4, .bytes = texel}),
        texture);
    assert_ptr_not_equal(store_texture(f.store, &(TextureSpec){.width = 1,
                                                               .height = 1,
                                                               .components = 4,
                                                               .bytes = texel,
                                                               .linear = true}),
                         texture);
    assert_int_equal(store_texture_count(f.store), 2);
    store_free(f.store);
    assert_true(gl_check(f.gl, "leaving a store"));
    gl_close(f.gl);
}

/* A pass whose text has more pieces than fit is refused with a message, in every build type. */
static void too_many_pieces_are_an_error(void **state)
{
    (void)state;
    Fixture f = open_fixture(true);
    ScreenPassText text = {.format = "RGBA32F"};
    for (int i = 0; i < SCREEN_PASS_PIECES; i++)
        screen_pass_add(&text, "\n");
    assert_false(text.full);
    screen_pass_add(&text, "");
    assert_false(text.full);
    screen_pass_add(&text, "\n");
    assert_true(text.full);
    ScreenPass pass;
    assert_false(screen_pass_make(f.store, &text, &pass));
    assert_string_equal(f.gl->error, "a pass has more than 62 pieces of GLSL");
    close_fixture(&f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_alike_is_there_once),
        cmocka_unit_test(uniforms_are_a_materials_own),
        cmocka_unit_test(numbers_change_in_place),
        cmocka_unit_test(anisotropy_is_what_the_driver_has),
        cmocka_unit_test(blocks_hold_every_type),
        cmocka_unit_test(faults_leave_nothing),
        cmocka_unit_test(a_store_takes_all_with_it),
        cmocka_unit_test(too_many_pieces_are_an_error),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
