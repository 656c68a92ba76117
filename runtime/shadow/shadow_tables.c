/* Shadow data that lighting reads: views and planes as texels; and the tiling of lists. */
#include "gen/shadow_view_layout.h"
#include "runtime/frame/frame.h"
#include "runtime/frame/transparency_draw.h"
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

/* Writes a view's texels; `layer` is 1 + the layer of its crossings, or 0. */
static void put_view(const Render *render, const ShadowView *view, int layer, float (*texels)[4])
{
    const float last[4] = {
        (float)view->near, (float)view->texel,
        view->method->views ? (float)shadow_method_number(render, view->method->word) : 0,
        (float)layer};
    for (int row = 0; row < SHADOW_VIEW_HOW; row++)
        from_eye(render->space.eye_from_world, view->rows[row], texels[SHADOW_VIEW_ROWS + row]);
    memcpy(texels[SHADOW_VIEW_HOW], last, sizeof texels[SHADOW_VIEW_HOW]);
}

void shadow_plane(const Render *render, const SceneMatrix *m, float texel[4])
{
    double row[4];
    vec3_cross(m->m, m->m + 4, row);
    vec3_normalize(row);
    row[3] = -vec3_dot(row, m->m + 12);
    from_eye(render->space.eye_from_world, row, texel);
}

/* Writes `count` times `texels` texels, ROW times per row, into the existing texture or a new
 * one. */
static bool write_table(GlContext *gl, const float (*from)[4], const int extents[2], GLuint *table)
{
    const int count = extents[0], row = count < ROW ? count : ROW;
    const TextureSpec spec = {.width = row * extents[1],
                              .height = (count + ROW - 1) / ROW,
                              .lanes = 4,
                              .floats = from[0]};
    if (*table)
        texture_rewrite(gl, *table, &spec);
    else
        *table = texture_check(gl, &spec) ? texture_make(gl, &spec) : 0;
    return *table != 0;
}

static bool write_views(Render *render)
{
    ShadowMaps *maps = render->shadows;
    float(*texels)[4] = calloc(((size_t)maps->views.count + ROW) * VIEW_TEXELS, sizeof *texels);
    if (!texels)
        return gl_fail(render->gl, "out of memory");
    for (int i = 0, layer = 0; i < maps->views.count; i++) {
        const ShadowView *view = &maps->views.views[i];
        put_view(render, view, view->crossed ? ++layer : 0, texels + (size_t)i * VIEW_TEXELS);
    }
    const bool done = write_table(render->gl, (const float(*)[4])texels,
                                  (int[]){maps->views.count, VIEW_TEXELS}, &maps->table);
    free(texels);
    return done;
}

/* Returns true for a plane of constant transparency, whose shadow needs no map. */
static bool is_glass(const GpuScenePlane *plane)
{
    return plane->transparent && plane->program->even;
}

int shadow_count_panes(const Render *render)
{
    int count = 0;
    for (int i = 0; i < render->gpu_scene.plane_count; i++)
        count += is_glass(&render->gpu_scene.planes[i]);
    return count;
}

/* Writes the transmittance of a plane: 0 or 1 if shadows are alpha-tested. */
static void put_through(const Render *render, const PassProgram *program, float texel[4])
{
    const float *t = program->through;
    for (int i = 0; i < 3; i++)
        texel[i] =
            !render->scene->shadow_colored ? t[0] + t[1] + t[2] > 1.5f : fminf(fmaxf(t[i], 0), 1);
}

/* Writes opaque planes, then those of constant transparency, each followed by its transmittance. */
static bool write_planes(Render *render)
{
    const GpuScene *gpu_scene = &render->gpu_scene;
    int count = 0;
    float(*texels)[4] = calloc(2 * (size_t)gpu_scene->plane_count + ROW, sizeof *texels);
    if (!texels)
        return gl_fail(render->gl, "out of memory");
    for (int glass = 0; glass < 2; glass++)
        for (int i = 0; i < gpu_scene->plane_count; i++) {
            const GpuScenePlane *plane = &gpu_scene->planes[i];
            if (glass ? !is_glass(plane) : plane->transparent)
                continue;
            shadow_plane(render, &render->scene->objects[plane->object].world_from_local,
                         texels[count++]);
            if (glass)
                put_through(render, plane->program, texels[count++]);
        }
    const bool done = write_table(render->gl, (const float(*)[4])texels, (int[]){count, 1},
                                  &render->shadows->planes);
    free(texels);
    return done;
}

