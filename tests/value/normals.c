/* The table of normal encodings, stored by the C references. */
#include "normals.h"
#include "compiler/library/normal.h"
#include "compiler/library/pack.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

const NormalRow normal_table[] = {
    {"octahedral snorm 6+6", STORE_snorm, 6, false, 1.379, 1.520, 3.895},
    {"octahedral unorm 7+7", STORE_unorm, 7, false, 0.6735, 0.7421, 1.907},
    {"octahedral precise unorm 7+7", STORE_precise, 7, false, 0.6294, 0.6759, 1.269},
    {"spheremap 7+7", STORE_spheremap, 7, false, 0.980, 1.377, 16.8},
    {"spheremap 7+7, facing", STORE_spheremap, 7, true, 0.707, 0.761, 1.781},
    {"octahedral snorm 8+8", STORE_snorm, 8, false, 0.3368, 0.371, 0.949},
    {"octahedral unorm 8+8", STORE_unorm, 8, false, 0.3357, 0.370, 0.947},
    {"octahedral precise snorm 8+8", STORE_precise_snorm, 8, false, 0.3147, 0.3380, 0.6330},
    {"octahedral 247 x 247", STORE_radix, 0, false, 0.3475, 0.3829, 0.983},
    {"spheremap 8+8", STORE_spheremap, 8, false, 0.492, 0.720, 11.65},
    {"spheremap 8+8, facing", STORE_spheremap, 8, true, 0.352, 0.379, 0.888},
    {"octahedral 10+10", STORE_snorm, 10, false, 0.0836, 0.0921, 0.236},
    {"octahedral precise 10+10", STORE_precise_snorm, 10, false, 0.0782, 0.0840, 0.158},
    {"octahedral 11+11", STORE_snorm, 11, false, 0.0418, 0.0460, 0.118},
    {"x, y, z unorm 8+8+8", STORE_xyz, 8, false, 0.170, 0.184, 0.387},
    {"octahedral 12+12", STORE_snorm, 12, false, 0.0209, 0.0230, 0.0591},
    {"octahedral precise 12+12", STORE_precise_snorm, 12, false, 0.0195, 0.0210, 0.0394},
    {"x, y, z unorm 10+10+10", STORE_xyz, 10, false, 0.0423, 0.0457, 0.0957},
    {"octahedral 15+15", STORE_snorm, 15, false, 0.00261, 0.00288, 0.0074},
    {"octahedral 16+16", STORE_snorm, 16, false, 0.00131, 0.00144, 0.0037},
    {"octahedral precise 16+16", STORE_precise_snorm, 16, false, 0.00122, 0.00131, 0.00247},
    {"spheremap 16+16", STORE_spheremap, 16, false, 0.00195, 0, 0},
    {"spheremap 16+16, facing", STORE_spheremap, 16, true, 0.00137, 0, 0.0034},
    {"octahedral in two halves", STORE_halves, 0, false, 0.0150, 0.0176, 0.0585},
    {"spheremap in two halves", STORE_spheremap_halves, 0, false, 0.0419, 0, 3.93},
    {"spheremap in two halves, facing", STORE_spheremap_halves, 0, true, 0.0324, 0, 0.108},
    {"x, y, z in three halves", STORE_xyz_halves, 0, false, 0.0061, 0.0073, 0.0229},
};
const int normal_rows = sizeof normal_table / sizeof *normal_table;

/* A 64-bit generator whose state is mixed by a multiplication and shifts: the same directions in
 * every run. */
static double random_number(uint64_t *state)
{
    uint64_t x = *state += 0x9E3779B97F4A7C15u;
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
    x = (x ^ x >> 27) * 0x94D049BB133111EBu;
    return (double)((x ^ x >> 31) >> 11) * 0x1p-53;
}

static void random_direction(uint64_t *state, bool hemisphere, double n[3])
{
    double z = hemisphere ? random_number(state) : 2 * random_number(state) - 1;
    double angle = 2 * M_PI * random_number(state), r = sqrt(fmax(0, 1 - z * z));
    n[0] = r * cos(angle);
    n[1] = r * sin(angle);
    n[2] = z;
}

static double through_half(double v) { return pack_half_value(pack_half_bits(v)); }

static void normalise(double n[3])
{
    double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int i = 0; i < 3; i++)
        n[i] /= length;
}

static void store_codes(const NormalRow *row, const double n[3], double read[3])
{
    int code[2], levels = row->store == STORE_radix ? RADIX_X : 1 << row->bits;
    bool precise = row->store == STORE_precise || row->store == STORE_precise_snorm;
    if (row->store == STORE_snorm || row->store == STORE_precise_snorm)
        levels = octahedral_levels(row->bits);
    if (row->store == STORE_spheremap)
        normal_spheremap_encode(n, levels, code);
    else if (precise)
        normal_octahedral_encode_precise(n, levels, code);
    else
        normal_octahedral_encode(n, levels, code);
    if (row->store == STORE_spheremap)
        normal_spheremap_decode(code, levels, read);
    else
        normal_octahedral_decode(code, levels, read);
}

static void store(const NormalRow *row, const double n[3], double read[3])
{
    double e[2], steps = (1 << row->bits) - 1;
    switch (row->store) {
    case STORE_halves:
    case STORE_spheremap_halves:
        (row->store == STORE_halves ? normal_octahedral_map : normal_spheremap_map)(n, e);
        for (int i = 0; i < 2; i++)
            e[i] = through_half(e[i]);
        (row->store == STORE_halves ? normal_octahedral_unmap : normal_spheremap_unmap)(e, read);
        break;
    case STORE_xyz:
    case STORE_xyz_halves:
        for (int i = 0; i < 3; i++)
            read[i] = row->store == STORE_xyz
                          ? 2 * floor((n[i] / 2 + 0.5) * steps + 0.5) / steps - 1
                          : through_half(n[i]);
        normalise(read);
        break;
    default:
        store_codes(row, n, read);
    }
}

NormalAngles normals_measure(const NormalRow *row, int count)
{
    NormalAngles a = {0};
    uint64_t state = 1;
    for (int i = 0; i < count; i++) {
        double n[3], read[3];
        random_direction(&state, row->hemisphere, n);
        store(row, n, read);
        double angle = normal_angle(n, read);
        a.mean += angle / count;
        a.rms += angle * angle / count;
        a.maximum = fmax(a.maximum, angle);
    }
    a.rms = sqrt(a.rms);
    return a;
}

/* Half a unit of the last printed digit of a table's number. */
static double half_unit(double printed)
{
    char text[32];
    snprintf(text, sizeof text, "%.10g", printed);
    const char *point = strchr(text, '.');
    return 0.5 * pow(10, point ? -(double)strlen(point + 1) : 0);
}

double normals_off(double measured, double wanted)
{
    return wanted > 0 ? fmax(0, fabs(measured - wanted) - half_unit(wanted)) / wanted : 0;
}

bool normals_are_singular(const NormalRow *row)
{
    return (row->store == STORE_spheremap || row->store == STORE_spheremap_halves) &&
           !row->hemisphere;
}
