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

// Finds the nearest cell point in the 3 x 3 (x 3) neighborhood of p: `away` is p minus the point,
// `nearest` its cell. Each cell has one random point; `jitter` scales its offset from the center.
// Coordinates are clamped to 2^24; in 2D z is 0. Error 3e-7.
void worleySearch(vec3 p, float jitter, int dimensions, out vec3 away, out vec3 nearest) {
    vec3 axes = vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    vec3 q = clamp(p, -16777216.0, 16777216.0) * axes;
    vec3 cell = floor(q);
    vec3 d = q - cell;
    float least = 1.0e6;
    away = vec3(0.0);
    nearest = cell;
    for (int i = 0; i < 27; i++) {
        if (i > 8 && dimensions < 3) break;
        float rows = floor((float(i) + 0.5) / 3.0);
        float plane = floor((float(i) + 0.5) / 9.0);
        vec3 beside = (vec3(float(i) - 3.0 * rows, rows - 3.0 * plane, plane) - 1.0) * axes;
        vec3 far = d - beside - ((jenkinsPlaces(cell + beside, dimensions) - 0.5) * jitter + 0.5) * axes;
        float square = dot(far, far);
        if (square < least) {
            least = square;
            away = far;
            nearest = cell + beside;
        }
    }
}

// Distance to the nearest random point or, for style 1, its cell's number, as MaterialX's
// worleynoise3d and worleynoise2d. Error 1e-6.
float worley(vec3 p, float jitter, int style, int dimensions) {
    vec3 away, nearest;
    worleySearch(p, jitter, dimensions, away, nearest);
    return style > 0 ? jenkins(nearest, dimensions) : length(away);
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
    // worley.yaml:10 Worley
    float diffuse_worley = worley(localPosition * 6.0, 0.7, 0, 3);
    // worley.yaml:5 Blend
    vec3 diffuse_blend = mix(mix(vec3(0.58407843, 0.45641103, 0.09758735), vec3(0.07818742, 0.19461784, 0.04231141), clamp((diffuse_worley - 0.1) * 2.5, 0.0, 1.0)), vec3(0.012286488, 0.02842604, 0.011612245), clamp((diffuse_worley - 0.5) * 5.0, 0.0, 1.0));
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits, 645922816u);
}
