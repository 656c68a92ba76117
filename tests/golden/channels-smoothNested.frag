#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
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

vec3 smooth3DInput0(vec3 p) {
    // smoothNested.yaml:14 VolumeChecker
    vec3 diffuse_volumeChecker_1 = fract(p * 1.5);
    return ((0.5 <= diffuse_volumeChecker_1.x) != (0.5 <= diffuse_volumeChecker_1.y)) != (0.5 <= diffuse_volumeChecker_1.z) ? vec3(0.8713671, 0.7454042, 0.5271151) : vec3(0.04373503, 0.051269457, 0.14412847);
}

vec3 smooth3DInput1(vec3 p) {
    // smoothNested.yaml:10 Smooth3D
    vec3 diffuse_smooth3D_1 = smooth3DInput0(p + vec3(-0.15, -0.15, 0.15)) + (smooth3DInput0(p + vec3(-0.15, -0.15, 0.0)) + smooth3DInput0(p - vec3(0.15)));
    vec3 diffuse_smooth3D_2 = smooth3DInput0(p + vec3(-0.15, 0.0, 0.15)) + (smooth3DInput0(p + vec3(-0.15, 0.0, 0.0)) + (smooth3DInput0(p + vec3(-0.15, 0.0, -0.15)) + diffuse_smooth3D_1));
    vec3 diffuse_smooth3D_3 = smooth3DInput0(p + vec3(-0.15, 0.15, 0.15)) + (smooth3DInput0(p + vec3(-0.15, 0.15, 0.0)) + (smooth3DInput0(p + vec3(-0.15, 0.15, -0.15)) + diffuse_smooth3D_2));
    vec3 diffuse_smooth3D_4 = smooth3DInput0(p + vec3(0.0, -0.15, 0.15)) + (smooth3DInput0(p + vec3(0.0, -0.15, 0.0)) + (smooth3DInput0(p + vec3(0.0, -0.15, -0.15)) + diffuse_smooth3D_3));
    vec3 diffuse_smooth3D_5 = smooth3DInput0(p + vec3(0.0, 0.0, 0.15)) + (smooth3DInput0(p) + (smooth3DInput0(p + vec3(0.0, 0.0, -0.15)) + diffuse_smooth3D_4));
    vec3 diffuse_smooth3D_6 = smooth3DInput0(p + vec3(0.0, 0.15, 0.15)) + (smooth3DInput0(p + vec3(0.0, 0.15, 0.0)) + (smooth3DInput0(p + vec3(0.0, 0.15, -0.15)) + diffuse_smooth3D_5));
    vec3 diffuse_smooth3D_7 = smooth3DInput0(p + vec3(0.15, -0.15, 0.15)) + (smooth3DInput0(p + vec3(0.15, -0.15, 0.0)) + (smooth3DInput0(p + vec3(0.15, -0.15, -0.15)) + diffuse_smooth3D_6));
    vec3 diffuse_smooth3D_8 = smooth3DInput0(p + vec3(0.15, 0.0, 0.15)) + (smooth3DInput0(p + vec3(0.15, 0.0, 0.0)) + (smooth3DInput0(p + vec3(0.15, 0.0, -0.15)) + diffuse_smooth3D_7));
    vec3 diffuse_smooth3D_9 = smooth3DInput0(p + vec3(0.15)) + (smooth3DInput0(p + vec3(0.15, 0.15, 0.0)) + (smooth3DInput0(p + vec3(0.15, 0.15, -0.15)) + diffuse_smooth3D_8));
    return diffuse_smooth3D_9 * 0.037037037;
}

vec3 smooth3DInput1Sum(vec3 p, vec3 size) {
    vec3 sum = vec3(0.0);
    for (float i = -0.5; i < 1.0; i += 0.5)
        for (float j = -0.5; j < 1.0; j += 0.5)
            for (float k = -0.5; k < 1.0; k += 0.5)
                sum += smooth3DInput1(p + vec3(i, j, k) * size);
    return sum;
}

void main() {
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    // smoothNested.yaml:5 Smooth3D
    vec3 diffuse_smooth3D = smooth3DInput1Sum(localPosition, vec3(0.1)) * 0.037037037;
    uint surface_bits = rootBits(diffuse_smooth3D.x, 8) | rootBits(diffuse_smooth3D.y, 8) << 8 | rootBits(diffuse_smooth3D.z, 8) << 16;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits, 645922816u);
}
