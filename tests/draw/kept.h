/* Compares a material's slots drawn unpacked with those unpacked from the G-buffer. */
#ifndef MATC_VALUE_KEPT_H
#define MATC_VALUE_KEPT_H
#include "gbuffer.h"

/* Results over any number of materials. */
typedef struct {
    int materials, fields;
    long values;
    double worst; /* greatest error as a share of its bound */
    int drawn[8]; /* number of materials by layout case */
    char error[1024];
} Kept;

/* A document's material, and its compile options. */
typedef struct {
    Document *document;
    int material;
    const MatcOptions *options;
} KeptMaterial;

/* Draws a material's slots and its G-buffer at the drawer's points, and compares each slot that
 * matters with the unpacked value, within its field's bound; a slot that the layout lacks must
 * be absent. `matters` NULL: all slots of the layout. Normals are excluded (another test
 * compares them). The drawer has POINT_COUNT points. Returns false with a message in `error`. */
bool kept_check(Kept *kept, Drawer *drawer, const KeptMaterial *material,
                const bool matters[SLOT_COUNT]);
#endif
