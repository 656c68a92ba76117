#include "runtime/viewer/model_scene.h"
#include "compiler/base/json_write.h"
#include "runtime/mesh_import/model.h"
#include <math.h>
#include <string.h>

enum { EDGE = 512, ANGLE = 30 /* angle of view in degrees */ };

static bool ends_in(const char *path, const char *const *endings)
{
    const char *dot = strrchr(path, '.');
    for (; dot && *endings; endings++)
        if (text_same(dot, *endings))
            return true;
    return false;
}

static bool is_gltf(const char *path)
{
    static const char *const endings[] = {".gltf", ".glb", NULL};
    return ends_in(path, endings);
}

bool model_scene_is(const char *path)
{
    static const char *const endings[] = {".obj", ".ply", NULL};
    return is_gltf(path) || ends_in(path, endings);
}

typedef struct {
    double center[3], radius;
} Sphere;

/* Computes the sphere around the bounding box. */
static Sphere sphere_of(const Shape *shape)
{
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
    Sphere sphere = {{0}, 0};
    for (int i = 0; i < shape->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            low[k] = fmin(low[k], (double)shape->vertices[i].position[k]);
            high[k] = fmax(high[k], (double)shape->vertices[i].position[k]);
        }
    for (int k = 0; k < 3; k++) {
        sphere.center[k] = (low[k] + high[k]) / 2;
        sphere.radius += (high[k] - low[k]) * (high[k] - low[k]) / 4;
    }
    sphere.radius = sqrt(sphere.radius);
    return sphere;
}

/* Writes a point at an offset from the center, in radii. */
static void put_point(Text *out, const Sphere *sphere, const double offset[3])
{
    for (int k = 0; k < 3; k++) {
        text_format(out, k ? ", " : "[");
        text_double(out, sphere->center[k] + sphere->radius * offset[k]);
    }
    text_format(out, "]");
}

/* Writes the camera: the sphere touches the edges of a square picture. */
static void put_camera(Text *out, const Sphere *sphere)
{
    static const double toward[3] = {.45, -.79, .4155}, target[3] = {0};
    const double distance = 1 / sin(ANGLE / 2. * 3.141592653589793 / 180);
    double position[3];
    for (int k = 0; k < 3; k++)
        position[k] = distance * toward[k];
    text_format(out,
                "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: ", EDGE,
                EDGE);
    put_point(out, sphere, position);
    text_format(out, ", target: ");
    put_point(out, sphere, target);
    text_format(out, ", angle: %d }\n", ANGLE);
}

/* Writes three lamps, warm in front, cool at the side and from behind, and light from all around.
 */
static void put_lights(Text *out)
{
    static const char *const lights[] = {
        "Directional, direction: [0.17, 0.76, -0.62], color: [0.88, 0.84, 0.77]",
        "Directional, direction: [-0.95, -0.2, -0.2], color: [0.15, 0.19, 0.25], shadows: none",
        "Directional, direction: [0.2, -0.8, -0.55], color: [0.42, 0.45, 0.5], shadows: none",
        "Hemisphere, color: [0.42, 0.44, 0.48], ground: [0.11, 0.104, 0.098]"};
    text_format(out, "lights:\n");
    for (size_t i = 0; i < sizeof lights / sizeof *lights; i++)
        text_format(out, "  - { light: %s }\n", lights[i]);
    text_format(out, "toneMapping: { toneMapping: Shoulder }\n");
}

bool model_scene_write(const char *path, Text *document, char *error, size_t capacity)
{
    Shape shape;
    const char *slash = strrchr(path, '/');
    if (!model_read_in_place(path, &shape, error, capacity))
        return false;
    const Sphere sphere = sphere_of(&shape);
    shape_free(&shape);
    text_format(document, "colors: srgb\n");
    put_camera(document, &sphere);
    put_lights(document);
    text_format(document, "materials: { gray: { material: Principled, baseColor: \"#b8b8b8\", "
                          "roughness: 0.5 } }\n");
    text_format(document, "objects:\n  - { object: Mesh, file: ");
    json_string(document, slash ? slash + 1 : path);
    text_format(document, is_gltf(path) ? " }\n" : ", material: gray }\n");
    return true;
}
