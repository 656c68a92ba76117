/* The technique's row: silhouette shadows, with the planes of the triangles that pixels show. */
#include "runtime/frame/frame.h"
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

static bool seen_wanted(const Render *render)
{
    return shadow_method_lights(render, WORD_Shadows_silhouette) > 0 && shadow_seen_fits(render) &&
           render->gl->major * 10 + render->gl->minor >= 45 && shadow_shows_light(render);
}

static bool seen_needed(const Render *render) { return silhouette_layers(render) > 0; }

/* Draws without slope-scaled bias, since silhouette.glsl compares with planes. */
static void draw(Render *render, const GpuSceneSource *source, int view)
{
    render->gl->PolygonOffset(-1.0f / 64, -2);
    shadow_draw_cast(render, source, view, false);
}

static bool has_views(const Render *render)
{
    const ShadowViews *views = &render->shadows->views;
    bool has = false;
    for (int i = 0; i < views->count; i++)
        has |= views->views[i].method->word == WORD_Shadows_silhouette;
    return has;
}

/* Writes the GLSL text; other techniques may read crossings, too. */
static void write_text(const Render *render, bool nearest, ShadowMethodText *made)
{
    const char **next = made->texts;
    const bool facets =
        nearest && shadow_method_seen(render) == &shadow_silhouette && seen_needed(render);
    if (!silhouette_layers(render))
        return;
    *next++ = "uniform sampler2DArray silhouette_crossings;\n";
    if (!has_views(render))
        return;
    snprintf(made->defined, sizeof made->defined, "#define SHADOW_SILHOUETTES\n%s",
             facets ? "#define FACETS\n" : "");
    *next++ = render_text_silhouette;
    made->calls[SHADOW_CALL_view] = "silhouetteShare";
    if (!facets)
        return;
    *next = render_text_facet;
    made->calls[SHADOW_CALL_pixel] = "facetFind";
    made->calls[SHADOW_CALL_way] = "facetTurn";
}

static void bind(const Render *render, int unit)
{
    if (!silhouette_state(render)->crossings)
        return;
    render->gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    render->gl->BindTexture(GL_TEXTURE_2D_ARRAY, silhouette_state(render)->crossings);
}

static void put(Text *out, const Render *render)
{
    const Silhouettes *silhouettes = silhouette_state(render);
    const long texels = (long)render->scene->shadow_size * render->scene->shadow_size;
    const int count = silhouette_layers(render);
    if (silhouettes->crossings)
        text_format(out,
                    "shadow    %d of them with crossings of silhouettes, RG8, %ld bytes; %ld to "
                    "find them; %d edges, %lu bytes\n",
                    count, 2 * count * texels, 2 * texels * (long)sizeof(GLuint),
                    silhouettes->edge_count,
                    (unsigned long)silhouettes->edge_count * sizeof(SilhouetteEdge));
}

static const SeenText seen = {.fragment = render_text_facet_slopes};

const ShadowMethod shadow_silhouette = {
    .word = WORD_Shadows_silhouette,
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
