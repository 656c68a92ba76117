/* GLSL of shadows for a program that lights surfaces: shadow.glsl, texts of techniques, and
 * functions that dispatch to the techniques by the row's number. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { MAPS_UNIT, VIEWS_UNIT, PLANES_UNIT, SHEETS_UNIT, SEEN_UNIT, OWN_UNIT };
_Static_assert(OWN_UNIT + SHADOW_OWN_UNITS == SHADOW_UNITS, "units");

/* Appends formatted text. */
__attribute__((format(printf, 2, 3))) static void add(char text[SHADOW_TEXT_CHARS],
                                                      const char *format, ...)
{
    va_list arguments;
    const size_t size = strlen(text);
    va_start(arguments, format);
    vsnprintf(text + size, SHADOW_TEXT_CHARS - size, format, arguments);
    va_end(arguments);
}

static void add_piece(ShadowText *made, const char *piece)
{
    int count = 0;
    while (count < SHADOW_TEXT_PIECES - 1 && made->pieces[count])
        count++;
    made->pieces[count] = piece;
}

/* Definitions that all techniques share. Returns false if no light casts shadows by them. */
static bool define(const Renderer *renderer, bool nearest, char defined[SHADOW_TEXT_CHARS])
{
    const bool maps = shadow_has_maps(renderer), planes = shadow_has_planes(renderer);
    const bool glass = shadow_glass_needed(renderer), sheets = plane_transmittance_needed(renderer);
    const int panes = planes ? shadow_count_panes(renderer) : 0;
    if (glass || panes)
        add(defined, "#define SHADOW_COLORED\n");
    if (glass)
        add(defined, "#define SHADOW_GLASS\n%s", renderer->tiled ? "#define SHADOW_PARTS\n" : "");
    if (maps)
        add(defined, "#define SHADOW_MAPS\n#define SHADOW_SIZE %d\n#define SHADOW_FILTER %d\n",
            renderer->scene->shadow_size, renderer->scene->shadow_filter);
    if (shadow_is_soft(renderer))
        add(defined, "#define SHADOW_SOFT\n#define SOFT_POINTS %d\n",
            renderer->scene->shadow_points);
    if (planes)
        add(defined, "#define SHADOW_PLANES %d\n", renderer->gpu_scene.opaque_plane_count);
    if (panes)
        add(defined, "#define SHADOW_GLASS_PLANES %d\n", panes);
    if (sheets)
        add(defined, "#define SHADOW_SHEETS\n");
    add(defined, "#define SHADOW_METHODS %d\n", SHADOW_METHODS_MAX);
    if (nearest && shadow_method_sees(renderer))
        add(defined, "#define SHADOW_SEEN\n");
    return maps || planes || sheets;
}

/* -- calls of the techniques' functions */

/* GLSL functions that call the function of a light's shadow technique. `otherwise`: the value
 * returned if the technique has no such function. NULL: the functions of all techniques are called
 * in turn, whatever the light. */
static const struct {
    const char *name, *head, *arguments, *otherwise;
} calls[SHADOW_CALLS] = {
    [SHADOW_CALL_pixel] = {"SHADOW_CALL_PIXEL",
                           "void shadowAtPixel(ivec2 pixel, float depth, vec3 point, vec4 ray, "
                           "vec4 view)",
                           "(pixel, depth, point, ray, view)", NULL},
    [SHADOW_CALL_way] = {"SHADOW_CALL_WAY", "void shadowWay(vec3 normal, vec3 l)", "(normal, l)",
                         NULL},
    [SHADOW_CALL_light] = {"SHADOW_CALL_LIGHT",
                           "vec3 shadowOfLight(int method, int number, ivec2 views, vec3 point, "
                           "vec3 side, float size, ivec2 pixel)",
                           "(number, views, point, side, size, pixel)", "vec3(1.0)"},
    [SHADOW_CALL_view] = {"SHADOW_CALL_VIEW",
                          "SHARE shadowOfView(int method, int first, int count, vec3 point, "
                          "vec3 side, float size)",
                          "(first, count, point, side, size)", "SHARE(1.0)"}};

