/* One way to compile a material: a choice on every axis of grammar/variants.def, and a layout. */
#ifndef MATC_MEASURE_VARIANT_H
#define MATC_MEASURE_VARIANT_H
#include "compiler/matc.h"
#include "grammar/tables.h"

typedef struct {
    int choice[AXIS_COUNT]; /* indices of choice_table */
    int layout;             /* of layout_table */
} Variant;

/* Axes that may vary. */
typedef struct {
    bool axis[AXIS_COUNT];
    bool layout;
} VariantAxes;

enum { VARIANT_LIMIT = 8192, VARIANT_NAME = 256 };

/* The variant that options mean. False: they name what does not exist. */
bool variant_of(const MatcOptions *options, Variant *variant);
/* Axes that options leave open: those that neither their own option nor --precision sets; the
 * layout without --layout. */
VariantAxes variant_open(const MatcOptions *options);
/* Options that name all of a variant, whatever else `base` says. */
MatcOptions variant_options(const Variant *variant, const MatcOptions *base);
/* Compiles a material for GLSL 3.30, without glslang. NULL: it does not compile. Free with
 * matc_program_free. */
MatcProgram *variant_compile(const MatcDocument *document, int material, unsigned outputs,
                             const MatcOptions *options);
/* Every combination of what is open, `base` itself first, then by how many choices differ from it;
 * at most VARIANT_LIMIT. From malloc. */
Variant *variant_list(const Variant *base, const VariantAxes *open, int *count);
/* Programs are equal up to the comment that names the choices. */
bool variant_programs_equal(const char *a, const char *b);
/* How many choices differ, the layout counted in. */
int variant_distance(const Variant *a, const Variant *b);
/* The names of what differs from `base`, with blanks between: "aa=box layout=thesis"; "as given"
 * when nothing does. */
void variant_name(const Variant *variant, const Variant *base, char name[VARIANT_NAME]);
#endif
