/* State that the tables of matbench shadows share. */
#ifndef SHADOWS_H
#define SHADOWS_H
#include "shadows_scene.h"
#include <stdio.h>

typedef struct {
    GlContext *gl;
    MatcOptions compile;
    bool timed, quick;
    int map_size;
    Shape mesh;
    const char *plot; /* begins names of files; or NULL */
    ShadowsMethod methods[SHADOWS_METHODS_MAX];
    int method_count, pcf;
} Shadows;

/* A list of methods, and the least seconds that a frame takes by each: of a scene that stands
 * still; of light that moves, so that all is drawn anew. NAN where nothing is timed. */
typedef struct {
    const ShadowsMethod *methods;
    int count, map_size;
    const Shape *mesh;
    int size[2];    /* of the picture; 0: by the driver */
    double seconds; /* that is measured for, if each was drawn a few times before */
} ShadowsTiming;
typedef struct {
    double still, moving;
} ShadowsTime;
/* False: said on standard error. */
bool shadows_time(const Shadows *s, const ShadowsTiming *timing, ShadowsTime *times);

/* Tables; false: said. Paths of data by sizes of maps; the thesis' table of polygons and its
 * charts; pixels that flicker while the light moves. */
bool shadows_paths(const Shadows *s);
bool shadows_polygons(const Shadows *s);
/* Prints table 1 of the thesis (Möck 2006), frames a second, beside ours. --quick omits rows of
 * many polygons. */
bool shadows_table1(const Shadows *s);
bool shadows_steps(const Shadows *s);
/* The thesis' claims of quality. */
bool shadows_claims(const Shadows *s);
#endif
