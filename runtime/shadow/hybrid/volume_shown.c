/* Debug views of hybrid shadow volumes. They are drawn with the lines of the pass tools: tone
 * mapping keeps their colors, and nearer surfaces hide them by the depth test. Their GLSL is
 * volume_vertex.glsl and volume_shown.glsl. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/shadow/hybrid/volume.h"
#include <stdlib.h>
#include <string.h>

/* Views of the picture with volumes. */
static const FrameLook views[] = {
    /* row of the view `volume` of the scene */
    {"volume", FRAME_LOOK_faces, FRAME_LOOK_faces},
    {"volumeWireframe", FRAME_LOOK_faces, FRAME_LOOK_lines},
    {"wireframes", FRAME_LOOK_lines, FRAME_LOOK_lines},
    {"volumeAlone", FRAME_LOOK_none, FRAME_LOOK_faces},
    {"volumeWireframeAlone", FRAME_LOOK_none, FRAME_LOOK_lines},
};

const FrameLook *volume_shown_find(const char *name)
{
    for (size_t i = 0; name && i < sizeof views / sizeof *views; i++)
        if (!strcmp(name, views[i].name))
            return &views[i];
    return NULL;
}

static void place(const Renderer *renderer, int view)
{
    Material *material = &volume_state(renderer)->shown[view];
    pass_volume_place(renderer, view, material);
    material_set(material, &(MaterialValue){"look_ray", 4, renderer->space.ray});
    material_set(material, &(MaterialValue){"look_view", 4, renderer->space.depth});
}

void volume_shown_place(Renderer *renderer)
{
    for (int i = 0; volume_state(renderer)->shown && i < renderer->shadows->views.count; i++)
        if (volume_state(renderer)->shown[i].store)
            place(renderer, i);
}

/* Returns the macros of a debug view. Lines hide lines behind them, and so do faces if nothing
 * else is drawn; over the scene faces are translucent. */
static const char *define_look(const Renderer *renderer)
{
    const FrameLook *look = renderer->look;
    if (look->shadows == FRAME_LOOK_lines)
        return "#define LINES\n#define VIEWED\n";
    return look->scene == FRAME_LOOK_none ? "#define SOLID\n#define VIEWED\n" : "#define VIEWED\n";
}

static bool make_view(Renderer *renderer, int view)
{
    const char *const head = pass_volume_head(renderer), *const defined = define_look(renderer);
    const char *const maps = volume_cells_are(renderer) ? volume_cells_maps() : "",
                      *const cells = volume_cells_are(renderer) ? render_text_volume_cells : "";
    const ProgramText text = {.vertex = {head, defined, volume_data_text(renderer, true), maps,
                                         render_text_shadow_volume, cells,
                                         render_text_volume_vertex},
                              .fragment = {head, defined, render_text_volume_shown}};
    if (!material_make(renderer->store, NULL, &text, &volume_state(renderer)->shown[view]))
        return false;
    place(renderer, view);
    return true;
}

bool volume_shown_make(Renderer *renderer)
{
    const int count = renderer->shadows->views.count;
    bool fine = true;
    if (!frame_look_has_shadows(renderer))
        return true;
    if (renderer->options.linear)
        return gl_fail(renderer->gl,
                       "view '%s' is a false-color image and cannot be written as OpenEXR",
                       renderer->look->name);
    if (!volume_lights_cast(renderer))
        return gl_fail(renderer->gl,
                       "view '%s' is not available: no light of the scene casts hybrid shadows",
                       renderer->look->name);
    volume_state(renderer)->shown = calloc((size_t)count, sizeof *volume_state(renderer)->shown);
    if (!volume_state(renderer)->shown)
        return gl_fail(renderer->gl, "out of memory");
    for (int i = 0; fine && i < count; i++)
        fine = !volume_has_view(renderer, i) || make_view(renderer, i);
    return fine;
}

/* Sets the blending: surfaces behind show through a face by a constant share, in any order, and
 * depth is not written. */
static void begin(const Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    gl->Enable(GL_DEPTH_CLAMP);
    gl->Enable(GL_PRIMITIVE_RESTART);
    gl->PrimitiveRestartIndex(~0u);
    gl->DepthFunc(GL_GEQUAL);
    gl->DepthMask(renderer->look->scene == FRAME_LOOK_none);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    if (renderer->look->shadows == FRAME_LOOK_lines)
        gl->PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, renderer->shadows->maps);
}

static void end(const Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl->BlendFunc(GL_ONE, GL_ZERO);
    gl->Disable(GL_BLEND);
    gl->DepthMask(GL_TRUE);
    gl->FrontFace(GL_CCW);
    gl->Disable(GL_PRIMITIVE_RESTART);
    gl->Disable(GL_DEPTH_CLAMP);
}

void volume_shown_draw(Renderer *renderer)
{
    if (!frame_look_has_shadows(renderer))
        return;
    begin(renderer);
    for (int i = 0; i < renderer->shadows->views.count; i++) {
        if (!volume_state(renderer)->shown[i].store)
            continue;
        renderer->gl->FrontFace(renderer->shadows->views.views[i].mirrored ? GL_CW : GL_CCW);
        volume_data_draw(renderer, i, true);
    }
    renderer->gl->BindVertexArray(0);
    end(renderer);
}
