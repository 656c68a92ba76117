/* Writes a document with one line for each light. */
#include "tests/frame/frame_lamps.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 1 << 20 };

/* Random number in [0, 1]. */
static double chance(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.;
}

#define APPEND(...) size += (size_t)snprintf(text + size, TEXT - size, __VA_ARGS__)

char *frame_lamps_text(const FrameLamps *c, int width, int height)
{
    char *text = malloc(TEXT);
    size_t size = 0;
    uint32_t state = 7;
    if (!text)
        abort();
    APPEND("image: { width: %d, height: %d }\n%slights:\n", width, height, c->head);
    for (int i = 0; i < c->count; i++) {
        const double x = chance(&state), y = chance(&state), z = chance(&state);
        const double red = chance(&state), green = chance(&state), blue = chance(&state);
        const char *const kind = strcmp(c->kind, FRAME_LAMPS_BOTH) != 0 ? c->kind
                                 : i % 3                                ? "Point"
                                                                        : "Spot";
        APPEND("- { light: %s, intensity: %.6f, color: [%.3f, %.3f, %.3f], shadows: false", kind,
               c->sum / c->count * (i == 0 ? c->bright : 1), red, green, blue);
        if (strcmp(kind, "Directional") != 0)
            APPEND(", position: [%.4f, %.4f, %.5f]", c->reach * (2 * x - 1), c->reach * (2 * y - 1),
                   c->low + (c->high - c->low) * z);
        if (strcmp(kind, "Point") != 0)
            APPEND(", direction: [%.4f, %.4f, -1]", x - .5, y - .5);
        if (!strcmp(kind, "Spot"))
            APPEND(", innerAngle: %.2f, outerAngle: %.2f", 40 + 30 * x, 70 + 15 * y);
        APPEND(" }\n");
    }
    if (size >= TEXT)
        abort();
    return text;
}

double frame_lamps_mapped(SceneKind tone, double x, double greatest)
{
    const double knee = .7, over = x > knee ? (x - knee) / (1 - knee) : 0;
    const double y = tone == SCENE_Filmic     ? x * (2.51 * x + .03) / (x * (2.43 * x + .59) + .14)
                     : tone == SCENE_Shoulder ? fmin(x, knee) + (1 - knee) * over / (1 + over)
                     : tone == SCENE_Exponential ? x / greatest * (1 - exp(-greatest))
                     : tone == SCENE_Linear      ? x / greatest
                                                 : x;
    return y < 0 ? 0 : y > 1 ? 1 : y;
}

double frame_lamps_encoded(double y)
{
    return y <= .0031308 ? 12.92 * y : 1.055 * pow(y, 1 / 2.4) - .055;
}

double frame_lamps_shown(SceneKind tone, double exposure, double light)
{
    return frame_lamps_encoded(frame_lamps_mapped(tone, light * exposure, 1));
}
