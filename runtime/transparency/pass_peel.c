/* The pass peel: depth peeling of transparent surfaces, from the farthest layer on, each lit and
 * composited over the light. Starting from the back, a layer needs no memory of those in front.
 * Its GLSL is peel_layer.glsl, which follows the materials' own, and pass_peel.glsl. */
#include "gen/render_text.h"
#include "runtime/frame/surface_draw.h"
#include "runtime/frame/transparency_draw.h"
#include "runtime/transparency/transparency_passes.h"
#include "runtime/post/post.h"

static bool pass_peel_needed(const Render *render)
{
    return transparency_is(render, TRANSPARENCY_peeling);
}

static const GLuint nothing[4] = {~0u, ~0u, ~0u, ~0u};

/* Makes the layer's G-buffer, followed by the keys. */
static bool make_layer(Render *render, int number)
{
    FramebufferTextures textures = {.depth = frame_texture(render, FRAME_TARGET_layer_depth, 0)};
    FramebufferSpec spec = {render->size[0], render->size[1], 0, 0, true};
    for (const char *format; (format = frame_format(render, FRAME_TARGET_layer, spec.color_count));
         spec.color_count++) {
        textures.formats[spec.color_count] = format;
        textures.colors[spec.color_count] =
            frame_texture(render, FRAME_TARGET_layer, spec.color_count);
    }
    if (spec.color_count == FRAMEBUFFER_COLORS)
        return gl_fail(render->gl, "the layout's %d targets leave none for peeling",
                       spec.color_count);
    textures.formats[spec.color_count] = frame_format(render, FRAME_TARGET_layer_keys, number);
    textures.colors[spec.color_count++] = frame_texture(render, FRAME_TARGET_layer_keys, number);
    return framebuffer_make_around(render->gl, &spec, &textures, &render->glass->layers[number]);
}

/* Returns the max number of triangles of an object. */
static int most_triangles(const GpuScene *gpu_scene)
{
    int most = 1;
    for (int i = gpu_scene->opaque_count; i < gpu_scene->surface_count; i++) {
        const int triangles = gpu_scene->meshes[gpu_scene->surfaces[i].mesh].index_count / 3;
        most = triangles > most ? triangles : most;
    }
    return most;
}

/* Assigns numbers to objects: a fragment is identified by its object's place and its triangle,
 * combined into one number. Programs that draw instances know the place. */
static bool number_objects(Render *render)
{
    GpuScene *gpu_scene = &render->gpu_scene;
    const long stride = most_triangles(gpu_scene) / TRANSPARENCY_STRIDE + 1,
               objects = gpu_scene->place_count + gpu_scene->plane_count;
    transparency_set(render, "peel_stride", (float)stride);
    for (int i = gpu_scene->instances ? gpu_scene->place_count : 0; i < gpu_scene->place_count; i++)
        material_set_number(&gpu_scene->kinds[gpu_scene->places[i].kind].material, "peel_object",
                            (float)i);
    for (int i = 0; i < gpu_scene->plane_count; i++)
        material_set_number(&gpu_scene->planes[i].material, "peel_object",
                            (float)(gpu_scene->place_count + i));
    return objects <= UINT32_MAX / TRANSPARENCY_STRIDE / stride ||
           gl_fail(render->gl,
                   "%ld objects of up to %d triangles are more than peeling can tell apart",
                   objects, most_triangles(gpu_scene));
}

static void draw_layer(Render *render, int number)
{
    static const float nearest[4] = {1};
    const GlContext *gl = render->gl;
    const GLuint behind = frame_texture(render, FRAME_TARGET_layer_keys, !number);
    surface_draw_begin(render, &render->glass->layers[number], GL_LEQUAL);
    gl->ClearBufferuiv(GL_COLOR, render->glass->layers[number].spec.color_count - 1, nothing);
    gl->ClearBufferfv(GL_DEPTH, 0, nearest);
    texture_bind(gl, frame_texture(render, FRAME_TARGET_depth, 0), render->glass->peel_units[0]);
    texture_bind(gl, behind, render->glass->peel_units[1]);
    surface_draw_objects(render, true);
    surface_draw_planes(render, true);
    surface_draw_end(render);
}

