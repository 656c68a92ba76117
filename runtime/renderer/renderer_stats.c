/* Describes a frame as text: the passes, their targets, and their times. */
#include "compiler/base/session.h"
#include "compiler/base/memory.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/gl/clock.h"
#include "runtime/transparency/transparency_state.h"
#include "runtime/indirect/settings/indirect.h"
#include "runtime/indirect/indirect_methods.h"
#include "runtime/indirect/radiance/radiance.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/light/light_far.h"
#include "runtime/renderer/displaced_stats.h"
#include "runtime/transparency/transparency_passes.h"
#include "runtime/renderer/passes.h"
#include "runtime/renderer/renderer.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/shadow_method.h"
#include "runtime/shadow/soft_views.h"
#include <stdlib.h>
#include <string.h>

static void put_targets(Text *out, unsigned targets)
{
    const char *comma = "";
    for (int i = 0; i < FRAME_TARGET_COUNT; i++)
        if (targets >> i & 1) {
            text_format(out, "%s%s", comma, frame_target_name((FrameTarget)i));
            comma = ", ";
        }
    if (!targets)
        text_put(out, "-");
}

static const char *joined(Arena *arena, unsigned targets)
{
    Text text = text_new(arena);
    put_targets(&text, targets);
    return text.at;
}

/* Writes the table of passes. `times` has the time of each pass; NULL: no times. */
static void put_passes(Text *out, const Renderer *renderer, const RendererPassTime *times)
{
    FramePlanRows made;
    frame_request(renderer, &made);
    const FramePlanPass *rows = made.passes;
    text_format(out, "%-13s  %-30s  %-31s  %s\n", "pass", "reads", "writes",
                times ? "milliseconds" : "runs when");
    for (int i = 0; i < frame_pass_count(); i++) {
        const char *why = frame_reason(renderer, &made.request, i);
        text_format(out, "%-13s  %-30s  %-31s  ", rows[i].name,
                    joined(out->arena, rows[i].reads | rows[i].changes),
                    joined(out->arena, rows[i].fills | rows[i].changes));
        if (why)
            text_format(out, "not run: %s\n", why);
        else if (times)
            text_rounded(out, 1e3 * times[i].seconds, 3), text_char(out, '\n');
        else
            text_format(out, "%s\n", frame_pass(i)->when);
    }
}

static void put_texel(Text *out, int map, double texel)
{
    enum { DIGITS = 3 };
    text_format(out, "shadow    map %d: texels of ", map);
    text_rounded(out, texel, DIGITS);
    text_char(out, '\n');
}

/* Describes the lists of transparent shadow casters. Tiled lists are drawn again for each pass
 * that lights. */
static void put_glass(Text *out, const Renderer *renderer)
{
    const ShadowGlass *glass = &renderer->shadows->glass;
    unsigned long fragments = 0;
    for (int i = 0; i < glass->part_count; i++)
        fragments += glass->parts[i].fragments;
    text_format(out, "shadow    lists of transparent fragments: %lu bytes for %lu fragments",
                (unsigned long)glass->bytes, fragments);
    if (renderer->tiled)
        text_format(out, ", in %d tiles, drawn again for every frame", glass->part_count);
    text_char(out, '\n');
}

static void put_maps(Text *out, const Renderer *renderer)
{
    const int size = renderer->scene->shadow_size, count = renderer->shadows->views.count;
    text_format(out, "shadow    %d maps of %d x %d, DEPTH32F, %ld bytes\n", count, size, size,
                (long)count * size * size * (long)sizeof(float));
    for (int i = 0; i < count; i++)
        if (renderer->shadows->views.views[i].near <= 0)
            put_texel(out, i, renderer->shadows->views.views[i].texel);
}

/* Writes bytes and their shared part, such as "16, 8 shared". */
static void put_bytes(Text *out, int bytes, int shared)
{
    text_format(out, "%d", bytes);
    if (shared == bytes)
        text_put(out, ", shared");
    else if (shared)
        text_format(out, ", %d shared", shared);
    text_char(out, '\n');
}

static int count_from(const Scene *scene, LightFrom from)
{
    int count = 0;
    for (int i = 0; i < scene->light_count; i++)
        count += light_from(&scene->lights[i]) == from;
    return count;
}

/* Counts area lights, with soft shadows or without. */
static int count_areas(const Renderer *renderer, bool soft)
{
    int count = 0;
    for (int i = 0; i < renderer->scene->light_count; i++)
        count += light_from(&renderer->scene->lights[i]) == LIGHT_FROM_extent &&
                 (soft_views_wanted(&renderer->scene->lights[i]) &&
                  !renderer->options.no_shadows) == soft;
    return count;
}

