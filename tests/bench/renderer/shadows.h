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
    const char *plot; /* prefix of file names; or NULL */
    ShadowsMethod methods[SHADOWS_METHODS_MAX];
    int method_count, pcf;
} Shadows;

/* A list of methods, and the minimum seconds of a frame by each: of a static scene; and with a
 * moving light, so that all shadows are redrawn. NAN if not timed. */
typedef struct {
    const ShadowsMethod *methods;
    int count, map_size;
    const Shape *mesh;
    int size[2];    /* size of the picture; 0: by the driver */
    double seconds; /* duration of the measurement, after a few warm-up frames */
} ShadowsTiming;
typedef struct {
    double still, moving;
} ShadowsTime;
/* Returns false after a message on standard error. */
bool shadows_time(const Shadows *s, const ShadowsTiming *timing, ShadowsTime *times);

/* Tables; they return false after a message. Data paths by map size; the thesis' table of
 * polygons and its charts; pixels that flicker under a moving light. */
bool shadows_paths(const Shadows *s);
bool shadows_polygons(const Shadows *s);
/* Prints table 1 of the thesis (Möck 2006), frames per second, next to ours. --quick omits rows
 * of many polygons. */
bool shadows_table1(const Shadows *s);
bool shadows_steps(const Shadows *s);
/* The thesis' claims of quality. */
bool shadows_claims(const Shadows *s);
#endif
