/* What a frame is drawn with. Private to frame.c, render.c and the passes. */
#ifndef MATC_RENDER_FRAME_H
#define MATC_RENDER_FRAME_H
#include "runtime/render/cache.h"
#include "runtime/render/frame_plan.h"
#include "runtime/render/measure.h"
#include "runtime/render/reader.h"
#include "runtime/render/render.h"
#include "runtime/render/screen_pass.h"
#include "runtime/render/shadow_views.h"

typedef enum {
    FRAME_TARGET_depth,
    FRAME_TARGET_gbuffer,
    FRAME_TARGET_shadow, /* maps of their own size: pass_shadow.c has them */
    FRAME_TARGET_light,
    FRAME_TARGET_edge,
    FRAME_TARGET_shown,
    FRAME_TARGET_COUNT
} FrameTarget;

/* Textures that are drawn to together. */
typedef enum {
    FRAME_DRAW_surface, /* G-buffer and depth */
    FRAME_DRAW_sky,     /* light and depth */
    FRAME_DRAW_light,
    FRAME_DRAW_edge,
    FRAME_DRAW_shown,
    FRAME_DRAW_COUNT
} FrameDraw;

/* Memory of a target: one texture, or those of the G-buffer. */
typedef struct {
    GLuint textures[FRAMEBUFFER_COLORS];
    int count;
} FrameMemory;

typedef struct {
    ShadowViews views;
    GLuint maps;        /* an array of depths, a layer for each view */
    GLuint table;       /* texels of the views, four each: their rows from the eye's space; near, texel */
    GLuint planes;      /* texels of infinite planes in the eye's space */
    GLuint framebuffer; /* of the layer that is drawn */
    Material solid;     /* draws depth alone; stays until the renderer goes */
    bool drawn;         /* the maps hold the scene */
} ShadowMaps;

enum { SKY_NUMBERS = 31 }; /* three of bands 1, 28 of the even bands to 6 */

typedef struct {
    GLuint map; /* a cube, in the world's axes, with mipmaps; 0: no sky shines */
    float irradiance[SKY_NUMBERS][4];
} SkyLight;

/* Of the pass edge. */
typedef struct {
    Material material;
    GLuint lines; /* texels of edge_list.h */
    int count;    /* of lines */
} FrameEdge;

struct Render {
    GlContext *gl;
    Store *store;
    MatcOptions compile;
    RenderOptions options;
    const Scene *scene;
    int size[2];  /* of the targets: of a tile */
    int whole[2]; /* of the picture */
    int at[2];    /* the targets' lower left corner in it */
    int margin;   /* pixels around a tile that its edges look at */
    bool compute, zero_to_one;
    Set set;
    ViewSpace space;
    CullVolume volume; /* what is in view */
    Cache cache;
    Screen screen;
    bool has_screen;
    FramePlan plan;
    FrameMemory memory[FRAME_PLAN_MOST];
    Framebuffer draws[FRAME_DRAW_COUNT];
    Measure measured, adapted; /* what tone mapping asks of the picture, and of what it makes of that */
    ScreenPass light, tone;
    FrameEdge edge;
    GLuint lights; /* texels of view_space_lights */
    int light_counts[VIEW_SPACE_SECTIONS];
    ShadowMaps shadows;
    SkyLight sky;
    Reader reader; /* of a slot that is viewed */
    bool has_reader;
};

/* The sky as a light (light_sky.c): the scene has one that shines; makes render->sky, with the cache's sky; tells a pass; binds its map. */
bool light_sky_shines(const Scene *scene);
bool light_sky_make(Render *render);
void light_sky_set(const Render *render, int unit, ScreenPass *pass);
void light_sky_bind(const Render *render, int unit);

/* A pass, as a row: frame.c has the list. */
typedef struct {
    FramePlanPass plan;
    bool (*needed)(const Render *render); /* there is something to do */
    bool (*make)(Render *render);         /* its programs; NULL: the cache has them */
    void (*draw)(Render *render);
    const char *when; /* it is needed, in words */
} FramePass;

