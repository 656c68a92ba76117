#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
uniform vec3 bright;
layout(location = 0) out uvec4 fragment0;

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

// Derives a second, unrelated hash from a corner's hash. One round suffices for a mixed hash.
uvec4 latticeNext(uvec4 hash) {
    hash = (hash ^ (hash >> 15u)) * 0x2C1B3C6Du;
    return hash ^ (hash >> 16u);
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

// Three lattice noises at position d in a cell: x is lattice(cell, d); y and z use further hashes.
vec3 vectorNoise(vec3 cell, vec3 d) {
    vec3 e = d - vec3(0.0, 0.0, 1.0);
    vec3 sum;
    uvec4 low, high;
    latticeCorners(cell, low, high);
    sum.x = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.y = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.z = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    return sum * latticeScale;
}

// Sum of octaves noiseRatio^k vectorNoise(frequencyRatio^k p), k from 0; at least one. Signed, not
// normalized. Error of turbulence.
vec3 vectorTurbulence(vec3 p, int octaves, float frequencyRatio, float noiseRatio) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    vec3 sum = vec3(0.0);
    for (int k = 0; k < count; k++) {
        vec3 cell = floor(p);
        sum += strength * vectorNoise(cell, p - cell);
        strength *= noiseRatio;
        p *= frequencyRatio;
    }
    return sum;
}

// Distance from the z axis, coordinates clamped to 1e37 and scaled so that no square over- or
// underflows. Relative error 2e-7.
float wood(vec3 p) {
    vec2 a = min(abs(p.xy), 1.0e37);
    float greater = max(max(a.x, a.y), 1.0e-37);
    return greater * length(a / greater);
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
    // malachite.json:32 XYZTransform
    vec3 bands_xyzTransform = mat3(vec3(0.921061, 0.0, -0.38941833), vec3(0.32768422, 0.5403023, 0.7750461), vec3(0.21040362, -0.84147096, 0.49765137)) * localPosition + vec3(0.4, 0.3, 0.0);
    // malachite.json:28 Turbulence
    vec3 bands_turbulence = vectorTurbulence(bands_xyzTransform, 3, 2.0, 0.45) * vec3(0.35) + bands_xyzTransform;
    // malachite.json:24 bands
    float bands_1 = abs(fract(wood(bands_turbulence) * 5.0) * 4.0 - 1.0) - 2.0;
    float bands = sin((abs(bands_1) - 1.0) * 0.9 + 0.1);
    // malachite.json:5 Blend
    float diffuse_blend_1 = bands + 1.0;
    vec3 diffuse_blend_2 = bands < -0.1 ? (bands < -1.0 ? vec3(0.0, 0.035601314, 0.023153367) : mix(vec3(0.0, 0.035601314, 0.023153367), vec3(0.008023193, 0.19461784, 0.107023105), diffuse_blend_1 * 1.1111112)) : mix(vec3(0.008023193, 0.19461784, 0.107023105), bright, (bands + 0.1) * 1.6666666);
    vec3 diffuse_blend = bands < 0.5 ? diffuse_blend_2 : bands <= 0.8 ? mix(bright, vec3(0.008023193, 0.19461784, 0.107023105), (bands - 0.5) * 3.3333333) : vec3(0.008023193, 0.19461784, 0.107023105);
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    // malachite.json:15 Blend
    float specular_blend = mix(0.45, 0.25, clamp(diffuse_blend_1 * 0.5, 0.0, 1.0));
    uint specular_bits = rootBits(specular_blend, 8);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits | specular_bits << 24, specular_bits | specular_bits << 8 | 1249902592u);
}
