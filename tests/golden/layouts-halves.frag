#version 330 core
// matc 0.1.0: pass gbuffer, layout halves

in vec3 eyeNormal;
layout(location = 0) out vec4 fragment0;
layout(location = 1) out vec4 fragment1;

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

// Octahedral encoding of a unit normal in [-1, 1]^2: n / (|x| + |y| + |z|), the lower half folded
// outward. (0, 0, 0) encodes as +z. sign() would be 0 at 0, where the fold needs 1. Error 2e-7.
vec2 encodeOctahedral(vec3 n) {
    vec2 p = n.xy / max(abs(n.x) + abs(n.y) + abs(n.z), 1.0e-30);
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    return n.z < 0.0 ? (1.0 - abs(p.yx)) * side : p;
}

// Maps an integer in [0, 61439] to a normal half float: 30720 from 2^-14 to 65504, then their
// negatives. Exact: multiplies by powers of two, without exp2.
float halfFromCode(float code) {
    float c = code < 30720.0 ? code : code - 30720.0;
    float exponent = floor(c * (1.0 / 1024.0));
    float value = (1024.0 + c - 1024.0 * exponent) * (1.0 / 16777216.0);
    if (exponent >= 16.0) { value *= 65536.0; exponent -= 16.0; }
    if (exponent >= 8.0) { value *= 256.0; exponent -= 8.0; }
    if (exponent >= 4.0) { value *= 16.0; exponent -= 4.0; }
    if (exponent >= 2.0) { value *= 4.0; exponent -= 2.0; }
    if (exponent >= 1.0) { value *= 2.0; }
    return code < 30720.0 ? value : -value;
}

// Packs a unit normal into a number that is exact in a half float: a 247 x 247 octahedral grid by
// mixed radix. The axes are exact.
float octahedralRadix(vec3 n) {
    vec2 q = floor(encodeOctahedral(n) * 123.0 + 0.5) + 123.0;
    return halfFromCode(q.x + 247.0 * q.y);
}

void main() {
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(octahedralRadix(normal), 11.470956, -6.28829e-05, 0.0044937134);
    fragment1 = vec4(0.004119873, 0.0, 0.0, 0.0);
}
