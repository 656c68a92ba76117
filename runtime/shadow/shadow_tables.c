/* Shadow data that lighting reads: views and planes as texels; and the tiling of lists. */
#include "gen/shadow_view_layout.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"
#include "runtime/shadow/soft_views.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VIEW_TEXELS = SHADOW_VIEW_TEXELS, ROW = SHADOW_VIEW_ROW };

/* Converts a row from world space to one from eye space. */
static void from_eye(const double *eye_from_world, const double row[4], float out[4])
{
    double last = row[3];
    for (int i = 0; i < 3; i++) {
        double sum = 0;
        for (int k = 0; k < 3; k++)
            sum += row[k] * eye_from_world[4 * k + i];
        last -= sum * eye_from_world[12 + i];
        out[i] = (float)sum;
    }
    out[3] = (float)last;
}

/* Writes the texels of a view. `layer` is 1 + the layer of its crossings; 0: none. */
static void put_view(const Renderer *renderer, const ShadowView *view, int layer,
                     float (*texels)[4])
{
    const float last[4] = {
        (float)view->near, (float)view->texel,
        view->method->views ? (float)shadow_method_number(renderer, view->method->word) : 0,
        (float)layer};
    for (int row = 0; row < SHADOW_VIEW_HOW; row++)
        from_eye(renderer->space.eye_from_world, view->rows[row], texels[SHADOW_VIEW_ROWS + row]);
    memcpy(texels[SHADOW_VIEW_HOW], last, sizeof texels[SHADOW_VIEW_HOW]);
}

void shadow_plane(const Renderer *renderer, const SceneMatrix *m, float texel[4])
{
    double row[4];
    vec3_cross(m->m, m->m + 4, row);
    vec3_normalize(row);
    row[3] = -vec3_dot(row, m->m + 12);
    from_eye(renderer->space.eye_from_world, row, texel);
}

/* Writes `count` times `texels` texels, ROW times per row, into the existing texture or a new
 * one. */
static bool write_table(GlContext *gl, const float (*from)[4], const int extents[2], GLuint *table)
{
    const int count = extents[0], row = count < ROW ? count : ROW;
    const TextureSpec spec = {.width = row * extents[1],
                              .height = (count + ROW - 1) / ROW,
                              .components = 4,
                              .floats = from[0]};
    if (*table)
        texture_rewrite(gl, *table, &spec);
    else
        *table = texture_check(gl, &spec) ? texture_make(gl, &spec) : 0;
    return *table != 0;
}

static bool write_views(Renderer *renderer)
{
    ShadowMaps *maps = renderer->shadows;
    float(*texels)[4] = calloc(((size_t)maps->views.count + ROW) * VIEW_TEXELS, sizeof *texels);
    if (!texels)
        return gl_fail(renderer->gl, "out of memory");
    for (int i = 0, layer = 0; i < maps->views.count; i++) {
        const ShadowView *view = &maps->views.views[i];
        put_view(renderer, view, view->crossed ? ++layer : 0, texels + (size_t)i * VIEW_TEXELS);
    }
    const bool done = write_table(renderer->gl, (const float(*)[4])texels,
                                  (int[]){maps->views.count, VIEW_TEXELS}, &maps->table);
    free(texels);
    return done;
}

/* Returns true for a plane of constant transparency, whose shadow needs no map. */
static bool is_glass(const GpuScenePlane *plane)
{
    return plane->transparent && plane->program->even;
}

int shadow_count_panes(const Renderer *renderer)
{
    int count = 0;
    for (int i = 0; i < renderer->gpu_scene.plane_count; i++)
        count += is_glass(&renderer->gpu_scene.planes[i]);
    return count;
}

/* Writes the transmittance of a plane: 0 or 1 if shadows are alpha-tested. */
static void put_through(const Renderer *renderer, const PassProgram *program, float texel[4])
{
    const float *t = program->through;
    for (int i = 0; i < 3; i++)
        texel[i] =
            !renderer->scene->shadow_colored ? t[0] + t[1] + t[2] > 1.5f : fminf(fmaxf(t[i], 0), 1);
}

/* Writes opaque planes, then those of constant transparency, each followed by its transmittance. */
static bool write_planes(Renderer *renderer)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    int count = 0;
    float(*texels)[4] = calloc(2 * (size_t)gpu_scene->plane_count + ROW, sizeof *texels);
    if (!texels)
        return gl_fail(renderer->gl, "out of memory");
    for (int glass = 0; glass < 2; glass++)
        for (int i = 0; i < gpu_scene->plane_count; i++) {
            const GpuScenePlane *plane = &gpu_scene->planes[i];
            if (glass ? !is_glass(plane) : plane->transparent)
                continue;
            shadow_plane(renderer, &renderer->scene->objects[plane->object].world_from_local,
                         texels[count++]);
            if (glass)
                put_through(renderer, plane->program, texels[count++]);
        }
    const bool done = write_table(renderer->gl, (const float(*)[4])texels, (int[]){count, 1},
                                  &renderer->shadows->planes);
    free(texels);
    return done;
}

/* -- for the lighting of surfaces */

