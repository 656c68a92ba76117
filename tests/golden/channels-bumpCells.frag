#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 localPosition;
in vec3 localTangentU;
in vec3 localTangentV;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

// Splits p + rest into an integer cell, modulo 2^25, and a position d in [0, 1) in the cell. Exact.
void cellsCell3(vec3 p, vec3 rest, out vec3 cell, out vec3 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec3 over = floor(d);
    d -= over;
    cell = cell - 33554432.0 * floor(cell * (1.0 / 33554432.0) + 0.5) + over;
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

// Distance of an offset, for comparison. Metric 0: Euclidean, squared; 1: Manhattan; 2: Chebyshev.
float cellsFar3(vec3 away, int metric) {
    vec3 a = abs(away);
    return metric == 0 ? dot(away, away) : metric == 1 ? a.x + a.y + a.z : max(a.x, max(a.y, a.z));
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

// The cell point nearest to p + rest, bitwise equal across the cell. Error 6e-8 of the position,
// half an ULP.
vec3 cells3Centre(vec3 p, vec3 rest, float jitter, int metric) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, 1, first, second);
    vec3 offset = floor(d + first.xyz);
    vec3 place = 0.5 + jitter * (cellsPlace3(cell, offset) - 0.5);
    vec3 whole = floor(p);
    return whole + floor(p - whole + rest) + offset + place;
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

// Converts the result of cellsFar2 or cellsFar3 to a distance.
float cellsDistance(float far, int metric) {
    return metric == 0 ? sqrt(far) : far;
}

// Gradient, by the sample position, of the distance to a point given as (offset, cellsFar3); 0 at
// the point.
vec3 cellsRise3(vec4 point, int metric) {
    vec3 side = -sign(point.xyz);
    vec3 a = abs(point.xyz);
    if (metric == 0) return -point.xyz / sqrt(max(point.w, 1.0e-30));
    return metric == 1 ? side : side * step(max(a.x, max(a.y, a.z)), a);
}

// Gradient by p (xyz) and value (w) of cells3(p, rest, jitter, metric, value). Error of the
// gradient 6e-6, divided by the distance to the point; of the value 6e-7.
vec4 cells3Gradient(vec3 p, vec3 rest, float jitter, int metric, int value) {
    vec3 cell, d;
    vec4 first, second;
    cellsCell3(p, rest, cell, d);
    cellsSearch3(cell, d, jitter, metric, value == 0 ? 1 : 2, first, second);
    vec4 nearest = vec4(cellsRise3(first, metric), cellsDistance(first.w, metric));
    vec4 next = vec4(cellsRise3(second, metric), cellsDistance(second.w, metric));
    return value == 0 ? nearest : value == 1 ? next : next - nearest;
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

// A 24-bit number in [0, 1) from a cell's hash, independent of its point's position.
float cellsNumber(uint hash) {
    hash = (hash ^ (hash >> 15u)) * 0x2C1B3C6Du;
    return float((hash ^ (hash >> 16u)) >> 8u) * (1.0 / 16777216.0);
}

// Distance of an offset, for comparison. Metric 0: Euclidean, squared; 1: Manhattan; 2: Chebyshev.
float cellsFar2(vec2 away, int metric) {
    vec2 a = abs(away);
    return metric == 0 ? dot(away, away) : metric == 1 ? a.x + a.y : max(a.x, a.y);
}

// Position of a cell's point in the cell, in (0, 1): 65536 steps per axis.
vec2 cellsPlace2(vec2 cell, vec2 offset) {
    uint h = cellsHash2(cell, offset);
    return (vec2(uvec2(h >> 16u, h & 65535u)) + 0.5) * (1.0 / 65536.0);
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

// Random number in [0, 1] of the cell whose point is nearest to p + rest. Discontinuous at cell
// borders; exact elsewhere.
float cells2Random(vec2 p, vec2 rest, float jitter, int metric) {
    vec2 cell, d;
    vec3 first, second;
    cellsCell2(p, rest, cell, d);
    cellsSearch2(cell, d, jitter, metric, 1, first, second);
    return cellsNumber(cellsHash2(cell, floor(d + first.xy)));
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

// Transforms a direction from world to eye space. The matrix is a rotation: lengths and angles are
// kept.
vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
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

void main() {
    // bumpCells.yaml:3 CellCentre
    vec3 diffuse_cellCentre = cells3Centre(localPosition * 3.0, vec3(0.0), 0.5, 2);
    // bumpCells.yaml:9 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // bumpCells.yaml:7 UVTransform
    vec2 uvTransform = uv * vec2(4.0, 3.0);
    uint diffuse_bits = rootBits(dot(diffuse_cellCentre, vec3(0.3, 0.4, 0.2)), 8);
    // bumpCells.yaml:11 Cells
    vec4 cells = cells3Gradient(localPosition * 2.0, vec3(0.0), 1.0, 0, 2);
    // bumpCells.yaml:7 Cells
    float cells4 = cells2Random(uvTransform, vec2(0.0), 1.0, 0);
    float cells_2 = cos(cells.w);
    float bumpMap_3 = cells_2 * dot(cells.xyz, localTangentU * 2.0) * 0.06;
    float bumpMap_4 = cells_2 * dot(cells.xyz, localTangentV * 2.0) * 0.06;
    vec3 bumpMap_5 = cross(bumpMap_1, bumpMap_3 * worldTangentV - bumpMap_4 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_5 : bumpMap_5;
    vec3 bumpMap_6 = bumpMap_3 * bumpMap_1 + worldTangentU;
    vec3 bumpMap_7 = bumpMap_4 * bumpMap_1 + worldTangentV;
    // bumpCells.yaml:5 BumpMap
    vec3 bumpMap2_1 = 1.0 / max(length(bumpMap), 1e-30) * bumpMap;
    vec3 bumpMap2_2 = cross(bumpMap_6, bumpMap_7);
    vec3 bumpMap2_3 = (cells2Random(uvTransform, vec2(0.05, 0.0), 1.0, 0) - cells4) * 3.2 * bumpMap_7 - (cells2Random(uvTransform, vec2(0.0, 0.05), 1.0, 0) - cells4) * 2.4 * bumpMap_6;
    vec3 bumpMap2_4 = cross(bumpMap2_1, bumpMap2_3) + bumpMap2_2;
    vec3 bumpMap2 = dot(bumpMap2_2, bumpMap2_1) < 0.0 ? -bumpMap2_4 : bumpMap2_4;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap2)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, diffuse_bits | diffuse_bits << 8 | diffuse_bits << 16, 645922816u);
}
