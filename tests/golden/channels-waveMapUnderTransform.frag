#version 330 core
// matc 0.1.0: pass gbuffer, layout thesis

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
uniform mat3 matc_eyeFromWorld;
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

// A world direction in eye space; the matrix is a rotation, so that lengths and angles stay.

vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
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

void main() {
    // UVTransform
    vec2 uvTransform_1 = mat2(vec2(2.6327477, -0.9588511), vec2(1.4382766, 1.7551651)) * uv;
    vec3 uvTransform = worldTangentV * 0.15980852 + worldTangentU * 0.29252753;
    vec3 uvTransform2 = worldTangentV * 0.43879128 + worldTangentU * -0.23971277;
    // WaveMap
    float waveMap_1 = 0.01 / max(length(worldNormal), 1e-30);
    float waveMap_2 = uvTransform_1.x * 18.849556;
    float waveMap_3 = uvTransform_1.y * 12.566371;
    vec3 waveMap_4 = cos(waveMap_3) * -(sin(waveMap_2) * 18.849556) * waveMap_1 * worldNormal;
    vec3 waveMap_5 = -(sin(waveMap_3) * 12.566371) * cos(waveMap_2) * waveMap_1 * worldNormal;
    vec3 waveMap = cross(waveMap_4 + uvTransform, waveMap_5 + uvTransform2);
    // normal
    vec3 normal = safeNormalize(eyeFromWorld(waveMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), 21.206507, 65504.0);
    fragment1 = vec4(0.21568628, 0.13725491, 0.32156864, 1.0);
    fragment2 = vec4(0.4, 0.4, 0.4, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
