/* What a frame is drawn with. Private to frame.c, render.c and the passes. */
#ifndef MATC_RENDER_FRAME_H
#define MATC_RENDER_FRAME_H
#include "runtime/cache/cache.h"
#include "runtime/draw/reader.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/render/exact.h"
#include "runtime/render/frame_plan.h"
#include "runtime/render/indirect.h"
#include "runtime/render/measure.h"
#include "runtime/render/radiance.h"
#include "runtime/render/render.h"
#include "runtime/render/shadow.h"
#include "runtime/render/volume.h"
#include "runtime/render/voxels.h"

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
    bool triangles; /* something asks for those that are drawn, wherever they are made */
    Transparency transparency;
    bool parted; /* lists of shadows are drawn in parts: shadow_parts.c */
    Set set;
    ViewSpace space;
    CullVolume volume; /* what is in view */
    Cache cache;
    Screen screen;
    bool has_screen;
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

/* Silhouettes find shadows, and light is drawn: so are facets, if the driver can. And something casts, so that the target is there. facet_lights.c */
bool facet_lights_write(const Render *render);
bool facet_lights_cast(const Render *render);
/* These, or numbers of triangles: there is the target seen. */
bool facet_lights_seen(const Render *render);

/* The sky as a light (light_sky.c): the scene has one that shines; makes render->sky, with the cache's sky; tells a pass; binds its map. */
bool light_sky_shines(const Scene *scene);
bool light_sky_make(Render *render);
void light_sky_set(const Render *render, int unit, ScreenPass *pass);
void light_sky_bind(const Render *render, int unit);

/* Whether there is something to count; it begins, goes on in each tile, where what the pass reads is drawn then, once more in all tiles where `again`
 * says so, and ends. */
typedef enum { FRAME_COUNT_wanted, FRAME_COUNT_begin, FRAME_COUNT_tile, FRAME_COUNT_again, FRAME_COUNT_end } FrameCount;

/* Sets what was set before in a scene that is made again; forgets it. render_param.c */
void render_param_again(Render *render);
/* Keeps what the scene's lights are, as all is made for it: render_lights.c. Whether they are so still. */
bool render_lights_keep(Render *render);
bool render_lights_kept(const Render *render);
void render_param_forget(Render *render);

Slot render_find_slot(const char *name); /* SLOT_COUNT: there is none */

/* A pass, as a row: frame.c has the list. */
typedef struct {
    FramePlanPass plan;
    bool (*needed)(const Render *render); /* there is something to do */
    bool (*make)(Render *render);         /* its programs; NULL: the cache has them */
    void (*draw)(Render *render);
    const char *when; /* it is needed, in words */
    /* How much there is to do, where that is counted, and counted again when the scene has changed; or NULL. */
    bool (*count)(Render *render, FrameCount step);
} FramePass;

extern const FramePass frame_passes[];
int frame_pass_count(void);

/* The format of a target's texture, "RGBA16F"; NULL: it has no such texture. */
const char *frame_format(const Render *render, FrameTarget target, int texture);
int frame_bytes(const Render *render, FrameTarget target);          /* of a pixel */
int frame_edge(const Render *render, FrameTarget target, int axis); /* of its textures: the picture has no samples */
int frame_shared_bytes(const Render *render, FrameTarget target);   /* of these, in memory of targets before it */
int frame_all_bytes(const Render *render); /* of a pixel, in all memory there is, but for lists */
/* How textures of a target can share memory. */
FramePlanTarget frame_plan_target(const Render *render, FrameTarget target);
const char *frame_target_name(FrameTarget target);

/* Makes what draws to targets that are there. */
bool frame_make_draw(Render *render, FrameDraw draw);
/* Draws to these targets from now on, by the picture's coordinates. */
void frame_use(const Render *render, const Framebuffer *framebuffer);
/* Tells the passes where the tile is. */
void frame_place(Render *render);

/* Decides what runs, and makes targets and programs of that. */
bool frame_make(Render *render);
/* Counts what there is to do; the scene has changed. */
bool frame_count(Render *render);
void frame_draw(Render *render);
/* Brings up to date what depends on that (a sum of RenderChange), but for the cache. */
bool frame_change(Render *render, unsigned what);
void frame_delete(Render *render);
/* Why a pass does not run; NULL: it does. */
const char *frame_reason(const Render *render, const FramePlanRequest *request, int pass);
/* What the plan was asked for. */
void frame_request(const Render *render, FramePlanRows *made);

