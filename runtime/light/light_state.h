/* State of light: data of the passes in runtime/light. */
#ifndef MATC_LIGHT_LIGHT_STATE_H
#define MATC_LIGHT_LIGHT_STATE_H
#include "gen/sky_layout.h"
#include "runtime/frame/frame.h"
#include "runtime/cache/view_space.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/scene/scene.h"

/* Numbers of lights, view_space_lights: light_table.c. */
typedef struct {
    float (*texels)[4];
    int count;      /* of texels, counted up to a power of two */
    GLuint texture; /* with them; 0: a block of each program's own has them */
} LightTable;

typedef struct {
    GLuint map; /* a cube, in the world's axes, with mipmaps; 0: no sky shines */
    float irradiance[SKY_WORLD][4]; /* the first numbers of sky.layout.def */
    bool uneven;                    /* it is not the same from everywhere, */
    float first[3];                 /* as it is in one place */
} SkyLight;

/* State of pass_gather.c, for many lights. */
typedef struct {
    ScreenPass groups, near, gather; /* one after the other */
    GLuint numbers, words;           /* storage buffers of far_blocks.glsl */
    GLuint texels, bits;             /* the same as textures, which the pass light reads */
} FrameFar;

struct FrameLight {
    ScreenPass pass;
    FrameFar far;
    LightTable table;
    int counts[VIEW_SPACE_SECTIONS]; /* of lights */
    SkyLight sky;
};
#endif
