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
    // WaveMap
    float waveMap_1 = uv.x - 0.25;
    float waveMap_2 = uv.y - 0.33333334;
    bool waveMap_3 = 0.0 <= waveMap_1 && waveMap_1 <= 0.25 && (0.0 <= waveMap_2 && waveMap_2 <= 0.33333334);
    vec3 waveMap;
    if (waveMap_3) {
        float waveMap_4 = 0.03 / max(length(worldNormal), 1e-30);
        float waveMap_5 = waveMap_1 * 50.265484;
        float waveMap_6 = waveMap_2 * 37.699112;
        vec3 waveMap_7 = cos(waveMap_6) * -(sin(waveMap_5) * 50.265484) * waveMap_4 * worldNormal;
        vec3 waveMap_8 = -(sin(waveMap_6) * 37.699112) * cos(waveMap_5) * waveMap_4 * worldNormal;
        waveMap = cross(waveMap_7 + worldTangentU, waveMap_8 + worldTangentV);
    } else {
        waveMap = worldNormal;
    }
    // normal
    vec3 normal = safeNormalize(eyeFromWorld(waveMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), 21.206507, 65504.0);
    fragment1 = vec4(0.07058824, 0.21176471, 0.29803923, 1.0);
    fragment2 = vec4(0.4, 0.4, 0.4, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
