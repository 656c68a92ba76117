/* The rows of foreign_kinds.def: what other tools call maps, materials and parameters, and what that is here. */
#ifndef MATC_FOREIGN_TABLE_H
#define MATC_FOREIGN_TABLE_H
#include "tables.h"

typedef enum { FOREIGN_MAP, FOREIGN_MATERIAL, FOREIGN_PARAM, FOREIGN_KEY, FOREIGN_SCENE, FOREIGN_PLACE } ForeignGroup;

typedef struct {
    ForeignGroup group;
    Kind kind; /* of a parameter: whose it is */
    const char *name;
    const char *here;
} ForeignRow;
extern const ForeignRow foreign_table[];
extern const int foreign_count;

/* What that is here, or NULL: nobody knows the name. Case, '_', '-' and spaces do not matter: "base_diffuse_roughness" is the row
 * baseDiffuseRoughness. `kind` is read of parameters alone. */
const char *foreign_name(ForeignGroup group, Kind kind, const char *name);
#endif
