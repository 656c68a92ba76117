#version 330 core
// matc 0.1.0: pass gbuffer, layout thesis

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
layout(location = 0) out vec4 fragment0;
layout(location = 1) out vec4 fragment1;
layout(location = 2) out vec4 fragment2;
layout(location = 3) out vec4 fragment3;

// v / |v| for every finite v; (0, 0, 1) where no component reaches 1e-37. v is divided by its greatest component first, so that
// no square over- or underflows, and a great one is scaled down before, so that its reciprocal does not. Relative error 3e-7.
vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}

// Unit normal n to n.xy / sqrt(8 n.z + 8) + 1/2 in [0, 1]^2, in two forms that are equal for a unit n: this one for n.z >= 0,
// and below it the direction of n.xy times the radius sqrt((1 - n.z) / 8), which holds its digits up to the singularity.
// At (0, 0, -1) itself the direction is +x.
vec2 encodeSpheremap(vec3 n) {
    float square = dot(n.xy, n.xy);
    vec2 direction = square > 1.0e-30 ? n.xy * inversesqrt(max(square, 1.0e-30)) : vec2(1.0, 0.0);
    vec2 front = n.xy * inversesqrt(8.0 * max(n.z, 0.0) + 8.0);
    vec2 back = direction * sqrt(0.125 - 0.125 * min(n.z, 0.0));
    return clamp((n.z < 0.0 ? back : front) + 0.5, 0.0, 1.0);
}

// Exponent of a Phong lobe for a shininess x: -2 / ln y, y = x (2 - x), 0 for y <= 0, at most 65504. Relative error 3e-6.
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

void main() {
    // normal
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), phongExponent(sharpness), 65504.0);
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
    fragment1 = vec4(clamp(blend.xyz, -65504.0, 65504.0), 1.0);
    fragment2 = vec4(clamp(vec3(gloss), -65504.0, 65504.0), 1.0);
    fragment3 = vec4(clamp(vec3(1.0) - blend.www, -65504.0, 65504.0), 1.0);
}
