#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 eyeNormal;
uniform mat3 matc_eyeFromWorld;
uniform sampler2D imageTexture0;
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

// Rotates the slot anisotropy, a (cos 2t, sin 2t), into the frame that the unit normal n alone
// defines, so a reader needs only n. `own` measures t from du toward dv; the result measures t from
// T toward B. With w = 1 / (1 + n.z)
//   T = (1 - w n.x n.x, -w n.x n.y, -n.x)
//   B = (-w n.x n.y, 1 - w n.y n.y, -n.y)
// are orthonormal to n and continuous except at (0, 0, -1), where T is (1, 0, 0). With p = (du.T,
// du.B) the double angle is added by the complex product with p^2 / |p|^2. A left-handed (du, dv)
// about n reverses t. A zero du, or one parallel to n, adds angle 0. Error 1e-6 while du is at
// least 0.05 from n, and n from (0, 0, -1).
//   n = (0, 0, 1), du = (0, 2, 0), dv = (-1, 0, 0), own = (.5, 0):
//   p = (0, 1), p^2 = (-1, 0), result (-.5, 0)
vec2 anisotropyStored(vec2 own, vec3 n, vec3 du, vec3 dv) {
    vec3 u = du * inversesqrt(max(dot(du, du), 1.0e-30)), v = dv * inversesqrt(max(dot(dv, dv), 1.0e-30));
    float across = dot(n.xy, n.xy);
    float below = n.z < 0.0 ? across / (1.0 - n.z) : 1.0 + n.z; // 1 + n.z
    vec2 p = u.xy - n.xy * (dot(n.xy, u.xy) / max(below, 1.0e-12) + u.z);
    float size = dot(p, p);
    vec2 turn = size < 1.0e-8 ? vec2(1.0, 0.0) : vec2(p.x * p.x - p.y * p.y, 2.0 * p.x * p.y) / max(size, 1.0e-8);
    vec2 a = dot(cross(u, v), n) < 0.0 ? vec2(own.x, -own.y) : own;
    return vec2(a.x * turn.x - a.y * turn.y, a.x * turn.y + a.y * turn.x);
}

// Transforms a direction from world to eye space. The matrix is a rotation: lengths and angles are
// kept.
vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
}

// Quantizes v, clamped to [0, 1], to `bits` <= 16 bits, rounding to nearest.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// Samples an image, texel values at texel centers. Uses implicit derivatives: not in branches.
// Under magnification the sampler's weights err by 1/256.
vec4 imageCentred(sampler2D s, vec2 uv) {
    return texture(s, uv);
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
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    vec2 anisotropy = anisotropyStored(vec2(0.45, 0.0), normal, eyeFromWorld(worldTangentU), eyeFromWorld(worldTangentV));
    uint surface_bits = unormBits((anisotropy.x + 1.0) * 0.5, 7) << 13 | unormBits((anisotropy.y + 1.0) * 0.5, 7) << 20;
    // published.yaml:37 ImageMap
    vec4 image = imageCentred(imageTexture0, uv * vec2(4.0));
    // published.yaml:33 Expression
    vec3 expression = max(clamp(image.xyz, 0.0, 1.0), 1e-37);
    uint surface_bits2 = unormBits(image.x * 1.0431488, 8) | rootBits(expression.x, 8) << 8 | rootBits(expression.y, 8) << 16;
    fragment0 = uvec4(4294861672u, octahedralBits(normal, 12) << 6 | 6u, surface_bits2 | rootBits(expression.z, 8) << 24, surface_bits | 2147484672u);
}
