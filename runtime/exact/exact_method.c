/* The technique's row: exact shadows. */
#include "gen/render_text.h"
#include "compiler/base/session.h"
#include "runtime/exact/exact.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/shadow/shadow_method.h"
#include <stdio.h>

enum {
    FIRSTS_BINDING = 5,
    TRIANGLES_BINDING,
    LISTS_BINDING
}; /* bindings that exact_triangle_id.glsl and exact.glsl use */

static void seen_bind(const Renderer *renderer)
{
    if (exact_state(renderer)->corners)
        renderer->gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, FIRSTS_BINDING,
                                     exact_state(renderer)->firsts);
}

/* Deletes the programs, which outlive a scene. */
static void close_cover(Renderer *renderer) { exact_cover_close(&exact_state(renderer)->cover); }

/* -- for lighting */

static void write_text(const Renderer *renderer, bool nearest, ShadowMethodText *made)
{
    if (!pass_exact_needed(renderer))
        return;
    snprintf(made->defined, sizeof made->defined, "%s", nearest ? "#define EXACT_SEEN\n" : "");
    made->texts[0] = render_text_exact;
    made->texts[1] = nearest ? render_text_exact_seen : NULL;
    made->calls[SHADOW_CALL_light] = "exactLight";
    made->calls[SHADOW_CALL_pixel] = nearest ? "exactAtPixel" : NULL;
}

static void set(const Renderer *renderer, ScreenPass *pass)
{
    static const char *const names[4] = {"exact_right", "exact_up", "exact_back", "exact_eye"};
    const SceneCamera *camera = &renderer->scene->camera;
    const double *const axes[3] = {camera->right, camera->up, camera->back};
    for (int i = 0; i < 4; i++) {
        float components[4] = {0, 0, 0, i == 3 ? (float)exact_state(renderer)->triangles.reach : 0};
        for (int k = 0; k < 3; k++)
            components[k] =
                (float)(i < 3 ? axes[i][k]
                              : camera->position[k] - exact_state(renderer)->triangles.origin[k]);
        material_set(&pass->material, &(MaterialValue){names[i], 4, components});
    }
}

static void bind(const Renderer *renderer, int unit)
{
    const GlContext *gl = renderer->gl;
    const ExactShadows *exact = exact_state(renderer);
    (void)unit;
    if (!exact->corners)
        return;
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, TRIANGLES_BINDING, exact->corners);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, LISTS_BINDING, exact->cover.lists);
}

/* -- for --stats */

static void put(Text *out, const Renderer *renderer)
{
    const ExactShadows *exact = exact_state(renderer);
    const int varying = shadow_views_varying(&renderer->gpu_scene);
    if (!exact->corners)
        return;
    text_format(out, "exact     %d triangles, %lu bytes\n", exact->triangles.count,
                (unsigned long)exact->triangles.count * sizeof(ExactCorners));
    text_format(out, "exact     lists of triangles for %d lights, %lu bytes; the longest has %d\n",
                exact->cover.light_count, (unsigned long)(exact->cover.words * sizeof(GLuint)),
                exact_cover_longest(&exact->cover));
    if (varying)
        text_format(out,
                    "exact     %d objects cast shadows by maps, as their transparency varies\n",
                    varying);
}

/* Times making the lists once more, as after a light has moved. */
static void put_time(Text *out, Renderer *renderer)
{
    if (!exact_state(renderer)->corners)
        return;
    const double start = session_now();
    const bool made = pass_exact_list(renderer);
    renderer->gl->Finish();
    text_put(out, "\nlists for exact shadows are made in ");
    text_rounded(out, 1e3 * (made ? session_now() - start : 0), 3);
    text_put(out, " milliseconds\n");
}

static const TriangleIdText seen = {.fragment = render_text_exact_triangle_id, .places = true};

extern const ShadowMethod shadow_exact;
const ShadowMethod shadow_exact = {
    .word = KEYWORD_Shadows_exact,
    .state = sizeof(ExactShadows),
    .triangles = true,
    .beside = true,
    .even = true,
    .seen = &seen,
    .seen_wanted = pass_exact_wanted,
    .seen_needed = pass_exact_needed,
    .seen_bind = seen_bind,
    .make = pass_exact_make,
    .changed = pass_exact_change,
    .moved = pass_exact_move,
    .forget = pass_exact_delete,
    .close = close_cover,
    .text = write_text,
    .set = set,
    .bind = bind,
    .put = put,
    .put_time = put_time,
};
