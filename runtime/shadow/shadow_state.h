/* What a frame keeps of shadows: data alone, of the passes in runtime/shadow. */
#ifndef MATC_SHADOW_SHADOW_STATE_H
#define MATC_SHADOW_SHADOW_STATE_H
#include "runtime/frame/frame.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/shadow/shadow_views.h"

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

/* What infinite planes let through whose transparency varies: shadow_sheet.c. */
typedef struct {
    Material *materials;    /* by layer and sheet */
    int layer_count, count; /* of lights, of sheets */
    /* an array of shares of each pixel, a layer for each light that casts shadows */
    GLuint layers;
    int depth_unit; /* where they find the depth of what is lit */
} ShadowSheets;

/* Edges of a mesh, in the buffer of all. */
typedef struct {
    int first, count;
} SilhouetteMesh;

typedef struct {
    GLuint crossings;       /* an array of two bytes a texel, a layer for each view that has them */
    GLuint extents;         /* buffer: crossings of a view while they are found */
    GLuint edges, places;   /* buffers: of all meshes; numbers of objects that a view sees */
    SilhouetteMesh *meshes; /* by the cache's meshes */
    int edge_count;
    Material find, pack;
} Silhouettes;

struct ShadowMaps {
    ShadowViews views;
    ShadowGlass glass;
    ShadowSheets sheets;
    Silhouettes silhouettes;
    GLuint maps; /* an array of depths, a layer for each view */
    /* texels of the views, four each: their rows from the eye's space; near, texel */
    GLuint table;
    GLuint planes;      /* texels of infinite planes in the eye's space */
    GLuint framebuffer; /* of the layer that is drawn */
    Material solid;     /* draws depth alone; stays until the renderer goes */
    bool drawn;         /* the maps hold the scene */
};

/* Of pass_volume.c, volume_data.c and volume_blur.c. */
struct FrameVolumes {
    /* by view, of those that are hybrid; caps of those that are perspective */
    Material *sheets, *caps;
    Material *marks; /* of each hybrid light */
    Material *shown; /* as sheets, to be looked at; NULL: they are not */
    int view_count, light_count;
    GLuint array; /* of caps and cells, whose vertices have no numbers but their own */
    Word path;    /* of volume_data.c, as is what follows; never auto */
    GLuint *arrays;
    int array_count;          /* one, or as many as views of hybrid lights */
    GLuint indices, vertices; /* 0: these fetch all */
    GLsizei index_count;      /* of a view */
    Material writer;
    Framebuffer corners; /* of quads, two by two texels each, before they are copied */
    Material blur;
    GLuint sharp;           /* depths before they are blurred */
    GLuint cells, commands; /* of volume_cells.c: buffers of lists of cells, and of draws */
};
#endif
