/* Converts matrices from double to floats of a buffer. */
#include "runtime/gpu_scene/instances.h"
#include "runtime/tessellate/scene_scatter.h"
#include <string.h>

bool instances_supported(const GlContext *gl)
{
    GLint vertex = 0, fragment = 0;
    if (gl->major * 10 + gl->minor < 45 || !gl->DrawElementsInstancedBaseInstance ||
        !gl->VertexAttribDivisor || !gl->VertexAttribIPointer || !gl->BindBufferBase)
        return false;
    gl->GetIntegerv(GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, &vertex);
    gl->GetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &fragment);
    return vertex >= 1 && fragment >= 1;
}

static void put_matrix(const Mat3 *from, float columns[3][4])
{
    for (int i = 0; i < 9; i++)
        columns[i / 3][i % 3] = from->m[i];
}

Instance instance_of(const Scene *scene, int object, int material)
{
    Instance instance = {.material = (uint32_t)material, .object = scene_object_random(object)};
    const SceneMatrix *world_from_local = &scene->objects[object].world_from_local;
    Mat4 matrix;
    for (int i = 0; i < 16; i++)
        matrix.m[i] = (float)world_from_local->m[i];
    const Mat3 normal = mat3_normal(&matrix);
    memcpy(instance.world_from_local, matrix.m, sizeof matrix.m);
    put_matrix(&normal, instance.world_normal_from_local);
    return instance;
}

InstanceView instance_view(const Spaces *spaces)
{
    InstanceView view = {.clip_from_world = {0}};
    const Mat4 clip = mat4_multiply(&spaces->clip_from_eye, &spaces->eye_from_world);
    const Mat3 eye = mat3_from_mat4(&spaces->eye_from_world);
    memcpy(view.clip_from_world, clip.m, sizeof clip.m);
    put_matrix(&eye, view.eye_normal_from_world); /* a rotation is its own inverse transpose */
    return view;
}
