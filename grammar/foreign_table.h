/* The rows of foreign.def: what other tools and languages call things, and what that is here. */
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
    Kind kind; /* of a parameter: whose it is */
    const char *name;
    const char *written; /* of a form: an example, as it stands behind a key; else NULL */
    const char *here;
} ForeignRow;
extern const ForeignRow foreign_table[];
extern const int foreign_count;

/* The `here` of the row; NULL: there is none. Case, '_', '-' and spaces do not matter, but in
 * formulas: "base_diffuse_roughness" is the row baseDiffuseRoughness. `kind` is read of parameters
 * alone. */
const char *foreign_name(ForeignGroup group, Kind kind, const char *name);
/* Whether two names differ in case, '_', '-' and spaces at most. */
bool foreign_is_alike(const char *a, const char *b);
#endif
