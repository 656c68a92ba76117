/* The handles of matc_render.h, shared by matc_scene.c and matc_render.c. */
#ifndef MATC_RENDERER_HANDLES_H
#define MATC_RENDERER_HANDLES_H
#include "runtime/renderer/matc_render.h"
#include "runtime/scene/scene.h"

struct MatcScene {
    Scene *scene;
    /* document of the caller; owns the scene's memory, so it is freed after the scene */
    MatcDocument *document;
    /* capacities of arrays with additions; 0: nothing was added */
    size_t object_capacity, mesh_capacity, material_capacity;
    char error[256];
};
#endif
