#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 localPosition;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

// ((sin x + sin y + sin z) / 3)^2, in [0, 1]. Error of sin(): 3e-7 on llvmpipe up to 1e6; GLSL has
// no bound.
float leopard(vec3 p) {
    float mean = dot(sin(p), vec3(1.0 / 3.0));
    return mean * mean;
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
    // published.yaml:54 Checker
    vec2 checker = fract(uv * vec2(8.0, 4.0));
    // published.yaml:56 NormalMap
    vec3 normalMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    // published.yaml:56 Leopard
    float leopard2 = leopard(localPosition * 9.0) * 0.5 + 0.25;
    vec3 normalMap_2 = worldTangentU - dot(worldTangentU, normalMap_1) * normalMap_1;
    vec3 normalMap_3 = 1.0 / max(length(normalMap_2), 1e-30) * normalMap_2;
    vec3 normalMap_4 = cross(normalMap_1, normalMap_3);
    vec3 normalMap = mat3(normalMap_3, dot(normalMap_4, worldTangentV) < 0.0 ? -normalMap_4 : normalMap_4, normalMap_1) * vec3((vec2(leopard2, 0.5) * 2.0 - vec2(1.0)) * 0.4, 1.0);
    vec3 normal = safeNormalize(eyeFromWorld(normalMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 6, 4227858432u, (0.5 <= checker.x) != (0.5 <= checker.y) ? 431868630u : 429367979u, 3221225190u);
}
