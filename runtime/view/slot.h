/* How a slot of the G-buffer becomes a colour that one can look at. */
#ifndef MATC_VIEW_SLOT_H
#define MATC_VIEW_SLOT_H
#include <stddef.h>

typedef struct SlotLook SlotLook;

enum { SLOT_LOOK_COUNT = 30 };
const char *slot_look_name(int i);
/* NULL if there is no such slot. */
const SlotLook *slot_look_find(const char *name);
/* So many pixels of four floats, as render_read has them of a view of the slot, become what is
 * shown, 0 to 1: colours as sRGB, normals in the eye's space with (0.5, 0.5, 1) for what faces it,
 * exponents as their logarithm to base 2, of 16. What is no surface is nearly black. */
void slot_look_show(const SlotLook *look, float *rgba, size_t pixels);
/* IEC 61966-2-1, of what is cut to 0 and 1; no number is 0. */
double slot_encoded(double linear);
#endif
