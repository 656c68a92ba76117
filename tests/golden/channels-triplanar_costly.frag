#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
in vec3 localTangentU;
in vec3 localTangentV;
layout(location = 0) out uvec4 fragment0;

// v / |v| for every finite v; (0, 0, 1) where no component reaches 1e-37. v is divided by its greatest component first, so that
// no square over- or underflows, and a great one is scaled down before, so that its reciprocal does not. Relative error 2e-7.
vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}

// p + rest as a whole cell, less whole periods of 2^25, and a place in it in [0, 1). Exact.
void cellsCell3(vec3 p, vec3 rest, out vec3 cell, out vec3 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec3 over = floor(d);
    d -= over;
    cell = cell - 33554432.0 * floor(cell * (1.0 / 33554432.0) + 0.5) + over;
}

// The distance that cellsFar2 and cellsFar3 compare by.
float cellsDistance(float far, int metric) {
    return metric == 0 ? sqrt(far) : far;
}

// How far away a point is: 0 by the square of its euclidean distance, 1 by the sum, 2 by the greatest of its coordinates.
float cellsFar3(vec3 away, int metric) {
    vec3 a = abs(away);
    return metric == 0 ? dot(away, away) : metric == 1 ? a.x + a.y + a.z : max(a.x, max(a.y, a.z));
}

// Hash of the cell that lies `offset` from another, with a period of 2^25 along each axis: all 32 bits are good.
uint cellsHash3(vec3 cell, vec3 offset) {
    uvec3 c = (uvec3(ivec3(cell) + ivec3(offset)) & 33554431u) * uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uint h = c.x ^ c.y ^ (c.z + 0x165667B1u);
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}

// Where a cell's point lies in it: 2048, 2048 and 1024 places along the axes, in (0, 1).
vec3 cellsPlace3(vec3 cell, vec3 offset) {
    uint h = cellsHash3(cell, offset);
    return (vec3(uvec3(h >> 21u, (h >> 10u) & 2047u, h & 1023u)) + 0.5) * vec3(1.0 / 2048.0, 1.0 / 2048.0, 1.0 / 1024.0);
}

// The points nearest to d in a cell, as (away, far); the second is known where `count` is 2. The 27 cells around are asked first. Points of ring r,
// of cells that are r away, are at least r - |d - 1/2| - jitter/2 away along an axis: where that is no nearer than what was found, which is nearly
// always for euclidean distances, the search ends; else those of its cells are asked that may have a nearer one. compiler/library/cells.h proves
// that none lies beyond ring 3.
void cellsSearch3Visit(vec3 away, int metric, inout vec4 first, inout vec4 second) {
    float far = cellsFar3(away, metric);
    if (far < first.w) {
        second = first;
        first = vec4(away, far);
    } else if (far < second.w) {
        second = vec4(away, far);
    }
}

void cellsSearch3(vec3 cell, vec3 d, float jitter, int metric, int count, out vec4 first, out vec4 second) {
    vec3 corner = 0.5 - 0.5 * jitter - d;
    first = vec4(0.0, 0.0, 0.0, 64.0);
    second = first;
    for (int z = -1; z <= 1; z++)
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++) {
                vec3 offset = vec3(float(x), float(y), float(z));
                cellsSearch3Visit(offset + corner + jitter * cellsPlace3(cell, offset), metric, first, second);
            }
    vec3 side = abs(d - 0.5);
    float gap = -max(side.x, max(side.y, side.z)) - 0.5 * jitter;
    for (int ring = 2; ring <= 3; ring++) {
        float least = gap + float(ring);
        if ((count == 1 ? first.w : second.w) <= (metric == 0 ? least * least : least)) break;
        for (int z = -ring; z <= ring; z++)
            for (int y = -ring; y <= ring; y++)
                for (int x = -ring; x <= ring; x++) {
                    vec3 offset = vec3(float(x), float(y), float(z));
                    vec3 nearest = max(abs(offset + 0.5 - d) - 0.5 * jitter, 0.0);
                    bool inner = max(abs(offset.x), max(abs(offset.y), abs(offset.z))) < float(ring) - 0.5;
                    if (inner || cellsFar3(nearest, metric) >= (count == 1 ? first.w : second.w)) continue;
                    cellsSearch3Visit(offset + corner + jitter * cellsPlace3(cell, offset), metric, first, second);
                }
    }
}

// Cells of p + rest, each of which has a point, moved from its middle by up to jitter/2: the distance to the nearest point (value 0), to the second
// nearest (1), or the second less the first (2): 0 on the walls between the points. Distances: 0 euclidean, 1 manhattan, 2 chebyshev. In [0, 3].
// Error 6e-7.
float cells3(vec3 p, vec3 rest, float jitter, int metric, int value) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    float nearest = cellsDistance(first.w, metric);
    float next = cellsDistance(second.w, metric);
    return value == 0 ? nearest : value == 1 ? next : next - nearest;
}