/* -- for the lighting of surfaces */

bool shadow_has_maps(const Render *render) { return render->shadows->views.count > 0; }

bool shadow_is_cast(const Render *render)
{
    return scene_casts(render->scene) && !render->options.no_shadows;
}

bool shadow_is_soft(const Render *render)
{
    bool soft = false;
    for (int i = 0; i < render->scene->light_count; i++)
        soft |= soft_views_wanted(&render->scene->lights[i]);
    return soft && !render->options.no_shadows;
}

MaterialSetCasts shadow_casts(const Render *render)
{
    if (!shadow_is_cast(render))
        return SET_CASTS_none;
    if (render->scene->shadow_colored && transparency_has_lists(render->gl))
        return SET_CASTS_colored;
    return shadow_methods_need(render).cuts ? SET_CASTS_cut : SET_CASTS_none;
}

/* Returns whether infinite planes cast shadows, which need no map. */
bool shadow_has_planes(const Render *render)
{
    return shadow_is_cast(render) &&
           (render->gpu_scene.opaque_plane_count > 0 || shadow_count_panes(render) > 0);
}

bool shadow_make_views(Render *render)
{
    return render->options.no_shadows ||
           shadow_views_make(shadow_methods_of(render), render->scene, &render->gpu_scene,
                             render->whole, &render->shadows->views) ||
           gl_fail(render->gl, "out of memory");
}

bool shadow_make_tables(Render *render)
{
    const ShadowMaps *maps = render->shadows;
    return (!shadow_has_maps(render) || maps->table || write_views(render)) &&
           (!shadow_has_planes(render) || maps->planes || write_planes(render)) &&
           shadow_sheet_make(render);
}

bool shadow_change(Render *render, bool drawn_again)
{
    ShadowMaps *maps = render->shadows;
    const int before = maps->views.count;
    if (drawn_again) {
        shadow_views_free(&maps->views);
        if (!shadow_make_views(render))
            return false;
        maps->drawn = false;
        render->uncounted |= shadow_glass_needed(render);
    }
    if (maps->views.count != before ||
        (shadow_has_planes(render) && !maps->planes && frame_has(render, FRAME_TARGET_light)))
        return gl_fail(render->gl,
                       "the lights' shadows take %d maps, not %d: this is another scene",
                       maps->views.count, before);
    shadow_sheet_change(render);
    return (!maps->table || write_views(render)) && (!maps->planes || write_planes(render));
}

/* Writes the entry of an area light, after its first edge: 1 + the first of its layers, or 0 if
 * it casts no shadow. */
static void put_extent(const Render *render, int light, float (*texels)[4])
{
    const ShadowViews *views = &render->shadows->views;
    const bool casts =
        soft_views_wanted(&render->scene->lights[light]) && !render->options.no_shadows;
    texels[LIGHT_AXIS][3] = !casts ? 0 : views->count ? (float)(1 + views->lights[light].first) : 1;
}

