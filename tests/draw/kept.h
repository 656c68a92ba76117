/* Compares a material's slots drawn unpacked with those unpacked from the G-buffer. */
#ifndef MATC_VALUE_KEPT_H
#define MATC_VALUE_KEPT_H
#include "gbuffer.h"

/* Results over any number of materials. */
typedef struct {
    int materials, fields;
    long values;
    double worst; /* share of its bound that an error took */
    int drawn[8]; /* materials by the case that they took */
    char error[1024];
} Kept;

/* A document's material, compiled with these options. */
typedef struct {
    Document *document;
    int material;
    const MatcOptions *options;
} KeptMaterial;

/* Draws a material's slots and its G-buffer, at the drawer's points, and compares each slot that
 * matters with what comes back: as far as its field promises; where the layout has none, as absent.
 * `matters` NULL: those that the layout has. Normals are another test's. The drawer has POINT_COUNT
 * points. False: see error. */
bool kept_check(Kept *kept, Drawer *drawer, const KeptMaterial *material,
                const bool matters[SLOT_COUNT]);
#endif