// A bijective finaliser, two rounds of shift and multiply, so that the top bits of every shift of the hash are good.
uvec4 latticeFinal(uvec4 h) {
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}

// Hashes of the eight corners of a cell, lanes as latticeMix takes them: xor of the coordinates' products, then a finaliser.
// The wrap to [0, 65536) is exact for every finite cell: its steps only scale by powers of two and drop high digits.
void latticeCorners(vec3 cell, out uvec4 low, out uvec4 high) {
    const uvec3 factor = uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uvec3 c = uvec3(ivec3(cell - 65536.0 * floor(cell * (1.0 / 65536.0))));
    uvec3 c0 = c * factor;
    uvec3 c1 = ((c + 1u) & 65535u) * factor;
    uvec4 square = uvec4(c0.x, c1.x, c0.x, c1.x) ^ uvec4(c0.yy, c1.yy);
    low = latticeFinal(square ^ (c0.z + 0x165667B1u));
    high = latticeFinal(square ^ (c1.z + 0x165667B1u));
}

// Mixes eight corner terms, lanes (x, y) = (0,0) (1,0) (0,1) (1,1), z = 0 in `low` and 1 in `high`, with weights 3d^2 - 2d^3.
float latticeMix(vec4 low, vec4 high, vec3 d) {
    vec3 s = d * d * (3.0 - 2.0 * d);
    vec4 plane = mix(low, high, s.z);
    vec2 line = mix(plane.xy, plane.zw, s.y);
    return mix(line.x, line.y, s.x);
}

// A hash read as a signed number is this much of 1.
const float latticeScale = 1.0 / 2147483648.0;

// Value plus gradient terms of a face's four corners, times 2^31; d is the offset from the first corner.
// A corner's numbers are its hash shifted left by 0, 7, 14, 21 and read as signed: uniform, symmetric to 2^-11, no masks.
vec4 latticeTerms(uvec4 hash, vec3 d) {
    vec4 dx = vec4(d.x, d.x - 1.0, d.x, d.x - 1.0);
    vec4 dy = vec4(d.yy, d.yy - 1.0);
    return 0.5 * vec4(ivec4(hash)) + vec4(ivec4(hash << 7u)) * dx + vec4(ivec4(hash << 14u)) * dy
         + vec4(ivec4(hash << 21u)) * d.z;
}

// Lattice noise at a point of a cell, d in [0, 1): at each corner a value and a gradient from a hash, smoothly interpolated.
// About [-1, 1], standard deviation 1/4, period 65536 an axis. Error below 1e-6 of the reference at the same floats.
float lattice(vec3 cell, vec3 d) {
    uvec4 low, high;
    latticeCorners(cell, low, high);
    return latticeMix(latticeTerms(low, d), latticeTerms(high, d - vec3(0.0, 0.0, 1.0)), d) * latticeScale;
}

// Noise in [-1, 1], standard deviation 1/2. About one sample in twenty is clamped. Error 2e-6, in simplex noise too.
float noise(vec3 p) {
    vec3 cell = floor(p);
    return clamp(2.0 * lattice(cell, p - cell), -1.0, 1.0);
}

// Sum of octaves noiseRatio^k noise(frequencyRatio^k p), k from 0; at least one. Signed and not normalised.
// Error that of noise, to the sum of the strengths, where frequencyRatio is a power of two; other ratios round p.
float turbulence(vec3 p, int octaves, float frequencyRatio, float noiseRatio) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    float sum = 0.0;
    for (int k = 0; k < count; k++) {
        sum += strength * noise(p);
        strength *= noiseRatio;
        p *= frequencyRatio;
    }
    return sum;
}

// v, taken to [0, 1], as the nearest of 2^bits equal steps, bits <= 16.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// The square root of v, taken to [0, 1], as the nearest of 2^bits equal steps: steps of v that shrink towards 0, as an eye's do.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
}

// Unit normal to the plane of an octahedron in [-1, 1]^2: n / (|x| + |y| + |z|), its lower half folded outward. (0, 0, 0) gives
// (0, 0), which is +z. No sign(): it is 0 at 0, where the fold wants 1. Error 2e-7.
vec2 encodeOctahedral(vec3 n) {
    vec2 p = n.xy / max(abs(n.x) + abs(n.y) + abs(n.z), 1.0e-30);
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    return n.z < 0.0 ? (1.0 - abs(p.yx)) * side : p;
}

// Unit normal to two whole numbers in [-s, s], s = 2^(bits-1) - 1, by the nearest point of the octahedron. The axes have codes
// of their own. A half float holds them exactly for bits <= 12. The power is exact: exp2 errs by less than 1/2 for bits <= 16.
vec2 octahedralWhole(vec3 n, int bits) {
    float scale = floor(exp2(float(bits - 1)) + 0.5) - 1.0;
    return floor(encodeOctahedral(n) * scale + 0.5);
}

