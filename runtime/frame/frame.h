/* What a frame is drawn with. */
#ifndef MATC_FRAME_FRAME_H
#define MATC_FRAME_FRAME_H
#include "runtime/draw/measure.h"
#include "runtime/draw/reader.h"
#include "runtime/frame/frame_indirect.h"
#include "runtime/frame/frame_plan.h"
#include "runtime/frame/frame_shadow.h"
#include "runtime/frame/render_options.h"

typedef enum {
    FRAME_TARGET_depth,
    FRAME_TARGET_gbuffer,
    FRAME_TARGET_traced,   /* which patch a ray met, and where: a pixel of cache_trace.h */
    FRAME_TARGET_shadow,   /* maps of their own size: pass_shadow.c has them */
    FRAME_TARGET_voxels,   /* of their own size, too: pass_voxels.c */
    FRAME_TARGET_cubes,    /* a view of them */
    FRAME_TARGET_positions, /* a view of depth as a mesh */
    FRAME_TARGET_radiance, /* buffers: pass_radiance.c */
    FRAME_TARGET_seen,     /* numbers of triangles, or how steep they are */
    FRAME_TARGET_lists,    /* no texture, but a buffer */
    FRAME_TARGET_far,      /* the same: what the pass gather sums */
    FRAME_TARGET_light,
    FRAME_TARGET_rays,    /* the same, of the pixels for which rays go out */
    FRAME_TARGET_history, /* of its own: pass_history.c */
    FRAME_TARGET_smooth,  /* smoothed along rows */
    FRAME_TARGET_open,    /* openness and indirect light */
    FRAME_TARGET_edge,
    FRAME_TARGET_mask,  /* a bit for each light with hybrid shadows: something keeps it off */
    FRAME_TARGET_layer, /* a G-buffer of transparent fragments */
    FRAME_TARGET_layer_depth,
    FRAME_TARGET_layer_keys, /* of two layers */
    FRAME_TARGET_tools,      /* their colours, as they are seen through what is before them */
    FRAME_TARGET_shown,
    FRAME_TARGET_COUNT
} FrameTarget;

/* Textures that are drawn to together. */
typedef enum {
    FRAME_DRAW_surface, /* G-buffer and depth */
    FRAME_DRAW_seen,    /* the same and what is seen */
    FRAME_DRAW_traced,  /* what rays meet, and depth */
    FRAME_DRAW_sky,     /* light and depth */
    FRAME_DRAW_cubes,
    FRAME_DRAW_positions,
    FRAME_DRAW_light,
    FRAME_DRAW_rays,
    FRAME_DRAW_smooth,
    FRAME_DRAW_open,
    FRAME_DRAW_edge,
    FRAME_DRAW_mask, /* with depth and stencil */
    FRAME_DRAW_shown,
    FRAME_DRAW_COUNT
} FrameDraw;

/* A piece of the targets' memory: as the first target that lies in it sees it. */
typedef struct {
    GLuint texture;
    const char *format;
} FrameMemory;

/* What a target's textures are. */
typedef struct {
    const char *formats[FRAME_PLAN_TEXTURES + 1]; /* "RGBA16F"; NULL behind the last */
    int coarse;                                   /* pixels of the frame along an edge of one of its own */
} FrameForm;

/* Numbers of lights, view_space_lights: light_table.c. */
typedef struct {
    float (*texels)[4];
    int count;      /* of texels, counted up to a power of two */
    GLuint texture; /* with them; 0: a block of each program's own has them */
} LightTable;

enum { SKY_NUMBERS = 31 }; /* three of bands 1, 28 of the even bands to 6 */

typedef struct {
    GLuint map; /* a cube, in the world's axes, with mipmaps; 0: no sky shines */
    float irradiance[SKY_NUMBERS][4];
    bool uneven;    /* it is not the same from everywhere, */
    float first[3]; /* as it is in one place */
} SkyLight;

/* Of pass_gather.c, where lights are many. */
typedef struct {
    ScreenPass groups, near, gather; /* one after the other */
    GLuint numbers, words;           /* storage buffers of far_blocks.glsl */
    GLuint texels, bits;             /* the same as textures, which the pass light reads */
} FrameFar;

/* Of the pass edge. */
typedef struct {
    Material material;
    GLuint lines; /* texels of edge_list.h */
    int count;    /* of lines */
} FrameEdge;

/* Of pass_tools.c. */
typedef struct {
    Material material;
    GLuint array, buffer;      /* of vertices of tool_lines.h */
    int count;                 /* of vertices */
    Framebuffer lines, colors; /* light and the tools' target with depth; that target alone */
    ScreenPass veil;           /* lays what is transparent over the tools: what it lets through */
} FrameTools;

/* Of pass_positions.c. */
typedef struct {
    Material material;
    GLuint array; /* without a buffer: vertices are numbers */
} FramePositions;

/* Of pass_lists.c. */
typedef struct {
    GLuint buffer;
    GLuint fragments; /* that it has room for: as many as there are */
    size_t bytes;
    int depth_unit; /* where the programs of planes find the depth of what is opaque */
    bool full;      /* they would take more than there may be */
} FrameLists;

/* What decides by which programs, maps and targets a light is drawn. */
typedef struct {
    SceneKind kind;
    Word shadows;
    bool both_sides;
} RenderLight;

/* A param of a material that was set. */
typedef struct {
    int material, count;
    char *name;
    float lanes[4];
} RenderParam;

