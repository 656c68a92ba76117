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

// Two numbers in [0, 1], cut to seven bits each, in one number of [1, 65504] that a half float holds exactly: x gives the
// exponent and the first three bits of the mantissa, y the other seven. The power of two is exact: exp2 errs by at most 33 ulp
// of 32768, an eighth, before it is rounded to a whole number.
float packPair(vec2 v) {
    vec2 q = floor(127.5 * clamp(v, 0.0, 1.0));
    float exponent = floor(q.x * 0.125);
    float mantissa = 1.0 + (q.x * 0.125 - exponent) + q.y * (1.0 / 1024.0);
    return mantissa * floor(exp2(exponent) + 0.5);
}

void main() {
    // normal
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), 4.0, 65504.0);
    // Blend
    float blend = mix(0.2, 0.8, clamp(localPosition.x, 0.0, 1.0));
    float blend2 = localPosition.x < 0.0 ? (localPosition.x < -1.0 ? 1000.0 : mix(1000.0, 0.001, localPosition.x + 1.0)) : localPosition.x < 1.0 ? mix(0.001, 0.002, localPosition.x) : 0.002;
    fragment1 = vec4(vec3(blend), packPair(vec2(blend2)));
    fragment2 = vec4(vec3(0.0), packPair(vec2(blend2, 0.0)));
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
