/* State of the passes in runtime/light. */
#ifndef MATC_LIGHT_LIGHT_STATE_H
#define MATC_LIGHT_LIGHT_STATE_H
#include "gen/sky_layout.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/gpu_scene/view_space.h"
#include "runtime/gpu_material/screen_pass.h"
#include "runtime/scene/scene.h"

/* Texels of all lights, as view_space_lights() computes them: light_table.c. */
typedef struct {
    float (*texels)[4];
    int count;      /* number of texels, rounded up to a power of two */
    GLuint texture; /* holds the texels; 0: each program has them in a uniform block */
} LightTable;

typedef struct {
    GLuint map; /* cube map of the sky in world space, with mipmaps; 0: no sky gives light */
    /* irradiance of the sky: the first elements of sky.layout.def */
    float irradiance[SKY_WORLD][4];
    bool uneven;    /* the sky's radiance differs by direction */
    float first[3]; /* the sky's first texel, to which all others are compared */
} SkyLight;

/* State of pass_light_cluster.c, for light clustering. */
typedef struct {
    ScreenPass groups, near, gather; /* passes of light clustering, which run in this order */
    GLuint numbers, words;           /* storage buffers of far_blocks.glsl */
    GLuint texels, bits;             /* the buffers as buffer textures, for the pass light */
} FrameFar;

struct FrameLight {
    ScreenPass pass;
    FrameFar far;
    LightTable table;
    int counts[VIEW_SPACE_SECTIONS]; /* number of lights in each section */
    SkyLight sky;
};
#endif
