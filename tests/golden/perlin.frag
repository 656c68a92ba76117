#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
layout(location = 0) out uvec4 fragment0;

// Low four bits of Jenkins' hash of `count` (2 or 3) integers, |cell| <= 2^24: lookup3's final mix,
// seeded with 0xDEADBEEF + 4 count + 13 as in OSL and MaterialX. For count 2, cell.z is 0. Exact.
uint perlinHashTurned(uint bits, int by) {
    return (bits << by) | (bits >> (32 - by));
}

float perlinHash(vec3 cell, int count) {
    uvec3 h = uvec3(ivec3(cell)) + (0xDEADBEEFu + 13u + 4u * uint(count));
    h.z = (h.z ^ h.y) - perlinHashTurned(h.y, 14);
    h.x = (h.x ^ h.z) - perlinHashTurned(h.z, 11);
    h.y = (h.y ^ h.x) - perlinHashTurned(h.x, 25);
    h.z = (h.z ^ h.y) - perlinHashTurned(h.y, 16);
    h.x = (h.x ^ h.z) - perlinHashTurned(h.z, 4);
    h.y = (h.y ^ h.x) - perlinHashTurned(h.x, 14);
    h.z = (h.z ^ h.y) - perlinHashTurned(h.y, 24);
    return float(h.z & 15u);
}

// Gradient of Perlin noise at a corner, times 0.9820 (3D) or 0.6616 (2D) so that the noise is in
// about [-1, 1]: the middle of one of a cube's 12 edges (four count twice), in 2D (+-1, +-2) or
// (+-2, +-1). Exact but for the factor's rounding.
vec3 perlinDirection(vec3 corner, int dimensions) {
    float h = perlinHash(corner, dimensions);
    float pairs = floor(h * 0.5);
    float s = 1.0 - 2.0 * (h - 2.0 * pairs);
    float t = 1.0 - 2.0 * (pairs - 2.0 * floor(pairs * 0.5));
    if (dimensions < 3)
        return 0.6616 * (h - 8.0 * floor(h * 0.125) < 4.0 ? vec3(s, 2.0 * t, 0.0) : vec3(2.0 * t, s, 0.0));
    if (h < 8.0)
        return 0.982 * (h < 4.0 ? vec3(s, t, 0.0) : vec3(s, 0.0, t));
    return 0.982 * (h == 12.0 || h == 14.0 ? vec3(t, s, 0.0) : vec3(0.0, s, t));
}

// Perlin's improved noise (2002) in 2D or 3D, with the hash of OSL and MaterialX and the fade 6t^5
// - 15t^4 + 10t^3. Coordinates are clamped to 2^24, where floats have no fraction and the noise is
// 0. Error 1e-6.
float perlinOctave(vec3 p, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0) * vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    vec3 cell = floor(q);
    vec3 d = q - cell;
    vec3 far = d * d * d * (d * (d * 6.0 - 15.0) + 10.0);
    float sum = 0.0;
    for (int i = 0; i < 8; i++) {
        if (i > 3 && dimensions < 3) break;
        vec3 corner = vec3(i == 1 || i == 3 || i == 5 || i == 7, i == 2 || i == 3 || i > 5, i > 3);
        vec3 share = mix(1.0 - far, far, corner);
        sum += share.x * share.y * share.z * dot(perlinDirection(cell + corner, dimensions), d - corner);
    }
    return sum;
}

// Fractal Perlin noise: the sum over k < octaves of diminish^k N(lacunarity^k p), coordinates
// clamped to 2^24. Error 2e-6 of the sum of |diminish|^k if lacunarity is a power of two; otherwise
// rounding of coordinates adds to it.
float perlin(vec3 p, int octaves, float lacunarity, float diminish, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0);
    float strength = 1.0;
    float sum = 0.0;
    for (int k = 0; k < octaves; k++) {
        sum += strength * perlinOctave(q, dimensions);
        strength *= diminish;
        q = clamp(q * lacunarity, -16777216.0, 16777216.0);
    }
    return sum;
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

void main() {
    // perlin.yaml:11 Noise
    float diffuse_perlin = perlin(localPosition * 4.0, 3, 2.0, 0.5, 3);
    // perlin.yaml:5 Blend
    vec3 diffuse_blend_1 = mix(mix(vec3(0.012286488, 0.045186203, 0.11193243), vec3(0.07818742, 0.2746773, 0.24620132), clamp((diffuse_perlin + 0.6) * 1.6666666, 0.0, 1.0)), vec3(0.69387174, 0.57758045, 0.2746773), clamp(diffuse_perlin * 3.3333333, 0.0, 1.0));
    vec3 diffuse_blend = mix(diffuse_blend_1, vec3(0.92158186, 0.8879231, 0.82278574), clamp((diffuse_perlin - 0.3) * 2.0, 0.0, 1.0));
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits, 645922816u);
}