// The two whole numbers of octahedralWhole, moved up to begin at 0, in 2 bits bits: x in the lower ones.
uint octahedralBits(vec3 n, int bits) {
    float scale = float((1 << (bits - 1)) - 1);
    uvec2 code = uvec2(octahedralWhole(n, bits) + scale);
    return code.x | code.y << bits;
}

// v by equal steps of its logarithm: code 0 is 0, code 1 is 1/16, the last is 65504 = 2^(19.9992954 - 4); below 1/32 it is 0.
// bits from 4 to 16.
uint logarithmBits(float v, int bits) {
    int steps = (1 << bits) - 2;
    float place = (log2(clamp(v, 0.0625, 65504.0)) + 4.0) * (float(steps) / 19.9992954);
    return v < 0.03125 ? 0u : uint(clamp(floor(place + 0.5), 0.0, float(steps))) + 1u;
}

// Exponent of a Phong lobe for a shininess x: -2 / ln y, y = x (2 - x), 0 for y <= 0, at most 65504. Relative error 8e-7.
// Near x = 1 the logarithm would lose its digits: there, with w = 1 - y = (1 - x)^2 and s = w / (2 - w), ln y is
// -2 (s + s^3/3 + s^5/5 + s^7/7 + ...); for w <= 1/4 the rest is below 2e-8 of it.
float phongExponent(float x) {
    float y = x * (2.0 - x);
    float w = min((1.0 - x) * (1.0 - x), 0.25);
    float s = w / (2.0 - w);
    float s2 = s * s;
    float series = s * (1.0 + s2 * (1.0 / 3.0 + s2 * (1.0 / 5.0 + s2 * (1.0 / 7.0))));
    float logarithm = -0.5 * log(clamp(y, 1.17549435e-38, 0.76));
    float exponent = min(1.0 / max(y < 0.75 ? logarithm : series, 1.0 / 65504.0), 65504.0);
    return y > 0.0 ? exponent : 0.0;
}

void main() {
    // triplanar_costly.yaml:4 Triplanar
    vec3 diffuse_triplanar_1 = pow(max(abs(safeNormalize(cross(localTangentU, localTangentV))), vec3(1e-37)), vec3(4.0));
    vec3 diffuse_triplanar_2 = max(diffuse_triplanar_1 / dot(diffuse_triplanar_1, vec3(1.0)) - vec3(0.015625), vec3(0.0));
    vec3 diffuse_triplanar_3 = diffuse_triplanar_2 / dot(diffuse_triplanar_2, vec3(1.0));
    // triplanar_costly.yaml:5 Expression
    float diffuse_expression;
    // triplanar_costly.yaml:7 Expression
    float shininess_expression;
    if (0.0 < diffuse_triplanar_3.x) {
        diffuse_expression = cells3(vec3(localPosition.yz * 6.0, 0.0), vec3(0.0), 1.0, 0, 2) * 0.15 + 0.4;
        shininess_expression = turbulence(vec3(localPosition.yz * 2.0, 0.0), 4, 2.0, 0.5) * 0.1 + 0.5;
    } else {
        diffuse_expression = 0.0;
        shininess_expression = 0.0;
    }
    // triplanar_costly.yaml:6 Expression
    float diffuse_expression2;
    float shininess_expression_1;
    if (0.0 < diffuse_triplanar_3.y) {
        diffuse_expression2 = turbulence(vec3(localPosition.xz * 3.0, 0.5), 5, 2.0, 0.5) * 0.15 + 0.5;
        shininess_expression_1 = turbulence(vec3(localPosition.xz * 2.0, 0.0), 4, 2.0, 0.5) * 0.1 + 0.5;
    } else {
        diffuse_expression2 = 0.0;
        shininess_expression_1 = 0.0;
    }
    float diffuse_expression2_1;
    float shininess_expression_2;
    if (0.0 < diffuse_triplanar_3.z) {
        diffuse_expression2_1 = turbulence(vec3(localPosition.xy * 3.0, 0.5), 5, 2.0, 0.5) * 0.15 + 0.5;
        shininess_expression_2 = turbulence(vec3(localPosition.xy * 2.0, 0.0), 4, 2.0, 0.5) * 0.1 + 0.5;
    } else {
        diffuse_expression2_1 = 0.0;
        shininess_expression_2 = 0.0;
    }
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    float diffuse_triplanar = diffuse_expression2_1 * diffuse_triplanar_3.z + (diffuse_expression2 * diffuse_triplanar_3.y + diffuse_expression * diffuse_triplanar_3.x);
    uint diffuse_bits = rootBits(diffuse_triplanar, 8);
    // triplanar_costly.yaml:7 Triplanar
    float shininess_triplanar = shininess_expression_2 * diffuse_triplanar_3.z + (shininess_expression_1 * diffuse_triplanar_3.y + shininess_expression * diffuse_triplanar_3.x);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, diffuse_bits | diffuse_bits << 8 | diffuse_bits << 16, logarithmBits(phongExponent(shininess_triplanar), 10) << 21);
}