bool shadow_has_maps(const Renderer *renderer) { return renderer->shadows->views.count > 0; }

bool shadow_is_cast(const Renderer *renderer)
{
    return scene_casts(renderer->scene) && !renderer->options.no_shadows;
}

bool shadow_is_soft(const Renderer *renderer)
{
    bool soft = false;
    for (int i = 0; i < renderer->scene->light_count; i++)
        soft |= soft_views_wanted(&renderer->scene->lights[i]);
    return soft && !renderer->options.no_shadows;
}

MaterialSetCasts shadow_casts(const Renderer *renderer)
{
    if (!shadow_is_cast(renderer))
        return SET_CASTS_none;
    if (renderer->scene->shadow_colored && transparency_has_lists(renderer->gl))
        return SET_CASTS_colored;
    return shadow_methods_need(renderer).cuts ? SET_CASTS_cut : SET_CASTS_none;
}

/* Returns whether infinite planes cast shadows, which need no map. */
bool shadow_has_planes(const Renderer *renderer)
{
    return shadow_is_cast(renderer) &&
           (renderer->gpu_scene.opaque_plane_count > 0 || shadow_count_panes(renderer) > 0);
}

bool shadow_make_views(Renderer *renderer)
{
    return renderer->options.no_shadows ||
           shadow_views_make(shadow_methods_of(renderer), renderer->scene, &renderer->gpu_scene,
                             renderer->whole, &renderer->shadows->views) ||
           gl_fail(renderer->gl, "out of memory");
}

bool shadow_make_tables(Renderer *renderer)
{
    const ShadowMaps *maps = renderer->shadows;
    return (!shadow_has_maps(renderer) || maps->table || write_views(renderer)) &&
           (!shadow_has_planes(renderer) || maps->planes || write_planes(renderer)) &&
           plane_transmittance_make(renderer);
}

bool shadow_change(Renderer *renderer, bool drawn_again)
{
    ShadowMaps *maps = renderer->shadows;
    const int before = maps->views.count;
    if (drawn_again) {
        shadow_views_free(&maps->views);
        if (!shadow_make_views(renderer))
            return false;
        maps->drawn = false;
        renderer->uncounted |= shadow_glass_needed(renderer);
    }
    if (maps->views.count != before ||
        (shadow_has_planes(renderer) && !maps->planes && frame_has(renderer, FRAME_TARGET_light)))
        return gl_fail(renderer->gl,
                       "the lights' shadows take %d maps, not %d: this is another scene",
                       maps->views.count, before);
    plane_transmittance_change(renderer);
    return (!maps->table || write_views(renderer)) && (!maps->planes || write_planes(renderer));
}

/* Writes the entry of an area light, after its first edge: 1 + the first of its layers, or 0 if
 * it casts no shadow. */
static void put_extent(const Renderer *renderer, int light, float (*texels)[4])
{
    const ShadowViews *views = &renderer->shadows->views;
    const bool casts =
        soft_views_wanted(&renderer->scene->lights[light]) && !renderer->options.no_shadows;
    texels[LIGHT_AXIS][3] = !casts ? 0 : views->count ? (float)(1 + views->lights[light].first) : 1;
}

void shadow_put_lights(const Renderer *renderer, const int counts[VIEW_SPACE_SECTIONS],
                       float (*texels)[4])
{
    const Scene *scene = renderer->scene;
    const bool shadows = !renderer->options.no_shadows;
    float(*places[VIEW_SPACE_SECTIONS])[4];
    int before[SHADOW_METHODS_MAX] = {0};
    for (int section = 0; section < VIEW_SPACE_SECTIONS; section++)
        places[section] = texels + view_space_texels(counts, section);
    for (int i = 0, layer = 0; i < scene->light_count; i++) {
        const int section = view_space_section(&scene->lights[i], shadows);
        layer += plane_transmittance_reads(&scene->lights[i]);
        if (section == VIEW_SPACE_PLAIN || section == VIEW_SPACE_SECTIONS)
            continue;
        float(*next)[4] = places[section];
        places[section] += LIGHT_TEXELS;
        if (section >= VIEW_SPACE_KINDS) {
            put_extent(renderer, i, next);
            continue;
        }
        const ShadowMethod *method =
            shadow_method_of(shadow_methods_of(renderer), &scene->lights[i]);
        const bool casts = method && shadows;
        const int number = casts ? shadow_method_number(renderer, method->word) : 0;
        const bool mapped = casts && shadow_has_maps(renderer);
        next[LIGHT_AXIS][3] = casts ? (float)(number + SHADOW_METHODS_MAX * before[number]++) : 0;
        next[LIGHT_CONE][2] = mapped ? (float)renderer->shadows->views.lights[i].first : 0;
        next[LIGHT_CONE][3] = mapped  ? (float)renderer->shadows->views.lights[i].count
                              : casts ? 0
                                      : -1;
        next[LIGHT_POWER][3] = casts ? (float)layer : 0;
    }
}