/* The passes' own functions. */
bool pass_surface_needed(const Render *render);
void pass_surface_draw(Render *render);
bool pass_plane_needed(const Render *render);
void pass_plane_draw(Render *render);
/* The view is one of these; what has to be as a tile's place, the camera, or objects are others. */
bool pass_positions_is_view(const char *view);
bool pass_positions_needed(const Render *render);
bool pass_positions_make(Render *render);
void pass_positions_place(Render *render);
void pass_positions_draw(Render *render);
void pass_positions_delete(Render *render);
bool pass_sky_needed(const Render *render);
void pass_sky_draw(Render *render);
bool pass_shadow_needed(const Render *render);
bool pass_shadow_make(Render *render);
/* The maps are drawn again, and room found for their lists. False: see the context's error. */
bool pass_shadow_count(Render *render);
void pass_shadow_draw(Render *render);
void pass_shadow_delete(Render *render);
bool pass_gather_needed(const Render *render);
bool pass_gather_make(Render *render);
void pass_gather_draw(Render *render);
bool pass_light_needed(const Render *render);
bool pass_light_make(Render *render);
void pass_light_draw(Render *render);
bool pass_edge_needed(const Render *render);
/* What is asked for and not there; NULL: nothing. */
const char *pass_edge_lacks(const Render *render);
bool pass_edge_make(Render *render);
/* The camera or objects have moved: looks for the lines again. */
bool pass_edge_change(Render *render);
void pass_edge_place(Render *render);
void pass_edge_draw(Render *render);
void pass_edge_delete(Render *render);
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
bool pass_lists_needed(const Render *render);
bool pass_lists_make(Render *render);
bool pass_lists_count(Render *render, FrameCount step);
bool pass_peel_count(Render *render, FrameCount step);
void pass_lists_draw(Render *render);
void pass_lists_delete(Render *render);
bool pass_blend_make(Render *render);
void pass_blend_draw(Render *render);
bool pass_peel_needed(const Render *render);
bool pass_peel_make(Render *render);
void pass_peel_draw(Render *render);
void pass_peel_delete(Render *render);
bool pass_tools_needed(const Render *render);
bool pass_tools_make(Render *render);
/* The camera or lights are others. */
bool pass_tools_change(Render *render);
void pass_tools_place(Render *render);
void pass_tools_draw(Render *render);
void pass_tools_delete(Render *render);
/* The pass runs, and has its target. */
bool pass_tools_are_there(const Render *render);
/* In tiles, what tone mapping asks of the whole picture. */
bool pass_tone_count(Render *render, FrameCount step);
bool pass_tone_make(Render *render);
void pass_tone_draw(Render *render);
void pass_tone_delete(Render *render);

/* What surfaces are drawn with: the framebuffer and the depth test; then the state of a context that begins. */
void pass_surface_begin(const Render *render, const Framebuffer *framebuffer, GLenum test);
void pass_surface_end(const Render *render);
/* Draws the planes that are opaque, or the others. */
void pass_plane_planes(Render *render, bool transparent);

/* What a pass lights, and by what: layers of what is transparent by all lights; what is nearest, at which hybrid shadows were counted, by all lights but
 * those that indirect light dims; or that by light from all around alone, without any that has a place, and without shadows; nodes of cached radiance, by the lights of what is
 * nearest. */
typedef enum { LIGHTING_layers, LIGHTING_nearest, LIGHTING_around, LIGHTING_nodes } LightingOf;

/* A pass that lights surfaces: its own GLSL stands behind what reads the G-buffer, the surface model and lighting.glsl. */
typedef struct {
    const char *body[7];
    bool over; /* it is passOver() */
    int block; /* of screen_pass.h */
    LightingOf of;
} LightingText;
enum {
    LIGHTING_UNITS = FRAMEBUFFER_COLORS + 10,
    LIGHTING_FREE_UNIT = LIGHTING_UNITS /* for a texture of the pass's own */
};
bool lighting_make(Render *render, const LightingText *text, ScreenPass *made);
/* For a pass that lays something transparent over the light, with the text of it that gives no light: and over the tools, where there are some. */
bool pass_tools_make_veil(Render *render, const LightingText *text);
void pass_tools_draw_veil(Render *render);
/* GLSL of backdropAt(), or "": for the pass tone; for passes that light, if something is transparent. What a pass shows of it may be light. */
const char *backdrop_text(const Render *render);
const char *backdrop_light_text(const Render *render);
void backdrop_set(const Render *render, bool light, ScreenPass *pass);
/* Counts the lights, and writes their numbers. */
bool lighting_lights(Render *render);
/* Numbers of lights: written, or written again; what the lighting's GLSL goes by; handed to a pass that lights; bound to a unit; deleted. */
enum { LIGHT_TABLE_DEFINITION = 64 };
bool light_table_write(Render *render, int unit);
void light_table_define(const Render *render, bool scattered, char defined[LIGHT_TABLE_DEFINITION]);
void light_table_set(const Render *render, int unit, ScreenPass *pass);
void light_table_bind(const Render *render, int unit);
void light_table_delete(Render *render);
/* Tells it where the tile is, if it is made. */
void lighting_place(const Render *render, ScreenPass *pass);
void pass_tone_place(Render *render);
/* The camera or lights are others; there are as many. */
bool lighting_change(Render *render, ScreenPass *pass);
/* Runs it over the light, once for each part of shadows' lists. It reads these targets, and a texture of its own, or 0. */
typedef struct {
    FrameTarget surfaces, depth;
    GLuint own;
} LightingSource;
void lighting_run(Render *render, const LightingSource *source, ScreenPass *pass);
/* Binds what it reads, before it runs. */
void lighting_bind(const Render *render, FrameTarget surfaces, FrameTarget depth);

/* What the cache is made of. */
CacheSource frame_source(const Render *render);

/* The texture of a target, and its number among those that are there together. */
GLuint frame_texture(const Render *render, FrameTarget target, int texture);
#endif
