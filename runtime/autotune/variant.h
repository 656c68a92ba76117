/* A variant: one choice on every axis of grammar/variants.def, and a layout. */
#ifndef MATC_AUTOTUNE_VARIANT_H
#define MATC_AUTOTUNE_VARIANT_H
#include "compiler/matc.h"
#include "grammar/tables.h"

typedef struct {
    int choice[AXIS_COUNT]; /* indices into choice_table */
    int layout;             /* index into layout_table */
} Variant;

/* Axes that may vary, and whether the layout may. */
typedef struct {
    bool axis[AXIS_COUNT];
    bool layout;
} VariantAxes;

enum { VARIANT_LIMIT = 8192, VARIANT_NAME = 256 };

/* Sets the variant that the options select. Returns false if they name an unknown choice. */
bool variant_of(const MatcOptions *options, Variant *variant);
/* Returns the axes that the options leave open: set neither by their own option nor by
 * --precision. The layout is open without --layout. */
VariantAxes variant_open(const MatcOptions *options);
/* Returns `base` with every choice and the layout replaced by the variant's. */
MatcOptions variant_options(const Variant *variant, const MatcOptions *base);
/* Compiles a material for GLSL 3.30, without glslang validation. Returns NULL on errors. Free
 * with matc_program_free. */
MatcProgram *variant_compile(const MatcDocument *document, int material, unsigned outputs,
                             const MatcOptions *options);
/* Lists every combination of the open axes: `base` first, then by variant_distance from it. At
 * most VARIANT_LIMIT. Returns an array from malloc. */
Variant *variant_list(const Variant *base, const VariantAxes *open, int *count);
/* Returns whether two programs are equal except for the comment that names the choices. */
bool variant_programs_equal(const char *a, const char *b);
/* Returns the number of differing choices, including the layout. */
int variant_distance(const Variant *a, const Variant *b);
/* Formats the choices that differ from `base`, separated by spaces: "aa=box layout=thesis"; "as
 * given" without differences. */
void variant_name(const Variant *variant, const Variant *base, char name[VARIANT_NAME]);
#endif
