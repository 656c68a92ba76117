/* The pass volume: hybrid shadows. The depth map of a light is the surface of one shadow volume
 * for all shadow casters: its texels are the vertices, and those without depth are infinitely
 * far away. The depth-fail method counts in the stencil: where the volume's surface is behind
 * the visible surface, back faces increment and front faces decrement; a nonzero count sets the
 * light's bit in the target mask.
 *
 * The volume is closed, so that counts are also right with the camera inside the shadow. For
 * parallel light the infinitely distant points coincide in one point. A spot, or a face of a
 * cube map, has a far cap over the map's border; since both share the border's vertices, they
 * cancel exactly where there is no shadow. Depth is clamped, so nothing is clipped at the far
 * plane. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/surface_draw.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/shadow/hybrid/volume.h"
#include <math.h>
#include <stdlib.h>

enum { BITS = 8 /* number of bits per component of the mask */ };

/* -- programs */

/* Sets the columns of the matrix from the map to homogeneous world space, where w is 1, or 0 at
 * infinity. Its input is x, y, and (1, depth), or for parallel light (depth, 1). */
static void world_from_place(const ShadowView *view, double m[4][4])
{
    const double(*rows)[4] = view->rows;
    const double scale = view->near > 0 ? view->near : 1;
    double columns[3][3];
    vec3_cross(rows[1], rows[2], columns[0]);
    vec3_cross(rows[2], rows[0], columns[1]);
    vec3_cross(rows[0], rows[1], columns[2]);
    const double volume = vec3_dot(rows[0], columns[0]);
    for (int component = 0; component < 3; component++) {
        m[3][component] = 0;
        for (int i = 0; i < 3; i++) {
            const double inverse = columns[i][component] / volume;
            m[3][component] -= inverse * rows[i][3];
            m[i][component] = scale * inverse;
        }
    }
    for (int i = 0; i < 4; i++)
        m[i][3] = i == 3;
}

static void transform(const double m[16], const double v[4], double out[4])
{
    for (int row = 0; row < 4; row++) {
        out[row] = 0;
        for (int k = 0; k < 4; k++)
            out[row] += m[4 * k + row] * v[k];
    }
}

/* A direction across the view has w = 0 in clip space, and no position in the picture; a GPU may
 * not draw such points. For an orthographic camera this holds for all directions. Infinite
 * distances are therefore replaced by large ones. For light from a point always: 2^10 times the
 * camera's distance, where a millionth of the light arrives. For parallel light only where it
 * runs across the view: its sides then meet in one point, and are tilted by 2^-20. */
/* across: a cosine */
static const double far_parallel = 1 << 20, far_place = 1 << 10, across = 1.0 / 1024;

static double distance_to(const Renderer *renderer, const double point[4])
{
    const SceneCamera *camera = &renderer->scene->camera;
    double away[3];
    for (int i = 0; i < 3; i++)
        away[i] = camera->position[i] - point[i];
    return sqrt(vec3_dot(away, away)) +
           (camera->kind == SCENE_Orthographic ? camera->depth + camera->half : 0);
}

static bool goes_across(const Renderer *renderer, const double along[4])
{
    const SceneCamera *camera = &renderer->scene->camera;
    return camera->kind == SCENE_Orthographic ||
           fabs(vec3_dot(camera->back, along)) < across * sqrt(vec3_dot(along, along));
}

/* Finds the direction of parallel light in clip space, from the columns for x, y, z and 1. If it
 * runs across the view: the distant point, from the map's center or corners, with the greatest
 * |w|. */
