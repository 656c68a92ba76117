#version 330 core
// matc 0.1.0: pass gbuffer, layout thesis

in vec3 localPosition;
in vec3 eyeNormal;
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

// e^v - 1, v taken to [-88, 88], where the result still is finite. Relative error 2e-7 for |v| < 1/2 (Taylor to v^8, remainder
// 1e-8), outside 2.5 times that of exp: no digits cancel anywhere.
float waveExpm1(float v) {
    v = clamp(v, -88.0, 88.0);
    float series = v * (1.0 + v * (1.0 / 2.0 + v * (1.0 / 6.0 + v * (1.0 / 24.0 + v * (1.0 / 120.0
                 + v * (1.0 / 720.0 + v * (1.0 / 5040.0 + v * (1.0 / 40320.0))))))));
    return abs(v) < 0.5 ? series : exp(v) - 1.0;
}

// tanh v in [-1, 1]. With t = e^(-2|v|) - 1 it is -t / (2 + t), where the denominator is at least 1: error of waveExpm1,
// 5e-7 on llvmpipe.
float waveTanh(float v) {
    float t = waveExpm1(-2.0 * min(abs(v), 40.0));
    float s = -t / (2.0 + t);
    return v < 0.0 ? -s : s;
}

void main() {
    // normal
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), 4.0, 65504.0);
    // Gradient
    float gradient_1 = waveTanh(dot(localPosition, vec3(0.8, 0.0, 0.6)) * 3.0);
    // Blend
    vec3 blend = mix(mix(vec3(0.007843138, 0.03137255, 0.023529412), vec3(0.078431375, 0.32156864, 0.105882354), clamp(gradient_1 + 1.0, 0.0, 1.0)), vec3(0.87058824, 0.84705883, 0.5529412), clamp(gradient_1, 0.0, 1.0));
    fragment1 = vec4(blend, 1.0);
    fragment2 = vec4(0.0, 0.0, 0.0, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
