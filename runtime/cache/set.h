/* A scene's materials as one set: one layout, a program for each material and each pass that draws
 * it; those that differ in numbers only share a text, and take their numbers from a buffer. */
#ifndef MATC_CACHE_SET_H
#define MATC_CACHE_SET_H
#include "grammar/layout_tables.h"
#include "runtime/gl/context.h"
#include "runtime/scene/scene.h"

#define SET_SHEET "sheet" /* the pass plane, of transparency alone */

typedef struct {
    int material; /* in Scene.materials */
    /* "gbuffer", "plane", "sky"; what casts shadows: "shadow", "value", and of planes SET_SHEET */
    const char *pass;
    bool transparent; /* at least in places */
    /* the program with which it casts shadows; -1: none of its own. Of a plane: where its
     * transparency varies */
    int caster;
    /* the program that leaves out where it lets more than half of the light through, the pass
     * "shadow"; -1: none */
    int cut;
    MatcProgram *program; /* its numbers, textures and uniforms */
    /* in Set.programs: whose text it is drawn with; itself, or one before it */
    int text;
    int next;         /* that is drawn with it; -1: none */
    int row;          /* among those of that text */
    int other;        /* program of the material, from 1; 0: none */
    bool even;        /* it is transparent by the same everywhere, */
    float through[3]; /* namely by so much */
} SetProgram;

/* How what is transparent casts shadows. */
typedef enum {
    SET_CASTS_none, /* nothing does */
    /* as if it were opaque where it lets half of the light through, or less; elsewhere none */
    SET_CASTS_cut,
    SET_CASTS_colored /* by what it lets through */
} SetCasts;

/* Programs that exist beside those that draw the picture. */
typedef struct {
    SetCasts casts;
    /* voxels are made: of surfaces whose transparency varies, what is cut away is asked for */
    bool cuts;
    bool even; /* surfaces that are transparent by the same everywhere cast without a program */
} SetUses;

typedef struct {
    MatcLayout *layout; /* NULL: a named one */
    /* of the pass SET_SHEET: three floats, what is let through; NULL: nothing is drawn with it */
    MatcLayout *sheet;
    const char *target; /* of the GLSL */
    /* GLSL that reads back the cases that the materials take; NULL: there is no surface */
    const char *unpack;
    SetProgram *programs;
    int *of_material; /* the last program of each, from 1; 0: none */
    int count;
    int texts; /* so many different ones */
    SetUses uses;
    bool instances; /* programs of surfaces draw instances (instances.h) */
} Set;

/* `compile` has the choices; its layout NULL: the smallest that holds the scene's materials.
 * Transparent materials of surfaces have programs for these uses. False: see gl->error. *made is
 * empty then. */
bool set_make(GlContext *gl, const Scene *scene, const MatcOptions *compile, SetUses uses,
              Set *made);
void set_free(Set *set);

/* Puts the place and the name of a material before what gl->error says of it. False. */
bool set_fail(GlContext *gl, const Scene *scene, int material);

/* The program of a material in a pass; NULL: there is none. */
const SetProgram *set_find(const Set *set, int material, const char *pass);
/* So many programs are drawn with that text. */
int set_rows(const Set *set, int text);
/* Texts to draw with. */
const char *set_vertex(const Set *set, const SetProgram *program);
const char *set_fragment(const Set *set, const SetProgram *program);
/* The layout, of `compile` where it was named there. */
const LayoutRow *set_layout(const Set *set, const MatcOptions *compile);
/* Formats of the G-buffer's targets: NULL behind the last. */
const char *set_format(const Set *set, int target);
#endif