void shadow_put_lights(const Render *render, const int counts[VIEW_SPACE_SECTIONS],
                       float (*texels)[4])
{
    const Scene *scene = render->scene;
    const bool shadows = !render->options.no_shadows;
    float(*places[VIEW_SPACE_SECTIONS])[4];
    int before[SHADOW_METHODS_MAX] = {0};
    for (int section = 0; section < VIEW_SPACE_SECTIONS; section++)
        places[section] = texels + view_space_texels(counts, section);
    for (int i = 0, layer = 0; i < scene->light_count; i++) {
        const int section = view_space_section(&scene->lights[i], shadows);
        layer += shadow_sheet_reads(&scene->lights[i]);
        if (section == VIEW_SPACE_PLAIN || section == VIEW_SPACE_SECTIONS)
            continue;
        float(*next)[4] = places[section];
        places[section] += LIGHT_TEXELS;
        if (section >= VIEW_SPACE_KINDS) {
            put_extent(render, i, next);
            continue;
        }
        const ShadowMethod *method = shadow_method_of(shadow_methods_of(render), &scene->lights[i]);
        const bool casts = method && shadows;
        const int number = casts ? shadow_method_number(render, method->word) : 0;
        const bool mapped = casts && shadow_has_maps(render);
        next[LIGHT_AXIS][3] = casts ? (float)(number + SHADOW_METHODS_MAX * before[number]++) : 0;
        next[LIGHT_CONE][2] = mapped ? (float)render->shadows->views.lights[i].first : 0;
        next[LIGHT_CONE][3] = mapped  ? (float)render->shadows->views.lights[i].count
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

static bool count(Render *render, ShadowPart *part)
{
    part->fragments = 0;
    shadow_draw_lists(render, part);
    return shadow_glass_count(render, &part->fragments);
}

/* -- in one piece */

static bool fail_room(Render *render, const ShadowPart *part)
{
    return gl_fail(render->gl,
                   "shadows of what is transparent take %lu bytes for %lu fragments, and there may "
                   "be %lu: smaller "
                   "maps take less, and shadowMaps: { colored: false } none",
                   (unsigned long)shadow_glass_bytes(part), (unsigned long)part->fragments,
                   (unsigned long)transparency_most_bytes(render));
}

/* Allocates the lists of all texels, if within the limit. */
static bool make_whole(Render *render, const ShadowPart *whole)
{
    ShadowGlass *glass = &render->shadows->glass;
    glass->full = shadow_glass_bytes(whole) > transparency_most_bytes(render);
    if (glass->full)
        return fail_room(render, whole);
    *glass->parts = *whole;
    return shadow_glass_make(render, shadow_glass_bytes(whole));
}

/* Draws, and enlarges the buffer, until all fragments fit. */
static bool count_whole(Render *render)
{
    ShadowPart part = *render->shadows->glass.parts;
    shadow_draw_lists(render, &part);
    if (!shadow_glass_count(render, &part.fragments))
        return false;
    if (part.fragments <= render->shadows->glass.parts->fragments)
        return true;
    return make_whole(render, &part) && count_whole(render);
}

/* -- in tiles */

static bool add(Render *render, const ShadowPart *part)
{
    ShadowGlass *glass = &render->shadows->glass;
    ShadowPart *parts = realloc(glass->parts, ((size_t)glass->part_count + 1) * sizeof *parts);
    if (!parts)
        return gl_fail(render->gl, "out of memory");
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
static bool fit(Render *render, ShadowPart *part)
{
    const size_t most = transparency_most_bytes(render);
    while (count(render, part)) {
        const size_t bytes = shadow_glass_bytes(part);
        if (bytes <= most)
            return true;
        if (part->rows == 1 && part->columns == 1)
            return fail_room(render, part);
        GLuint *length = part->rows > 1 ? &part->rows : &part->columns;
        *length = shorter(*length, (double)most / (double)bytes);
    }
    return false;
}

static bool divide(Render *render)
{
    ShadowGlass *glass = &render->shadows->glass;
    const ShadowPart whole = shadow_glass_whole(render);
    GLuint row = 0, column = 0, rows = whole.rows;
    size_t bytes = 0;
    glass->part_count = 0;
    if (!shadow_glass_make(render, 0))
        return false;
    while (row < whole.rows) {
        ShadowPart part = {column, row, whole.columns - column, column ? 1 : rows, 0};
        part.rows = part.rows < whole.rows - row ? part.rows : whole.rows - row;
        if (!fit(render, &part) || !add(render, &part))
            return false;
        bytes = shadow_glass_bytes(&part) > bytes ? shadow_glass_bytes(&part) : bytes;
        rows = 2 * part.rows; /* the next tile may be larger */
        column = (column + part.columns) % whole.columns;
        row += column ? 0 : part.rows;
    }
    return shadow_glass_make(render, bytes);
}

bool shadow_parts_make(Render *render)
{
    const ShadowPart whole = shadow_glass_whole(render);
    return !shadow_glass_needed(render) ||
           (add(render, &whole) && (render->parted || make_whole(render, &whole)));
}

bool shadow_parts_count(Render *render)
{
    return render->parted ? divide(render) : count_whole(render);
}

bool shadow_parts_fall_back(const Render *render)
{
    return render->shadows->glass.full && !render->parted;
}

int shadow_parts_number(const Render *render)
{
    return render->parted ? render->shadows->glass.part_count : 1;
}

void shadow_parts_load(Render *render, int part)
{
    if (render->parted)
        shadow_draw_lists(render, &render->shadows->glass.parts[part]);
}
