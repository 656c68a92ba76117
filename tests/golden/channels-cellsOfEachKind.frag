#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec2 uv;
in vec3 localPosition;
in vec3 eyeNormal;
uniform float loose;
layout(location = 0) out uvec4 fragment0;

// Splits p + rest into an integer cell, modulo 2^25, and a position d in [0, 1) in the cell. Exact.
void cellsCell3(vec3 p, vec3 rest, out vec3 cell, out vec3 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec3 over = floor(d);
    d -= over;
    cell = cell - 33554432.0 * floor(cell * (1.0 / 33554432.0) + 0.5) + over;
}

// Converts the result of cellsFar2 or cellsFar3 to a distance.
float cellsDistance(float far, int metric) {
    return metric == 0 ? sqrt(far) : far;
}

// Distance of an offset, for comparison. Metric 0: Euclidean, squared; 1: Manhattan; 2: Chebyshev.
float cellsFar3(vec3 away, int metric) {
    vec3 a = abs(away);
    return metric == 0 ? dot(away, away) : metric == 1 ? a.x + a.y + a.z : max(a.x, max(a.y, a.z));
}

// 32-bit hash of cell + offset, with a period of 2^25 per axis; every bit is well mixed.
uint cellsHash3(vec3 cell, vec3 offset) {
    uvec3 c = (uvec3(ivec3(cell) + ivec3(offset)) & 33554431u) * uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uint h = c.x ^ c.y ^ (c.z + 0x165667B1u);
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}

// Position of a cell's point in the cell, in (0, 1): 2048, 2048 and 1024 steps along x, y, z.
vec3 cellsPlace3(vec3 cell, vec3 offset) {
    uint h = cellsHash3(cell, offset);
    return (vec3(uvec3(h >> 21u, (h >> 10u) & 2047u, h & 1023u)) + 0.5) * vec3(1.0 / 2048.0, 1.0 / 2048.0, 1.0 / 1024.0);
}

// Finds the points nearest to d in a cell, as (offset, cellsFar3); `second` is valid only for count
// 2. Visits the 3 x 3 x 3 neighborhood first. Points of ring r are at least r - |d - 1/2| -
// jitter/2 away along an axis, so the search usually ends there for Euclidean distances; otherwise
// it visits the cells of rings 2 and 3 that may hold a nearer point. cells.h proves that ring 3
// suffices.
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

// Cellular noise at p + rest. Each cell has a point, at most jitter/2 per axis from the center.
// Returns the distance to the nearest point (value 0), to the second nearest (1), or second minus
// nearest (2), which is 0 at cell borders. Metric: 0 Euclidean, 1 Manhattan, 2 Chebyshev. In [0,
// 3]. Error 6e-7.
float cells3(vec3 p, vec3 rest, float jitter, int metric, int value) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    float nearest = cellsDistance(first.w, metric);
    float next = cellsDistance(second.w, metric);
    return value == 0 ? nearest : value == 1 ? next : next - nearest;
}

// v / |v| for every finite v; (0, 0, 1) if all components are below 1e-37. v is divided by its
// largest component, so no square over- or underflows; large vectors are scaled down first, so the
// reciprocal does not underflow. Relative error 2e-7.
vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}

// Splits p + rest into an integer cell, modulo 2^25, and a position d in [0, 1) in the cell. Exact.
void cellsCell2(vec2 p, vec2 rest, out vec2 cell, out vec2 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec2 over = floor(d);
    d -= over;
    cell = cell - 33554432.0 * floor(cell * (1.0 / 33554432.0) + 0.5) + over;
}

// 32-bit hash of cell + offset, with a period of 2^25 per axis; every bit is well mixed.
uint cellsHash2(vec2 cell, vec2 offset) {
    uvec2 c = (uvec2(ivec2(cell) + ivec2(offset)) & 33554431u) * uvec2(0x9E3779B1u, 0x85EBCA77u);
    uint h = c.x ^ c.y ^ 0x27D4EB2Fu;
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}

// Position of a cell's point in the cell, in (0, 1): 65536 steps per axis.
vec2 cellsPlace2(vec2 cell, vec2 offset) {
    uint h = cellsHash2(cell, offset);
    return (vec2(uvec2(h >> 16u, h & 65535u)) + 0.5) * (1.0 / 65536.0);
}

// Distance of an offset, for comparison. Metric 0: Euclidean, squared; 1: Manhattan; 2: Chebyshev.
float cellsFar2(vec2 away, int metric) {
    vec2 a = abs(away);
    return metric == 0 ? dot(away, away) : metric == 1 ? a.x + a.y : max(a.x, a.y);
}

// Finds the points nearest to d in a cell, as (offset, cellsFar2); `second` is valid only for count
// 2. Visits the 3 x 3 neighborhood first. Points of ring r are at least r - |d - 1/2| - jitter/2
// away along an axis, so the search usually ends there for Euclidean distances; otherwise it visits
// the cells of ring 2 that may hold a nearer point. cells.h proves that ring 2 suffices.
void cellsSearch2Visit(vec2 away, int metric, inout vec3 first, inout vec3 second) {
    float far = cellsFar2(away, metric);
    if (far < first.z) {
        second = first;
        first = vec3(away, far);
    } else if (far < second.z) {
        second = vec3(away, far);
    }
}

