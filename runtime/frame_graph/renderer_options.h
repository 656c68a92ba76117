/* Options of a renderer. */
#ifndef MATC_FRAME_GRAPH_RENDERER_OPTIONS_H
#define MATC_FRAME_GRAPH_RENDERER_OPTIONS_H
#include "compiler/matc.h"
#include "runtime/surface/surface_model.h"

typedef struct Renderer Renderer;

/* Antialiasing of edges: coverage blends both sides of outlines, creases and horizons by the
 * share of the pixel that each covers. */
typedef enum { RENDERER_EDGES_none, RENDERER_EDGES_coverage } RendererEdges;

enum {
    RENDERER_MEMORY = 256 << 20,
    RENDERER_TILE_MIN = 16, /* min rows of a tile, however small the memory */
    RENDERER_SAMPLES_MAX = 8
};

typedef struct {
    /* Compile options of all programs. A NULL layout selects the smallest that holds the scene's
     * materials; normals are always stored in eye space. Copied. */
    const MatcOptions *compile;
    /* The result to read: "final", the picture (NULL); "light"; "depth"; or a slot such as
     * "normal". "shadow" draws only shadow maps (renderer_read_map). "wireframe" is the picture
     * with objects as lines. Debug views of shadow volumes: "volume" and "volumeWireframe" add
     * them to the picture; "wireframes" draws both as lines; "volumeAlone" and
     * "volumeWireframeAlone" omit the objects. */
    const char *view;
    int width, height; /* size of the picture; 0: the scene's size */
    int samples;       /* n: each pixel is the mean of n x n samples, taken in linear light; 0: 1 */
    /* light is stored as 32-bit floats, the picture with 16 bits per component */
    bool deep;
    /* The picture is linear radiance, without exposure, tone mapping or an upper limit. */
    bool linear;
    RendererEdges edges; /* antialiasing of the picture; coverage needs OpenGL 4.3 */
    /* Max bytes of targets; 0: RENDERER_MEMORY. A picture that needs more is drawn in tiles. */
    size_t memory;
    int tile[2];     /* max size of a tile in pixels; 0: what fits into `memory` */
    bool no_shadows; /* disables all shadows */
    /* "lists" (per-pixel linked lists), "peeling" (depth peeling), or "auto" (NULL): lists if
     * the driver supports them and their memory suffices. */
    const char *transparency;
    /* "all": sums each light at each pixel. "bounded": sums distant lights together, within an
     * error bound that holds for the picture with 8 bits, or for light as half floats
     * (light_bound.c lists the tone mappings). "auto" (NULL): "bounded" if the scene has many
     * lights and the picture is of that kind. */
    const char *lights;
    /* Max bytes of linked lists; 0: 1 GiB, or the driver's limit of a buffer. */
    size_t list_bytes;
    /* Draws all surfaces as opaque: a view of a slot shows the nearest surface. */
    bool opaque;
    /* Full-screen passes are fragment programs even if compute programs are supported. */
    bool fragment;
    const SurfaceModel *surface; /* BRDF of all materials; NULL: that of the layout */
    bool unculled;               /* disables frustum culling: for tests */
} RendererOptions;

/* Parts of the scene that the caller may change in place, without a rebuild of programs,
 * textures, meshes or targets. */
typedef enum {
    RENDERER_CAMERA = 1, /* all properties of the camera */
    /* All numbers of lights. A change of kind, shadow technique or number of lights rebuilds the
     * scene's resources. */
    RENDERER_LIGHTS = 2,
    RENDERER_TIME = 4 /* the time that materials read; displaced meshes keep their shape */
} RendererChange;
#endif
