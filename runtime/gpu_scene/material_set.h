/* A scene's materials as a set: one layout, and a program for each material and pass. Programs
 * that differ only in constants share their text, and read the constants from a buffer. */
#ifndef MATC_GPU_SCENE_MATERIAL_SET_H
#define MATC_GPU_SCENE_MATERIAL_SET_H
#include "grammar/layout_tables.h"
#include "runtime/gl/context.h"
#include "runtime/scene/scene.h"

#define SET_SHEET "sheet" /* name of the pass plane with transparency as its only slot */

typedef struct {
    int material; /* index in Scene.materials */
    /* "gbuffer", "plane", "sky"; for shadow casters "shadow", "value", or, for planes,
     * SET_SHEET. */
    const char *pass;
    bool transparent; /* at least some fragments are transparent */
    /* Index of the program that casts its shadows; -1: none of its own. A plane has one if its
     * transmittance varies. */
    int caster;
    /* Index of the alpha-tested program, of the pass "shadow", which discards fragments that
     * transmit more than half of the light; -1: none. */
    int cut;
    MatcProgram *program; /* the program's constants, textures and uniforms */
    /* Index of the program that has the shared text: this program, or an earlier one. */
    int text;
    int next;         /* next program with the same text; -1: none */
    int row;          /* index among the programs of that text */
    int other;        /* another program of the material, its index + 1; 0: none */
    bool even;        /* transmittance is constant over the surface */
    float through[3]; /* the constant transmittance, RGB */
} PassProgram;

/* Kinds of shadows that transparent surfaces cast. */
typedef enum {
    SET_CASTS_none, /* transparent surfaces cast no shadows */
    /* opaque shadows where a surface transmits at most half of the light; no shadow elsewhere */
    SET_CASTS_cut,
    SET_CASTS_colored /* shadows are colored by the surfaces' transmittance */
} MaterialSetCasts;

/* Programs to make in addition to those that draw the picture. */
typedef struct {
    MaterialSetCasts casts;
    /* Voxels exist: alpha-tested programs for surfaces whose transmittance varies. */
    bool cuts;
    bool even; /* surfaces of constant transmittance cast shadows without a program */
} MaterialSetUses;

typedef struct {
    MatcLayout *layout; /* read or automatic layout; NULL: a built-in one */
    /* Layout of the pass SET_SHEET: transmittance as three floats; NULL if no program has that
     * pass. */
    MatcLayout *sheet;
    const char *target; /* the GLSL version, "glsl330" or "glsl450" */
    /* GLSL that unpacks the layout's cases in use; NULL: the scene has no surface. */
    const char *unpack;
    PassProgram *programs;
    int *of_material; /* indexed by material: its last program, index + 1; 0: none */
    int count;
    int texts; /* number of different texts */
    MaterialSetUses uses;
    bool instances; /* programs of surfaces use instancing (instances.h) */
} MaterialSet;

/* Compiles the scene's materials. `compile` has the options; a NULL layout in it selects the
 * smallest that holds the scene's materials. Transparent surfaces also get the programs for
 * `uses`. Returns false on failure, with *made empty; see gl->error. */
bool material_set_make(GlContext *gl, const Scene *scene, const MatcOptions *compile,
                       MaterialSetUses uses, MaterialSet *made);
void material_set_free(MaterialSet *set);

/* Prepends a material's place and name to gl->error, and returns false. */
bool material_set_fail(GlContext *gl, const Scene *scene, int material);

/* Returns the program of a material in a pass; NULL if missing. */
const PassProgram *material_set_find(const MaterialSet *set, int material, const char *pass);
/* Returns the number of programs that share the text. */
int material_set_rows(const MaterialSet *set, int text);
/* Return the shared texts of a program. */
const char *material_set_vertex(const MaterialSet *set, const PassProgram *program);
const char *material_set_fragment(const MaterialSet *set, const PassProgram *program);
/* Returns the layout of the set, or the one that `compile` names. */
const LayoutRow *material_set_layout(const MaterialSet *set, const MatcOptions *compile);
/* Returns the format of a G-buffer target; NULL after the last. */
const char *material_set_format(const MaterialSet *set, int target);
#endif
