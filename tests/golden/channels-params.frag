#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
uniform vec4 dark;
uniform float bright;
uniform int steps;
uniform float real;
uniform float imaginary;
uniform float contrast;
uniform float lift;
uniform vec3 turn;
uniform float zoom;
uniform vec3 pan;
uniform float gloss;
uniform float sharpness;
layout(location = 0) out uvec4 fragment0;

// Julia set of c = cx + i cy: z from 4 (fraction of p.xy) - 2 on; the share of `iterations` steps z^2 + c that stay within
// |z| <= 2, laid over [-1, 1]. Next to the set's edge rounding may change the number of steps.
float julia(vec3 p, int iterations, float cx, float cy) {
    vec2 z = 4.0 * fract(p.xy) - 2.0;
    int steps = 0;
    for (int k = 0; k < iterations; k++) {
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + vec2(cx, cy);
        if (dot(z, z) > 4.0) break;
        steps++;
    }
    return 2.0 * float(steps) / max(float(iterations), 1.0) - 1.0;
}

// v / |v| for every finite v; (0, 0, 1) where no component reaches 1e-37. v is divided by its greatest component first, so that
// no square over- or underflows, and a great one is scaled down before, so that its reciprocal does not. Relative error 2e-7.
vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}

// v, taken to [0, 1], as the nearest of 2^bits equal steps, bits <= 16.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// The square root of v, taken to [0, 1], as the nearest of 2^bits equal steps: steps of v that shrink towards 0, as an eye's do.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
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

void main() {
    // XYZTransform
    float xyzTransform_1 = sin(turn.x);
    float xyzTransform_2 = cos(turn.x) * zoom;
    float xyzTransform_3 = -xyzTransform_1 * zoom;
    float xyzTransform_4 = xyzTransform_1 * zoom;
    float xyzTransform_5 = cos(turn.y);
    float xyzTransform_6 = sin(turn.y);
    float xyzTransform_7 = xyzTransform_5 * zoom;
    float xyzTransform_8 = xyzTransform_6 * xyzTransform_4;
    float xyzTransform_9 = xyzTransform_6 * xyzTransform_2;
    float xyzTransform_10 = cos(turn.z);
    float xyzTransform_11 = sin(turn.z);
    float xyzTransform_12 = -xyzTransform_11;
    vec3 xyzTransform_13 = vec3(xyzTransform_12 * xyzTransform_2 + xyzTransform_10 * xyzTransform_8, xyzTransform_10 * xyzTransform_2 + xyzTransform_11 * xyzTransform_8, xyzTransform_5 * xyzTransform_4);
    vec3 xyzTransform_14 = vec3(xyzTransform_12 * xyzTransform_3 + xyzTransform_10 * xyzTransform_9, xyzTransform_10 * xyzTransform_3 + xyzTransform_11 * xyzTransform_9, xyzTransform_5 * xyzTransform_2);
    vec3 xyzTransform = mat3(vec3(xyzTransform_10 * xyzTransform_7, xyzTransform_11 * xyzTransform_7, -xyzTransform_6 * zoom), xyzTransform_13, xyzTransform_14) * localPosition + pan;
    // Julia
    float julia_1 = sin(lift + contrast * julia(xyzTransform, steps, real, imaginary));
    // Blend
    vec4 blend_1 = vec4(vec3(bright), 1.0);
    vec4 blend = julia_1 < 1.0 ? (julia_1 < -1.0 ? dark : mix(dark, blend_1, (julia_1 + 1.0) * 0.5)) : blend_1;
    // transparency
    vec3 transparency = vec3(1.0) - blend.www;
    // normal
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    // surface
    uint surface_1 = rootBits(blend.x, 8) | rootBits(blend.y, 8) << 8 | rootBits(blend.z, 8) << 16;
    // specular
    uint specular_1 = rootBits(gloss, 7);
    // surface
    uint surface_2 = specular_1 | specular_1 << 7 | logarithmBits(phongExponent(sharpness), 10) << 14 | rootBits(transparency.x, 6) << 24;
    uvec4 surface_3 = uvec4(octahedralBits(normal, 12) << 2 | 4227858433u, surface_1 | specular_1 << 24, surface_2, rootBits(transparency.y, 6) | rootBits(transparency.z, 6) << 6);
    fragment0 = surface_3;
}