extern const FramePass frame_passes[];
int frame_pass_count(void);

/* The format of a target's texture, "RGBA16F"; NULL: it has no such texture. */
const char *frame_format(const Render *render, FrameTarget target, int texture);
int frame_bytes(const Render *render, FrameTarget target);   /* of a pixel */
bool frame_shares(const Render *render, FrameTarget target); /* its memory is that of one before it */
int frame_all_bytes(const Render *render);                   /* of a pixel, in all memory there is */
const char *frame_target_name(FrameTarget target);

/* Draws to these targets from now on, by the picture's coordinates. */
void frame_use(const Render *render, FrameDraw draw);
/* Tells the passes where the tile is. */
void frame_place(Render *render);

/* Decides what runs, and makes targets and programs of that. */
bool frame_make(Render *render);
void frame_draw(Render *render);
/* Brings up to date what depends on that (a sum of RenderChange), but for the cache. */
bool frame_change(Render *render, unsigned what);
void frame_delete(Render *render);
/* What the plan was asked for. The passes are written to `rows`. */
FramePlanRequest frame_request(const Render *render, FramePlanPass rows[FRAME_PLAN_MOST],
                               int classes[FRAME_TARGET_COUNT]);

/* The passes' own functions. */
bool pass_surface_needed(const Render *render);
void pass_surface_draw(Render *render);
bool pass_plane_needed(const Render *render);
void pass_plane_draw(Render *render);
bool pass_sky_needed(const Render *render);
void pass_sky_draw(Render *render);
bool pass_shadow_needed(const Render *render);
bool pass_shadow_make(Render *render);
void pass_shadow_draw(Render *render);
void pass_shadow_delete(Render *render);
bool pass_light_needed(const Render *render);
bool pass_light_make(Render *render);
void pass_light_draw(Render *render);
bool pass_edge_needed(const Render *render);
bool pass_edge_make(Render *render);
/* The camera or objects have moved: looks for the lines again. */
bool pass_edge_change(Render *render);
void pass_edge_place(Render *render);
void pass_edge_draw(Render *render);
void pass_edge_delete(Render *render);
bool pass_tone_make(Render *render);
void pass_tone_draw(Render *render);

/* A pass that lights surfaces: `body` is its own GLSL, behind what reads the G-buffer, the surface model and lighting.glsl. */
bool lighting_make(Render *render, const char *body, ScreenPass *made);
/* Tells it where the tile is, if it is made. */
void lighting_place(const Render *render, ScreenPass *pass);
void pass_tone_place(Render *render);
/* The camera or lights are others; there are as many. */
bool lighting_change(Render *render, ScreenPass *pass);
/* Binds what it reads, before it runs. */
void lighting_bind(const Render *render, FrameTarget surfaces, FrameTarget depth);

/* What lights see, before any pass is made. */
bool shadow_make_views(Render *render);
/* The view is another; or the lights or objects are, and the maps are drawn again. False: lights cast shadows by more or fewer maps. */
bool shadow_change(Render *render, bool drawn_again);
/* Shadows, for lighting.c: definitions, and the GLSL that goes by them; "": no light casts any, and nothing is computed. */
enum { SHADOW_DEFINITIONS = 256, SHADOW_UNITS = 3 };
const char *shadow_text(const Render *render, char defined[SHADOW_DEFINITIONS]);
bool shadow_make_tables(Render *render);
/* Behind the cone of each light: the first of its views, and how many; 0: planes alone; -1: it casts no shadows. */
void shadow_put_lights(const Render *render, float *texels);
/* SHADOW_UNITS units from `unit` on. */
void shadow_samplers(ScreenPass *pass, int unit);
void shadow_bind(const Render *render, int unit);
/* The texture of a target, and its number among those that are there together. */
GLuint frame_texture(const Render *render, FrameTarget target, int texture);
#endif
