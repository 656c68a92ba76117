/* A program a function: its chunks, and a main that reads the arguments. */
#include "call.h"
#include "compiler/emit/chunks.h"
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include <stdio.h>
#include <string.h>

enum { WIDTH = 7, HEIGHT = 5, BYTES = 4 * WIDTH * HEIGHT, SIDE = 256, RANDOM_COUNT = 512 };

/* Any bytes, and any numbers about 0. */
#define ROW(a) a, 255 - a, (a * 37) % 256, (a * 91 + 13) % 256
static const uint8_t picture[BYTES] = {ROW(3),   ROW(250), ROW(17),  ROW(128), ROW(99),  ROW(200), ROW(64),
                                       ROW(31),  ROW(77),  ROW(5),   ROW(190), ROW(220), ROW(141), ROW(12),
                                       ROW(88),  ROW(166), ROW(233), ROW(54),  ROW(109), ROW(0),   ROW(255),
                                       ROW(70),  ROW(180), ROW(25),  ROW(133), ROW(47),  ROW(211), ROW(92),
                                       ROW(158), ROW(8),   ROW(240), ROW(115), ROW(36),  ROW(174), ROW(60)};
#undef ROW
static const float relief[WIDTH * HEIGHT] = {0.5f,  -0.25f, 1.5f,  0.1f,  -0.7f, 0.33f, 0.9f,   -1.1f, 0.05f,
                                             0.6f,  -0.4f,  1.25f, 0.75f, -0.9f, 0.2f,  -0.05f, 0.45f, 1.0f,
                                             -0.6f, 0.8f,   0.15f, -1.3f, 0.7f,  0.3f,  -0.8f,  0.55f, 1.1f,
                                             -0.2f, 0.4f,   -0.5f, 0.95f, 0.0f,  -1.0f, 0.65f,  0.25f};
const ReferenceTexture call_textures[CALL_TEXTURES] = {{WIDTH, HEIGHT, 4, picture, NULL},
                                                       {WIDTH, HEIGHT, 1, NULL, relief}};
static const char *const table_names[CALL_TABLES] = {"matc_permutation", "matc_random", "matc_xor"};

static bool make_tables(Caller *c)
{
    static float permutation[SIDE * SIDE], random[4 * RANDOM_COUNT];
    static uint8_t xor [SIDE * SIDE];
    for (int i = 0; i < SIDE * SIDE; i++) {
        permutation[i] = reference_permutation()[i];
        xor[i] = (uint8_t)((i % SIDE) ^ (i / SIDE));
    }
    for (int i = 0; i < 4 * RANDOM_COUNT; i++)
        random[i] = reference_random_table()[(i / 4 + i % 4) % RANDOM_COUNT];
    const TextureSpec specs[CALL_TABLES] = {{SIDE, SIDE, 1, NULL, permutation, false, true, false},
                                            {RANDOM_COUNT, 1, 4, NULL, random, false, true, false},
                                            {SIDE, SIDE, 1, xor, NULL, false, true, false}};
    for (int i = 0; i < CALL_TABLES; i++) {
        c->tables[i] = texture_make(c->gl, &specs[i]);
        if (!c->tables[i])
            return false;
    }
    return true;
}

static bool make_textures(Caller *c)
{
    for (int i = 0; i < CALL_TEXTURES; i++) {
        const ReferenceTexture *t = &call_textures[i];
        TextureSpec spec = {t->width, t->height, t->lanes, t->bytes, t->floats, false, true, false};
        c->textures[i] = texture_make(c->gl, &spec);
        if (!c->textures[i])
            return false;
    }
    return make_tables(c);
}

static void make_triangle(Caller *c)
{
    static const float corners[] = {-1, -1, 3, -1, -1, 3};
    c->gl->GenVertexArrays(1, &c->array);
    c->gl->BindVertexArray(c->array);
    c->gl->GenBuffers(1, &c->buffer);
    c->gl->BindBuffer(GL_ARRAY_BUFFER, c->buffer);
    c->gl->BufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    c->gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, NULL);
    c->gl->EnableVertexAttribArray(0);
}

static bool make_all(Caller *c)
{
    FramebufferSpec spec = {CALL_SIDE, CALL_SIDE, 1, GL_RGBA32F, false};
    make_triangle(c);
    if (!make_textures(c) || !framebuffer_make(c->gl, &spec, &c->floats))
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
    if (c->gl)
        gl_close(c->gl);
    c->gl = NULL;
}

static void put(Caller *c, const char *text) { strncat(c->text, text, CALL_TEXT - 1 - strlen(c->text)); }

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

static void put_argument(char *text, size_t room, char letter, int i)
{
    static const char *const lanes[] = {['2'] = ".xy", ['3'] = ".xyz", ['4'] = "", ['f'] = ".x"};
    const char *comma = i ? ", " : "";
    if (letter == 's')
        snprintf(text, room, "%ssource", comma);
    else if (letter == 'i')
        snprintf(text, room, "%sint(floor(argument(%d.0).x + 0.5))", comma, i);
    else
        snprintf(text, room, "%sargument(%d.0)%s", comma, i, lanes[(int)letter]);
}

