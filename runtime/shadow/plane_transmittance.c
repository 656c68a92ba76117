/* Shadows of infinite planes with varying transparency, called sheets. The ray from a pixel's
 * surface point to a light intersects a sheet, and the material's value there is the
 * transmittance. The plane's program, compiled for a layout of that slot only, is drawn over all
 * pixels, with the view ray replaced by one through the intersection (plane_transmittance.glsl).
 * The transmittances of all sheets in between are multiplied, in a texture layer for each light,
 * which the lighting passes read.
 *
 * Since a texel has one depth, transparent surfaces are rendered by depth peeling if there are
 * sheets. */
#include "gen/render_text.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/shadow/shadow.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXEL_BYTES = 8, IMAGE_UNIT = 0 };

static bool is_sheet(const GpuScenePlane *plane) { return plane->program->caster >= 0; }

/* Returns whether the light has a layer: an area light has many points, and no layer. */
bool plane_transmittance_reads(const SceneLight *light)
{
    return scene_light_casts(light) && light_from(light) != LIGHT_FROM_extent;
}

static int count_layers(const Renderer *renderer)
{
    int count = 0;
    for (int i = 0; i < renderer->scene->light_count; i++)
        count += plane_transmittance_reads(&renderer->scene->lights[i]);
    return count;
}

bool plane_transmittance_needed(const Renderer *renderer)
{
    bool needed = false;
    for (int i = 0; i < renderer->set.count && count_layers(renderer); i++)
        needed |= renderer->set.programs[i].caster >= 0 &&
                  !strcmp(renderer->set.programs[i].pass, "plane");
    return needed;
}

bool plane_transmittance_check(const Renderer *renderer)
{
    const char *way = renderer->options.transparency;
    return !plane_transmittance_needed(renderer) || !way || strcmp(way, "lists") != 0 ||
           gl_fail(renderer->gl, "a plane with varying transparency casts shadows, which fragment "
                                 "lists do not support: use transparency auto or peeling");
}

static int count_sheets(const Renderer *renderer)
{
    int count = 0;
    for (int i = 0; i < renderer->gpu_scene.plane_count; i++)
        count += is_sheet(&renderer->gpu_scene.planes[i]);
    return count;
}

int plane_transmittance_bytes(const Renderer *renderer)
{
    return plane_transmittance_needed(renderer) ? TEXEL_BYTES * count_layers(renderer) : 0;
}

void plane_transmittance_put(Text *out, const Renderer *renderer)
{
    if (renderer->shadows->sheets.layers)
        text_format(out, "%-13s  %-24s  %d: plane transmittance of %d lights\n", "sheets", "RG32UI",
                    plane_transmittance_bytes(renderer), renderer->shadows->sheets.layer_count);
}

/* -- resources */

static bool make_layers(Renderer *renderer)
{
    GlContext *gl = renderer->gl;
    ShadowSheets *sheets = &renderer->shadows->sheets;
    GLint most = 0;
    gl->GetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (sheets->layer_count > most)
        return gl_fail(
            gl,
            "%d lights shine through planes with varying transparency, but the driver supports %d",
            sheets->layer_count, most);
    gl->GenTextures(1, &sheets->layers);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, sheets->layers);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    gl->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RG32UI, renderer->size[0], renderer->size[1],
                   sheets->layer_count, 0, GL_RG_INTEGER, GL_UNSIGNED_INT, NULL);
    return gl_check(gl, "allocating plane transmittance");
}

/* Replaces the input worldRay by a variable: blanks out the qualifiers before the type in
 * "layout(location = 7) in vec3 worldRay;". From malloc. */
static char *without_input(const char *fragment)
{
    char *text = strdup(fragment), *name = text ? strstr(text, "vec3 worldRay;") : NULL;
    for (char *at = name; at && at > text && at[-1] != '\n'; at--)
        at[-1] = ' ';
    return text;
}

