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

// Mandelbrot set: c = 4 fract(p.xy) - 2, z starts at c. Returns the fraction of `iterations` steps
// z^2 + c with |z| <= 2, scaled to [-1, 1]. Rounding may change the count near the set's border.
float mandel(vec3 p, int iterations) {
    vec2 c = 4.0 * fract(p.xy) - 2.0;
    vec2 z = c;
    int steps = 0;
    for (int k = 0; k < iterations; k++) {
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
        if (dot(z, z) > 4.0) break;
        steps++;
    }
    return 2.0 * float(steps) / max(float(iterations), 1.0) - 1.0;
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
    // displacementSwitch.yaml:6 XYZTransform
    vec3 rise_xyzTransform = localPosition * 1.5;
    // displacementSwitch.yaml:6 rise
    float rise = mandel(rise_xyzTransform, 10);
    vec3 rise_1 = fract(rise_xyzTransform);
    float normal_1 = uvByY.y * uvByX.x - uvByY.x * uvByX.y;
    bool normal_2 = abs(normal_1) < 1e-30;
    float normal_3 = normal_2 ? 0.0 : 1.0 / (normal_2 ? 1.0 : normal_1);
    vec3 normal_4 = (uvByY.y * worldNormalByX - uvByX.y * worldNormalByY) * normal_3;
    float normal_5 = 1.0 / max(length(worldNormal), 1e-30);
    vec3 normal_6 = normal_5 * worldNormal;
    vec3 normal_7 = (uvByX.x * worldNormalByY - uvByY.x * worldNormalByX) * normal_3;
    float rise_2 = (mandel(rise_1 + vec3(0.005, 0.0, 0.0), 10) - rise) * 200.0;
    float rise_3 = (mandel(rise_1 + vec3(0.0, 0.005, 0.0), 10) - rise) * 200.0;
    vec3 rise_xyzTransform_1 = localTangentU * 1.5;
    vec3 rise_xyzTransform_2 = localTangentV * 1.5;
    float normal_8 = rise * 0.05;
    vec3 normal_9 = normal_8 * ((normal_4 - dot(normal_6, normal_4) * normal_6) * normal_5) + worldTangentU;
    vec3 normal_10 = normal_8 * ((normal_7 - dot(normal_6, normal_7) * normal_6) * normal_5) + worldTangentV;
    vec3 normal_11 = normal_10 * ((rise_xyzTransform_1.y * rise_3 + rise_xyzTransform_1.x * rise_2) * 0.05) - normal_9 * ((rise_xyzTransform_2.y * rise_3 + rise_xyzTransform_2.x * rise_2) * 0.05);
    vec3 normal_12 = cross(normal_6, normal_11) + cross(normal_9, normal_10);
    vec3 normal_13 = safeNormalize(eyeFromWorld(dot(cross(worldTangentU, worldTangentV), normal_6) < 0.0 ? -normal_12 : normal_12));
    vec3 normal = normal_13 * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, gl_FrontFacing ? 5344484u : 14971473u, 645922816u);
}