/* Clears the keys so that nothing is behind the first layer. */
static void begin_layers(Render *render)
{
    static const GLuint none[4] = {0, ~0u};
    framebuffer_use(render->gl, &render->glass->layers[1]);
    render->gl->ClearBufferuiv(GL_COLOR, render->glass->layers[1].spec.color_count - 1, none);
}

/* Counts layers, until one has no fragment. Keeps the maximum of all tiles. */
static bool count_layers(Render *render)
{
    GlContext *gl = render->gl;
    GLuint query = 0, fragments = 1;
    int count = 0;
    gl->GenQueries(1, &query);
    begin_layers(render);
    while (fragments) {
        gl->BeginQuery(GL_SAMPLES_PASSED, query);
        draw_layer(render, count % 2);
        gl->EndQuery(GL_SAMPLES_PASSED);
        gl->GetQueryObjectuiv(query, GL_QUERY_RESULT, &fragments);
        count += fragments > 0;
    }
    gl->DeleteQueries(1, &query);
    if (count > render->glass->layer_count)
        render->glass->layer_count = count;
    return gl_check(gl, "counting transparent layers");
}

static bool pass_peel_count(Render *render, FrameCount step)
{
    if (step == FRAME_COUNT_begin)
        render->glass->layer_count = 0;
    if (step == FRAME_COUNT_tile)
        return count_layers(render);
    return step != FRAME_COUNT_again;
}

static bool pass_peel_make(Render *render)
{
    const LightingText text = {{render_text_pass_peel}, true, 0, LIGHTING_layers},
                       veil = {{"#define VEIL\n", render_text_pass_peel}, true, 0, LIGHTING_layers};
    if (!make_layer(render, 0) || !make_layer(render, 1) ||
        !lighting_make(render, &text, &render->glass->peel) ||
        !pass_tools_make_veil(render, &veil) ||
        !transparency_units(render, render->glass->peel_units) || !number_objects(render))
        return false;
    screen_pass_sampler(&render->glass->peel, "peel_keys", LIGHTING_FREE_UNIT);
    if (pass_tools_are_there(render))
        screen_pass_sampler(&render->picture->tools.veil, "peel_keys", LIGHTING_FREE_UNIT);
    transparency_set(render, "peel_depth", (float)render->glass->peel_units[0]);
    transparency_set(render, "peel_behind", (float)render->glass->peel_units[1]);
    return true;
}

static void pass_peel_draw(Render *render)
{
    begin_layers(render);
    for (int i = 0; i < render->glass->layer_count; i++) {
        draw_layer(render, i % 2);
        const GLuint keys = frame_texture(render, FRAME_TARGET_layer_keys, i % 2);
        lighting_run(render, &(LightingSource){FRAME_TARGET_layer, FRAME_TARGET_layer_depth, keys},
                     &render->glass->peel);
        pass_tools_draw_veil(render);
    }
}

static void pass_peel_delete(Render *render)
{
    frame_retire(render, &render->glass->peel);
    for (int i = 0; i < 2; i++)
        framebuffer_delete(render->gl, &render->glass->layers[i]);
    render->glass->layer_count = 0;
}

static void pass_peel_place(Render *render) { lighting_place(render, &render->glass->peel); }
static bool pass_peel_changed(Render *render, unsigned what)
{
    return lighting_changed(render, what, &render->glass->peel);
}

static bool pass_peel_moved(Render *render, int first, int count)
{
    (void)first, (void)count;
    lighting_moved(render, &render->glass->peel);
    return true;
}

const FramePass pass_peel = {
    .plan = {"peel", .reads = FRAME_BIT(depth),
             .fills = FRAME_BIT(layer) | FRAME_BIT(layer_depth) | FRAME_BIT(layer_keys),
             .changes = FRAME_BIT(light) | FRAME_BIT(tools)},
    .when = "something is transparent, and there are no lists",
    .needed = pass_peel_needed,
    .make = pass_peel_make,
    .count = pass_peel_count,
    .draw = pass_peel_draw,
    .place = pass_peel_place,
    .changed = pass_peel_changed,
    .moved = pass_peel_moved,
    .forget = pass_peel_delete,
};
