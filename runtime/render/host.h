/* The handles of matc_render.h, between matc_scene.c and matc_render.c. */
#ifndef MATC_RENDER_HANDLES_H
#define MATC_RENDER_HANDLES_H
#include "runtime/render/matc_render.h"
#include "runtime/scene/scene.h"

struct MatcScene {
    Scene *scene;
    MatcDocument *document; /* the caller's, as is its memory, which goes after the scene */
    size_t object_room, mesh_room, material_room; /* of what was added; 0: nothing was */
    char error[256];
};
#endif
