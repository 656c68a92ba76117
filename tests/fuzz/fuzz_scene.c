/* libFuzzer's entry for scenes: any bytes as a document, read into a Scene, whose invariants for
 * drawing are checked. */
#include "fuzz.h"
#include "runtime/scene_reader/scene_read.h"
#include "runtime/tessellate/scene_solid.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* limits on what is checked, so that an input takes little time */
enum { MAX_OBJECTS = 64, MAX_FRAMES = 64 };

/* Every other requested file contains materials. */
static char *read_materials(void *user, const char *path, size_t *size, const char **why)
{
    static const char text[] = "materials: { one: { material: Phong, diffuse: { map: Granite } }, "
                               "two: { material: RGBA } }\n";
    char *copy = strlen(path) % 2 ? malloc(sizeof text) : NULL;
    if (!copy)
        return fuzz_no_file(user, path, size, why);
    *size = sizeof text - 1;
    return memcpy(copy, text, sizeof text);
}

static void want(bool fine)
{
    if (!fine)
        abort();
}

static bool are_finite(const double *numbers, int count)
{
    int i = 0;
    while (i < count && isfinite((float)numbers[i]))
        i++;
    return i == count;
}

static double product(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static bool is_unit(const double v[3]) { return fabs(product(v, v) - 1) < 1e-9; }

static void look_at_camera(const SceneCamera *camera)
{
    want(is_unit(camera->right) && is_unit(camera->up) && is_unit(camera->back));
    want(fabs(product(camera->right, camera->up)) < 1e-9 &&
         fabs(product(camera->right, camera->back)) < 1e-9);
    want(are_finite(camera->position, 3) && camera->half > 0);
}

static void look_at_light(const SceneLight *light)
{
    want(are_finite(light->position, 3) && are_finite(light->light, 3) &&
         are_finite(light->edges[0], 6));
    want((light->kind != SCENE_Spot && light->kind != SCENE_Directional) ||
         is_unit(light->direction));
    want(light->kind != SCENE_Spot || light->inner_cosine >= light->outer_cosine);
}

static void look_at_object(const Scene *scene, const SceneObject *object)
{
    Shape shape;
    want(object->material >= 0 && object->material < scene->material_count);
    want(object->kind != SCENE_Mesh || (object->mesh >= 0 && object->mesh < scene->mesh_count));
    want(are_finite(object->world_from_local.m, 16));
    want(scene_solid(object, &shape));
    for (int i = 0; i < shape.vertex_count; i++)
        for (int k = 0; k < 3; k++)
            want(isfinite(shape.vertices[i].position[k]) && isfinite(shape.vertices[i].normal[k]));
    for (int i = 0; i < shape.index_count; i++)
        want(shape.indices[i] < (uint32_t)shape.vertex_count);
    shape_free(&shape);
}

static void look_at_scene(const Scene *scene)
{
    SceneCamera camera;
    want(scene->width > 0 && scene->height > 0 && scene->sky < scene->material_count);
    look_at_camera(&scene->camera);
    for (int i = 0; i < scene->light_count; i++)
        look_at_light(&scene->lights[i]);
    for (int i = 0; i < scene->object_count && i < MAX_OBJECTS; i++)
        look_at_object(scene, &scene->objects[i]);
    for (int i = 0; i < scene->material_count; i++)
        want(scene->materials[i].index < matc_material_count(scene->materials[i].document));
    for (int i = 0; i < scene->motion.frames && i < MAX_FRAMES; i++) {
        want(scene_motion_camera(scene, i, scene->motion.frames, &camera));
        look_at_camera(&camera);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    Scene *scene;
    MatcOptions options;
    matc_options_init(&options);
    options.read_file = read_materials;
    const char *name = size && bytes[0] == '{' ? "fuzz.json" : "fuzz.yaml";
    MatcDocument *document = scene_read(name, (const char *)bytes, size, &options, &scene);
    matc_diagnostics(document, MATC_TEXT);
    want(!scene ||
         /* a document without a scene has an error, unless it contains only materials */
         !matc_error_count(document));
    if (scene)
        look_at_scene(scene);
    scene_free(scene);
    matc_document_free(document);
    return 0;
}
