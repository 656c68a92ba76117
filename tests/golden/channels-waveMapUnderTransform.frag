#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
uniform mat3 matc_eyeFromWorld;
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

// Transforms a direction from world to eye space. The matrix is a rotation: lengths and angles are
// kept.
vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
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
    // waveMapUnderTransform.yaml:9 UVTransform
    vec2 uvTransform_1 = mat2(vec2(2.6327477, -0.9588511), vec2(1.4382766, 1.7551651)) * uv;
    vec3 uvTransform = worldTangentV * 0.15980852 + worldTangentU * 0.29252753;
    vec3 uvTransform_2 = worldTangentV * 0.43879128 + worldTangentU * -0.23971277;
    // waveMapUnderTransform.yaml:5 WaveMap
    vec3 waveMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    float waveMap_2 = uvTransform_1.x * 18.849556;
    float waveMap_3 = uvTransform_1.y * 12.566371;
    vec3 waveMap_4 = cross(uvTransform, uvTransform_2);
    vec3 waveMap_5 = cos(waveMap_3) * -(sin(waveMap_2) * 18.849556) * 0.01 * uvTransform_2;
    vec3 waveMap_6 = -(sin(waveMap_3) * 12.566371) * cos(waveMap_2) * 0.01 * uvTransform;
    vec3 waveMap_7 = cross(waveMap_1, waveMap_5 - waveMap_6) + waveMap_4;
    vec3 waveMap = dot(waveMap_4, waveMap_1) < 0.0 ? -waveMap_7 : waveMap_7;
    vec3 normal = safeNormalize(eyeFromWorld(waveMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, 2710658934u, 903913889u);
}