static void find_far(const Renderer *renderer, double world[4][4], double clip[4][4], float far[4])
{
    static const double places[5][2] = {{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
    double best = -1;
    for (int i = 0; i < 4; i++)
        far[i] = (float)-clip[2][i];
    if (!goes_across(renderer, world[2]))
        return;
    const double deep = sqrt(vec3_dot(world[2], world[2]));
    const double depths = far_parallel * (1 + distance_to(renderer, world[3]) / deep);
    for (int k = 0; k < 5; k++) {
        double point[4];
        for (int i = 0; i < 4; i++)
            point[i] = places[k][0] * clip[0][i] + places[k][1] * clip[1][i] - depths * clip[2][i] +
                       clip[3][i];
        for (int i = 0; i < 4 && fabs(point[3]) > 1.5 * best; i++)
            far[i] = (float)point[i];
        best = fmax(best, fabs(point[3]));
    }
}

void pass_volume_place(const Renderer *renderer, int number, Material *material)
{
    static const char *const names[] = {"volume_x", "volume_y", "volume_z", "volume_w"};
    const ShadowView *view = &renderer->shadows->views.views[number];
    const Scene *scene = renderer->scene;
    const float map[4] = {(float)number, (float)scene->shadow_size, view->near <= 0,
                          scene->shadow_stretched};
    double world[4][4], eye[4], clip[4][4], projection[16];
    float far[4] = {0};
    world_from_place(view, world);
    for (int i = 0; i < 16; i++)
        projection[i] = renderer->space.spaces.clip_from_eye.m[i];
    for (int i = 0; i < 4; i++) {
        transform(renderer->space.eye_from_world, world[i], eye);
        transform(projection, eye, clip[i]);
        const float column[4] = {(float)clip[i][0], (float)clip[i][1], (float)clip[i][2],
                                 (float)clip[i][3]};
        material_set(material, &(MaterialValue){names[i], 4, column});
    }
    material_set(material, &(MaterialValue){"volume_map", 4, map});
    if (view->near > 0)
        far[0] = (float)(view->near / (far_place * (view->near + distance_to(renderer, world[3]))));
    else
        find_far(renderer, world, clip, far);
    material_set(material, &(MaterialValue){"volume_far", 4, far});
}

const char *pass_volume_head(const Renderer *renderer)
{
    return renderer->gl->major * 10 + renderer->gl->minor >= 45 ? "#version 450 core\n"
                                                                : "#version 330 core\n";
}

static bool make_view(Renderer *renderer, int number)
{
    FrameVolumes *volumes = volume_state(renderer);
    const char *const head = pass_volume_head(renderer);
    const char *const maps = volume_cells_are(renderer) ? volume_cells_maps() : "",
                      *const cells = volume_cells_are(renderer) ? render_text_volume_cells : "";
    const ProgramText sheet = {.vertex = {head, volume_data_text(renderer, false), maps,
                                          render_text_shadow_volume, cells,
                                          render_text_volume_vertex},
                               .fragment = {head, "void main() {}\n"}};
    const ProgramText cap = {
        .vertex = {head, "#define CAP\n", render_text_shadow_volume, render_text_volume_vertex},
        .fragment = {head, "void main() {}\n"}};
    if (!material_make(renderer->store, NULL, &sheet, &volumes->sheets[number]))
        return false;
    pass_volume_place(renderer, number, &volumes->sheets[number]);
    if (renderer->shadows->views.views[number].near <= 0)
        return true;
    if (!material_make(renderer->store, NULL, &cap, &volumes->caps[number]))
        return false;
    pass_volume_place(renderer, number, &volumes->caps[number]);
    return true;
}

/* Makes the program that adds a light's bit to the mask. */
static bool make_mark(Renderer *renderer, int number)
{
    static const char text[] =
        "layout(std140) uniform Mark { vec4 mark_bit; };\nlayout(location = 0) out vec4 bits;\n"
        "void main() { bits = mark_bit; }\n";
    const char *const head = pass_volume_head(renderer);
    const ProgramText mark = {.vertex = {head, screen_text}, .fragment = {head, text}};
    float bit[4] = {0};
    bit[number / BITS] = (float)(1 << number % BITS) / 255;
    return material_make(renderer->store, NULL, &mark, &volume_state(renderer)->marks[number]) &&
           material_set(&volume_state(renderer)->marks[number],
                        &(MaterialValue){"mark_bit", 4, bit});
}

static bool check(const Renderer *renderer)
{
    const int count = volume_lights_count(renderer);
    if (count > VOLUME_LIGHTS)
        return gl_fail(renderer->gl, "%d lights cast hybrid shadows, more than %d", count,
                       VOLUME_LIGHTS);
    return renderer->gl->PrimitiveRestartIndex ||
           gl_fail(renderer->gl, "hybrid shadows take OpenGL 3.1");
}

static bool pass_volume_make(Renderer *renderer)
{
    FrameVolumes *volumes = volume_state(renderer);
    const int views = renderer->shadows->views.count, lights = volume_lights_count(renderer);
    if (!check(renderer))
        return false;
    volumes->sheets = calloc((size_t)views, sizeof *volumes->sheets);
    volumes->caps = calloc((size_t)views, sizeof *volumes->caps);
    volumes->marks = calloc((size_t)lights, sizeof *volumes->marks);
    if (!volumes->sheets || !volumes->caps || !volumes->marks)
        return gl_fail(renderer->gl, "out of memory");
    volumes->view_count = views;
    volumes->light_count = lights;
    renderer->gl->GenVertexArrays(1, &volumes->array);
    bool fine = true;
    for (int i = 0; fine && i < views; i++)
        fine = !volume_has_view(renderer, i) || make_view(renderer, i);
    for (int i = 0; fine && i < lights; i++)
        fine = make_mark(renderer, i);
    return fine;
}

/* Updates matrices after a change of the camera's or the lights' views. */
static void pass_volume_change(Renderer *renderer)
{
    for (int i = 0; i < volume_state(renderer)->view_count; i++) {
        if (volume_state(renderer)->sheets[i].store)
            pass_volume_place(renderer, i, &volume_state(renderer)->sheets[i]);
        if (volume_state(renderer)->caps[i].store)
            pass_volume_place(renderer, i, &volume_state(renderer)->caps[i]);
    }
}

/* -- drawing */

static void draw_view(Renderer *renderer, int view)
{
    const GlContext *gl = renderer->gl;
    FrameVolumes *volumes = volume_state(renderer);
    gl->FrontFace(renderer->shadows->views.views[view].mirrored ? GL_CW : GL_CCW);
    volume_data_draw(renderer, view, false);
    if (volumes->caps[view].store) {
        gl->BindVertexArray(volumes->array);
        material_use(&volumes->caps[view]);
        gl->DrawArrays(GL_TRIANGLES, 0, 3 * 4 * (renderer->scene->shadow_size - 1));
    }
    gl->BindVertexArray(0);
}

static void count_faces(Renderer *renderer, const ShadowLight *light)
{
    const GlContext *gl = renderer->gl;
    gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl->StencilFunc(GL_ALWAYS, 0, ~0u);
    gl->StencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
    gl->StencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
    gl->Enable(GL_DEPTH_TEST);
    gl->Enable(GL_PRIMITIVE_RESTART);
    gl->PrimitiveRestartIndex(~0u);
    for (int i = 0; i < light->count; i++)
        draw_view(renderer, light->first + i);
    gl->Disable(GL_PRIMITIVE_RESTART);
    gl->FrontFace(GL_CCW);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

/* Adds the light's bit where the count is not 0, and resets the counts. */
static void mark(Renderer *renderer, int number)
{
    const GlContext *gl = renderer->gl;
    gl->Disable(GL_DEPTH_TEST);
    gl->StencilFunc(GL_NOTEQUAL, 0, ~0u);
    gl->StencilOp(GL_KEEP, GL_KEEP, GL_ZERO);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE);
    material_use(&volume_state(renderer)->marks[number]);
    screen_draw(gl, &renderer->screen);
    gl->BlendFunc(GL_ONE, GL_ZERO);
    gl->Disable(GL_BLEND);
}

static void pass_volume_draw(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    int number = 0;
    surface_draw_begin(renderer, &renderer->targets.draws[FRAME_DRAW_mask], GL_GEQUAL);
    gl->ClearBufferfv(GL_COLOR, 0, (float[4]){0});
    gl->Clear(GL_STENCIL_BUFFER_BIT);
    gl->DepthMask(GL_FALSE);
    gl->Enable(GL_STENCIL_TEST);
    gl->Enable(GL_DEPTH_CLAMP);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, renderer->shadows->maps);
    for (int i = 0; i < renderer->scene->light_count; i++)
        if (renderer->scene->lights[i].shadows == KEYWORD_Shadows_hybrid) {
            count_faces(renderer, &renderer->shadows->views.lights[i]);
            mark(renderer, number++);
        }
    gl->Disable(GL_DEPTH_CLAMP);
    gl->StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    gl->StencilFunc(GL_ALWAYS, 0, ~0u);
    gl->Disable(GL_STENCIL_TEST);
    gl->DepthMask(GL_TRUE);
    surface_draw_end(renderer);
}

static void delete_all(Material *materials, int count)
{
    for (int i = 0; materials && i < count; i++)
        if (materials[i].store)
            material_delete(&materials[i]);
    free(materials);
}

static void pass_volume_delete(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    FrameVolumes *volumes = volume_state(renderer);
    delete_all(volumes->sheets, volumes->view_count);
    delete_all(volumes->caps, volumes->view_count);
    delete_all(volumes->marks, volumes->light_count);
    delete_all(volumes->shown, volumes->view_count);
    gl->DeleteVertexArrays(1, &volumes->array); /* GL ignores the name 0 */
    volume_data_delete(renderer);
    volume_blur_delete(renderer);
    *volumes = (FrameVolumes){0};
}

static bool pass_volume_changed(Renderer *renderer, unsigned what)
{
    (void)what;
    pass_volume_change(renderer);
    return true;
}

/* Updates the matrices after objects have moved, since the views are fitted to objects. */
static bool pass_volume_moved(Renderer *renderer, int first, int count)
{
    (void)first, (void)count;
    pass_volume_change(renderer);
    return true;
}

const FramePass pass_volume = {
    .plan = {"volume", .reads = FRAME_BIT(depth) | FRAME_BIT(shadow), .fills = FRAME_BIT(mask)},
    .when = "a light casts hybrid shadows",
    .needed = volume_lights_cast,
    .make = pass_volume_make,
    .draw = pass_volume_draw,
    .changed = pass_volume_changed,
    .moved = pass_volume_moved,
    .forget = pass_volume_delete,
};
