#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
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

// sin(x / 2) / (x / 2), x >= 0: attenuation of a sine by a box of edge x. Error 2e-7.
float sincMean(float x) {
    float h = 0.5 * x;
    return h < 1.0e-2 ? 1.0 - h * h * (1.0 / 6.0) : sin(h) / max(h, 1.0e-2);
}

// Quantizes v, clamped to [0, 1], to `bits` <= 16 bits, rounding to nearest.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// Quantizes sqrt(v), v clamped to [0, 1], to `bits` bits: finer steps near 0, like perceived
// lightness.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
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
    vec3 localPositionByX = dFdx(localPosition);
    vec3 localPositionByY = dFdy(localPosition);
    // Cos.yaml:14 XYZTransform
    vec3 diffuse_xyzTransform = mat3(vec3(0.9800666, 0.0, -0.19866933), vec3(0.18516758, 0.36235777, 0.9134604), vec3(0.07198937, -0.9320391, 0.35513473)) * localPosition + vec3(0.0, 0.2, 0.0);
    // Cos.yaml:11 Wood
    vec4 diffuse_wood_1 = woodGradient(diffuse_xyzTransform);
    float diffuse_wood_2 = dot(diffuse_wood_1.xyz, mat3(vec3(0.9800666, 0.0, -0.19866933), vec3(0.18516758, 0.36235777, 0.9134604), vec3(0.07198937, -0.9320391, 0.35513473)) * localPositionByX) * 18.0;
    float diffuse_wood_3 = dot(diffuse_wood_1.xyz, mat3(vec3(0.9800666, 0.0, -0.19866933), vec3(0.18516758, 0.36235777, 0.9134604), vec3(0.07198937, -0.9320391, 0.35513473)) * localPositionByY) * 18.0;
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    float diffuse_wood = cos(diffuse_wood_1.w * 18.0) * sincMean(sqrt(diffuse_wood_3 * diffuse_wood_3 + diffuse_wood_2 * diffuse_wood_2));
    // Cos.yaml:5 Blend
    vec3 diffuse_blend = mix(mix(vec3(0.023153367, 0.011612245, 0.004024717), vec3(0.462077, 0.14412847, 0.027320892), clamp(diffuse_wood + 1.0, 0.0, 1.0)), vec3(0.9559733, 0.76815116, 0.45641103), clamp(diffuse_wood, 0.0, 1.0));
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits, 645922816u);
}
