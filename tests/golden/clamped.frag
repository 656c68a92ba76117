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

// Component-wise sine. Error of sin().
vec3 sine3(vec3 x) {
    return sin(x);
}

// Component-wise sin(x) / x, x >= 0; 1 - x^2 / 6 near 0 avoids loss of digits. Error 3e-7.
vec3 sinc(vec3 x) {
    vec3 near = 1.0 - x * x * (1.0 / 6.0);
    vec3 far = sine3(x) / max(x, 1.0e-2);
    return mix(far, near, step(x, vec3(1.0e-2)));
}

// Mean of leopard over a box around p: (sum of sin)^2 / 9 from the means of sin and sin^2, exact
// for independent axes. Error 4.3e-7 if sin and cos err by 1e-7.
float leopardFiltered(vec3 p, vec3 edge) {
    vec3 sine = sine3(p);
    vec3 mean = sine * sinc(0.5 * edge);
    vec3 square = 0.5 - (0.5 - sine * sine) * sinc(edge);
    float sum = mean.x + mean.y + mean.z;
    return max(sum * sum + dot(square - mean * mean, vec3(1.0)), 0.0) * (1.0 / 9.0);
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
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    // clamped.yaml:7 Leopard
    float diffuse_leopard = leopardFiltered(localPosition * 9.0, max(abs(localPositionByY * 9.0), abs(localPositionByX * 9.0)));
    // clamped.yaml:4 Clamp
    float diffuse_clamped = min(max(diffuse_leopard, 0.1), 0.5);
    uint diffuse_bits = rootBits(diffuse_clamped, 8);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, diffuse_bits | diffuse_bits << 8 | diffuse_bits << 16, 645922816u);
}
