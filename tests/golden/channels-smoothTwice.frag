#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
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

float smooth3DInput0(vec3 p) {
    // smoothTwice.yaml:8 Leopard
    return leopard(p * 3.0);
}

void main() {
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    // smoothTwice.yaml:4 Smooth3D
    float diffuse_smooth3D_1 = smooth3DInput0(localPosition + vec3(-0.05, -0.05, 0.05)) + (smooth3DInput0(localPosition + vec3(-0.05, -0.05, 0.0)) + smooth3DInput0(localPosition - vec3(0.05)));
    float diffuse_smooth3D_2 = smooth3DInput0(localPosition + vec3(-0.05, 0.0, 0.05)) + (smooth3DInput0(localPosition + vec3(-0.05, 0.0, 0.0)) + (smooth3DInput0(localPosition + vec3(-0.05, 0.0, -0.05)) + diffuse_smooth3D_1));
    float diffuse_smooth3D_3 = smooth3DInput0(localPosition + vec3(-0.05, 0.05, 0.05)) + (smooth3DInput0(localPosition + vec3(-0.05, 0.05, 0.0)) + (smooth3DInput0(localPosition + vec3(-0.05, 0.05, -0.05)) + diffuse_smooth3D_2));
    float diffuse_smooth3D_4 = smooth3DInput0(localPosition + vec3(0.0, -0.05, 0.05)) + (smooth3DInput0(localPosition + vec3(0.0, -0.05, 0.0)) + (smooth3DInput0(localPosition + vec3(0.0, -0.05, -0.05)) + diffuse_smooth3D_3));
    float diffuse_smooth3D_5 = smooth3DInput0(localPosition);
    float diffuse_smooth3D_6 = smooth3DInput0(localPosition + vec3(0.0, 0.0, 0.05)) + (diffuse_smooth3D_5 + (smooth3DInput0(localPosition + vec3(0.0, 0.0, -0.05)) + diffuse_smooth3D_4));
    float diffuse_smooth3D_7 = smooth3DInput0(localPosition + vec3(0.0, 0.05, 0.05)) + (smooth3DInput0(localPosition + vec3(0.0, 0.05, 0.0)) + (smooth3DInput0(localPosition + vec3(0.0, 0.05, -0.05)) + diffuse_smooth3D_6));
    float diffuse_smooth3D_8 = smooth3DInput0(localPosition + vec3(0.05, -0.05, 0.05)) + (smooth3DInput0(localPosition + vec3(0.05, -0.05, 0.0)) + (smooth3DInput0(localPosition + vec3(0.05, -0.05, -0.05)) + diffuse_smooth3D_7));
    float diffuse_smooth3D_9 = smooth3DInput0(localPosition + vec3(0.05, 0.0, 0.05)) + (smooth3DInput0(localPosition + vec3(0.05, 0.0, 0.0)) + (smooth3DInput0(localPosition + vec3(0.05, 0.0, -0.05)) + diffuse_smooth3D_8));
    float diffuse_smooth3D_10 = smooth3DInput0(localPosition + vec3(0.05)) + (smooth3DInput0(localPosition + vec3(0.05, 0.05, 0.0)) + (smooth3DInput0(localPosition + vec3(0.05, 0.05, -0.05)) + diffuse_smooth3D_9));
    uint diffuse_bits = rootBits(diffuse_smooth3D_10 * 0.037037037, 8);
    // smoothTwice.yaml:10 Laplace3D
    float specular_laplace3D_1 = diffuse_smooth3D_5 - smooth3DInput0(localPosition + vec3(0.1, 0.0, 0.0)) + (diffuse_smooth3D_5 - smooth3DInput0(localPosition + vec3(-0.1, 0.0, 0.0)));
    float specular_laplace3D_2 = diffuse_smooth3D_5 - smooth3DInput0(localPosition + vec3(0.0, 0.1, 0.0)) + (diffuse_smooth3D_5 - smooth3DInput0(localPosition + vec3(0.0, -0.1, 0.0)) + specular_laplace3D_1);
    float specular_laplace3D_3 = diffuse_smooth3D_5 - smooth3DInput0(localPosition + vec3(0.0, 0.0, 0.1)) + (diffuse_smooth3D_5 - smooth3DInput0(localPosition + vec3(0.0, 0.0, -0.1)) + specular_laplace3D_2);
    uint specular_bits = rootBits(specular_laplace3D_3 * 0.083333336, 8);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, diffuse_bits | diffuse_bits << 8 | diffuse_bits << 16 | specular_bits << 24, specular_bits | specular_bits << 8 | 645922816u);
}
