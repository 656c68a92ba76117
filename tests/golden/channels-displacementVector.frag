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

// Gradient (xyz) and value (w) of leopard. Error 4.3e-7 if sin and cos err by 1e-7.
vec4 leopardGradient(vec3 p) {
    float mean = dot(sin(p), vec3(1.0 / 3.0));
    return vec4(cos(p) * (mean * (2.0 / 3.0)), mean * mean);
}

// sin(x / 2) / (x / 2), x >= 0: attenuation of a sine by a box of edge x. Error 2e-7.
float sincMean(float x) {
    float h = 0.5 * x;
    return h < 1.0e-2 ? 1.0 - h * h * (1.0 / 6.0) : sin(h) / max(h, 1.0e-2);
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
    vec3 localPositionByX = dFdx(localPosition);
    vec3 localPositionByY = dFdy(localPosition);
    vec3 worldNormalByX = dFdx(worldNormal);
    vec3 worldNormalByY = dFdy(worldNormal);
    vec3 worldTangentUByX = dFdx(worldTangentU);
    vec3 worldTangentUByY = dFdy(worldTangentU);
    vec3 worldTangentVByX = dFdx(worldTangentV);
    vec3 worldTangentVByY = dFdy(worldTangentV);
    // displacementVector.yaml:7 Gradient
    float gradient_1 = dot(localPosition, vec3(2.0, 1.0, 0.0));
    float gradient_2 = dot(localPositionByX, vec3(2.0, 1.0, 0.0));
    float gradient_3 = dot(localPositionByY, vec3(2.0, 1.0, 0.0));
    float gradient_4 = cos(gradient_1);
    // displacementVector.yaml:8 Leopard
    vec4 leopard2 = leopardGradient(localPosition * 3.0);
    float normal_1 = uvByY.y * uvByX.x - uvByY.x * uvByX.y;
    bool normal_2 = abs(normal_1) < 1e-30;
    float normal_3 = normal_2 ? 0.0 : 1.0 / (normal_2 ? 1.0 : normal_1);
    vec3 normal_4 = (uvByY.y * worldNormalByX - uvByX.y * worldNormalByY) * normal_3;
    float normal_5 = 1.0 / max(length(worldNormal), 1e-30);
    vec3 normal_6 = normal_5 * worldNormal;
    vec3 normal_7 = (normal_4 - dot(normal_6, normal_4) * normal_6) * normal_5;
    vec3 normal_8 = (uvByX.x * worldNormalByY - uvByY.x * worldNormalByX) * normal_3;
    vec3 normal_9 = (normal_8 - dot(normal_6, normal_8) * normal_6) * normal_5;
    vec3 normal_10 = (worldTangentUByX * uvByY.y - worldTangentUByY * uvByX.y) * normal_3;
    float normal_11 = 1.0 / max(length(worldTangentU), 1e-30);
    vec3 normal_12 = normal_11 * worldTangentU;
    vec3 normal_13 = (normal_10 - dot(normal_12, normal_10) * normal_12) * normal_11;
    vec3 normal_14 = (worldTangentUByY * uvByX.x - worldTangentUByX * uvByY.x) * normal_3;
    vec3 normal_15 = (normal_14 - dot(normal_12, normal_14) * normal_12) * normal_11;
    vec3 normal_16 = (worldTangentVByX * uvByY.y - worldTangentVByY * uvByX.y) * normal_3;
    float normal_17 = 1.0 / max(length(worldTangentV), 1e-30);
    vec3 normal_18 = normal_17 * worldTangentV;
    vec3 normal_19 = (normal_16 - dot(normal_18, normal_16) * normal_18) * normal_17;
    vec3 normal_20 = (worldTangentVByY * uvByX.x - worldTangentVByX * uvByY.x) * normal_3;
    vec3 normal_21 = (normal_20 - dot(normal_18, normal_20) * normal_18) * normal_17;
    float gradient_5 = sincMean(sqrt(gradient_3 * gradient_3 + gradient_2 * gradient_2));
    float gradient = gradient_5 * sin(gradient_1);
    // displacementVector.yaml:5 Blend
    vec3 blend = mix(vec3(-0.4, 0.1, -0.2), vec3(0.4, -0.1, 0.3), clamp((gradient + 1.0) * 0.5, 0.0, 1.0));
    vec3 normal_22 = (vec3(0.0, 0.0, leopard2.w) + blend) * 0.25;
    vec3 normal_23 = gradient_5 * (gradient_4 * dot(localTangentU, vec3(2.0, 1.0, 0.0))) * vec3(0.4, -0.1, 0.25) + vec3(0.0, 0.0, dot(leopard2.xyz, localTangentU * 3.0));
    vec3 normal_24 = normal_23 * 0.25;
    vec3 normal_25 = dot(localTangentV, vec3(2.0, 1.0, 0.0)) * gradient_4 * gradient_5 * vec3(0.4, -0.1, 0.25) + vec3(0.0, 0.0, dot(leopard2.xyz, localTangentV * 3.0));
    vec3 normal_26 = normal_25 * 0.25;
    vec3 normal_27 = normal_24.x * normal_12 + (normal_22.z * normal_7 + worldTangentU) + normal_24.y * normal_18 + normal_22.x * (normal_13 - dot(normal_6, normal_13) * normal_6);
    vec3 normal_28 = normal_27 + normal_22.y * (normal_19 - dot(normal_6, normal_19) * normal_6);
    vec3 normal_29 = normal_26.x * normal_12 + (normal_22.z * normal_9 + worldTangentV) + normal_26.y * normal_18 + normal_22.x * (normal_15 - dot(normal_6, normal_15) * normal_6);
    vec3 normal_30 = normal_29 + normal_22.y * (normal_21 - dot(normal_6, normal_21) * normal_6);
    vec3 normal_31 = normal_30 * (normal_24.z - normal_22.x * dot(normal_7, normal_12) - normal_22.y * dot(normal_7, normal_18));
    vec3 normal_32 = normal_28 * (normal_26.z - normal_22.x * dot(normal_9, normal_12) - normal_22.y * dot(normal_9, normal_18));
    vec3 normal_33 = cross(normal_6, normal_31 - normal_32) + cross(normal_28, normal_30);
    vec3 normal_34 = safeNormalize(eyeFromWorld(dot(cross(worldTangentU, worldTangentV), normal_6) < 0.0 ? -normal_33 : normal_33));
    vec3 normal = normal_34 * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, 11837810u, 645922816u);
}
