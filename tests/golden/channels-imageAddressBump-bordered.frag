#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
uniform mat3 matc_eyeFromWorld;
uniform sampler2D imageTexture0;
layout(location = 0) out uvec4 fragment0;

// Texel (i.x, i.y) of mipmap level 0, independent of the sampler; i is integral and inside the
// image.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texelFetch(s, ivec2(i), 0);
}

// Texel (i.x, i.y), i integral, with an address mode: 1 mirror, up to two texels outside the mirror
// image; 2 clamp to edge; 3 border of 0.
vec4 texelBeyond(sampler2D s, vec2 i, vec2 size, int address) {
    vec2 turn = i - 2.0 * size * step(2.0 * size, i);
    vec2 place = clamp(address == 1 ? min(turn, 2.0 * size - 1.0 - turn) : i, vec2(0.0), size - 1.0);
    return address == 3 && place != i ? vec4(0.0) : texel(s, place, size);
}

// Differences along u and v of bilinear interpolation, from three rows of three texels, bottom row
// first; top.z is unused. Differences are taken before mixing, which avoids cancellation.
vec2 texelsRise(vec3 row, vec3 above, vec3 top, vec2 weight) {
    vec2 low = mix(vec2(row.y - row.x, above.x - row.x), vec2(row.z - row.y, top.x - above.x), weight);
    vec2 high = mix(vec2(above.y - above.x, above.y - row.y), vec2(above.z - above.y, top.y - above.y), weight);
    return mix(low, high, weight.yx);
}

// Finite difference of the filtered texture's component `lane` over one texel along u and v, per
// unit of uv.
vec2 imageRiseSampled(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up) {
    vec2 at = uv + 0.5 / size;
    float here = textureGrad(s, at, right, up)[lane];
    float beyondU = textureGrad(s, at + vec2(1.0 / size.x, 0.0), right, up)[lane];
    float beyondV = textureGrad(s, at + vec2(0.0, 1.0 / size.y), right, up)[lane];
    return (vec2(beyondU, beyondV) - here) * size;
}

// imageRiseOver for a sampler that mirrors (address 1), clamps (2), or has a zero border (3). Error
// 6e-7 size.
vec3 imageRiseBeyondRow(sampler2D s, vec3 x, float y, vec2 size, int lane, int address) {
    return vec3(texelBeyond(s, vec2(x.x, y), size, address)[lane], texelBeyond(s, vec2(x.y, y), size, address)[lane],
                texelBeyond(s, vec2(x.z, y), size, address)[lane]);
}

vec2 imageRiseBeyond(sampler2D s, vec2 uv, vec2 size, int lane, int address, vec2 right, vec2 up) {
    vec2 across = right * size, along = up * size;
    vec2 turn = address == 1 ? fract(uv * 0.5) * 2.0 : uv; // as imageRiseOver's, two at a time
    if (max(dot(across, across), dot(along, along)) > 1.0)
        return imageRiseSampled(s, turn, size, lane, right, up);
    vec2 at = turn * size;
    vec2 low = floor(at);
    vec3 x = low.x + vec3(0.0, 1.0, 2.0);
    return texelsRise(imageRiseBeyondRow(s, x, low.y, size, lane, address), imageRiseBeyondRow(s, x, low.y + 1.0, size, lane, address),
                      imageRiseBeyondRow(s, x, low.y + 2.0, size, lane, address), at - low) * size;
}

// Width and height of an image in texels.
vec2 pictureSize(sampler2D s) {
    return vec2(textureSize(s, 0));
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
    vec2 uvByX = dFdx(uv);
    vec2 uvByY = dFdy(uv);
    // imageAddressBump.yaml:5 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // imageAddressBump.yaml:5 ImageMap
    vec2 image = imageRiseBeyond(imageTexture0, (uv + vec2(0.7, 0.8)) * vec2(2.5), pictureSize(imageTexture0), 0, 3, uvByX * vec2(2.5), uvByY * vec2(2.5));
    vec3 bumpMap_3 = cross(bumpMap_1, image.x * 0.05 * worldTangentV - image.y * 0.05 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_3 : bumpMap_3;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, 11842740u, 645922816u);
}
