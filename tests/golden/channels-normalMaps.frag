#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 localPosition;
in vec3 localTangentU;
in vec3 localTangentV;
uniform float strength;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

// Gradient (xyz) and value (w) of leopard. Error 4.3e-7 if sin and cos err by 1e-7.
vec4 leopardGradient(vec3 p) {
    float mean = dot(sin(p), vec3(1.0 / 3.0));
    return vec4(cos(p) * (mean * (2.0 / 3.0)), mean * mean);
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
    // normalMaps.yaml:17 UVTransform
    vec3 uvTransform = worldTangentV * -0.12980612 + worldTangentU * -0.30702034;
    vec3 uvTransform_1 = worldTangentV * 0.4605305 + worldTangentU * -0.19470917;
    // normalMaps.yaml:13 NormalMap
    vec3 normalMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    // normalMaps.yaml:16 Checker
    vec2 checker = fract(uv);
    bool checker_2 = (0.5 <= checker.x) != (0.5 <= checker.y);
    vec3 normalMap_2 = uvTransform - dot(uvTransform, normalMap_1) * normalMap_1;
    vec3 normalMap_3 = 1.0 / max(length(normalMap_2), 1e-30) * normalMap_2;
    vec3 normalMap_4 = cross(normalMap_1, normalMap_3);
    vec3 normalMap = mat3(normalMap_3, dot(normalMap_4, uvTransform_1) < 0.0 ? -normalMap_4 : normalMap_4, normalMap_1) * vec3((checker_2 ? vec2(0.2, -0.2) : vec2(-0.4, 0.1)) * strength, checker_2 ? 0.9591663 : 0.91104335);
    float normalMap_5 = max(dot(normalMap, normalMap_1), 0.001);
    vec3 normalMap_6 = uvTransform - dot(normalMap, uvTransform) / normalMap_5 * normalMap_1;
    vec3 normalMap_7 = uvTransform_1 - dot(normalMap, uvTransform_1) / normalMap_5 * normalMap_1;
    // normalMaps.yaml:8 NormalMap
    vec3 normalMap2_1 = 1.0 / max(length(normalMap), 1e-30) * normalMap;
    vec3 normalMap2_2 = normalMap_6 - dot(normalMap_6, normalMap2_1) * normalMap2_1;
    vec3 normalMap2_3 = 1.0 / max(length(normalMap2_2), 1e-30) * normalMap2_2;
    vec3 normalMap2_4 = cross(normalMap2_1, normalMap2_3);
    vec3 normalMap2 = mat3(normalMap2_3, dot(normalMap2_4, normalMap_7) < 0.0 ? -normalMap2_4 : normalMap2_4, normalMap2_1) * vec3(0.2, 0.1, 0.8);
    float normalMap2_5 = max(dot(normalMap2, normalMap2_1), 0.001);
    vec3 normalMap2_6 = normalMap_6 - dot(normalMap2, normalMap_6) / normalMap2_5 * normalMap2_1;
    vec3 normalMap2_7 = normalMap_7 - dot(normalMap2, normalMap_7) / normalMap2_5 * normalMap2_1;
    // normalMaps.yaml:4 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(normalMap2), 1e-30) * normalMap2;
    // normalMaps.yaml:6 Leopard
    vec3 leopard2 = leopardGradient(localPosition * 3.0).xyz;
    vec3 bumpMap_2 = cross(normalMap2_6, normalMap2_7);
    float leopard2_2 = dot(leopard2, localTangentU * 3.0);
    float leopard2_3 = dot(leopard2, localTangentV * 3.0);
    vec3 bumpMap_3 = (leopard2_3 * -0.12980612 + leopard2_2 * -0.30702034) * 0.04 * normalMap2_7 - (leopard2_3 * 0.4605305 + leopard2_2 * -0.19470917) * 0.04 * normalMap2_6;
    vec3 bumpMap_4 = cross(bumpMap_1, bumpMap_3) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_4 : bumpMap_4;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, 11842740u, 645922816u);
}
