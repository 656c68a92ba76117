/* Per-instance data of programs that draw instances (MatcOptions.instances), in the std140
 * layout of their buffers. */
#ifndef MATC_GPU_SCENE_INSTANCES_H
#define MATC_GPU_SCENE_INSTANCES_H
#include "runtime/gpu_material/spaces.h"
#include "runtime/scene/scene.h"
#include <stdint.h>

enum { INSTANCE_MATRICES = 0, INSTANCE_NUMBERS = 1 }; /* binding points of storage buffers */

/* An element of the array matc_instances. */
typedef struct {
    float world_from_local[16];
    float world_normal_from_local[3][4];
    uint32_t material; /* index in matc_numbers */
    float object;      /* the object's random number */
    uint32_t nothing[2];
} Instance;

/* The uniform block View. */
typedef struct {
    float clip_from_world[16];
    float eye_normal_from_world[3][4];
} InstanceView;

/* Reports whether the driver supports such instances: OpenGL 4.5, with storage buffers in both
 * stages. */
bool instances_supported(const GlContext *gl);
Instance instance_of(const Scene *scene, int object, int material);
InstanceView instance_view(const Spaces *spaces);
#endif
