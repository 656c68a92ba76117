/* Cameras, programs and their uniforms, values. */
#include "scene.h"
#include "compiler/evaluate.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

Space space_flat(void)
{
    return (Space){.world_from_local = mat4_identity(),
                   .eye_from_world = mat4_identity(),
                   .clip_from_eye = mat4_identity()};
}

Space space_camera(const float eye[3], const float target[3], float height)
{
    const float up[3] = {0.1f, -0.2f, 1}, near = 0.5f, far = 40;
    Space space = space_flat();
    space.eye_from_world = mat4_look_at(eye, target, up);
    space.clip_from_eye = mat4_perspective(height, 1, near, far);
    memcpy(space.eye, eye, sizeof space.eye);
    return space;
}

void space_change_depth(Space *space, SpaceDepth kind)
{
    const float oblique[4] = {0.2f, 0.3f, -1, -0.5f}, reversed[4] = {0, 0, 0, 0.5f};
    float *m = space->clip_from_eye.m;
    for (int i = 0; i < 4 && kind != SPACE_usual; i++)
        m[4 * i + 2] = kind == SPACE_oblique ? oblique[i] - m[4 * i + 3] : reversed[i];
}

Mat4 space_clip_from_world(const Space *space)
{
    return mat4_multiply(&space->clip_from_eye, &space->eye_from_world);
}

void space_transform(const Mat4 *matrix, const double point[3], double w, double result[4])
{
    for (int row = 0; row < 4; row++) {
        result[row] = matrix->m[12 + row] * w;
        for (int column = 0; column < 3; column++)
            result[row] += matrix->m[4 * column + row] * point[column];
    }
}

static void normalize(double a[3])
{
    double length = sqrt(dot(a, a));
    for (int i = 0; i < 3 && length > 0; i++)
        a[i] /= length;
}

/* Uses the camera's axes, the rows of eye_from_world; inverts no matrix. */
static void aim(const Space *space, double x, double y, double ray[3])
{
    double eye[3] = {x / space->clip_from_eye.m[0], y / space->clip_from_eye.m[5], -1};
    for (int i = 0; i < 3; i++) {
        ray[i] = 0;
        for (int row = 0; row < 3; row++)
            ray[i] += space->eye_from_world.m[4 * i + row] * eye[row];
    }
    normalize(ray);
}

