/* Makes one program per function: its chunks, and a main that reads the arguments. */
#include "call.h"
#include "compiler/emit/chunks.h"
#include <stdio.h>
#include <string.h>

enum { WIDTH = 7, HEIGHT = 5, BYTES = 4 * WIDTH * HEIGHT, SIDE = 256, RANDOM_COUNT = 512 };

/* Arbitrary bytes, and numbers around 0. */
#define ROW(a) a, 255 - a, (a * 37) % 256, (a * 91 + 13) % 256
static const uint8_t picture[BYTES] = {
    ROW(3),   ROW(250), ROW(17),  ROW(128), ROW(99),  ROW(200), ROW(64),  ROW(31),  ROW(77),
    ROW(5),   ROW(190), ROW(220), ROW(141), ROW(12),  ROW(88),  ROW(166), ROW(233), ROW(54),
    ROW(109), ROW(0),   ROW(255), ROW(70),  ROW(180), ROW(25),  ROW(133), ROW(47),  ROW(211),
    ROW(92),  ROW(158), ROW(8),   ROW(240), ROW(115), ROW(36),  ROW(174), ROW(60)};
#undef ROW
static const float relief[WIDTH * HEIGHT] = {
    0.5f,  -0.25f, 1.5f, 0.1f,   -0.7f, 0.33f, 0.9f,  -1.1f, 0.05f, 0.6f,  -0.4f, 1.25f,
    0.75f, -0.9f,  0.2f, -0.05f, 0.45f, 1.0f,  -0.6f, 0.8f,  0.15f, -1.3f, 0.7f,  0.3f,
    -0.8f, 0.55f,  1.1f, -0.2f,  0.4f,  -0.5f, 0.95f, 0.0f,  -1.0f, 0.65f, 0.25f};
const ReferenceTexture call_textures[CALL_TEXTURES] = {
    {.width = WIDTH, .height = HEIGHT, .components = 4, .bytes = picture},
    {.width = WIDTH, .height = HEIGHT, .components = 1, .floats = relief}};
/* Sets GroIMP's noise tables if the program uses them. */
static bool set_tables(Material *material)
{
    static float permutation[SIDE * SIDE], random[4 * RANDOM_COUNT];
    static uint8_t xor [SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        permutation[i] = reference_permutation()[i];
        xor[i] = (uint8_t)((i % SIDE) ^ (i / SIDE));
    }
    for (int i = 0; i < 4 * RANDOM_COUNT; i++)
        random[i] = reference_random_table()[(i / 4 + i % 4) % RANDOM_COUNT];
    const TextureSpec specs[] = {
        {.width = SIDE, .height = SIDE, .components = 1, .floats = permutation, .wrap = GL_REPEAT},
        {.width = RANDOM_COUNT, .height = 1, .components = 4, .floats = random, .wrap = GL_REPEAT},
        {.width = SIDE, .height = SIDE, .components = 1, .bytes = xor, .wrap = GL_REPEAT}};
    return material_set_texture(material, "matc_permutation", &specs[0]) &&
           material_set_texture(material, "matc_random", &specs[1]) &&
           material_set_texture(material, "matc_xor", &specs[2]);
}

/* `linear`: the function relies on the sampler's interpolation. */
static bool set_textures(Material *material, Tuple *tuples, int source, bool linear)
{
    const ReferenceTexture *t = &call_textures[source];
    return material_set_texture(material, "arguments",
                                &(TextureSpec){.width = CALL_ARGUMENTS,
                                               .height = CALL_COUNT,
                                               .components = CALL_COMPONENTS,
                                               .floats = &tuples[0][0][0]}) &&
           material_set_texture(material, "source",
                                &(TextureSpec){.width = t->width,
                                               .height = t->height,
                                               .components = t->components,
                                               .bytes = t->bytes,
                                               .floats = t->floats,
                                               .wrap = GL_REPEAT,
                                               .linear = linear}) &&
           set_tables(material);
}

static bool make_all(Caller *c)
{
    FramebufferSpec spec = {CALL_SIDE, CALL_SIDE, 1, GL_RGBA32F, false};
    c->store = store_new(c->gl);
    if (!c->store || !screen_make(c->gl, &c->screen) || !framebuffer_make(c->gl, &spec, &c->floats))
        return false;
    spec.color_format = GL_RGBA32UI;
    return framebuffer_make(c->gl, &spec, &c->words);
}

bool caller_open(Caller *c, Target target)
{
    memset(c, 0, sizeof *c);
    c->target = target;
    c->gl = gl_open(GL_KIND_osmesa, target_table[target].in_out, c->error, sizeof c->error);
    if (!c->gl)
        return false;
    if (make_all(c))
        return true;
    snprintf(c->error, sizeof c->error, "%s", c->gl->error);
    return false;
}

void caller_close(Caller *c)
{
    if (c->gl && gl_use(c->gl))
        store_free(c->store);
    gl_close(c->gl);
    c->gl = NULL;
}

static void put(Caller *c, const char *text)
{
    strncat(c->text, text, CALL_TEXT - 1 - strlen(c->text));
}

