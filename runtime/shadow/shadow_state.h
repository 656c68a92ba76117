/* State of shadows: data of the passes in runtime/shadow. */
#ifndef MATC_SHADOW_SHADOW_STATE_H
#define MATC_SHADOW_SHADOW_STATE_H
#include "runtime/frame/frame.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/shadow/shadow_views.h"

enum { SHADOW_METHODS_MAX = 16 };

/* Texels of the maps, one above the other, and how many fragments what is transparent has there. */
typedef struct {
    GLuint column, row, columns, rows;
    GLuint fragments;
} ShadowPart;

/* Fragments of what is transparent, of each texel of the maps: glass_store.glsl. */
typedef struct {
    GLuint buffer;
    size_t bytes;
    ShadowPart *parts; /* whose lists take the buffer in turn; all texels, if that is one */
    int part_count;
    bool full; /* all of them would take more than there may be */
} ShadowGlass;

/* Transmittance of infinite planes if it varies: shadow_sheet.c. */
typedef struct {
    Material *materials;    /* by layer and sheet */
    int layer_count, count; /* of lights, of sheets */
    /* an array of shares of each pixel, a layer for each light that casts shadows */
    GLuint layers;
    int depth_unit; /* where they find the depth of what is lit */
} ShadowSheets;

/* The rows of techniques, up to NULL, and the state of each. */
typedef struct {
    const ShadowMethod *const *rows;
    void *states[SHADOW_METHODS_MAX];
} ShadowMethods;

struct ShadowMaps {
    ShadowViews views;
    ShadowGlass glass;
    ShadowSheets sheets;
    GLuint maps; /* an array of depths, a layer for each view */
    /* texels of the views, four each: their rows from the eye's space; near, texel */
    GLuint table;
    GLuint planes;         /* texels of infinite planes in the eye's space */
    GLuint framebuffer;    /* of the layer that is drawn */
    Material solid;        /* draws depth alone; stays until the renderer goes */
    bool drawn;            /* the maps hold the scene */
    bool seen;             /* the target `seen` holds what this frame's camera sees */
    ShadowMethods methods; /* stay, too */
};
#endif