Hit space_meet(const Space *space, double x, double y)
{
    Hit hit = {0};
    double origin[3], u[3], v[3], from[3];
    aim(space, x, y, hit.ray);
    for (int i = 0; i < 3; i++) {
        origin[i] = (double)space->plane[0][i] - space->eye[i];
        u[i] = space->plane[1][i];
        v[i] = space->plane[2][i];
    }
    for (int i = 0; i < 3; i++)
        hit.normal[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
    normalize(hit.normal);
    hit.slope = dot(hit.ray, hit.normal);
    double along = dot(origin, hit.normal) / hit.slope;
    for (int i = 0; i < 3; i++) {
        hit.position[i] = space->eye[i] + along * hit.ray[i];
        from[i] = along * hit.ray[i] - origin[i];
    }
    hit.u = dot(from, u) / dot(u, u);
    hit.v = dot(from, v) / dot(v, v);
    hit.before = along > 0;
    return hit;
}

void surface_set3(Surface *surface, Group group, const double components[3])
{
    memcpy(&surface->root[channel_id(group, 0)], components, 3 * sizeof *components);
}

Surface space_surface(const Space *space, const Hit *hit, bool mesh)
{
    const double uv[3] = {hit->u, hit->v, 0}, local[3] = {2 * hit->u - 1, 2 * hit->v - 1, 0};
    Surface s = {.front = hit->slope < 0};
    s.root[channel_id(GROUP_IOR, 0)] = 1;
    surface_set3(&s, GROUP_P, hit->position);
    surface_set3(&s, GROUP_N, hit->normal);
    for (int i = 0; i < 3; i++) {
        s.root[channel_id(GROUP_DU, i)] = space->plane[1][i];
        s.root[channel_id(GROUP_DV, i)] = space->plane[2][i];
    }
    surface_set3(&s, GROUP_U, uv);
    surface_set3(&s, GROUP_X, mesh ? local : uv);
    return s;
}

void space_place(Space *space)
{
    const Mat4 stretch = {{1.3f, 0, 0, 0, 0, 0.8f, 0, 0, 0, 0, 2.1f, 0, 0, 0, 0, 1}};
    Mat4 turn = mat4_look_at((float[3]){0.2f, 0.1f, -0.15f}, (float[3]){0.6f, 0.3f, -0.75f},
                             (float[3]){0, 1, 0.3f});
    space->world_from_local = mat4_multiply(&turn, &stretch);
    for (int k = 0; k < 3; k++) {
        double world[4], local[3] = {k ? 2 * (k == 1) : -1, k ? 2 * (k == 2) : -1, 0};
        space_transform(&space->world_from_local, local, k == 0, world);
        for (int component = 0; component < 3; component++)
            space->plane[k][component] = (float)world[component];
    }
}

double space_depth(const Space *space, const double position[3])
{
    double clip[4];
    Mat4 clip_from_world = space_clip_from_world(space);
    space_transform(&clip_from_world, position, 1, clip);
    return fmin(fmax(clip[2] / clip[3] / 2 + 0.5, 0), 1);
}

static bool fail(Scene *scene, const char *first, const char *second)
{
    snprintf(scene->error, sizeof scene->error, "%s%s", first, second);
    return false;
}

static bool read_document(Scene *scene, const char *text)
{
    char whole[8192];
    size_t size = strlen(text);
    bool path = size > 5 && !strcmp(text + size - 5, ".yaml");
    FILE *file = path ? fopen(text, "rb") : NULL;
    if (path && !file)
        return fail(scene, "cannot read ", text);
    if (file) {
        size = fread(whole, 1, sizeof whole, file);
        fclose(file);
    }
    scene->document =
        matc_read(path ? text : "test.yaml", path ? whole : text, size, &scene->options);
    return matc_material_count(scene->document) == 1 ||
           fail(scene, matc_diagnostics(scene->document, MATC_TEXT), "");
}

bool scene_open(Scene *scene, Store *store, const char *text, const SceneOptions *options)
{
    *scene = (Scene){0};
    matc_options_init(&scene->options);
    scene->options.pass = options->pass;
    scene->options.slot = options->slot;
    scene->options.target = options->target;
    scene->options.normals = options->normals;
    scene->options.aa = options->aa ? options->aa : "none"; /* point values, like the oracle's */
    /* floats, compared unchanged */
    scene->options.layout = "thesis";
    scene->options.check = true;
    if (!read_document(scene, text))
        return false;
    const unsigned outputs = MATC_FRAGMENT | MATC_VERTEX | MATC_UNPACK | MATC_REFLECT;
    scene->program = matc_compile(scene->document, 0, outputs, &scene->options);
    if (!matc_ok(scene->program))
        return fail(scene, matc_program_diagnostics(scene->program, MATC_TEXT), "");
    if (!material_make(store, scene->program, &(ProgramText){0}, &scene->material))
        return fail(scene, store_context(store)->error, "");
    return true;
}

void scene_close(Scene *scene)
{
    material_delete(&scene->material);
    matc_program_free(scene->program);
    matc_document_free(scene->document);
    *scene = (Scene){0};
}

void scene_use(Scene *scene, const Space *space)
{
    spaces_set(space, &scene->material);
    material_use(&scene->material);
}

bool scene_values(const Scene *scene, const Surface *surface, SlotValues *values)
{
    return evaluate_material(scene->document, 0, &scene->options, (SurfacePoints){surface, 1},
                             values);
}
