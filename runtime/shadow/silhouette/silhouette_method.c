/* The technique's row: silhouette shadows, with the planes of the triangles that pixels show. */
#include "runtime/frame_graph/frame.h"
#include "gen/render_text.h"
#include "runtime/shadow/shadow.h"
#include "runtime/shadow/silhouette/silhouette.h"
#include <stdio.h>

extern const ShadowMethod shadow_silhouette;

static bool crossed(const Scene *scene)
{
    (void)scene;
    return true;
}

static bool seen_wanted(const Renderer *renderer)
{
    return shadow_method_lights(renderer, KEYWORD_Shadows_silhouette) > 0 &&
           shadow_seen_fits(renderer) && renderer->gl->major * 10 + renderer->gl->minor >= 45 &&
           shadow_shows_light(renderer);
}

static bool seen_needed(const Renderer *renderer) { return silhouette_layers(renderer) > 0; }

/* Draws without slope-scaled bias, since silhouette.glsl compares with planes. */
static void draw(Renderer *renderer, const GpuSceneSource *source, int view)
{
    renderer->gl->PolygonOffset(-1.0f / 64, -2);
    shadow_draw_cast(renderer, source, view, false);
}

static bool has_views(const Renderer *renderer)
{
    const ShadowViews *views = &renderer->shadows->views;
    bool has = false;
    for (int i = 0; i < views->count; i++)
        has |= views->views[i].method->word == KEYWORD_Shadows_silhouette;
    return has;
}

/* Writes the GLSL text; other techniques may read crossings, too. */
static void write_text(const Renderer *renderer, bool nearest, ShadowMethodText *made)
{
    const char **next = made->texts;
    const bool microfacets =
        nearest && shadow_method_seen(renderer) == &shadow_silhouette && seen_needed(renderer);
    if (!silhouette_layers(renderer))
        return;
    *next++ = "uniform sampler2DArray silhouette_crossings;\n";
    if (!has_views(renderer))
        return;
    snprintf(made->defined, sizeof made->defined, "#define SHADOW_SILHOUETTES\n%s",
             microfacets ? "#define MICROFACETS\n" : "");
    *next++ = render_text_silhouette;
    made->calls[SHADOW_CALL_view] = "silhouetteShare";
    if (!microfacets)
        return;
    *next = render_text_triangle;
    made->calls[SHADOW_CALL_pixel] = "triangleFind";
    made->calls[SHADOW_CALL_way] = "triangleTurn";
}

static void bind(const Renderer *renderer, int unit)
{
    if (!silhouette_state(renderer)->crossings)
        return;
    renderer->gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    renderer->gl->BindTexture(GL_TEXTURE_2D_ARRAY, silhouette_state(renderer)->crossings);
}

static void put(Text *out, const Renderer *renderer)
{
    const Silhouettes *silhouettes = silhouette_state(renderer);
    const long texels = (long)renderer->scene->shadow_size * renderer->scene->shadow_size;
    const int count = silhouette_layers(renderer);
    if (silhouettes->crossings)
        text_format(out,
                    "shadow    %d of them with crossings of silhouettes, RG8, %ld bytes; %ld to "
                    "find them; %d edges, %lu bytes\n",
                    count, 2 * count * texels, 2 * texels * (long)sizeof(GLuint),
                    silhouettes->edge_count,
                    (unsigned long)silhouettes->edge_count * sizeof(SilhouetteEdge));
}

static const TriangleIdText seen = {.fragment = render_text_triangle_slopes};

const ShadowMethod shadow_silhouette = {
    .word = KEYWORD_Shadows_silhouette,
    .state = sizeof(Silhouettes),
    .triangles = true,
    .beside = true,
    .meshes = true,
    .seen = &seen,
    .seen_wanted = seen_wanted,
    .seen_needed = seen_needed,
    .border = true,
    .views = true,
    .crossed = crossed,
    .make_maps = silhouette_make,
    .draw = draw,
    .drawn = silhouette_find,
    .forget = silhouette_delete,
    .text = write_text,
    .sampler = "silhouette_crossings",
    .bind = bind,
    .put = put,
};
