/* The rows of foreign.def: names in other tools and languages, and their equivalents here. */
#ifndef MATC_FOREIGN_TABLE_H
#define MATC_FOREIGN_TABLE_H
#include "tables.h"

typedef enum {
    FOREIGN_MAP,
    FOREIGN_MATERIAL,
    FOREIGN_PARAM,
    FOREIGN_KEY,
    FOREIGN_TOP,
    FOREIGN_TYPE,
    FOREIGN_SCENE,
    FOREIGN_PLACE,
    FOREIGN_COLOR,
    FOREIGN_FORMULA,
    FOREIGN_FORM,
} ForeignGroup;

typedef struct {
    ForeignGroup group;
    Kind kind; /* kind of a FOREIGN_PARAM row */
    const char *name;
    const char *written; /* FOREIGN_FORM: an example as written after a key; else NULL */
    const char *here;
} ForeignRow;
extern const ForeignRow foreign_table[];
extern const int foreign_count;

/* Returns the `here` of a row; NULL: unknown. Case, '_', '-' and spaces are ignored except in
 * formulas: "base_diffuse_roughness" matches the row baseDiffuseRoughness. `kind` is used for
 * FOREIGN_PARAM only. */
const char *foreign_name(ForeignGroup group, Kind kind, const char *name);
/* Returns true if two names differ at most in case, '_', '-' and spaces. */
bool foreign_is_alike(const char *a, const char *b);
#endif