static void put_uniforms(Caller *c, const ChunkUniform *uniform)
{
    char line[128];
    for (; uniform->name; uniform++) {
        snprintf(line, sizeof line, "uniform %s %s;\n", uniform->type, uniform->name);
        put(c, line);
    }
}

bool call_gather(Caller *c, int function, const Job *job)
{
    MatcOptions options = {0};
    Arena arena = {0};
    Session compile = {.options = &options, .arena = &arena};
    Chunks chunks = {0};
    bool found = chunks_add(&compile, &chunks, function_row(function)->name, job);
    c->text[0] = 0;
    for (size_t i = 0; i < chunks.count; i++) {
        put_uniforms(c, chunks.at[i]->uniforms);
        put(c, chunks.at[i]->body);
    }
    arena_free(&arena);
    return found || gl_fail(c->gl, "no chunk %s", function_row(function)->name);
}

static void put_argument(char *text, size_t capacity, char letter, int i)
{
    static const char *const components[] = {
        ['2'] = ".xy", ['3'] = ".xyz", ['4'] = "", ['f'] = ".x"};
    const char *comma = i ? ", " : "";
    if (letter == 's')
        snprintf(text, capacity, "%ssource", comma);
    else if (letter == 'i')
        snprintf(text, capacity, "%sint(floor(argument(%d.0).x + 0.5))", comma, i);
    else
        snprintf(text, capacity, "%sargument(%d.0)%s", comma, i, components[(int)letter]);
}

/* "color = vec4(f(...), 0.0, 0.0);" */
static void put_main(Caller *c, int function)
{
    const FunctionRow *row = function_row(function);
    int components = type_table[row->result].components;
    bool words = row->result == TYPE_uint, old = !target_table[c->target].in_out;
    char text[128];
    snprintf(text, sizeof text, "void main() {\n    %s = %s(%s(", old ? "gl_FragColor" : "color",
             words ? "uvec4" : "vec4", row->name);
    put(c, text);
    const char *letters = function_arguments(function);
    for (int i = 0; letters[i]; i++) {
        put_argument(text, sizeof text, letters[i], i);
        put(c, text);
    }
    put(c, ")");
    for (int i = words ? 1 : components; i < CALL_COMPONENTS; i++)
        put(c, words ? ", 0u" : ", 0.0");
    put(c, ");\n}\n");
}

static bool make_program(Caller *c, int function, Material *made)
{
    bool old = !target_table[c->target].in_out;
    char version[32], head[1024];
    snprintf(version, sizeof version, "#version %s\n", target_table[c->target].version);
    snprintf(head, sizeof head,
             "%s%s%s\nuniform sampler2D arguments;\nuniform sampler2D source;\n"
             "vec4 argument(float i) {\n"
             "    float tuple = floor(gl_FragCoord.x) + %d.0 * floor(gl_FragCoord.y);\n"
             "    return texture2D(arguments, vec2((i + 0.5) / %d.0, (tuple + 0.5) / %d.0));\n}\n",
             old ? "" : "#define texture2D texture\nout ",
             old                                           ? ""
             : function_row(function)->result == TYPE_uint ? "uvec4"
                                                           : "vec4",
             old ? "" : " color;", CALL_SIDE, CALL_ARGUMENTS, CALL_COUNT);
    put_main(c, function);
    const ProgramText text = {.vertex = {version, old ? screen_text_old : screen_text},
                              .fragment = {version, head, c->text}};
    return material_make(c->store, NULL, &text, made);
}

static bool read_back(Caller *c, bool words, double (*results)[CALL_COMPONENTS])
{
    static float floats[CALL_COUNT][CALL_COMPONENTS];
    static GLuint numbers[CALL_COUNT][CALL_COMPONENTS];
    bool read = words ? framebuffer_read_words(c->gl, &c->words, 0, &numbers[0][0])
                      : framebuffer_read(c->gl, &c->floats, 0, &floats[0][0]);
    for (int i = 0; i < CALL_COUNT; i++)
        for (int component = 0; component < CALL_COMPONENTS; component++)
            results[i][component] =
                words ? (double)numbers[i][component] : (double)floats[i][component];
    return read;
}

static bool draw(Caller *c, int function, Tuple *tuples, double (*results)[CALL_COMPONENTS])
{
    const bool words = function_row(function)->result == TYPE_uint;
    const bool sampled = function_arguments(function)[0] == 's';
    Material material;
    gl_use(c->gl);
    if (!make_program(c, function, &material))
        return false;
    bool linear = function == FN_imageSampled || function == FN_imageCentred ||
                  function == FN_imageSampledOver;
    bool drawn = set_textures(&material, tuples, sampled ? (int)tuples[0][0][0] : 0, linear);
    framebuffer_use(c->gl, words ? &c->words : &c->floats);
    material_use(&material);
    screen_draw(c->gl, &c->screen);
    material_delete(&material);
    return drawn && gl_check(c->gl, "calling a function") && read_back(c, words, results);
}

bool call_draw(Caller *c, int function, Tuple *tuples, double (*results)[CALL_COMPONENTS])
{
    bool drawn = draw(c, function, tuples, results);
    if (!drawn)
        snprintf(c->error, sizeof c->error, "%s", c->gl->error);
    return drawn;
}
