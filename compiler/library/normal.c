/* Encodings of unit normals: octahedral, and the spheremap of the thesis. */
#include "compiler/library/normal.h"
#include "compiler/library/pack.h"
#include "compiler/library/reference.h"

#define MIN_SUM 1e-30

static double square(double v) { return v * v; }
static double side(double v) { return v < 0 ? -1 : 1; }

void normal_octahedral_map(const double n[3], double e[2])
{
    double sum = fmax(fabs(n[0]) + fabs(n[1]) + fabs(n[2]), MIN_SUM), x = n[0] / sum,
           y = n[1] / sum;
    e[0] = n[2] < 0 ? (1 - fabs(y)) * side(x) : x;
    e[1] = n[2] < 0 ? (1 - fabs(x)) * side(y) : y;
}

void normal_octahedral_unmap(const double e[2], double n[3])
{
    double z = 1 - fabs(e[0]) - fabs(e[1]), fold = fmax(-z, 0);
    double x = e[0] - side(e[0]) * fold, y = e[1] - side(e[1]) * fold,
           length = sqrt(x * x + y * y + z * z);
    n[0] = x / length;
    n[1] = y / length;
    n[2] = z / length;
}

static int nearest(double v, int levels)
{
    return whole_between(clamp(v, 0, 1) * (levels - 1) + .5, 0, levels - 1);
}

static int bits_of(double v) { return whole_between(v, 1, REFERENCE_BITS); }

void normal_octahedral_encode(const double n[3], int levels, int code[2])
{
    double e[2];
    normal_octahedral_map(n, e);
    for (int i = 0; i < 2; i++)
        code[i] = nearest(e[i] / 2 + .5, levels);
}

void normal_octahedral_encode_precise(const double n[3], int levels, int code[2])
{
    double e[2], least = INFINITY;
    normal_octahedral_map(n, e);
    for (int i = 0; i < 4; i++) {
        double decoded[3];
        int tried[2] = {whole_between((e[0] / 2 + .5) * (levels - 1), 0, levels) + i % 2,
                        whole_between((e[1] / 2 + .5) * (levels - 1), 0, levels) + i / 2};
        if (tried[0] >= levels || tried[1] >= levels)
            continue;
        normal_octahedral_decode(tried, levels, decoded);
        double distance =
            square(n[0] - decoded[0]) + square(n[1] - decoded[1]) + square(n[2] - decoded[2]);
        if (distance >= least)
            continue;
        least = distance;
        code[0] = tried[0];
        code[1] = tried[1];
    }
}

void normal_octahedral_decode(const int code[2], int levels, double n[3])
{
    const double e[2] = {2. * code[0] / (levels - 1) - 1, 2. * code[1] / (levels - 1) - 1};
    normal_octahedral_unmap(e, n);
}

/* For a unit vector the radius |n.xy| / sqrt(8 n.z + 8) is sqrt((1 - n.z) / 8), which is
 * accurate below the equator. */
void normal_spheremap_map(const double n[3], double e[2])
{
    double x = n[0], y = n[1], z = n[2], length = hypot(x, y);
    double scale = z < 0 ? sqrt((1 - z) / 8) : length / sqrt(8 * z + 8);
    bool directed = length > 1e-15;
    e[0] = clamp((directed ? x / length : 1) * scale + .5, 0, 1);
    e[1] = clamp((directed ? y / length : 0) * scale + .5, 0, 1);
}

void normal_spheremap_unmap(const double e[2], double n[3])
{
    double x = 4 * e[0] - 2, y = 4 * e[1] - 2, d = fmin(x * x + y * y, 4), scale = sqrt(1 - d / 4);
    n[0] = x * scale;
    n[1] = y * scale;
    n[2] = 1 - d / 2;
}

void normal_spheremap_encode(const double n[3], int levels, int code[2])
{
    double e[2];
    normal_spheremap_map(n, e);
    for (int i = 0; i < 2; i++)
        code[i] = nearest(e[i], levels);
}

void normal_spheremap_decode(const int code[2], int levels, double n[3])
{
    const double e[2] = {(double)code[0] / (levels - 1), (double)code[1] / (levels - 1)};
    normal_spheremap_unmap(e, n);
}

double normal_angle(const double a[3], const double b[3])
{
    double dot = 0, sum = 0;
    for (int i = 0; i < 3; i++) {
        double cross = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        dot += a[i] * b[i];
        sum += square(cross);
    }
    return atan2(sqrt(sum), dot) * 180 / M_PI;
}

REFERENCE(encodeSpheremap)
{
    (void)context;
    normal_spheremap_map(args, result);
}

REFERENCE(decodeSpheremap)
{
    (void)context;
    normal_spheremap_unmap(args, result);
}

REFERENCE(octahedralWhole)
{
    (void)context;
    int levels = octahedral_levels(bits_of(args[3])), code[2];
    normal_octahedral_encode(args, levels, code);
    for (int i = 0; i < 2; i++)
        result[i] = code[i] - levels / 2;
}

REFERENCE(octahedralRadix)
{
    (void)context;
    int code[2];
    normal_octahedral_encode(args, RADIX_X, code);
    result[0] = pack_half_from_code(code[0] + RADIX_X * code[1]);
}

REFERENCE(octahedralBits)
{
    (void)context;
    int bits = bits_of(args[3]), code[2];
    normal_octahedral_encode(args, octahedral_levels(bits), code);
    result[0] = code[0] + ldexp(code[1], bits);
}

REFERENCE(spheremapBits)
{
    (void)context;
    int bits = bits_of(args[3]), code[2];
    normal_spheremap_encode(args, 1 << bits, code);
    result[0] = code[0] + ldexp(code[1], bits);
}