/* -- lists of transparent fragments, in tiles
 *
 * Lists that exceed the memory limit are drawn in tiles. A tile is a rectangle of texels of all
 * maps, stacked vertically, whose lists fit. Light is a sum over the texels that a point reads,
 * so the sum over one tile after the other is exact: each lighting pass runs once per tile
 * (lighting_run), and the lists are drawn again before it.
 *
 * Worked example: two maps of 4 x 4 texels with three fragments each, 8 + 32 + 96 words. With a
 * limit of 80: rows 0 to 3 take 8 + 16 + 48, so they are one tile, and rows 4 to 7 the other.
 * With a limit of 20: a row takes 8 + 4 + 12 and is too much, two of its texels take 16. */

static bool count(Renderer *renderer, ShadowPart *part)
{
    part->fragments = 0;
    shadow_draw_lists(renderer, part);
    return shadow_glass_count(renderer, &part->fragments);
}

/* -- in one piece */

static bool fail_capacity(Renderer *renderer, const ShadowPart *part)
{
    return gl_fail(renderer->gl,
                   "shadows of transparent surfaces need %lu bytes for %lu fragments, but the "
                   "limit is %lu: use smaller maps or shadowMaps: { colored: false }",
                   (unsigned long)shadow_glass_bytes(part), (unsigned long)part->fragments,
                   (unsigned long)transparency_most_bytes(renderer));
}

/* Allocates the lists of all texels, if within the limit. */
static bool make_whole(Renderer *renderer, const ShadowPart *whole)
{
    ShadowGlass *glass = &renderer->shadows->glass;
    glass->full = shadow_glass_bytes(whole) > transparency_most_bytes(renderer);
    if (glass->full)
        return fail_capacity(renderer, whole);
    *glass->parts = *whole;
    return shadow_glass_make(renderer, shadow_glass_bytes(whole));
}

/* Draws, and enlarges the buffer, until all fragments fit. */
static bool count_whole(Renderer *renderer)
{
    ShadowPart part = *renderer->shadows->glass.parts;
    shadow_draw_lists(renderer, &part);
    if (!shadow_glass_count(renderer, &part.fragments))
        return false;
    if (part.fragments <= renderer->shadows->glass.parts->fragments)
        return true;
    return make_whole(renderer, &part) && count_whole(renderer);
}

/* -- in tiles */

static bool add(Renderer *renderer, const ShadowPart *part)
{
    ShadowGlass *glass = &renderer->shadows->glass;
    ShadowPart *parts = realloc(glass->parts, ((size_t)glass->part_count + 1) * sizeof *parts);
    if (!parts)
        return gl_fail(renderer->gl, "out of memory");
    glass->parts = parts;
    parts[glass->part_count++] = *part;
    return true;
}

static GLuint shorter(GLuint length, double share)
{
    const GLuint wanted = (GLuint)(length * share);
    return wanted < 1 ? 1 : wanted < length ? wanted : length - 1;
}

/* Reduces the tile's rows, or the columns of a single row, until its lists fit. */
static bool fit(Renderer *renderer, ShadowPart *part)
{
    const size_t most = transparency_most_bytes(renderer);
    while (count(renderer, part)) {
        const size_t bytes = shadow_glass_bytes(part);
        if (bytes <= most)
            return true;
        if (part->rows == 1 && part->columns == 1)
            return fail_capacity(renderer, part);
        GLuint *length = part->rows > 1 ? &part->rows : &part->columns;
        *length = shorter(*length, (double)most / (double)bytes);
    }
    return false;
}

static bool divide(Renderer *renderer)
{
    ShadowGlass *glass = &renderer->shadows->glass;
    const ShadowPart whole = shadow_glass_whole(renderer);
    GLuint row = 0, column = 0, rows = whole.rows;
    size_t bytes = 0;
    glass->part_count = 0;
    if (!shadow_glass_make(renderer, 0))
        return false;
    while (row < whole.rows) {
        ShadowPart part = {column, row, whole.columns - column, column ? 1 : rows, 0};
        part.rows = part.rows < whole.rows - row ? part.rows : whole.rows - row;
        if (!fit(renderer, &part) || !add(renderer, &part))
            return false;
        bytes = shadow_glass_bytes(&part) > bytes ? shadow_glass_bytes(&part) : bytes;
        rows = 2 * part.rows; /* the next tile may be larger */
        column = (column + part.columns) % whole.columns;
        row += column ? 0 : part.rows;
    }
    return shadow_glass_make(renderer, bytes);
}

bool shadow_parts_make(Renderer *renderer)
{
    const ShadowPart whole = shadow_glass_whole(renderer);
    return !shadow_glass_needed(renderer) ||
           (add(renderer, &whole) && (renderer->tiled || make_whole(renderer, &whole)));
}

bool shadow_parts_count(Renderer *renderer)
{
    return renderer->tiled ? divide(renderer) : count_whole(renderer);
}

bool shadow_parts_fall_back(const Renderer *renderer)
{
    return renderer->shadows->glass.full && !renderer->tiled;
}

int shadow_parts_number(const Renderer *renderer)
{
    return renderer->tiled ? renderer->shadows->glass.part_count : 1;
}

void shadow_parts_load(Renderer *renderer, int part)
{
    if (renderer->tiled)
        shadow_draw_lists(renderer, &renderer->shadows->glass.parts[part]);
}
