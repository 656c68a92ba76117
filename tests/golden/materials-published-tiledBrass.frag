#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec2 uv;
in vec3 eyeNormal;
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

// A picture by its sampler, a texel's value at its centre, where samplers have it. The footprint is that of the neighbouring pixels: not in branches.
// Below a texel a pixel the sampler's weights err by 1/256.
vec4 imageCentred(sampler2D s, vec2 uv) {
    return texture(s, uv);
}

// v, taken to [0, 1], as the nearest of 2^bits equal steps, bits <= 16.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
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
    // published.yaml:45 rough
    vec4 rough = imageCentred(imageTexture0, uv);
    uint surface_bits = unormBits(rough.x, 6) << 6 | rootBits(rough.x, 5) << 17 | rootBits(rough.y, 5) << 22;
    fragment0 = uvec4(surface_bits | rootBits(rough.z, 5) << 27 | 24588u, unormBits(rough.x, 8) << 24 | 16515072u, octahedralBits(normal, 12) | 3825205248u, 2256528612u);
}