static bool make_material(Renderer *renderer, const PassProgram *program, Material *made)
{
    const bool modern = renderer->gl->major * 10 + renderer->gl->minor >= 45;
    const char *const head = modern ? "#version 450 core\n" : "#version 430 core\n";
    /* GLSL text after the #version line */
    char *own = without_input(strchr(material_set_fragment(&renderer->set, program), '\n') + 1);
    if (!own)
        return gl_fail(renderer->gl, "out of memory");
    const ProgramText text = {.vertex = {head, screen_text},
                              .fragment = {head, "#define main surfaceMain\n", own, "#undef main\n",
                                           render_text_plane_transmittance}};
    const bool done = material_make(renderer->store, program->program, &text, made) ||
                      material_set_fail(renderer->gl, renderer->scene, program->material);
    free(own);
    return done;
}

static bool make_materials(Renderer *renderer)
{
    ShadowSheets *sheets = &renderer->shadows->sheets;
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    sheets->materials =
        calloc((size_t)sheets->layer_count * (size_t)sheets->count + 1, sizeof *sheets->materials);
    if (!sheets->materials)
        return gl_fail(renderer->gl, "out of memory");
    for (int layer = 0, k = 0; layer < sheets->layer_count; layer++)
        for (int i = 0; i < gpu_scene->plane_count; i++)
            if (is_sheet(&gpu_scene->planes[i]) &&
                !make_material(renderer,
                               &renderer->set.programs[gpu_scene->planes[i].program->caster],
                               &sheets->materials[k++]))
                return false;
    return true;
}

/* -- uniforms */

static void set(Material *material, const char *name, int components, const float *values)
{
    material_set(material, &(MaterialValue){name, components, values});
}

static void set_point(Material *material, const char *name, const double point[3])
{
    set(material, name, 3, (float[]){(float)point[0], (float)point[1], (float)point[2]});
}

static void to_eye(const double *m, const double from[3], double w, float to[4])
{
    for (int i = 0; i < 3; i++)
        to[i] = (float)(m[i] * from[0] + m[4 + i] * from[1] + m[8 + i] * from[2] + m[12 + i] * w);
    to[3] = (float)w;
}

static void set_world(const Renderer *renderer, Material *material)
{
    const SceneCamera *camera = &renderer->scene->camera;
    const double *axes[4] = {camera->right, camera->up, camera->back, camera->position};
    float m[16] = {0};
    for (int i = 0; i < 12; i++)
        m[i / 3 * 4 + i % 3] = (float)axes[i / 3][i % 3];
    m[15] = 1;
    set(material, "sheet_worldFromEye", 16, m);
}

static void set_light(const Renderer *renderer, const SceneLight *light, Material *material)
{
    const bool far = light_from(light) == LIGHT_FROM_afar;
    const double back[3] = {-light->direction[0], -light->direction[1], -light->direction[2]};
    float place[4];
    to_eye(renderer->space.eye_from_world, far ? back : light->position, far ? 0 : 1, place);
    set(material, "sheet_light", 4, place);
}

/* Rays start at a point near the camera, on the light's side of the plane, from where they
 * intersect it steeply. */
static void set_plane(const Renderer *renderer, const SceneLight *light, const SceneMatrix *plane,
                      Material *material)
{
    const SceneCamera *camera = &renderer->scene->camera;
    const double *m = plane->m, *const origin = m + 12;
    double n[3], foot[3], eye[3], row[4];
    vec3_cross(m, m + 4, n);
    vec3_normalize(n);
    const double offset = vec3_dot(n, origin), away = vec3_dot(n, camera->position) - offset;
    const double side = light_from(light) == LIGHT_FROM_afar
                            ? -vec3_dot(n, light->direction)
                            : vec3_dot(n, light->position) - offset;
    for (int i = 0; i < 3; i++) {
        foot[i] = camera->position[i] - away * n[i];
        eye[i] = foot[i] + (side < 0 ? -1 : 1) * fmax(fabs(away), 1) * n[i];
        row[i] = vec3_dot(n, i == 0 ? camera->right : i == 1 ? camera->up : camera->back);
    }
    row[3] = away;
    set(material, "sheet_plane", 4,
        (float[]){(float)row[0], (float)row[1], (float)row[2], (float)row[3]});
    set_point(material, "sheet_foot", foot);
    set_point(material, "sheet_eye", eye);
    set_point(material, "matc_eyePosition", eye);
    set_point(material, "matc_planeOrigin", origin);
    set_point(material, "matc_planeU", m);
    set_point(material, "matc_planeV", m + 4);
}