void cellsSearch2(vec2 cell, vec2 d, float jitter, int metric, int count, out vec3 first, out vec3 second) {
    vec2 corner = 0.5 - 0.5 * jitter - d;
    first = vec3(0.0, 0.0, 64.0);
    second = first;
    for (int y = -1; y <= 1; y++)
        for (int x = -1; x <= 1; x++) {
            vec2 offset = vec2(float(x), float(y));
            cellsSearch2Visit(offset + corner + jitter * cellsPlace2(cell, offset), metric, first, second);
        }
    vec2 side = abs(d - 0.5);
    float least = 2.0 - max(side.x, side.y) - 0.5 * jitter;
    if ((count == 1 ? first.z : second.z) <= (metric == 0 ? least * least : least)) return;
    for (int y = -2; y <= 2; y++)
        for (int x = -2; x <= 2; x++) {
            vec2 offset = vec2(float(x), float(y));
            vec2 nearest = max(abs(offset + 0.5 - d) - 0.5 * jitter, 0.0);
            bool inner = max(abs(offset.x), abs(offset.y)) < 1.5;
            if (inner || cellsFar2(nearest, metric) >= (count == 1 ? first.z : second.z)) continue;
            cellsSearch2Visit(offset + corner + jitter * cellsPlace2(cell, offset), metric, first, second);
        }
}

// The cell point nearest to p + rest, bitwise equal across the cell. Error 6e-8 of the position,
// half an ULP.
vec2 cells2Centre(vec2 p, vec2 rest, float jitter, int metric) {
    vec2 cell, d;
    vec3 first, second;
    cellsCell2(p, rest, cell, d);
    cellsSearch2(cell, d, jitter, metric, 1, first, second);
    vec2 offset = floor(d + first.xy);
    vec2 place = 0.5 + jitter * (cellsPlace2(cell, offset) - 0.5);
    vec2 whole = floor(p);
    return whole + floor(p - whole + rest) + offset + place;
}

// A 24-bit number in [0, 1) from a cell's hash, independent of its point's position.
float cellsNumber(uint hash) {
    hash = (hash ^ (hash >> 15u)) * 0x2C1B3C6Du;
    return float((hash ^ (hash >> 16u)) >> 8u) * (1.0 / 16777216.0);
}

// Random number in [0, 1] of the cell whose point is nearest to p + rest. Discontinuous at cell
// borders; exact elsewhere.
float cells2Random(vec2 p, vec2 rest, float jitter, int metric) {
    vec2 cell, d;
    vec3 first, second;
    cellsCell2(p, rest, cell, d);
    cellsSearch2(cell, d, jitter, metric, 1, first, second);
    return cellsNumber(cellsHash2(cell, floor(d + first.xy)));
}

// Quantizes v, clamped to [0, 1], to `bits` <= 16 bits, rounding to nearest.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// Quantizes sqrt(v), v clamped to [0, 1], to `bits` bits: finer steps near 0, like perceived
// lightness.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
}

// Cellular noise at p + rest. Each cell has a point, at most jitter/2 per axis from the center.
// Returns the distance to the nearest point (value 0), to the second nearest (1), or second minus
// nearest (2), which is 0 at cell borders. Metric: 0 Euclidean, 1 Manhattan, 2 Chebyshev. In [0,
// 2]. Error 6e-7.
float cells2(vec2 p, vec2 rest, float jitter, int metric, int value) {
    vec2 cell, d;
    vec3 first, second;
    cellsCell2(p, rest, cell, d);
    cellsSearch2(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    float nearest = cellsDistance(first.z, metric);
    float next = cellsDistance(second.z, metric);
    return value == 0 ? nearest : value == 1 ? next : next - nearest;
}

// Quantizes v in equal steps of log2: code 0 is 0, code 1 is 1/16, the last is 65504 =
// 2^(19.9992954 - 4). Values below 1/32 become 0. bits in [4, 16].
uint logarithmBits(float v, int bits) {
    int steps = (1 << bits) - 2;
    float place = (log2(clamp(v, 0.0625, 65504.0)) + 4.0) * (float(steps) / 19.9992954);
    return v < 0.03125 ? 0u : uint(clamp(floor(place + 0.5), 0.0, float(steps))) + 1u;
}

// Phong exponent of a shininess x: -2 / ln y, y = x (2 - x), at most 65504; 0 for y <= 0. Relative
// error 8e-7. Near x = 1 a series avoids cancellation: with w = (1 - x)^2 and s = w / (2 - w), ln y
// is -2 (s + s^3/3 + s^5/5 + s^7/7 + ...); for w <= 1/4 the remainder is below 2e-8 relative.
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

// Random number in [0, 1] of the cell whose point is nearest to p + rest. Discontinuous at cell
// borders; exact elsewhere.
float cells3Random(vec3 p, vec3 rest, float jitter, int metric) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, 1, first, second);
    return cellsNumber(cellsHash3(cell, floor(d + first.xyz)));
}

