/* An edge is known by the places of its ends, as a number of 64 bits that looks like chance; what is met an even number of times leaves nothing of an
 * exclusive or. So it takes no table, and as long as reading the triangles.
 *
 *     a tetrahedron's six edges: each has two triangles, all leave 0. Without one triangle, the three of its edges are left */
#include "runtime/gl/shape.h"
#include <string.h>

/* The finaliser of SplitMix64: each bit of the result goes by each bit of the argument. */
static uint64_t mix(uint64_t x)
{
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
    x = (x ^ x >> 27) * 0x94D049BB133111EBu;
    return x ^ x >> 31;
}

static uint64_t place_number(const float position[3])
{
    uint64_t number = 0x9E3779B97F4A7C15u;
    for (int i = 0; i < 3; i++) {
        const float lane = position[i] == 0 ? 0 : position[i]; /* -0 is there, too */
        uint32_t bits;
        memcpy(&bits, &lane, sizeof bits);
        number = mix(number + bits);
    }
    return number;
}

bool shape_is_closed(const Shape *shape)
{
    uint64_t left = 0;
    for (int i = 0; i < shape->index_count; i += 3) {
        uint64_t corners[3];
        for (int k = 0; k < 3; k++)
            corners[k] = place_number(shape->vertices[shape->indices[i + k]].position);
        for (int k = 0; k < 3; k++) {
            const uint64_t from = corners[k], to = corners[(k + 1) % 3];
            left ^= from == to ? 0 : mix(from + to); /* without an extent it is no edge */
        }
    }
    return left == 0;
}
