/* State of shadows: data of the passes in runtime/shadow. */
#ifndef MATC_SHADOW_SHADOW_STATE_H
#define MATC_SHADOW_SHADOW_STATE_H
#include "runtime/frame_graph/frame.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/shadow/shadow_views.h"

enum { SHADOW_METHODS_MAX = 16 };

/* A rectangle of texels of the maps, stacked vertically, and the number of its transparent
 * fragments. */
typedef struct {
    GLuint column, row, columns, rows;
    GLuint fragments;
} ShadowPart;

/* Transparent fragments of the maps' texels: glass_store.glsl. */
typedef struct {
    GLuint buffer;
    size_t bytes;
    ShadowPart *parts; /* tiles whose lists use the buffer in turn; a single tile has all texels */
    int part_count;
    bool full; /* the lists of all texels exceed the memory limit */
} ShadowGlass;

/* Transmittance of infinite planes if it varies: plane_transmittance.c. */
typedef struct {
    Material *materials;    /* programs, indexed by layer and plane */
    int layer_count, count; /* number of lights with a layer, number of planes */
    /* Array texture of transmittances per pixel, a layer for each light that casts shadows. */
    GLuint layers;
    int depth_unit; /* texture unit of the depth of the lit surfaces */
} ShadowSheets;

/* The rows of techniques, followed by NULL, and the state of each. */
typedef struct {
    const ShadowMethod *const *rows;
    void *states[SHADOW_METHODS_MAX];
} ShadowMethods;

struct ShadowMaps {
    ShadowViews views;
    ShadowGlass glass;
    ShadowSheets sheets;
    GLuint maps; /* array of depth maps, a layer for each view */
    /* Texture of the views, four texels each: their rows from eye space; near, texel. */
    GLuint table;
    GLuint planes;         /* texture of infinite planes in eye space */
    GLuint framebuffer;    /* framebuffer whose target is the drawn layer */
    Material solid;        /* program that draws depth only; lives as long as the renderer */
    bool drawn;            /* the maps are up to date with the scene */
    bool seen;             /* the target `seen` is up to date with this frame's camera */
    ShadowMethods methods; /* state of the techniques; lives as long as the renderer */
};
#endif
