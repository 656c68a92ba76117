#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
uniform mat3 matc_eyeFromWorld;
uniform sampler2D carpenterTexture0;
layout(location = 0) out uvec4 fragment0;

// Texel (i.x, i.y) of mipmap level 0, independent of the sampler; i is integral and inside the
// image.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texelFetch(s, ivec2(i), 0);
}

// Samples a synthetic single-channel texture, repeated and bilinear as in GroIMP: size * uv is
// truncated toward zero, so a negative coordinate extrapolates with a negative weight. fract()
// removes whole periods exactly.
float carpenterRelief(sampler2D s, vec2 uv, vec2 size) {
    vec2 side = 1.0 - 2.0 * vec2(lessThan(uv, vec2(0.0)));
    vec2 at = fract(abs(uv)) * size;
    vec2 low = side * floor(at);
    vec2 weight = side * at - low;
    low += size * vec2(lessThan(low, vec2(0.0)));
    low -= size * step(size, low);
    vec2 high = low + 1.0;
    high -= size * step(size, high);
    return mix(mix(texel(s, low, size).r, texel(s, vec2(high.x, low.y), size).r, weight.x),
               mix(texel(s, vec2(low.x, high.y), size).r, texel(s, high, size).r, weight.x), weight.y);
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
    // bumpCarpenter.yaml:4 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // bumpCarpenter.yaml:4 Carpenter
    float carpenter_map = carpenterRelief(carpenterTexture0, uv, vec2(256.0));
    vec2 carpenter_map_1 = floor(uv);
    vec2 carpenter_map_2 = uv - (carpenter_map_1 - clamp(carpenter_map_1, vec2(-2.0), vec2(1.0)));
    vec3 bumpMap_3 = (carpenterRelief(carpenterTexture0, carpenter_map_2 + vec2(0.005, 0.0), vec2(256.0)) - carpenter_map) * 6.0 * worldTangentV - (carpenterRelief(carpenterTexture0, carpenter_map_2 + vec2(0.0, 0.005), vec2(256.0)) - carpenter_map) * 6.0 * worldTangentU;
    vec3 bumpMap_4 = cross(bumpMap_1, bumpMap_3) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_4 : bumpMap_4;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, 7306115u, 645922816u);
}