/* Reports whether there are planes that would cast shadows by a program of their own, which the
 * driver does not support. */
static bool lacks_sheets(const Renderer *renderer)
{
    bool lacks = false;
    for (int i = 0; i < renderer->gpu_scene.plane_count; i++) {
        const GpuScenePlane *plane = &renderer->gpu_scene.planes[i];
        lacks |= plane->transparent && !plane->program->even && plane->program->caster < 0;
    }
    return lacks;
}

static bool is_transparent(const Renderer *renderer)
{
    bool found = false;
    for (int i = 0; i < renderer->gpu_scene.place_count; i++)
        found |= renderer->gpu_scene.places[i].transparent;
    return found;
}

/* Lists shadows that a user may expect, but that are missing. */
static void put_unshadowed(Text *out, const Renderer *renderer)
{
    const int areas = count_areas(renderer, false),
              skies = count_from(renderer->scene, LIGHT_FROM_sky);
    if (areas || skies)
        text_format(out, "shadow    no shadows from %d area lights and %d skies\n", areas, skies);
    if (!shadow_is_cast(renderer))
        return;
    if (lacks_sheets(renderer))
        text_put(out,
                 "shadow    no shadows of planes with varying transparency: needs OpenGL 4.3\n");
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if ((*row)->apart && shadow_has_maps(renderer) &&
            shadow_method_lights(renderer, (*row)->word) &&
            renderer->set.uses.casts != SET_CASTS_colored && is_transparent(renderer))
            text_format(out, "shadow    no shadows of transparent surfaces by method %s%s\n",
                        keyword_table[(*row)->word].name,
                        renderer->scene->shadow_colored ? ": needs OpenGL 4.3"
                                                        : ": shadows are not colored");
    if (renderer->gpu_scene.caster_count && renderer->scene->shadow_colored &&
        renderer->set.uses.casts != SET_CASTS_colored)
        text_put(out, "shadow    transparent surfaces cast opaque shadows or none: colored shadows "
                      "need OpenGL 4.3\n");
}

/* Describes soft shadows of area lights, and shadow casters that they lack. */
static void put_soft(Text *out, const Renderer *renderer)
{
    const int points = renderer->scene->shadow_points, areas = count_areas(renderer, true);
    if (!areas)
        return;
    text_format(out, "shadow    soft shadows from %d area lights, %d points each\n", areas,
                points * points);
    if (plane_transmittance_needed(renderer) || lacks_sheets(renderer))
        text_put(out, "shadow    no soft shadows of planes with varying transparency\n");
    if (renderer->tiled)
        text_put(out, "shadow    no soft shadows of transparent surfaces: their lists are tiled\n");
}

static void put_memory(Text *out, const Renderer *renderer)
{
    text_format(out, "\n%-13s  %-24s  %s\n", "target", "format", "bytes a pixel");
    for (int i = 0; i < FRAME_TARGET_COUNT; i++) {
        const FrameTarget target = (FrameTarget)i;
        if (target == FRAME_TARGET_shadow)
            continue; /* shadow maps have their own sizes, so no bytes per pixel */
        Text formats = text_new(out->arena);
        text_put(&formats, "");
        for (int t = 0; frame_format(renderer, target, t); t++)
            text_format(&formats, "%s%s", t ? " " : "", frame_format(renderer, target, t));
        if (target == FRAME_TARGET_lists)
            transparency_put_lists(out, renderer);
        else if (target == FRAME_TARGET_far)
            light_far_put(out, renderer);
        else if (renderer->targets.plan.memory[i][0] < 0)
            text_format(out, "%-13s  %-24s  not allocated\n", frame_target_name(target),
                        formats.at);
        else {
            text_format(out, "%-13s  %-24s  ", frame_target_name(target), formats.at);
            put_bytes(out, frame_bytes(renderer, target), frame_shared_bytes(renderer, target));
        }
    }
    plane_transmittance_put(out, renderer);
    text_format(out, "%-13s  %-24s  %d\n", "", "", frame_all_bytes(renderer));
    if (renderer->samples > 1)
        text_format(out, "%d x %d samples per pixel: each has these bytes, and the image one\n",
                    renderer->samples, renderer->samples);
    displaced_stats_put(out, renderer);
    if (renderer->targets.plan.there >> FRAME_TARGET_shadow & 1)
        put_maps(out, renderer);
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if ((*row)->put)
            (*row)->put(out, renderer);
    if (renderer->shadows->glass.buffer)
        put_glass(out, renderer);
    if (indirect_is(renderer))
        indirect_methods_put(out, renderer);
    if (renderer->voxels->map)
        voxels_put(out, renderer);
    radiance_put(out, renderer);
    put_soft(out, renderer);
    put_unshadowed(out, renderer);
}

