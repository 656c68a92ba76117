/* How a slot of the G-buffer becomes a colour that one can look at. */
#ifndef MATC_VIEW_SLOT_H
#define MATC_VIEW_SLOT_H
#include <stdbool.h>
#include <stddef.h>

typedef struct {
    const char *name;
    const char *shown; /* GLSL: a vec3 made of the Surface s */
    bool encoded;      /* it is linear light, and the picture sRGB; else a lane of 0.5 is a byte of 128 */
} SlotLook;

enum { SLOT_LOOK_COUNT = 12 };
const char *slot_look_name(int i);
/* NULL if there is no such slot. */
const SlotLook *slot_look_find(const char *name);
#endif
