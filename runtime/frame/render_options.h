/* Options of a renderer. */
#ifndef MATC_FRAME_RENDER_OPTIONS_H
#define MATC_FRAME_RENDER_OPTIONS_H
#include "compiler/matc.h"
#include "runtime/surface/surface_model.h"

typedef struct Render Render;

/* Antialiasing of edges: coverage blends both sides of outlines, creases and horizons by their
 * shares of a pixel. */
typedef enum { RENDER_EDGES_none, RENDER_EDGES_coverage } RenderEdges;

enum {
    RENDER_MEMORY = 256 << 20,
    RENDER_TILE_LEAST = 16, /* rows of a tile, however little memory there may be */
    RENDER_SAMPLES_MOST = 8
};

typedef struct {
    /* how programs compute; layout NULL: the smallest that holds the scene's materials; normals are
     * kept in the eye's space, whatever is chosen. Copied */
    const MatcOptions *compile;
    /* what is read: "shown", the picture (NULL), "light", "depth", or a slot: "normal", ...;
     * "shadow": nothing is, but maps (render_read_map). The picture with objects as lines:
     * "wireframe"; with shadow volumes: "volume", "volumeWireframe", "wireframes",
     * both as lines; these alone: "volumeAlone", "volumeWireframeAlone" */
    const char *view;
    int width, height; /* of the picture; 0: as the scene says */
    int samples;       /* n: a pixel is the mean of n x n samples, as a screen sends light; 0: 1 */
    bool deep;         /* light is kept as floats, and the picture as 16 bits a lane */
    /* the picture is light: linear, without exposure, tone mapping or an upper limit */
    bool linear;
    RenderEdges edges; /* of the picture; coverage takes OpenGL 4.3 */
    /* bytes that targets may take, 0: RENDER_MEMORY; a picture that takes more is drawn in tiles */
    size_t memory;
    int tile[2];     /* at most so many pixels at once; 0: as many as the memory holds */
    bool no_shadows; /* no light casts any */
    /* "lists", "peeling", or "auto" (NULL): lists where there are some, and room for them */
    const char *transparency;
    /* "all": each light is summed at each pixel; "bounded": far ones together, within a bound that
     * holds for the picture as it is shown with 8 bits, or for light as halves (light_bound.c says
     * for which tone mappings); "auto" (NULL): that, where lights are many and that is the
     * picture */
    const char *lights;
    /* that lists may take at most; 0: 1 GiB, or what the driver gives a buffer */
    size_t list_bytes;
    /* surfaces are drawn as if all were opaque: a view of a slot has the nearest */
    bool opaque;
    /* passes over all pixels are fragment programs, also where there is compute */
    bool fragment;
    const SurfaceModel *surface; /* of all materials; NULL: what the layout says */
    bool unculled;               /* what is out of view is drawn, too: for tests */
} RenderOptions;

/* Parts of the scene that the caller may change in place. No program, picture, mesh or target is
 * made for it. */
typedef enum {
    RENDER_CAMERA = 1, /* all of it */
    /* of their numbers none is fixed. Of another kind, with other shadows, or more or fewer: what
     * is made of the scene is made anew */
    RENDER_LIGHTS = 2,
    RENDER_TIME = 4 /* that materials go by; meshes that are displaced stay as they are */
} RenderChange;
#endif
