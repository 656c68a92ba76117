/* Table of the slots and their mapping to colors. */
#include "runtime/viewer/slot.h"
#include <math.h>
#include <stdbool.h>
#include <string.h>

typedef enum { COLOR, NUMBER, EXPONENT, NORMAL, RATIO, PATH } Look;

struct SlotLook {
    const char *name;
    Look look;
};

static const SlotLook looks[SLOT_LOOK_COUNT] = {
    {"normal", NORMAL},
    {"diffuse", COLOR},
    {"alpha", NUMBER},
    {"specular", COLOR},
    {"shininess", EXPONENT},
    {"transparency", COLOR},
    {"transparencyShininess", EXPONENT},
    {"interpolatedTransparency", NUMBER},
    {"diffuseTransparency", COLOR},
    {"ambient", COLOR},
    {"emissive", COLOR},
    {"ior", RATIO},
    {"metalness", NUMBER},
    {"roughness", NUMBER},
    {"reflectance", NUMBER},
    {"model", NUMBER},
    {"coat", NUMBER},
    {"coatTint", COLOR},
    {"coatRoughness", NUMBER},
    {"coatReflectance", NUMBER},
    {"fuzz", NUMBER},
    {"fuzzColor", COLOR},
    {"fuzzRoughness", NUMBER},
    {"anisotropy", NORMAL},
    {"transmission", NUMBER},
    {"film", NUMBER},
    {"filmPath", PATH},
    {"filmIor", RATIO},
    {"diffuseRoughness", NUMBER},
    {"coatNormal", NORMAL},
};

const char *slot_look_name(int i) { return looks[i].name; }

const SlotLook *slot_look_find(const char *name)
{
    for (int i = 0; i < SLOT_LOOK_COUNT; i++)
        if (!strcmp(looks[i].name, name))
            return &looks[i];
    return NULL;
}

double slot_encoded(double linear)
{
    if (!(linear > 0))
        return 0; /* also replaces NaN, which images cannot hold */
    if (linear >= 1)
        return 1;
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

/* Maps a component of the slot to [0, 1]. */
static double shown(Look look, double value)
{
    switch (look) {
    case NORMAL:
        return .5 + .5 * value;
    case EXPONENT:
        return log2(fmax(value, 1)) / 16; /* exponents range from 1 to 2^16 */
    case RATIO:
        return value - 1;
    case PATH:
        return value / 5; /* thickness in micrometers; at most 5 by slots.def */
    default:
        return value;
    }
}

void slot_look_show(const SlotLook *look, float *rgba, size_t pixels)
{
    const double nothing = .02;
    const bool grey =
        look->look == NUMBER || look->look == EXPONENT || look->look == RATIO || look->look == PATH;
    for (float *end = rgba + 4 * pixels; rgba < end; rgba += 4) {
        const double share = rgba[3];
        /* Component 0 is written last, since all components of a gray pixel read it. */
        for (int component = 2; component >= 0; component--) {
            const double value =
                share * shown(look->look, rgba[grey ? 0 : component]) + (1 - share) * nothing;
            rgba[component] =
                (float)(look->look == COLOR ? slot_encoded(value) : fmin(fmax(value, 0), 1));
        }
        rgba[3] = 1;
    }
}
