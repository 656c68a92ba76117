/* Random choices by a linear congruential generator. */
#include "tests/frame/frame_random.h"
#include <stdio.h>
#include <stdlib.h>

static uint64_t state;

/* Random number in [0, 1). */
static double part(void)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (double)(state >> 11) / 9007199254740992.0;
}

static double between(double low, double high) { return low + (high - low) * part(); }

enum { TEXT = 1 << 20, MATERIALS = 5 };

static const char *const kinds[] = {"Sphere", "Box, size: [1, .3, 2]", "Cylinder",
                                    "Cone, radius: .2"};

char *frame_random_text(uint64_t seed, int count, bool orthographic)
{
    state = seed;
    char *text = malloc(TEXT);
    size_t size = (size_t)snprintf(text, TEXT,
                                   "image: { width: 96, height: 64 }\ncamera: { camera: %s, "
                                   "position: [%g, %g, %g], target: [0, 0, 0], %s }\n"
                                   "lights: [{ light: Point, position: [4, -4, 4], intensity: 30 "
                                   "}, { light: Ambient, intensity: .2 "
                                   "}]\nmaterials:\n",
                                   orthographic ? "Orthographic" : "Perspective", between(-5, 5),
                                   between(-5, 5), between(1, 3),
                                   orthographic ? "size: 4, depth: 6" : "angle: 60, near: .3");
    for (int i = 0; i < MATERIALS; i++)
        size += (size_t)snprintf(
            text + size, TEXT - size,
            i % 2 ? "  m%d: { material: Phong, diffuse: { map: Checker, color1: %g } }\n"
                  : "  m%d: { material: Phong, diffuse: [%g, .5, .2], ambient: .4 }\n",
            i, between(.2, .9));
    size += (size_t)snprintf(text + size, TEXT - size, "objects:\n");
    for (int i = 0; i < count; i++)
        size +=
            (size_t)snprintf(text + size, TEXT - size,
                             "- { object: %s, material: m%d, transform: { translation: [%.3f, "
                             "%.3f, %.3f], rotation: "
                             "[%.3f, %.3f, 0], scale: [%.3f, %.3f, .5] } }\n",
                             kinds[(int)(4 * part())], (int)(MATERIALS * part()), between(-8, 8),
                             between(-8, 8), between(-8, 8), between(-3, 3), between(-3, 3),
                             between(-1, 1) + 1.1, part() < .3 ? -.7 : between(.1, 2));
    return text;
}
