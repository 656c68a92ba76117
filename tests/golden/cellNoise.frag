#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
layout(location = 0) out uvec4 fragment0;

// Jenkins' lookup3 hash of `count` (2 or 3) integers, |cell| <= 2^24, over 2^32 - 1, seeded with
// 0xDEADBEEF + 4 count + 13 as in OSL and MaterialX. For count 2, cell.z is 0. Error 1e-7.
// jenkinsPlaces also hashes the component index 0 to `dimensions` - 1.
uint jenkinsTurned(uint bits, int by) {
    return (bits << by) | (bits >> (32 - by));
}

float jenkinsEnd(uvec3 h) {
    h.z = (h.z ^ h.y) - jenkinsTurned(h.y, 14);
    h.x = (h.x ^ h.z) - jenkinsTurned(h.z, 11);
    h.y = (h.y ^ h.x) - jenkinsTurned(h.x, 25);
    h.z = (h.z ^ h.y) - jenkinsTurned(h.y, 16);
    h.x = (h.x ^ h.z) - jenkinsTurned(h.z, 4);
    h.y = (h.y ^ h.x) - jenkinsTurned(h.x, 14);
    h.z = (h.z ^ h.y) - jenkinsTurned(h.y, 24);
    return float(h.z) / 4294967296.0;
}

float jenkins(vec3 cell, int count) {
    return jenkinsEnd(uvec3(ivec3(cell)) + (0xDEADBEEFu + 13u + 4u * uint(count)));
}

vec3 jenkinsPlaces(vec3 cell, int dimensions) {
    if (dimensions < 3)
        return vec3(jenkins(vec3(cell.xy, 0.0), 3), jenkins(vec3(cell.xy, 1.0), 3), 0.0);
    uvec3 h = uvec3(ivec3(cell)) + (0xDEADBEEFu + 13u + 16u);
    h.x = (h.x - h.z) ^ jenkinsTurned(h.z, 4);
    h.z += h.y;
    h.y = (h.y - h.x) ^ jenkinsTurned(h.x, 6);
    h.x += h.z;
    h.z = (h.z - h.y) ^ jenkinsTurned(h.y, 8);
    h.y += h.x;
    h.x = (h.x - h.z) ^ jenkinsTurned(h.z, 16);
    h.z += h.y;
    h.y = (h.y - h.x) ^ jenkinsTurned(h.x, 19);
    h.x += h.z;
    h.z = (h.z - h.y) ^ jenkinsTurned(h.y, 4);
    h.y += h.x;
    return vec3(jenkinsEnd(h), jenkinsEnd(h + uvec3(1u, 0u, 0u)), jenkinsEnd(h + uvec3(2u, 0u, 0u)));
}

// Random number in [0, 1] per unit cube (or unit square), as MaterialX's cellnoise3d and
// cellnoise2d. Coordinates are clamped to 2^24. Error 1e-7.
float cellNoise(vec3 p, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0) * vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    return jenkins(floor(q), dimensions);
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
    // cellNoise.yaml:10 CellNoise
    float diffuse_cellNoise = cellNoise(localPosition * 4.0, 3);
    // cellNoise.yaml:5 Blend
    vec3 diffuse_blend = mix(mix(vec3(0.014443844, 0.029556835, 0.07818742), vec3(0.43415365, 0.064803265, 0.045186203), clamp((diffuse_cellNoise - 0.2) * 2.5, 0.0, 1.0)), vec3(0.8148466, 0.7156935, 0.5271151), clamp((diffuse_cellNoise - 0.6) * 3.3333333, 0.0, 1.0));
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits, 645922816u);
}
