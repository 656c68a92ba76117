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

vec3 smooth3DInput0(vec3 p) {
    // VolumeChecker
    vec3 volumeChecker_1 = fract(p * 3.0 * 0.5);
    vec3 volumeChecker = ((0.5 <= volumeChecker_1.x) != (0.5 <= volumeChecker_1.y)) != (0.5 <= volumeChecker_1.z) ? vec3(0.87058824, 0.74509805, 0.5254902) : vec3(0.043137256, 0.050980393, 0.14509805);
    return volumeChecker;
}

vec3 smooth3DInput1(vec3 p) {
    // Smooth3D
    vec3 smooth3D_1 = smooth3DInput0(p + vec3(-0.15, -0.15, 0.15)) + (smooth3DInput0(p + vec3(-0.15, -0.15, 0.0)) + smooth3DInput0(p - vec3(0.15)));
    vec3 smooth3D_2 = smooth3DInput0(p + vec3(-0.15, 0.0, 0.15)) + (smooth3DInput0(p + vec3(-0.15, 0.0, 0.0)) + (smooth3DInput0(p + vec3(-0.15, 0.0, -0.15)) + smooth3D_1));
    vec3 smooth3D_3 = smooth3DInput0(p + vec3(-0.15, 0.15, 0.15)) + (smooth3DInput0(p + vec3(-0.15, 0.15, 0.0)) + (smooth3DInput0(p + vec3(-0.15, 0.15, -0.15)) + smooth3D_2));
    vec3 smooth3D_4 = smooth3DInput0(p + vec3(0.0, -0.15, 0.15)) + (smooth3DInput0(p + vec3(0.0, -0.15, 0.0)) + (smooth3DInput0(p + vec3(0.0, -0.15, -0.15)) + smooth3D_3));
    vec3 smooth3D_5 = smooth3DInput0(p + vec3(0.0, 0.0, 0.15)) + (smooth3DInput0(p) + (smooth3DInput0(p + vec3(0.0, 0.0, -0.15)) + smooth3D_4));
    vec3 smooth3D_6 = smooth3DInput0(p + vec3(0.0, 0.15, 0.15)) + (smooth3DInput0(p + vec3(0.0, 0.15, 0.0)) + (smooth3DInput0(p + vec3(0.0, 0.15, -0.15)) + smooth3D_5));
    vec3 smooth3D_7 = smooth3DInput0(p + vec3(0.15, -0.15, 0.15)) + (smooth3DInput0(p + vec3(0.15, -0.15, 0.0)) + (smooth3DInput0(p + vec3(0.15, -0.15, -0.15)) + smooth3D_6));
    vec3 smooth3D_8 = smooth3DInput0(p + vec3(0.15, 0.0, 0.15)) + (smooth3DInput0(p + vec3(0.15, 0.0, 0.0)) + (smooth3DInput0(p + vec3(0.15, 0.0, -0.15)) + smooth3D_7));
    vec3 smooth3D_9 = smooth3DInput0(p + vec3(0.15)) + (smooth3DInput0(p + vec3(0.15, 0.15, 0.0)) + (smooth3DInput0(p + vec3(0.15, 0.15, -0.15)) + smooth3D_8));
    return smooth3D_9 * 0.037037037;
}

vec3 smooth3DInput1Sum(vec3 p, vec3 size) {
    vec3 sum = vec3(0.0);
    for (float i = -0.5; i < 1.0; i += 0.5)
        for (float j = -0.5; j < 1.0; j += 0.5)
            for (float k = -0.5; k < 1.0; k += 0.5)
                sum += smooth3DInput1(p + vec3(i, j, k) * size);
    return sum;
}

void main() {
    // normal
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), 4.0, 65504.0);
    // Smooth3D
    vec3 smooth3D = smooth3DInput1Sum(localPosition, vec3(0.1)) * 0.037037037;
    fragment1 = vec4(smooth3D, 1.0);
    fragment2 = vec4(0.0, 0.0, 0.0, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
