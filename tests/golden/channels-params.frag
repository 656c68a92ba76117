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

// Julia set of c = (cx, cy): z starts at 4 fract(p.xy) - 2. Returns the fraction of `iterations`
// steps z^2 + c with |z| <= 2, scaled to [-1, 1]. Rounding may change the count near the set's
// border.
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
    // params.yaml:13 XYZTransform
    float diffuse_xyzTransform_1 = sin(turn.x);
    float diffuse_xyzTransform_2 = cos(turn.x) * zoom;
    float diffuse_xyzTransform_3 = -diffuse_xyzTransform_1 * zoom;
    float diffuse_xyzTransform_4 = diffuse_xyzTransform_1 * zoom;
    float diffuse_xyzTransform_5 = cos(turn.y);
    float diffuse_xyzTransform_6 = sin(turn.y);
    float diffuse_xyzTransform_7 = diffuse_xyzTransform_5 * zoom;
    float diffuse_xyzTransform_8 = diffuse_xyzTransform_6 * diffuse_xyzTransform_4;
    float diffuse_xyzTransform_9 = diffuse_xyzTransform_6 * diffuse_xyzTransform_2;
    float diffuse_xyzTransform_10 = cos(turn.z);
    float diffuse_xyzTransform_11 = sin(turn.z);
    float diffuse_xyzTransform_12 = -diffuse_xyzTransform_11;
    vec3 diffuse_xyzTransform_13 = vec3(diffuse_xyzTransform_12 * diffuse_xyzTransform_2 + diffuse_xyzTransform_10 * diffuse_xyzTransform_8, diffuse_xyzTransform_10 * diffuse_xyzTransform_2 + diffuse_xyzTransform_11 * diffuse_xyzTransform_8, diffuse_xyzTransform_5 * diffuse_xyzTransform_4);
    vec3 diffuse_xyzTransform_14 = vec3(diffuse_xyzTransform_12 * diffuse_xyzTransform_3 + diffuse_xyzTransform_10 * diffuse_xyzTransform_9, diffuse_xyzTransform_10 * diffuse_xyzTransform_3 + diffuse_xyzTransform_11 * diffuse_xyzTransform_9, diffuse_xyzTransform_5 * diffuse_xyzTransform_2);
    vec3 diffuse_xyzTransform = mat3(vec3(diffuse_xyzTransform_10 * diffuse_xyzTransform_7, diffuse_xyzTransform_11 * diffuse_xyzTransform_7, -diffuse_xyzTransform_6 * zoom), diffuse_xyzTransform_13, diffuse_xyzTransform_14) * localPosition + pan;
    // params.yaml:7 Julia
    float diffuse_julia = sin(lift + contrast * julia(diffuse_xyzTransform, steps, real, imaginary));
    // params.yaml:4 Blend
    vec4 diffuse_blend_1 = vec4(vec3(bright), 1.0);
    vec4 diffuse_blend = diffuse_julia <= 1.0 ? (diffuse_julia < -1.0 ? dark : mix(dark, diffuse_blend_1, (diffuse_julia + 1.0) * 0.5)) : diffuse_blend_1;
    vec3 transparency = vec3(1.0) - diffuse_blend.www;
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    uint specular_bits = rootBits(gloss, 7);
    uint surface_bits2 = specular_bits | specular_bits << 7 | logarithmBits(phongExponent(sharpness), 10) << 14 | rootBits(transparency.x, 6) << 24;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 4227858433u, surface_bits | specular_bits << 24, surface_bits2, rootBits(transparency.y, 6) | rootBits(transparency.z, 6) << 6);
}
