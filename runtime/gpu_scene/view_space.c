/* Matrices and rays are computed in double and rounded once. */
#include "runtime/gpu_scene/view_space.h"
#include "runtime/scene/scene_area.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <string.h>

static Mat4 rounded(const double m[16])
{
    Mat4 result;
    for (int i = 0; i < 16; i++)
        result.m[i] = (float)m[i];
    return result;
}

static void look(const SceneCamera *camera, double m[16])
{
    const double *axes[3] = {camera->right, camera->up, camera->back};
    memset(m, 0, 16 * sizeof *m);
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) {
            m[4 * column + row] = axes[row][column];
            m[12 + row] -= axes[row][column] * camera->position[column];
        }
    m[15] = 1;
}

/* Projection with reversed depth: 1 is nearest. In perspective depth is near / distance, 0 at
 * infinity; clip space z is depth, or, for the range -1 to 1, twice depth minus 1, times w.
 * Orthographic: 1 - distance / depth. */
static void project(const SceneCamera *camera, const double half[2], bool zero_to_one, double m[16])
{
    const double scale = zero_to_one ? 1 : 2;
    memset(m, 0, 16 * sizeof *m);
    m[0] = 1 / half[0];
    m[5] = 1 / half[1];
    if (camera->kind == SCENE_Perspective) {
        m[11] = -1;
        m[14] = scale * camera->near;
        m[10] = zero_to_one ? 0 : 1; /* minus w, which is -z */
    } else {
        m[15] = 1;
        m[10] = scale / camera->depth;
        m[14] = 1; /* 1, or 2 minus 1 */
    }
}

void view_space_make(const SceneCamera *camera, const int size[2], bool zero_to_one,
                     ViewSpace *made)
{
    const double shorter = size[0] < size[1] ? size[0] : size[1];
    const double half[2] = {camera->half * size[0] / shorter, camera->half * size[1] / shorter};
    double projection[16];
    look(camera, made->eye_from_world);
    project(camera, half, zero_to_one, projection);
    made->spaces = (Spaces){.world_from_local = mat4_identity(),
                            .eye_from_world = rounded(made->eye_from_world),
                            .clip_from_eye = rounded(projection),
                            .zero_to_one = zero_to_one};
    const bool orthographic = camera->kind == SCENE_Orthographic;
    for (int i = 0; i < 3; i++) {
        made->spaces.eye[i] = (float)camera->position[i];
        made->spaces.viewer[i] = (float)(orthographic ? camera->back[i] : camera->position[i]);
    }
    made->spaces.viewer[3] = orthographic ? 0 : 1;
    for (int i = 0; i < 2; i++) {
        made->ray[i] = (float)(camera->half / shorter);
        made->ray[2 + i] = (float)size[i];
    }
    memcpy(made->depth,
           (float[4]){(float)(orthographic ? camera->depth : camera->near), orthographic},
           sizeof made->depth);
}

Spaces view_space_of_sky(const ViewSpace *space)
{
    Spaces spaces = space->spaces;
    if (space->depth[1] > 0)
        spaces.clip_from_eye.m[10] = -spaces.clip_from_eye.m[10];
    return spaces;
}

void view_space_place(ViewSpace *space, const int size[2], const int at[2])
{
    for (int i = 0; i < 2; i++)
        space->ray[2 + i] = (float)(size[i] - 2 * at[i]);
}

/* Moves `at` along the view direction onto the plane. */
static void meet(const SceneCamera *camera, const double normal[3], const double origin[3],
                 double at[3])
{
    const double along =
        (vec3_dot(normal, origin) - vec3_dot(normal, at)) / vec3_dot(normal, camera->back);
    for (int i = 0; i < 3; i++)
        at[i] += along * camera->back[i];
}

void view_space_parallels(const SceneCamera *camera, const int size[2], const SceneMatrix *plane,
                          Spaces *spaces)
{
    const double edge_on = 1e-6, shorter = size[0] < size[1] ? size[0] : size[1], *m = plane->m;
    const double *axes[3] = {camera->back, camera->right, camera->up};
    /* centers of the picture, of its right border, and of its upper border */
    double normal[3], points[3][3];
    vec3_cross(m, m + 4, normal);
    vec3_normalize(normal);
    const bool seen = fabs(vec3_dot(normal, camera->back)) > edge_on;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++)
            points[k][i] =
                camera->position[i] + (k ? axes[k][i] * camera->half * size[k - 1] / shorter : 0);
        if (seen)
            meet(camera, normal, m + 12, points[k]);
    }
    spaces->parallel = true;
    for (int i = 0; i < 3; i++) {
        const double back = seen ? camera->back[i] * camera->half : normal[i];
        spaces->rays[0][i] = (float)((seen ? points[0][i] : m[12 + i]) + back);
        /* edge-on: rays lead away from the plane */
        spaces->rays[1][i] = (float)(seen ? points[0][i] - spaces->rays[0][i] : back);
        spaces->rays[2][i] = (float)(seen ? points[1][i] - points[0][i] : 0);
        spaces->rays[3][i] = (float)(seen ? points[2][i] - points[0][i] : 0);
    }
}

