#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
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
    // lacquer.yaml:12 dents
    vec3 dents_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    // lacquer.yaml:12 Expression
    vec3 dents_expression = cells3Gradient(localPosition * 6.0, vec3(0.0), 1.0, 0, 0).xyz;
    vec3 dents_2 = cross(worldTangentU, worldTangentV);
    vec3 dents_3 = dot(dents_expression, localTangentU * 6.0) * 0.04 * worldTangentV - dot(dents_expression, localTangentV * 6.0) * 0.04 * worldTangentU;
    vec3 dents_4 = cross(dents_1, dents_3) + dents_2;
    vec3 dents = dot(dents_2, dents_1) < 0.0 ? -dents_4 : dents_4;
    vec3 normal = safeNormalize(eyeFromWorld(dents)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(2780459016u, 4293918720u, octahedralBits(normal, 12) | 1291845632u, 2222497011u);
}