static void put_tiles(Text *out, const Renderer *renderer)
{
    const int whole[2] = {renderer_width(renderer), renderer_height(renderer)};
    const int tile[2] = {renderer_tile_width(renderer), renderer_tile_height(renderer)};
    if (tile[0] < whole[0] || tile[1] < whole[1])
        text_format(out, "\n%d tiles of %d x %d pixels: the times are those of the last tile\n",
                    ((whole[0] + tile[0] - 1) / tile[0]) * ((whole[1] + tile[1] - 1) / tile[1]),
                    tile[0], tile[1]);
}

static char *finish(Text *out)
{
    char *copy = strdup(out->at);
    if (!copy)
        memory_exhausted();
    arena_free(out->arena);
    return copy;
}

char *renderer_graph(const Renderer *renderer)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    put_passes(&out, renderer, NULL);
    put_memory(&out, renderer);
    return finish(&out);
}

/* Joins the messages of all programs, each once: a material's programs often repeat them. */
char *renderer_diagnostics(const Renderer *renderer)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    const MaterialSet *set = &renderer->set;
    text_put(&out, "");
    for (int i = 0; i < set->count; i++) {
        const char *reported = matc_program_diagnostics(set->programs[i].program, MATC_TEXT);
        if (!strstr(out.at, reported))
            text_put(&out, reported);
    }
    if (renderer->scene && renderer->gpu_scene.place_count && !renderer->gpu_scene.seen &&
        !renderer->gpu_scene.plane_count)
        diag_complain(&out, MATC_TEXT, SEVERITY_warning, NULL,
                      "no object is in view: all are outside the frustum, behind the camera, or "
                      "nearer than its `near`");
    return finish(&out);
}

static double time_pass(Renderer *renderer, int pass)
{
    const bool clock = gl_clock_is(renderer->gl);
    const GLuint query = clock ? gl_clock_start(renderer->gl) : 0;
    const double start = session_now();
    frame_pass(pass)->draw(renderer);
    if (clock)
        return gl_clock_stop(renderer->gl, query);
    renderer->gl->Finish();
    return session_now() - start;
}

int renderer_time_passes(Renderer *renderer, RendererPassTime times[RENDERER_PASSES_MAX])
{
    renderer->gl->Finish();
    /* Draws kept maps again, so that their passes are measured, too. */
    renderer->shadows->drawn = renderer->shadows->seen = renderer->voxels->drawn =
        renderer->radiance->drawn = false;
    for (int i = 0; i < frame_pass_count(); i++) {
        times[i] = (RendererPassTime){frame_pass(i)->plan.name, 0};
        if (renderer->targets.plan.runs >> i & 1)
            times[i].seconds = time_pass(renderer, i);
    }
    return frame_pass_count();
}

int renderer_pixel_bytes(const Renderer *renderer) { return frame_all_bytes(renderer); }

int renderer_fragment_bytes(const Renderer *renderer)
{
    return renderer->transparent->lists.buffer
               ? (int)sizeof(GLuint) * transparency_stride(&renderer->set)
               : 0;
}

char *renderer_stats(Renderer *renderer)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    RendererPassTime times[RENDERER_PASSES_MAX];
    renderer_time_passes(renderer, times);
    put_passes(&out, renderer, times);
    put_memory(&out, renderer);
    put_tiles(&out, renderer);
    for (const ShadowMethod *const *row = shadow_methods_of(renderer); *row; row++)
        if ((*row)->put_time)
            (*row)->put_time(&out, renderer);
    text_format(&out,
                "\n%d x %d pixels, %d objects, %ld triangles in %d meshes, %d planes, %d lights\n",
                renderer_width(renderer), renderer_height(renderer), renderer->scene->object_count,
                renderer->gpu_scene.triangles, renderer->gpu_scene.mesh_count,
                renderer->gpu_scene.plane_count, renderer->scene->light_count);
    text_format(&out,
                "%d materials, %d programs of %d distinct sources, full-screen passes in %s\n",
                renderer->scene->material_count, renderer->set.count, renderer->set.texts,
                renderer->compute ? "compute" : "fragments");
    return finish(&out);
}
