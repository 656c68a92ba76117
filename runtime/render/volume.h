/* Hybrid shadows: what a renderer keeps of shadow volumes, and what draws them. Private to frame.c and the passes. */
#ifndef MATC_RENDER_VOLUME_H
#define MATC_RENDER_VOLUME_H
#include "runtime/render/material.h"
#include "runtime/render/render.h"

enum { VOLUME_LIGHTS = 32 /* with hybrid shadows, in a scene: bits of the mask */ };

/* Of pass_volume.c and volume_blur.c. */
typedef struct {
    Material *sheets, *caps; /* by view, of those that are hybrid; caps of those that are perspective */
    Material *marks;         /* of each hybrid light */
    int view_count, light_count;
    GLuint array, indices;
    GLsizei index_count;
    bool quads; /* two triangles a quad, else a strip a row */
    Material blur;
    GLuint sharp; /* depths before they are blurred */
} FrameVolumes;

/* A light casts hybrid shadows; how many do; one does, and there is something that casts. volume_lights.c */
bool volume_lights_has(const Render *render, int light);
int volume_lights_count(const Render *render);
bool volume_lights_cast(const Render *render);

/* Where depths are blurred: what that takes; depth is drawn to what will be; its means to what is drawn to. volume_blur.c */
bool volume_blur_make(Render *render);
void volume_blur_use(const Render *render);
void volume_blur_draw(Render *render);
void volume_blur_delete(Render *render);

bool pass_volume_make(Render *render);
/* The view is another, or those of lights. */
void pass_volume_change(Render *render);
void pass_volume_draw(Render *render);
void pass_volume_delete(Render *render);
#endif
