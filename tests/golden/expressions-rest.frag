#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec2 uv;
in vec3 localPosition;
in vec3 eyeNormal;
in vec4 matc_attribute_color;
layout(location = 0) out uvec4 fragment0;

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
    // rest.yaml:3 Expression
    float diffuse_expression = sin(uv.x * 3.0) * 0.5 + 0.5;
    float diffuse_expression_2 = 0.5 - diffuse_expression;
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    // rest.yaml:5 Expression
    vec3 emissive_expression_1 = localPosition * 3.1415927;
    vec3 emissive_expression = uv.x <= 0.5 ? sin(emissive_expression_1) : cos(emissive_expression_1);
    // rest.yaml:4 Expression
    vec3 specular_expression = ceil(localPosition.z * 4.0) != 0.0 ? matc_attribute_color.xyz * 0.5 : vec3(0.2, 0.3, 0.4);
    float diffuse_expression_3 = (0.5 - abs(diffuse_expression_2)) / (abs(1.0 - diffuse_expression * 2.0) * -0.5714286 + 1.0);
    uint surface_bits = rootBits(0.5 - (0.5 - diffuse_expression_3) * sign(diffuse_expression_2), 8) | rootBits(cellNoise(localPosition * 3.0, 3), 8) << 8;
    uint surface_bits2 = surface_bits | rootBits(worley(localPosition * 2.0, 1.0, 0, 3), 8) << 16 | rootBits(specular_expression.x, 8) << 24;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, sharedExponentBits(emissive_expression, 7), surface_bits2, rootBits(specular_expression.y, 8) | rootBits(specular_expression.z, 8) << 8 | 645922816u);
}