/* Adds the call of a technique's function; `number` is that of its row. */
static void add_call(ShadowText *made, ShadowCall call, int number, const char *function)
{
    if (!strstr(made->defined, calls[call].name)) {
        add(made->defined, "#define %s\n", calls[call].name);
        add(made->calls, "%s\n{\n", calls[call].head);
    }
    if (calls[call].otherwise)
        add(made->calls, "    if (method == %d) return %s%s;\n", number, function,
            calls[call].arguments);
    else
        add(made->calls, "    %s%s;\n", function, calls[call].arguments);
}

static void end_call(ShadowText *made, ShadowCall call)
{
    if (strstr(made->defined, calls[call].name) && calls[call].otherwise)
        add(made->calls, "    return %s;\n", calls[call].otherwise);
    if (strstr(made->defined, calls[call].name))
        add(made->calls, "}\n");
}

void shadow_text(const Renderer *renderer, bool nearest, ShadowText *made)
{
    const ShadowMethod *const *rows = shadow_methods_of(renderer);
    ShadowMethodText texts[SHADOW_METHODS_MAX] = {0};
    memset(made, 0, sizeof *made);
    bool there = define(renderer, nearest, made->defined);
    for (int i = 0; rows[i]; i++) {
        if (rows[i]->text)
            rows[i]->text(renderer, nearest, &texts[i]);
        add(made->defined, "%s", texts[i].defined);
        there |= texts[i].texts[0] != NULL;
    }
    if (!there)
        return;
    add_piece(made, made->defined);
    add_piece(made, render_text_shadow);
    for (int i = 0; rows[i]; i++)
        for (int k = 0; k < SHADOW_METHOD_TEXTS && texts[i].texts[k]; k++)
            add_piece(made, texts[i].texts[k]);
    for (ShadowCall call = 0; call < SHADOW_CALLS; call++) {
        for (int i = 0; rows[i]; i++)
            if (texts[i].calls[call])
                add_call(made, call, i + 1, texts[i].calls[call]);
        end_call(made, call);
    }
    add_piece(made, made->calls);
}

/* -- textures and buffers */

void shadow_set(const Renderer *renderer, int unit, ScreenPass *pass)
{
    int own = unit + OWN_UNIT;
    screen_pass_sampler(pass, "shadow_maps", unit + MAPS_UNIT);
    screen_pass_sampler(pass, "shadow_views", unit + VIEWS_UNIT);
    screen_pass_sampler(pass, "shadow_planes", unit + PLANES_UNIT);
    screen_pass_sampler(pass, "plane_transmittances", unit + SHEETS_UNIT);
    screen_pass_sampler(pass, "shadow_seen", unit + SEEN_UNIT);
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++) {
        if ((*row)->sampler)
            screen_pass_sampler(pass, (*row)->sampler, own++);
        if ((*row)->set)
            (*row)->set(renderer, pass);
    }
}

static void bind_array(const GlContext *gl, GLuint texture, int unit)
{
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, texture);
}

void shadow_bind(const Renderer *renderer, int unit)
{
    const GlContext *gl = renderer->gl;
    const ShadowMaps *maps = renderer->shadows;
    int own = unit + OWN_UNIT;
    if (maps->table) {
        bind_array(gl, maps->maps, unit + MAPS_UNIT);
        texture_bind(gl, maps->table, unit + VIEWS_UNIT);
    }
    if (maps->planes)
        texture_bind(gl, maps->planes, unit + PLANES_UNIT);
    if (maps->sheets.layers)
        bind_array(gl, maps->sheets.layers, unit + SHEETS_UNIT);
    if (shadow_method_sees(renderer) && frame_texture(renderer, FRAME_TARGET_triangle_id, 0))
        texture_bind(gl, frame_texture(renderer, FRAME_TARGET_triangle_id, 0), unit + SEEN_UNIT);
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++) {
        if ((*row)->bind)
            (*row)->bind(renderer, own);
        own += (*row)->sampler != NULL;
    }
    if (maps->glass.buffer)
        gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, SHADOW_GLASS_LISTS, maps->glass.buffer);
}
