/* The pass peel: depth peeling of transparent surfaces, from the farthest layer on, each lit and
 * composited over the light. Starting from the back, a layer needs no memory of those in front.
 * Its GLSL is peel_layer.glsl, which follows the materials' own, and pass_peel.glsl. */
#include "gen/render_text.h"
#include "runtime/frame_graph/surface_draw.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/transparency/transparency_passes.h"
#include "runtime/post/post.h"

static bool pass_peel_needed(const Renderer *renderer)
{
    return transparency_is(renderer, TRANSPARENCY_peeling);
}

static const GLuint nothing[4] = {~0u, ~0u, ~0u, ~0u};

/* Makes the layer's G-buffer, followed by the keys. */
static bool make_layer(Renderer *renderer, int number)
{
    FramebufferTextures textures = {.depth = frame_texture(renderer, FRAME_TARGET_layer_depth, 0)};
    FramebufferSpec spec = {renderer->size[0], renderer->size[1], 0, 0, true};
    for (const char *format;
         (format = frame_format(renderer, FRAME_TARGET_layer, spec.color_count));
         spec.color_count++) {
        textures.formats[spec.color_count] = format;
        textures.colors[spec.color_count] =
            frame_texture(renderer, FRAME_TARGET_layer, spec.color_count);
    }
    if (spec.color_count == FRAMEBUFFER_COLORS)
        return gl_fail(renderer->gl,
                       "the layout uses all %d targets, so none is left for depth peeling",
                       spec.color_count);
    textures.formats[spec.color_count] = frame_format(renderer, FRAME_TARGET_layer_keys, number);
    textures.colors[spec.color_count++] = frame_texture(renderer, FRAME_TARGET_layer_keys, number);
    return framebuffer_make_around(renderer->gl, &spec, &textures,
                                   &renderer->transparent->layers[number]);
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
static bool number_objects(Renderer *renderer)
{
    GpuScene *gpu_scene = &renderer->gpu_scene;
    const long stride = most_triangles(gpu_scene) / TRANSPARENCY_STRIDE + 1,
               objects = gpu_scene->place_count + gpu_scene->plane_count;
    transparency_set(renderer, "peel_stride", (float)stride);
    for (int i = gpu_scene->instances ? gpu_scene->place_count : 0; i < gpu_scene->place_count; i++)
        material_set_number(&gpu_scene->kinds[gpu_scene->places[i].kind].material, "peel_object",
                            (float)i);
    for (int i = 0; i < gpu_scene->plane_count; i++)
        material_set_number(&gpu_scene->planes[i].material, "peel_object",
                            (float)(gpu_scene->place_count + i));
    return objects <= UINT32_MAX / TRANSPARENCY_STRIDE / stride ||
           gl_fail(renderer->gl,
                   "%ld objects of up to %d triangles are more than peeling can tell apart",
                   objects, most_triangles(gpu_scene));
}

static void draw_layer(Renderer *renderer, int number)
{
    static const float nearest[4] = {1};
    const GlContext *gl = renderer->gl;
    const GLuint behind = frame_texture(renderer, FRAME_TARGET_layer_keys, !number);
    surface_draw_begin(renderer, &renderer->transparent->layers[number], GL_LEQUAL);
    gl->ClearBufferuiv(GL_COLOR, renderer->transparent->layers[number].spec.color_count - 1,
                       nothing);
    gl->ClearBufferfv(GL_DEPTH, 0, nearest);
    texture_bind(gl, frame_texture(renderer, FRAME_TARGET_depth, 0),
                 renderer->transparent->peel_units[0]);
    texture_bind(gl, behind, renderer->transparent->peel_units[1]);
    surface_draw_objects(renderer, true);
    surface_draw_planes(renderer, true);
    surface_draw_end(renderer);
}

/* Clears the keys so that nothing is behind the first layer. */
static void begin_layers(Renderer *renderer)
{
    static const GLuint none[4] = {0, ~0u};
    framebuffer_use(renderer->gl, &renderer->transparent->layers[1]);
    renderer->gl->ClearBufferuiv(GL_COLOR, renderer->transparent->layers[1].spec.color_count - 1,
                                 none);
}

/* Counts layers, until one has no fragment. Keeps the maximum of all tiles. */
static bool count_layers(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    GLuint query = 0, fragments = 1;
    int count = 0;
    gl->GenQueries(1, &query);
    begin_layers(renderer);
    while (fragments) {
        gl->BeginQuery(GL_SAMPLES_PASSED, query);
        draw_layer(renderer, count % 2);
        gl->EndQuery(GL_SAMPLES_PASSED);
        gl->GetQueryObjectuiv(query, GL_QUERY_RESULT, &fragments);
        count += fragments > 0;
    }
    gl->DeleteQueries(1, &query);
    if (count > renderer->transparent->layer_count)
        renderer->transparent->layer_count = count;
    return gl_check(gl, "counting transparent layers");
}

static bool pass_peel_count(Renderer *renderer, FrameCount step)
{
    if (step == FRAME_COUNT_begin)
        renderer->transparent->layer_count = 0;
    if (step == FRAME_COUNT_tile)
        return count_layers(renderer);
    return step != FRAME_COUNT_again;
}

static bool pass_peel_make(Renderer *renderer)
{
    const LightingText text = {{render_text_pass_peel}, true, 0, LIGHTING_layers},
                       veil = {{"#define VEIL\n", render_text_pass_peel}, true, 0, LIGHTING_layers};
    if (!make_layer(renderer, 0) || !make_layer(renderer, 1) ||
        !lighting_make(renderer, &text, &renderer->transparent->peel) ||
        !pass_tools_make_veil(renderer, &veil) ||
        !transparency_units(renderer, renderer->transparent->peel_units) ||
        !number_objects(renderer))
        return false;
    screen_pass_sampler(&renderer->transparent->peel, "peel_keys", LIGHTING_FREE_UNIT);
    if (pass_tools_enabled(renderer))
        screen_pass_sampler(&renderer->post->tools.veil, "peel_keys", LIGHTING_FREE_UNIT);
    transparency_set(renderer, "peel_depth", (float)renderer->transparent->peel_units[0]);
    transparency_set(renderer, "peel_behind", (float)renderer->transparent->peel_units[1]);
    return true;
}

static void pass_peel_draw(Renderer *renderer)
{
    begin_layers(renderer);
    for (int i = 0; i < renderer->transparent->layer_count; i++) {
        draw_layer(renderer, i % 2);
        const GLuint keys = frame_texture(renderer, FRAME_TARGET_layer_keys, i % 2);
        lighting_run(renderer,
                     &(LightingSource){FRAME_TARGET_layer, FRAME_TARGET_layer_depth, keys},
                     &renderer->transparent->peel);
        pass_tools_draw_veil(renderer);
    }
}

static void pass_peel_delete(Renderer *renderer)
{
    frame_retire(renderer, &renderer->transparent->peel);
    for (int i = 0; i < 2; i++)
        framebuffer_delete(renderer->gl, &renderer->transparent->layers[i]);
    renderer->transparent->layer_count = 0;
}

static void pass_peel_place(Renderer *renderer)
{
    lighting_place(renderer, &renderer->transparent->peel);
}
static bool pass_peel_changed(Renderer *renderer, unsigned what)
{
    return lighting_changed(renderer, what, &renderer->transparent->peel);
}

static bool pass_peel_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    lighting_moved(renderer, &renderer->transparent->peel);
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
