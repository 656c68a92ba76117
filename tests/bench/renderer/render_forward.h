/* A plain forward renderer, as a baseline for matbench render: one program per material, which
 * lights in the fragment program, and one draw per object in scene order. Supports opaque
 * objects, point and directional lights without shadows, and ambient lights. OpenGL 4.5. */
#ifndef RENDER_FORWARD_H
#define RENDER_FORWARD_H
#include "runtime/scene/scene.h"

typedef struct GlContext GlContext;
typedef struct Forward Forward;
typedef struct {
    const Scene *scene;
    const MatcOptions *compile;
    int width, height;
} ForwardSource;

/* Returns NULL with gl->error. The scene must outlive it. */
Forward *forward_open(GlContext *gl, const ForwardSource *source);
void forward_draw(Forward *forward);
/* Linear light, four floats per pixel, row 0 is the bottom row. */
bool forward_read(Forward *forward, float *rgba);
/* Accepts NULL. */
void forward_close(Forward *forward);
#endif
