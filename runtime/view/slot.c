/* A row for each slot. */
#include "runtime/view/slot.h"
#include <string.h>

/* Exponents reach from 1 to 2^16. */
#define EXPONENT(slot) "vec3(log2(max(s." slot ", 1.)) / 16.)"

static const SlotLook looks[SLOT_LOOK_COUNT] = {
    {"normal", ".5 + .5 * s.normal", false}, /* in the eye's space: what faces the eye is (128, 128, 255) */
    {"diffuse", "s.diffuse", true},
    {"alpha", "vec3(s.alpha)", false},
    {"specular", "s.specular", true},
    {"shininess", EXPONENT("shininess"), false},
    {"transparency", "s.transparency", true},
    {"transparencyShininess", EXPONENT("transparencyShininess"), false},
    {"interpolatedTransparency", "vec3(s.interpolatedTransparency)", false},
    {"diffuseTransparency", "s.diffuseTransparency", true},
    {"ambient", "s.ambient", true},
    {"emissive", "s.emissive", true},
    {"ior", "vec3(s.ior - 1.)", false},
};

const char *slot_look_name(int i) { return looks[i].name; }

const SlotLook *slot_look_find(const char *name)
{
    for (int i = 0; i < SLOT_LOOK_COUNT; i++)
        if (!strcmp(looks[i].name, name))
            return &looks[i];
    return NULL;
}
