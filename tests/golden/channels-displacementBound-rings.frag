#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 localPosition;
in vec3 localTangentU;
in vec3 localTangentV;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

// Gradient (xyz; 0 on the axis) and value (w) of wood. Error 3e-7, relative for the value.
vec4 woodGradient(vec3 p) {
    vec2 a = clamp(p.xy, -1.0e37, 1.0e37);
    float greater = max(max(abs(a.x), abs(a.y)), 1.0e-37);
    vec2 unit = a / greater;
    float size = length(unit);
    return vec4(unit / max(size, 1.0), 0.0, greater * size);
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
    vec2 uvByX = dFdx(uv);
    vec2 uvByY = dFdy(uv);
    vec3 worldNormalByX = dFdx(worldNormal);
    vec3 worldNormalByY = dFdy(worldNormal);
    // displacementBound.yaml:5 Wood
    vec4 wood2 = woodGradient(localPosition * 0.3);
    float normal_1 = uvByY.y * uvByX.x - uvByY.x * uvByX.y;
    bool normal_2 = abs(normal_1) < 1e-30;
    float normal_3 = normal_2 ? 0.0 : 1.0 / (normal_2 ? 1.0 : normal_1);
    vec3 normal_4 = (uvByY.y * worldNormalByX - uvByX.y * worldNormalByY) * normal_3;
    float normal_5 = 1.0 / max(length(worldNormal), 1e-30);
    vec3 normal_6 = normal_5 * worldNormal;
    vec3 normal_7 = (uvByX.x * worldNormalByY - uvByY.x * worldNormalByX) * normal_3;
    float normal_8 = clamp(wood2.w, -0.4, 0.4);
    float normal_9 = step(-0.4, wood2.w);
    float normal_10 = step(wood2.w, 0.4);
    vec3 normal_11 = normal_8 * ((normal_4 - dot(normal_6, normal_4) * normal_6) * normal_5) + worldTangentU;
    vec3 normal_12 = normal_8 * ((normal_7 - dot(normal_6, normal_7) * normal_6) * normal_5) + worldTangentV;
    vec3 normal_13 = dot(wood2.xyz, localTangentU * 0.3) * normal_10 * normal_9 * normal_12 - dot(wood2.xyz, localTangentV * 0.3) * normal_10 * normal_9 * normal_11;
    vec3 normal_14 = cross(normal_6, normal_13) + cross(normal_11, normal_12);
    vec3 normal_15 = safeNormalize(eyeFromWorld(dot(cross(worldTangentU, worldTangentV), normal_6) < 0.0 ? -normal_14 : normal_14));
    vec3 normal = normal_15 * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, 11842740u, 645922816u);
}