static void set_numbers(const Renderer *renderer, int layer, const SceneLight *light)
{
    const ShadowSheets *sheets = &renderer->shadows->sheets;
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    Material *material = sheets->materials + (size_t)layer * (size_t)sheets->count;
    for (int i = 0, before = 0; i < gpu_scene->plane_count; i++) {
        if (!is_sheet(&gpu_scene->planes[i]))
            continue;
        set_world(renderer, material);
        set_light(renderer, light, material);
        set_plane(renderer, light,
                  &renderer->scene->objects[gpu_scene->planes[i].object].world_from_local,
                  material);
        set(material, "sheet_view", 4, renderer->space.depth);
        material_set_number(material, "sheet_layer", (float)layer);
        material_set_number(material, "sheet_more", (float)(before++ > 0));
        material_set_number(material, "sheet_cut", !renderer->scene->shadow_colored);
        material_set_number(material, "sheet_layers", IMAGE_UNIT);
        material_set_number(material, "sheet_depth", (float)sheets->depth_unit);
        material++;
    }
}

void plane_transmittance_change(const Renderer *renderer)
{
    if (!renderer->shadows->sheets.materials)
        return;
    for (int i = 0, layer = 0; i < renderer->scene->light_count; i++)
        if (plane_transmittance_reads(&renderer->scene->lights[i]))
            set_numbers(renderer, layer++, &renderer->scene->lights[i]);
    plane_transmittance_place(renderer);
}

void plane_transmittance_place(const Renderer *renderer)
{
    const ShadowSheets *sheets = &renderer->shadows->sheets;
    for (int i = 0; sheets->materials && i < sheets->layer_count * sheets->count; i++)
        set(&sheets->materials[i], "sheet_ray", 4, renderer->space.ray);
}

bool plane_transmittance_set(const Renderer *renderer, int material, const MaterialValue *value)
{
    const ShadowSheets *sheets = &renderer->shadows->sheets;
    bool found = false;
    for (int layer = 0, k = 0; sheets->materials && layer < sheets->layer_count; layer++)
        for (int i = 0; i < renderer->gpu_scene.plane_count; i++)
            if (is_sheet(&renderer->gpu_scene.planes[i])) {
                const int own =
                    renderer->scene->objects[renderer->gpu_scene.planes[i].object].material;
                found |= own == material && material_set(&sheets->materials[k], value);
                k++;
            }
    return found;
}

bool plane_transmittance_make(Renderer *renderer)
{
    ShadowSheets *sheets = &renderer->shadows->sheets;
    int units[2];
    if (!plane_transmittance_needed(renderer) || sheets->materials)
        return true;
    sheets->count = count_sheets(renderer);
    sheets->layer_count = count_layers(renderer);
    if (!transparency_units(renderer, units) || !make_layers(renderer) || !make_materials(renderer))
        return false;
    sheets->depth_unit = units[0];
    plane_transmittance_change(renderer);
    return true;
}

void plane_transmittance_delete(Renderer *renderer)
{
    ShadowSheets *sheets = &renderer->shadows->sheets;
    for (int i = 0; sheets->materials && i < sheets->layer_count * sheets->count; i++)
        material_delete(&sheets->materials[i]);
    free(sheets->materials);
    renderer->gl->DeleteTextures(1, &sheets->layers); /* GL ignores the name 0 */
    *sheets = (ShadowSheets){0};
}

/* -- drawing */

void plane_transmittance_draw(const Renderer *renderer, GLuint depth)
{
    static const GLenum none = GL_NONE;
    const GlContext *gl = renderer->gl;
    const ShadowSheets *sheets = &renderer->shadows->sheets;
    if (!sheets->materials)
        return;
    framebuffer_use(gl, &renderer->targets.draws[FRAME_DRAW_light]);
    gl->DrawBuffers(1, &none);
    gl->BindImageTexture(IMAGE_UNIT, sheets->layers, 0, GL_TRUE, 0, GL_READ_WRITE, GL_RG32UI);
    texture_bind(gl, depth, sheets->depth_unit);
    for (int i = 0; i < sheets->layer_count * sheets->count; i++) {
        gl->MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        material_use(&sheets->materials[i]);
        screen_draw(gl, &renderer->screen);
    }
    gl->MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}