struct Render {
    GlContext *gl;
    Store *store;
    MatcOptions compile;
    RenderOptions options;
    const SurfaceModel *surface;
    char surface_lacks[SURFACE_MODEL_DEFINITIONS];
    const VolumeView *look; /* the view, if it is one of these; or NULL */
    const Scene *scene;
    RenderParam *params; /* that were set since the scene was given */
    int param_count;
    RenderLight *kept_lights; /* as they were when all was made: render_lights.c */
    int kept_light_count;
    int samples;  /* of a pixel, across and down: what follows counts these */
    int size[2];  /* of the targets: of a tile */
    int whole[2]; /* of the picture */
    int at[2];    /* the targets' lower left corner in it */
    int margin;   /* around a tile, that its edges look at */
    bool compute, zero_to_one;
    ExactNumberWhat number; /* what programs of surfaces write of triangles */
    bool triangles; /* something asks for those that are drawn, wherever they are made */
    Transparency transparency;
    bool parted; /* lists of shadows are drawn in parts: shadow_parts.c */
    Set set;
    ViewSpace space;
    CullVolume volume; /* what is in view */
    Cache cache;
    Screen screen;
    bool has_screen;
    FrameForm forms[FRAME_TARGET_COUNT];
    FramePlan plan;
    FrameMemory memory[FRAME_PLAN_PIECES];
    GLuint textures[FRAME_TARGET_COUNT][FRAMEBUFFER_COLORS]; /* of targets: the memory's, or views of these */
    Framebuffer draws[FRAME_DRAW_COUNT];
    Measure measured, adapted;                /* what tone mapping asks of the picture, and of what it makes of that */
    GLuint whole_picture[2];                  /* textures of the same, of all tiles; 0: there is one tile */
    float whole_texels[2][MEASURE_TEXELS][4]; /* what is in them */
    ScreenPass light, tone, blend, peel;
    FrameLists lists;
    Framebuffer layers[2]; /* that are peeled, in turns */
    int layer_count;
    bool uncounted;    /* fragments and layers, since the scene changed */
    int peel_units[2]; /* where their programs find the depth of what is opaque, and the keys */
    FrameEdge edge;
    FrameTools tools;
    FramePositions positions;
    FrameVolumes volumes;
    FrameFar far;
    LightTable lights;
    int light_counts[VIEW_SPACE_SECTIONS];
    ShadowMaps shadows;
    ExactShadows exact;
    FrameVoxels voxels;
    FrameIndirect indirect;
    FrameRadiance radiance;
    SkyLight sky;
    Reader reader; /* of a slot that is viewed */
    bool has_reader;
};

/* Whether there is something to count; it begins, goes on in each tile, where what the pass reads is drawn then, once more in all tiles where `again`
 * says so, and ends. */
typedef enum { FRAME_COUNT_wanted, FRAME_COUNT_begin, FRAME_COUNT_tile, FRAME_COUNT_again, FRAME_COUNT_end } FrameCount;

/* The format of a target's texture, "RGBA16F"; NULL: it has no such texture. */
const char *frame_format(const Render *render, FrameTarget target, int texture);
int frame_bytes(const Render *render, FrameTarget target);          /* of a pixel */
int frame_edge(const Render *render, FrameTarget target, int axis); /* of its textures: the picture has no samples */
int frame_shared_bytes(const Render *render, FrameTarget target);   /* of these, in memory of targets before it */
int frame_plan_bytes(const Render *render);                        /* of a pixel, in all of these */
/* How textures of a target can share memory. */
FramePlanTarget frame_plan_target(const Render *render, FrameTarget target);
const char *frame_target_name(FrameTarget target);

/* Makes what draws to targets that are there. */
bool frame_make_draw(Render *render, FrameDraw draw);
/* Draws to these targets from now on, by the picture's coordinates. */
void frame_use(const Render *render, const Framebuffer *framebuffer);
/* The choice can be met. False: see the context's error. */
bool transparency_check(GlContext *gl, const RenderOptions *options);
/* Lists, if nothing else is wanted, and there are some. */
Transparency transparency_first(const Render *render);
/* Lists would take more than there may be, and are not insisted on. */
bool transparency_falls_back(const Render *render);
bool transparency_has_lists(const GlContext *gl);
/* Of a buffer of fragments. */
size_t transparency_most_bytes(const Render *render);
/* A line on the lists' memory. */
void transparency_put_lists(Text *out, const Render *render);
/* Something is transparent, and that is how it is drawn. */
bool transparency_is(const Render *render, Transparency way);
/* Sets a number of all programs of what is transparent. */
void transparency_set(Render *render, const char *name, float number);
/* The last units that the driver has, for textures of the passes, number 0 and 1. False: a material takes them. */
bool transparency_units(Render *render, int units[2]);

/* What surfaces are drawn with: the framebuffer and the depth test; then the state of a context that begins. */
void surface_draw_begin(const Render *render, const Framebuffer *framebuffer, GLenum test);
void surface_draw_end(const Render *render);
/* The view shows surfaces. Draws the cache's objects, as the view has them; the planes: those that are opaque, or the others. */
bool surface_draw_is_shown(const Render *render);
void surface_draw_objects(Render *render, bool transparent);
void surface_draw_planes(Render *render, bool transparent);

/* What the cache is made of. */
CacheSource frame_source(const Render *render);

/* The texture of a target, and its number among those that are there together. */
GLuint frame_texture(const Render *render, FrameTarget target, int texture);
#endif