// Octahedral encoding of a unit normal in [-1, 1]^2: n / (|x| + |y| + |z|), the lower half folded
// outward. (0, 0, 0) encodes as +z. sign() would be 0 at 0, where the fold needs 1. Error 2e-7.
vec2 encodeOctahedral(vec3 n) {
    vec2 p = n.xy / max(abs(n.x) + abs(n.y) + abs(n.z), 1.0e-30);
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    return n.z < 0.0 ? (1.0 - abs(p.yx)) * side : p;
}

// Quantizes a unit normal to two integers in [-s, s], s = 2^(bits-1) - 1, on the octahedron. The
// axes are exact. A half float holds them exactly for bits <= 12. floor() makes exp2 exact for bits
// <= 16.
vec2 octahedralWhole(vec3 n, int bits) {
    float scale = floor(exp2(float(bits - 1)) + 0.5) - 1.0;
    return floor(encodeOctahedral(n) * scale + 0.5);
}

// Packs octahedralWhole, offset to start at 0, in 2 * bits bits: x in the lower half.
uint octahedralBits(vec3 n, int bits) {
    float scale = float((1 << (bits - 1)) - 1);
    uvec2 code = uvec2(octahedralWhole(n, bits) + scale);
    return code.x | code.y << bits;
}

// Packs three numbers >= 0 with a shared exponent: mantissas m of `bits` bits (4 to 9), then a
// 5-bit exponent e: v = m 2^(e - 15 - bits), at most 65536 (1 - 2^-bits). 9 bits are the format
// RGB9E5. The float's own exponent is used, so no logarithm errs. A mantissa that rounds to 2^bits
// uses the next exponent.
uint sharedExponentBits(vec3 v, int bits) {
    float steps = float(1 << bits);
    vec3 c = clamp(v, 0.0, 65536.0 - 65536.0 / steps);
    float greatest = max(max(c.x, c.y), max(c.z, 1.0 / 65536.0));
    int e = int(floatBitsToUint(greatest) >> 23) - 111;
    float scale = uintBitsToFloat(uint(142 + bits - e) << 23);
    if (floor(greatest * scale + 0.5) >= steps) { e += 1; scale *= 0.5; }
    uvec3 m = uvec3(floor(c * scale + 0.5));
    return m.x | m.y << bits | m.z << (2 * bits) | uint(e) << (3 * bits);
}

void main() {
    // cellsOfEachKind.yaml:6 Cells
    float diffuse_cells = cells3(localPosition * vec3(3.0, 2.0, 4.0), vec3(0.0), 0.5, 2, 0);
    // cellsOfEachKind.yaml:4 Blend
    float diffuse_blend_1 = clamp(diffuse_cells, 0.0, 1.0);
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    // cellsOfEachKind.yaml:10 Checker
    vec2 ambient_checker = fract(cells2Centre(uv * vec2(9.0), vec2(0.0), 0.0, 0));
    bool ambient_checker_2 = (0.5 <= ambient_checker.x) != (0.5 <= ambient_checker.y);
    // cellsOfEachKind.yaml:8 Cells
    float emissive_cells = cells2Random(mat2(vec2(5.732019, -0.29552022), vec2(1.7731212, 0.9553365)) * uv, vec2(0.0), 1.0, 0) * 0.5;
    // cellsOfEachKind.yaml:7 Cells
    float specular_cells = cells3(localPosition, vec3(0.0), clamp(loose, 0.0, 1.0), 1, 2) * 0.5;
    uint specular_bits = rootBits(specular_cells, 8);
    // cellsOfEachKind.yaml:9 Cells
    float shininess_cells = cells2(uv * vec2(4.0), vec2(0.0), 0.0, 0, 0) * 0.5;
    uint surface_bits = specular_bits | specular_bits << 8 | (ambient_checker_2 ? 1310720u : 655360u) | logarithmBits(phongExponent(shininess_cells), 10) << 21;
    // cellsOfEachKind.yaml:5 Cells
    float diffuse_cells2;
    if (diffuse_cells < 1.0) {
        diffuse_cells2 = sin(cells3Random(localPosition, vec3(0.0), 1.0, 0) * 3.0 + 0.2);
    } else {
        diffuse_cells2 = 0.0;
    }
    // cellsOfEachKind.yaml:5 Cells
    float diffuse_cells3;
    if (0.0 < diffuse_cells) {
        diffuse_cells3 = cells2(uv * vec2(5.0, 7.0), vec2(0.0), 1.0, 1, 1);
    } else {
        diffuse_cells3 = 0.0;
    }
    float diffuse_blend = diffuse_cells3 * diffuse_blend_1 + diffuse_cells2 * (1.0 - diffuse_blend_1);
    uint diffuse_bits = rootBits(diffuse_blend, 8);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | (ambient_checker_2 ? 2684354560u : 1342177280u) | 67108864u, sharedExponentBits(vec3(emissive_cells), 7) | (ambient_checker_2 ? 1342177280u : 671088640u), diffuse_bits | diffuse_bits << 8 | diffuse_bits << 16 | specular_bits << 24, surface_bits);
}