/* Transforms a point (w 1) or a direction (w 0) to eye space. */
static void to_eye(const ViewSpace *space, const double from[3], double w, float out[4])
{
    const double *m = space->eye_from_world;
    for (int i = 0; i < 3; i++)
        out[i] = (float)(m[i] * from[0] + m[4 + i] * from[1] + m[8 + i] * from[2] + m[12 + i] * w);
    out[3] = (float)w;
}

/* Writes a light's texels; an area light must have been cut to a finite part (scene_area.h). */
static void put_light(const ViewSpace *space, const SceneLight *light, float out[LIGHT_TEXELS][4])
{
    const LightKind *row = light_kind_of(light);
    const bool far = row->from == LIGHT_FROM_afar;
    double cone[2] = {0, 1};
    const double back[3] = {-light->direction[0], -light->direction[1], -light->direction[2]};
    memset(out, 0, LIGHT_TEXELS * sizeof *out);
    to_eye(space, far ? back : light->position, far ? 0 : 1, out[LIGHT_PLACE]);
    for (int component = 0; component < 3; component++)
        out[LIGHT_POWER][component] = (float)light->light[component];
    if (row->from == LIGHT_FROM_extent) {
        to_eye(space, light->edges[0], 0, out[LIGHT_AXIS]);
        to_eye(space, light->edges[1], 0, out[LIGHT_CONE]);
        out[LIGHT_POWER][3] = light->both_sides;
        return;
    }
    to_eye(space, light->direction, 0, out[LIGHT_AXIS]);
    if (row->cone)
        row->cone(light, cone);
    for (int i = 0; i < 2; i++)
        out[LIGHT_CONE][i] = (float)cone[i];
}

int view_space_section(const SceneLight *light, bool shadows)
{
    const LightKind *row = light_kind_of(light);
    if (row->from >= LIGHT_FROM_around)
        return VIEW_SPACE_SECTIONS;
    if (row->glsl)
        return VIEW_SPACE_KINDS + light_kind_number(light->kind);
    return row->from == LIGHT_FROM_point && !row->cone && !(scene_light_casts(light) && shadows)
               ? VIEW_SPACE_PLAIN
               : VIEW_SPACE_POINTS;
}

static int texels_of(int section)
{
    return section == VIEW_SPACE_PLAIN ? LIGHT_PLAIN_TEXELS : LIGHT_TEXELS;
}

int view_space_texels(const int counts[VIEW_SPACE_SECTIONS], int section)
{
    int sum = 0;
    for (int i = 0; i < section; i++)
        sum += counts[i] * texels_of(i);
    return sum;
}

void view_space_lights(const ViewSpace *space, const Scene *scene, bool shadows, float (*texels)[4],
                       int counts[VIEW_SPACE_SECTIONS])
{
    float light[LIGHT_TEXELS][4];
    SceneLight cut;
    for (int section = 0; section < VIEW_SPACE_SECTIONS; section++) {
        counts[section] = 0;
        for (int i = 0; i < scene->light_count; i++)
            if (view_space_section(&scene->lights[i], shadows) == section) {
                const bool wide = light_from(&scene->lights[i]) == LIGHT_FROM_extent;
                if (wide)
                    scene_area_cut(&scene->camera, &scene->lights[i], &cut);
                put_light(space, wide ? &cut : &scene->lights[i], light);
                memcpy(texels, light, (size_t)texels_of(section) * sizeof *texels);
                texels += texels_of(section);
                counts[section]++;
            }
    }
}

bool view_space_around(const ViewSpace *space, const Scene *scene, const LightKind *kind,
                       float numbers[VIEW_SPACE_AROUND][4])
{
    double above[3] = {0}, below[3] = {0};
    bool there = false;
    memset(numbers, 0, VIEW_SPACE_AROUND * sizeof *numbers);
    to_eye(space, (const double[]){0, 0, 1}, 0, numbers[0]);
    for (int i = 0; kind->from == LIGHT_FROM_around && i < scene->light_count; i++) {
        const SceneLight *light = &scene->lights[i];
        if (light->kind != kind->kind)
            continue;
        there = true;
        for (int component = 0; component < 3; component++) {
            numbers[1][component] = (float)(above[component] += light->light[component]);
            numbers[2][component] = (float)(below[component] += light->ground[component]);
        }
    }
    return there;
}
