#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
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

// Bijective hash finalizer, two xorshift-multiply rounds: the top bits of every shifted hash are
// well mixed.
uvec4 latticeFinal(uvec4 h) {
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}

// Hashes of a cell's eight corners, in latticeMix's order: xor of products, then a finalizer. The
// wrap to [0, 65536) is exact for every finite cell.
void latticeCorners(vec3 cell, out uvec4 low, out uvec4 high) {
    const uvec3 factor = uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uvec3 c = uvec3(ivec3(cell - 65536.0 * floor(cell * (1.0 / 65536.0))));
    uvec3 c0 = c * factor;
    uvec3 c1 = ((c + 1u) & 65535u) * factor;
    uvec4 square = uvec4(c0.x, c1.x, c0.x, c1.x) ^ uvec4(c0.yy, c1.yy);
    low = latticeFinal(square ^ (c0.z + 0x165667B1u));
    high = latticeFinal(square ^ (c1.z + 0x165667B1u));
}

// Mixes eight corner terms with weights 3d^2 - 2d^3. Order: (x, y) = (0,0) (1,0) (0,1) (1,1), z = 0
// in `low` and 1 in `high`.
float latticeMix(vec4 low, vec4 high, vec3 d) {
    vec3 s = d * d * (3.0 - 2.0 * d);
    vec4 plane = mix(low, high, s.z);
    vec2 line = mix(plane.xy, plane.zw, s.y);
    return mix(line.x, line.y, s.x);
}

// Scales a signed 32-bit hash to [-1, 1].
const float latticeScale = 1.0 / 2147483648.0;

// Value plus gradient terms of a face's four corners, times 2^31; d is the offset from the first
// corner. The numbers are the hash shifted left by 0, 7, 14, 21, read as signed: uniform, symmetric
// to 2^-11.
vec4 latticeTerms(uvec4 hash, vec3 d) {
    vec4 dx = vec4(d.x, d.x - 1.0, d.x, d.x - 1.0);
    vec4 dy = vec4(d.yy, d.yy - 1.0);
    return 0.5 * vec4(ivec4(hash)) + vec4(ivec4(hash << 7u)) * dx + vec4(ivec4(hash << 14u)) * dy
         + vec4(ivec4(hash << 21u)) * d.z;
}

// Lattice noise at position d in [0, 1) in a cell: hashed value and gradient per corner, smoothly
// interpolated. About [-1, 1], standard deviation 1/4, period 65536 per axis. Error 1e-6.
float lattice(vec3 cell, vec3 d) {
    uvec4 low, high;
    latticeCorners(cell, low, high);
    return latticeMix(latticeTerms(low, d), latticeTerms(high, d - vec3(0.0, 0.0, 1.0)), d) * latticeScale;
}

// Noise in [-1, 1], standard deviation 1/2. About 1 sample in 20 is clamped. Error 2e-6, also for
// simplex noise.
float noise(vec3 p) {
    vec3 cell = floor(p);
    return clamp(2.0 * lattice(cell, p - cell), -1.0, 1.0);
}

// Sum of octaves noiseRatio^k noise(frequencyRatio^k p), k from 0; at least one. Signed, not
// normalized. Error of noise times the sum of amplitudes if frequencyRatio is a power of two; other
// ratios round p.
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

// Quantizes v, clamped to [0, 1], to `bits` <= 16 bits, rounding to nearest.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// Quantizes sqrt(v), v clamped to [0, 1], to `bits` bits: finer steps near 0, like perceived
// lightness.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
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
    // cellCentre.yaml:13 CellCentre
    vec3 diffuse_cellCentre = cells3Centre(localPosition * 6.0, vec3(0.0), 1.0, 1);
    // cellCentre.yaml:10 VolumeTurbulence
    float diffuse_volumeTurbulence = turbulence(diffuse_cellCentre * 0.6, 2, 2.0, 1.0);
    // cellCentre.yaml:4 Blend
    vec3 diffuse_blend = mix(mix(vec3(0.07058824, 0.22745098, 0.2901961), vec3(0.23529412, 0.47843137, 0.45490196), clamp((diffuse_volumeTurbulence + 0.4) * 2.5, 0.0, 1.0)), vec3(0.8901961, 0.84313726, 0.65882355), clamp(diffuse_volumeTurbulence * 2.5, 0.0, 1.0));
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits | 2348810240u, 903908492u);
}
