#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
uniform float swell;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

// v / |v| for every finite v; (0, 0, 1) where no component reaches 1e-37. v is divided by its greatest component first, so that
// no square over- or underflows, and a great one is scaled down before, so that its reciprocal does not. Relative error 2e-7.
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

// Unit normal to the plane of an octahedron in [-1, 1]^2: n / (|x| + |y| + |z|), its lower half folded outward. (0, 0, 0) gives
// (0, 0), which is +z. No sign(): it is 0 at 0, where the fold wants 1. Error 2e-7.
vec2 encodeOctahedral(vec3 n) {
    vec2 p = n.xy / max(abs(n.x) + abs(n.y) + abs(n.z), 1.0e-30);
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    return n.z < 0.0 ? (1.0 - abs(p.yx)) * side : p;
}

// Unit normal to two whole numbers in [-s, s], s = 2^(bits-1) - 1, by the nearest point of the octahedron. The axes have codes
// of their own. A half float holds them exactly for bits <= 12. The power is exact: exp2 errs by less than 1/2 for bits <= 16.
vec2 octahedralWhole(vec3 n, int bits) {
    float scale = floor(exp2(float(bits - 1)) + 0.5) - 1.0;
    return floor(encodeOctahedral(n) * scale + 0.5);
}

// The two whole numbers of octahedralWhole, moved up to begin at 0, in 2 bits bits: x in the lower ones.
uint octahedralBits(vec3 n, int bits) {
    float scale = float((1 << (bits - 1)) - 1);
    uvec2 code = uvec2(octahedralWhole(n, bits) + scale);
    return code.x | code.y << bits;
}

float smooth3DInput1(vec2 st) {
    // displacementBound.yaml:9 Checker
    vec2 checker_1 = fract(st * vec2(3.0, 2.0));
    float checker = (0.5 <= checker_1.x) != (0.5 <= checker_1.y) ? 1.0 : 0.0;
    return checker;
}

float smooth3DInput2(vec2 st) {
    // displacementBound.yaml:9 Checker
    vec2 checker_1 = fract(st * vec2(3.0, 2.0));
    vec2 checker_2 = fract(checker_1 + vec2(0.05, 0.0));
    float checker = (0.5 <= checker_1.x) != (0.5 <= checker_1.y) ? 1.0 : 0.0;
    float checker_3 = (((0.5 <= checker_2.x) != (0.5 <= checker_2.y) ? 1.0 : 0.0) - checker) * 20.0 * 3.0;
    return checker_3;
}

float smooth3DInput3(vec2 st) {
    // displacementBound.yaml:9 Checker
    vec2 checker_1 = fract(st * vec2(3.0, 2.0));
    float checker = (0.5 <= checker_1.x) != (0.5 <= checker_1.y) ? 1.0 : 0.0;
    vec2 checker_2 = fract(checker_1 + vec2(0.0, 0.05));
    float checker_3 = (((0.5 <= checker_2.x) != (0.5 <= checker_2.y) ? 1.0 : 0.0) - checker) * 20.0 * 2.0;
    return checker_3;
}

