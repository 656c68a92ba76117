/* Text around fragment programs. For a layout of one RGBA32UI target, lists, and a surface:
 *
 *     #version 450 core
 *     #define main surfaceMain
 *     bool surface_gone = false;
 *     #define discard surface_gone = true      (derivatives are undefined after a discard)
 *     ... matc's text, without its #version: void main() { ... fragment0 = ...; }
 *     #undef main
 *     #undef discard
 *     #define FRAGMENT_DEPTH gl_FragCoord.z
 *     #define LISTS_STRIDE 6u
 *     #define LISTS_PACK fragment0.x, fragment0.y, fragment0.z, fragment0.w
 *     ... depth_hidden.glsl
 *     ... lists_store.glsl, whose main() calls surfaceMain() */
#include "runtime/gpu_scene/transparency.h"
#include "gen/render_text.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* Per format: GLSL that packs a target's output into words, and unpacks words into a texel; %1$d
 * is the target, %2$d its first word. */
static const struct {
    const char *format;
    int words;
    const char *pack, *unpack;
} packings[] = {
    {"R32UI", 1, "fragment%1$d.x", "uvec4(LISTS_WORD(%2$d), 0u, 0u, 1u)"},
    {"RG32UI", 2, "fragment%1$d.x, fragment%1$d.y",
     "uvec4(LISTS_WORD(%2$d), LISTS_WORD(%2$d + 1), 0u, 1u)"},
    {"RGBA32UI", 4, "fragment%1$d.x, fragment%1$d.y, fragment%1$d.z, fragment%1$d.w",
     "uvec4(LISTS_WORD(%2$d), LISTS_WORD(%2$d + 1), LISTS_WORD(%2$d + 2), LISTS_WORD(%2$d + 3))"},
    {"RGBA16UI", 2, "fragment%1$d.x | fragment%1$d.y << 16, fragment%1$d.z | fragment%1$d.w << 16",
     "uvec4(LISTS_WORD(%2$d) & 65535u, LISTS_WORD(%2$d) >> 16, LISTS_WORD(%2$d + 1) & 65535u, "
     "LISTS_WORD(%2$d + 1) >> "
     "16)"},
    {"RGBA8", 1, "packUnorm4x8(fragment%1$d)", "unpackUnorm4x8(LISTS_WORD(%2$d))"},
    {"RGBA16F", 2, "packHalf2x16(fragment%1$d.xy), packHalf2x16(fragment%1$d.zw)",
     "vec4(unpackHalf2x16(LISTS_WORD(%2$d)), unpackHalf2x16(LISTS_WORD(%2$d + 1)))"},
};

static int packing_of(const char *format)
{
    int i = 0;
    while (strcmp(packings[i].format, format) != 0)
        i++;
    return i;
}

/* Appends to a text; overflow is cut, which happens for no layout. */
__attribute__((format(printf, 2, 3))) static void put(char *text, const char *format, ...)
{
    const size_t size = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + size, TRANSPARENCY_TEXT - size, format, arguments);
    va_end(arguments);
}

int transparency_stride(const MaterialSet *set)
{
    int words = TRANSPARENCY_NODE_HEAD;
    for (int i = 0; material_set_format(set, i); i++)
        words += packings[packing_of(material_set_format(set, i))].words;
    return words;
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
/* Appends a packing's text. */
static void put_target(char *text, const char *format, int target, int word)
{
    const size_t size = strlen(text);
    snprintf(text + size, TRANSPARENCY_TEXT - size, format, target, word);
}
#pragma GCC diagnostic pop

static void put_packing(const MaterialSet *set, char *text)
{
    put(text, "#define LISTS_STRIDE %du\n#define LISTS_PACK", transparency_stride(set));
    for (int i = 0; material_set_format(set, i); i++) {
        put(text, "%s", i ? ", " : " ");
        put_target(text, packings[packing_of(material_set_format(set, i))].pack, i, 0);
    }
    put(text, "\n");
}

void transparency_reader(const MaterialSet *set, char text[TRANSPARENCY_TEXT])
{
    int word = TRANSPARENCY_NODE_HEAD;
    *text = 0;
    put(text, "#define LISTS_STRIDE %du\n#define LISTS_TEXELS ", transparency_stride(set));
    for (int i = 0; material_set_format(set, i); i++) {
        const int packing = packing_of(material_set_format(set, i));
        put(text, "%s", i ? ", " : "");
        put_target(text, packings[packing].unpack, i, word);
        word += packings[packing].words;
    }
    put(text, "\n");
}

void transparency_text(const GlContext *gl, const MaterialSet *set, Transparency way,
                       TransparencyText *made)
{
    static const char *const depths[] = {"gl_FragCoord.z", "gl_FragDepth"};
    const bool lists = way == TRANSPARENCY_lists;
    *made = (TransparencyText){.way = way,
                               .instances = set->instances,
                               .body = lists ? render_text_lists_store : render_text_peel_layer};
    put(made->head,
        "#version %s core\n#define main surfaceMain\n"
        "bool surface_gone = false;\n#define discard surface_gone = true\n",
        gl->major * 10 + gl->minor >= 45 ? "450"
        : lists                          ? "430"
                                         : "330");
    for (int plane = 0; plane < 2; plane++) {
        char *tail = made->tail[plane];
        int targets = 0;
        put(tail, "#undef main\n#undef discard\n#define FRAGMENT_DEPTH %s\n", depths[plane]);
        while (material_set_format(set, targets))
            targets++;
        if (lists)
            put_packing(set, tail);
        else
            put(tail, "#define PEEL_TARGET %d\n%s", targets,
                plane || !set->instances ? "" : "#define PEEL_INSTANCES\n");
    }
}

/* Depth peeling with instancing: the vertex program passes the instance on. */
static const char vertex_tail[] = "#undef main\nflat out uint peel_object;\nvoid main()\n{\n    "
                                  "surfaceMain();\n    peel_object = "
                                  "matc_instance;\n}\n";

static const char *without_version(const char *text)
{
    const char *end = strchr(text, '\n');
    return end ? end + 1 : text;
}

void transparency_wrap(const TransparencyText *text, bool plane, ProgramText *program)
{
    const char *vertex = program->vertex[0], *fragment = program->fragment[0];
    const char *const pieces[] = {text->head, without_version(fragment), text->tail[plane],
                                  render_text_depth_hidden, text->body};
    memcpy(program->fragment, pieces, sizeof pieces);
    if (text->way != TRANSPARENCY_peeling || !text->instances || plane)
        return;
    const char *const vertex_pieces[] = {text->head, without_version(vertex), vertex_tail};
    memcpy(program->vertex, vertex_pieces, sizeof vertex_pieces);
}

/* Appends an end that writes to images and buffers. */
static void wrap_end(const GlContext *gl, const char *defined, const char *end,
                     ProgramText *program)
{
    const bool modern = gl->major * 10 + gl->minor >= 45;
    const char *const pieces[] = {modern ? "#version 450 core\n" : "#version 430 core\n",
                                  "#define main surfaceMain\n",
                                  without_version(program->fragment[0]), defined, end};
    memcpy(program->fragment, pieces, sizeof pieces);
}

void transparency_wrap_caster(const GlContext *gl, ProgramText *program)
{
    wrap_end(gl, "#undef main\n", render_text_glass_store, program);
}

void transparency_wrap_cut(const GlContext *gl, ProgramText *program)
{
    wrap_end(gl, "#undef main\n#define VOXEL_CUT\n", render_text_voxel_touch, program);
}
