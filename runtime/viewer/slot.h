/* Maps the values of a G-buffer slot to displayable colors. */
#ifndef MATC_VIEWER_SLOT_H
#define MATC_VIEWER_SLOT_H
#include <stddef.h>

typedef struct SlotLook SlotLook;

enum { SLOT_LOOK_COUNT = 30 };
const char *slot_look_name(int i);
/* Returns the mapping of a slot; NULL for an unknown name. */
const SlotLook *slot_look_find(const char *name);
/* Maps `pixels` pixels of four floats, as renderer_read returns them for a slot's view, to display
 * values from 0 to 1. Colors become sRGB. Normals are in view space; (0.5, 0.5, 1) faces the
 * camera. Exponents become log2(exponent) / 16. The background is nearly black. */
void slot_look_show(const SlotLook *look, float *rgba, size_t pixels);
/* Encodes a linear value as sRGB (IEC 61966-2-1) after clamping to [0, 1]. NaN gives 0. */
double slot_encoded(double linear);
#endif