void main() {
    vec3 normal_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 normal_2 = cross(worldTangentU, worldTangentV);
    // displacementBound.yaml:9 Smooth3D
    vec2 smooth3D_1 = uv - vec2(0.1);
    vec2 smooth3D_2 = uv + vec2(-0.1, 0.0);
    vec2 smooth3D_3 = uv + vec2(-0.1, 0.1);
    vec2 smooth3D_4 = uv + vec2(0.0, -0.1);
    vec2 smooth3D_5 = uv + vec2(0.0, 0.1);
    vec2 smooth3D_6 = uv + vec2(0.1, -0.1);
    vec2 smooth3D_7 = uv + vec2(0.1, 0.0);
    vec2 smooth3D_8 = uv + vec2(0.1);
    float smooth3D_9 = smooth3DInput1(smooth3D_1);
    float smooth3D_10 = smooth3DInput1(smooth3D_2);
    float smooth3D_11 = smooth3DInput1(smooth3D_3);
    float smooth3D_12 = smooth3D_11 + (smooth3D_10 + (smooth3D_9 + smooth3D_9 + smooth3D_9) + smooth3D_10 + smooth3D_10) + smooth3D_11;
    float smooth3D_13 = smooth3DInput1(smooth3D_4);
    float smooth3D_14 = smooth3DInput1(uv);
    float smooth3D_15 = smooth3D_14 + (smooth3D_13 + (smooth3D_12 + smooth3D_11) + smooth3D_13 + smooth3D_13) + smooth3D_14 + smooth3D_14;
    float smooth3D_16 = smooth3DInput1(smooth3D_5);
    float smooth3D_17 = smooth3DInput1(smooth3D_6);
    float smooth3D_18 = smooth3DInput1(smooth3D_7);
    float smooth3D_19 = smooth3D_18 + (smooth3D_17 + (smooth3D_16 + smooth3D_15 + smooth3D_16 + smooth3D_16) + smooth3D_17 + smooth3D_17);
    float smooth3D_20 = smooth3DInput1(smooth3D_8);
    float smooth3D = (smooth3D_20 + (smooth3D_19 + smooth3D_18 + smooth3D_18) + smooth3D_20 + smooth3D_20) * 0.037037037;
    float normal_3 = smooth3D * swell;
    float smooth3D_21 = smooth3DInput2(smooth3D_1);
    float smooth3D_22 = smooth3DInput2(smooth3D_2);
    float smooth3D_23 = smooth3DInput2(smooth3D_3);
    float smooth3D_24 = smooth3D_23 + (smooth3D_22 + (smooth3D_21 + smooth3D_21 + smooth3D_21) + smooth3D_22 + smooth3D_22) + smooth3D_23;
    float smooth3D_25 = smooth3DInput2(smooth3D_4);
    float smooth3D_26 = smooth3DInput2(uv);
    float smooth3D_27 = smooth3D_26 + (smooth3D_25 + (smooth3D_24 + smooth3D_23) + smooth3D_25 + smooth3D_25) + smooth3D_26 + smooth3D_26;
    float smooth3D_28 = smooth3DInput2(smooth3D_5);
    float smooth3D_29 = smooth3DInput2(smooth3D_6);
    float smooth3D_30 = smooth3DInput2(smooth3D_7);
    float smooth3D_31 = smooth3D_30 + (smooth3D_29 + (smooth3D_28 + smooth3D_27 + smooth3D_28 + smooth3D_28) + smooth3D_29 + smooth3D_29);
    float smooth3D_32 = smooth3DInput2(smooth3D_8);
    float normal_4 = (smooth3D_32 + (smooth3D_31 + smooth3D_30 + smooth3D_30) + smooth3D_32 + smooth3D_32) * 0.037037037 * swell;
    float normal_5 = step(-0.25, normal_3);
    float normal_6 = step(normal_3, 0.25);
    float smooth3D_33 = smooth3DInput3(smooth3D_1);
    float smooth3D_34 = smooth3DInput3(smooth3D_2);
    float smooth3D_35 = smooth3DInput3(smooth3D_3);
    float smooth3D_36 = smooth3D_35 + (smooth3D_34 + (smooth3D_33 + smooth3D_33 + smooth3D_33) + smooth3D_34 + smooth3D_34) + smooth3D_35;
    float smooth3D_37 = smooth3DInput3(smooth3D_4);
    float smooth3D_38 = smooth3DInput3(uv);
    float smooth3D_39 = smooth3D_38 + (smooth3D_37 + (smooth3D_36 + smooth3D_35) + smooth3D_37 + smooth3D_37) + smooth3D_38 + smooth3D_38;
    float smooth3D_40 = smooth3DInput3(smooth3D_5);
    float smooth3D_41 = smooth3DInput3(smooth3D_6);
    float smooth3D_42 = smooth3DInput3(smooth3D_7);
    float smooth3D_43 = smooth3D_42 + (smooth3D_41 + (smooth3D_40 + smooth3D_39 + smooth3D_40 + smooth3D_40) + smooth3D_41 + smooth3D_41);
    float smooth3D_44 = smooth3DInput3(smooth3D_8);
    float normal_7 = (smooth3D_44 + (smooth3D_43 + smooth3D_42 + smooth3D_42) + smooth3D_44 + smooth3D_44) * 0.037037037 * swell;
    vec3 normal_8 = normal_6 * normal_4 * normal_5 * worldTangentV - normal_7 * normal_6 * normal_5 * worldTangentU;
    vec3 normal_9 = cross(normal_1, normal_8) + normal_2;
    vec3 normal = safeNormalize(eyeFromWorld(dot(normal_2, normal_1) < 0.0 ? -normal_9 : normal_9)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, 11842740u, 645922816u);
}
