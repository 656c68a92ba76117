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
    // BumpMap
    float bumpMap_1 = 0.03 / max(length(worldNormal), 1e-30);
    // Checker
    vec2 checker_1 = fract(uv * vec2(6.0, 3.0));
    bool checker_2 = (0.5 <= checker_1.x) != (0.5 <= checker_1.y);
    vec2 checker_3 = fract(checker_1 + vec2(0.05, 0.0));
    vec2 checker_4 = fract(checker_1 + vec2(0.0, 0.05));
    // BumpMap
    float bumpMap_2 = checker_2 ? -20.0 : 20.0;
    vec3 bumpMap_3 = (checker_2 != ((0.5 <= checker_3.x) != (0.5 <= checker_3.y)) ? bumpMap_2 : 0.0) * bumpMap_1 * worldNormal;
    vec3 bumpMap_4 = (checker_2 != ((0.5 <= checker_4.x) != (0.5 <= checker_4.y)) ? bumpMap_2 : 0.0) * bumpMap_1 * worldNormal;
    vec3 bumpMap = cross(bumpMap_3 + worldTangentU, bumpMap_4 + worldTangentV);
    // normal
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), 21.206507, 65504.0);
    fragment1 = vec4(0.32156864, 0.27450982, 0.21176471, 1.0);
    fragment2 = vec4(0.4, 0.4, 0.4, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
