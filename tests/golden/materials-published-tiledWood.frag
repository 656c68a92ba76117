#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 eyeNormal;
uniform mat3 matc_eyeFromWorld;
uniform sampler2D imageTexture0;
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

// The slot anisotropy, a (cos 2 t, sin 2 t), about another frame. `own` counts t from du toward dv; the result counts it from the vector T toward B, which
// the unit normal n alone makes, so that who reads n back has them: with w = 1 / (1 + n.z)
//   T = (1 - w n.x n.x, -w n.x n.y, -n.x), B = (-w n.x n.y, 1 - w n.y n.y, -n.y)
// are at right angles to n and to each other, and change with it everywhere but at (0, 0, -1), where T is (1, 0, 0). Of what du is in their plane, p, the
// angle is added twice: times p^2 / |p|^2 as complex numbers. Where dv lies to the right of it, seen against n, t counts the other way round.
// A du along n, or of no length, has no angle, and adds 0. Error 1e-6 where du is no closer to n than 0.05 and n no closer to (0, 0, -1).
//   n = (0, 0, 1), du = (0, 2, 0), dv = (-1, 0, 0), own = (.5, 0): p = (0, 1), p^2 = (-1, 0), the result (-.5, 0)
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

// A world direction in eye space; the matrix is a rotation, so that lengths and angles stay.
vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
}

// v, taken to [0, 1], as the nearest of 2^bits equal steps, bits <= 16.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// A picture by its sampler, a texel's value at its centre, where samplers have it. The footprint is that of the neighbouring pixels: not in branches.
// Below a texel a pixel the sampler's weights err by 1/256.
vec4 imageCentred(sampler2D s, vec2 uv) {
    return texture(s, uv);
}

// The square root of v, taken to [0, 1], as the nearest of 2^bits equal steps: steps of v that shrink towards 0, as an eye's do.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
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