/* "color = vec4(f(...), 0.0, 0.0);" */
static void put_main(Caller *c, int function)
{
    const FunctionRow *row = function_row(function);
    int lanes = type_table[row->result].lanes;
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
    for (int i = words ? 1 : lanes; i < CALL_LANES; i++)
        put(c, words ? ", 0u" : ", 0.0");
    put(c, ");\n}\n");
}

static GLuint make_program(Caller *c, int function)
{
    bool old = !target_table[c->target].in_out;
    static const char *const attributes[] = {"at"};
    char vertex[256], head[1024];
    const char *version = target_table[c->target].version;
    snprintf(vertex, sizeof vertex, "#version %s\n%s vec2 at;\nvoid main() { gl_Position = vec4(at, 0.0, 1.0); }\n",
             version, old ? "attribute" : "in");
    snprintf(head, sizeof head,
             "#version %s\n%s%s%s\nuniform sampler2D arguments;\nuniform sampler2D source;\n"
             "vec4 argument(float i) {\n"
             "    float tuple = floor(gl_FragCoord.x) + %d.0 * floor(gl_FragCoord.y);\n"
             "    return texture2D(arguments, vec2((i + 0.5) / %d.0, (tuple + 0.5) / %d.0));\n}\n",
             version, old ? "" : "#define texture2D texture\nout ",
             old                                           ? ""
             : function_row(function)->result == TYPE_uint ? "uvec4"
                                                           : "vec4",
             old ? "" : " color;", CALL_SIDE, CALL_ARGUMENTS, CALL_COUNT);
    put_main(c, function);
    return program_make(
        c->gl, &(ProgramText){
                   .vertex = {vertex}, .fragment = {head, c->text}, .attributes = attributes, .attribute_count = 1});
}

static void bind_all(Caller *c, GLuint program, int source)
{
    texture_bind(c->gl, c->arguments, 0);
    texture_bind(c->gl, c->textures[source], 1);
    program_set(c->gl, program, &(ProgramValue){"arguments", 1, (float[]){0}});
    program_set(c->gl, program, &(ProgramValue){"source", 1, (float[]){1}});
    program_set(c->gl, program, &(ProgramValue){"matc_eyeFromWorld", 9, (float[]){1, 0, 0, 0, 1, 0, 0, 0, 1}});
    for (int i = 0; i < CALL_TABLES; i++) {
        texture_bind(c->gl, c->tables[i], 2 + i);
        program_set(c->gl, program, &(ProgramValue){table_names[i], 1, (float[]){(float)(2 + i)}});
    }
}

static bool read_back(Caller *c, bool words, double (*results)[CALL_LANES])
{
    static float floats[CALL_COUNT][CALL_LANES];
    static GLuint numbers[CALL_COUNT][CALL_LANES];
    bool read = words ? framebuffer_read_words(c->gl, &c->words, 0, &numbers[0][0])
                      : framebuffer_read(c->gl, &c->floats, 0, &floats[0][0]);
    for (int i = 0; i < CALL_COUNT; i++)
        for (int lane = 0; lane < CALL_LANES; lane++)
            results[i][lane] = words ? (double)numbers[i][lane] : (double)floats[i][lane];
    return read;
}

static bool draw(Caller *c, int function, Tuple *tuples, double (*results)[CALL_LANES])
{
    bool words = function_row(function)->result == TYPE_uint;
    bool sampled = function_arguments(function)[0] == 's';
    TextureSpec spec = {CALL_ARGUMENTS, CALL_COUNT, CALL_LANES, NULL, &tuples[0][0][0], false, false, false};
    gl_use(c->gl);
    GLuint program = make_program(c, function);
    if (!program)
        return false;
    c->gl->ActiveTexture(GL_TEXTURE0);
    c->arguments = texture_make(c->gl, &spec);
    bind_all(c, program, sampled ? (int)tuples[0][0][0] : 0);
    framebuffer_use(c->gl, words ? &c->words : &c->floats);
    c->gl->UseProgram(program);
    c->gl->BindVertexArray(c->array);
    c->gl->DrawArrays(GL_TRIANGLES, 0, 3);
    bool drawn = gl_check(c->gl, "calling a function") && read_back(c, words, results);
    c->gl->DeleteTextures(1, &c->arguments);
    c->gl->DeleteProgram(program);
    return drawn;
}

bool call_draw(Caller *c, int function, Tuple *tuples, double (*results)[CALL_LANES])
{
    bool drawn = draw(c, function, tuples, results);
    if (!drawn)
        snprintf(c->error, sizeof c->error, "%s", c->gl->error);
    return drawn;
}
