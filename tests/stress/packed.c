/* Extracts the codes of fields from words. */
#include "packed.h"
#include <math.h>
#include <stdlib.h>

bool packed_in_range(double value, const FormatRow *format)
{
    if (!format->words)
        return fabs(value) <= 65504;
    return value >= 0 && value < ldexp(1, format->bits) && value == floor(value);
}

static uint32_t code_of(const Piece *piece, uint32_t word)
{
    return piece->size == 32 ? word : word >> piece->shift & ((1u << piece->size) - 1);
}

/* A coordinate on the square's rim is adjacent to one on the opposite rim. */
static bool coordinates_agree(uint32_t a, uint32_t b, int bits)
{
    const uint32_t mask = (1u << bits) - 1;
    const int most = (int)mask - 1;
    int x[2] = {(int)(a & mask), (int)(b & mask)}, y[2] = {(int)(a >> bits), (int)(b >> bits)};
    bool rim = x[0] <= 1 || y[0] <= 1 || x[0] >= most - 1 || y[0] >= most - 1;
    return rim || (abs(x[0] - x[1]) <= 1 && abs(y[0] - y[1]) <= 1);
}

static double shared_component(uint32_t code, int bits, int component)
{
    return ldexp(code >> component * bits & ((1u << bits) - 1), (int)(code >> 3 * bits));
}

static bool shared_agree(uint32_t a, uint32_t b, int bits)
{
    double step = ldexp(1, (int)((a > b ? a : b) >> 3 * bits));
    for (int component = 0; component < 3; component++)
        if (fabs(shared_component(a, bits, component) - shared_component(b, bits, component)) >
            step)
            return false;
    return true;
}

static bool codes_agree(const FieldRow *field, uint32_t a, uint32_t b)
{
    switch (field->encoding) {
    case ENCODING_octahedral:
        return coordinates_agree(a, b, field->bits);
    case ENCODING_sphere:
        return true; /* near -z, adjacent codes are arbitrary directions around it */
    case ENCODING_sharedExponent:
        return shared_agree(a, b, field->bits);
    case ENCODING_full:
        return fabs((double)a - (double)b) < 64;
    default:
        return fabs((double)a - (double)b) <= 1;
    }
}

bool packed_agree(const LayoutRow *layout, int target, int component, const PackedPair *pair)
{
    Placement placement;
    const double a = pair->word[0], b = pair->word[1];
    int number = 0;
    if (a == b)
        return true;
    if (layout_case_bits(layout) && !target && !component) {
        number = layout_case_of(layout, (uint32_t)a, (uint32_t)pair->last[0]);
        if (number != layout_case_of(layout, (uint32_t)b, (uint32_t)pair->last[1]))
            /* the optimizer recognizes more slots as absent; the slots themselves are compared
             * separately */
            return true;
    } else if (layout_case_bits(layout)) {
        return true; /* the case, and so its fields, depends on another word */
    }
    if (layout_allocate(layout, number, &placement))
        return false;
    for (int i = 0; i < placement.count; i++) {
        const Piece *piece = &placement.pieces[i];
        if (piece->target == target && piece->component == component &&
            !codes_agree(piece->field, code_of(piece, (uint32_t)a), code_of(piece, (uint32_t)b)))
            return false;
    }
    return true;
}
