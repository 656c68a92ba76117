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

// Differences along u and v of bilinear interpolation, from three rows of three texels, bottom row
// first; top.z is unused. Differences are taken before mixing, which avoids cancellation.
vec2 texelsRise(vec3 row, vec3 above, vec3 top, vec2 weight) {
    vec2 low = mix(vec2(row.y - row.x, above.x - row.x), vec2(row.z - row.y, top.x - above.x), weight);
    vec2 high = mix(vec2(above.y - above.x, above.y - row.y), vec2(above.z - above.y, top.y - above.y), weight);
    return mix(low, high, weight.yx);
}

// Finite difference of imageBilinear(s, uv, size)[lane] over one texel along u and v, per unit of
// uv. Reads eight texels instead of twelve. Error 6e-7 * size.
vec3 imageRiseRow(sampler2D s, vec3 x, float y, vec2 size, int lane) {
    return vec3(texel(s, vec2(x.x, y), size)[lane], texel(s, vec2(x.y, y), size)[lane], texel(s, vec2(x.z, y), size)[lane]);
}

vec2 imageRise(sampler2D s, vec2 uv, vec2 size, int lane) {
    vec2 at = fract(uv) * size;
    vec2 low = floor(at);
    vec2 weight = at - low;
    low -= size * step(size, low);
    vec2 next = low + 1.0;
    next -= size * step(size, next);
    vec2 last = next + 1.0;
    last -= size * step(size, last);
    vec3 x = vec3(low.x, next.x, last.x);
    return texelsRise(imageRiseRow(s, x, low.y, size, lane), imageRiseRow(s, x, next.y, size, lane),
                      imageRiseRow(s, x, last.y, size, lane), weight) * size;
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

// imageRise of a mipmapped image over the footprint of the pixel's uv derivatives `right` and `up`.
// Under magnification texels are mixed here: the sampler's 8-bit weights are too coarse for a
// difference times the size. Whole periods are dropped to keep steps precise; the explicit
// footprint avoids a seam.
vec2 imageRiseOver(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up) {
    vec2 across = right * size, along = up * size;
    if (max(dot(across, across), dot(along, along)) > 1.0)
        return imageRiseSampled(s, fract(uv), size, lane, right, up);
    return imageRise(s, uv, size, lane);
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

vec2 uvByX;
vec2 uvByY;

float smooth3DInput0(vec2 st) {
    return imageRiseOver(imageTexture0, st * vec2(6.0, 3.0), pictureSize(imageTexture0), 0, uvByX * vec2(6.0, 3.0), uvByY * vec2(6.0, 3.0)).x * 6.0;
}

float smooth3DInput1(vec2 st) {
    return imageRiseOver(imageTexture0, st * vec2(6.0, 3.0), pictureSize(imageTexture0), 0, uvByX * vec2(6.0, 3.0), uvByY * vec2(6.0, 3.0)).y * 3.0;
}

void main() {
    uvByX = dFdx(uv);
    uvByY = dFdy(uv);
    // bumpFilter.yaml:4 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // bumpFilter.yaml:7 Smooth3D
    vec2 smooth3D = uv - vec2(0.005);
    vec2 smooth3D_2 = uv + vec2(-0.005, 0.0);
    vec2 smooth3D_3 = uv + vec2(-0.005, 0.005);
    vec2 smooth3D_4 = uv + vec2(0.0, -0.005);
    vec2 smooth3D_5 = uv + vec2(0.0, 0.005);
    vec2 smooth3D_6 = uv + vec2(0.005, -0.005);
    vec2 smooth3D_7 = uv + vec2(0.005, 0.0);
    vec2 smooth3D_8 = uv + vec2(0.005);
    float bumpMap_3 = smooth3DInput0(smooth3D_8);
    float bumpMap_4 = smooth3DInput0(smooth3D_7);
    float bumpMap_5 = smooth3DInput0(smooth3D_6);
    float bumpMap_6 = smooth3DInput0(smooth3D_5);
    float bumpMap_7 = smooth3DInput0(uv);
    float bumpMap_8 = smooth3DInput0(smooth3D_4);
    float bumpMap_9 = smooth3DInput0(smooth3D_3);
    float bumpMap_10 = smooth3DInput0(smooth3D_2);
    float bumpMap_11 = smooth3DInput0(smooth3D);
    float bumpMap_12 = bumpMap_11 + bumpMap_11 + bumpMap_11 + bumpMap_10 + bumpMap_10 + bumpMap_10 + bumpMap_9 + bumpMap_9;
    float bumpMap_13 = bumpMap_12 + bumpMap_9 + bumpMap_8 + bumpMap_8 + bumpMap_8 + bumpMap_7 + bumpMap_7 + bumpMap_7;
    float bumpMap_14 = bumpMap_13 + bumpMap_6 + bumpMap_6 + bumpMap_6 + bumpMap_5 + bumpMap_5 + bumpMap_5 + bumpMap_4;
    float bumpMap_15 = smooth3DInput1(smooth3D_8);
    float bumpMap_16 = smooth3DInput1(smooth3D_7);
    float bumpMap_17 = smooth3DInput1(smooth3D_6);
    float bumpMap_18 = smooth3DInput1(smooth3D_5);
    float bumpMap_19 = smooth3DInput1(uv);
    float bumpMap_20 = smooth3DInput1(smooth3D_4);
    float bumpMap_21 = smooth3DInput1(smooth3D_3);
    float bumpMap_22 = smooth3DInput1(smooth3D_2);
    float bumpMap_23 = smooth3DInput1(smooth3D);
    float bumpMap_24 = bumpMap_23 + bumpMap_23 + bumpMap_23 + bumpMap_22 + bumpMap_22 + bumpMap_22 + bumpMap_21 + bumpMap_21;
    float bumpMap_25 = bumpMap_24 + bumpMap_21 + bumpMap_20 + bumpMap_20 + bumpMap_20 + bumpMap_19 + bumpMap_19 + bumpMap_19;
    float bumpMap_26 = bumpMap_25 + bumpMap_18 + bumpMap_18 + bumpMap_18 + bumpMap_17 + bumpMap_17 + bumpMap_17 + bumpMap_16;
    vec3 bumpMap_27 = (bumpMap_14 + bumpMap_4 + bumpMap_4 + bumpMap_3 + bumpMap_3 + bumpMap_3) * 0.0014814815 * worldTangentV;
    vec3 bumpMap_28 = (bumpMap_26 + bumpMap_16 + bumpMap_16 + bumpMap_15 + bumpMap_15 + bumpMap_15) * 0.0014814815 * worldTangentU;
    vec3 bumpMap_29 = cross(bumpMap_1, bumpMap_27 - bumpMap_28) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_29 : bumpMap_29;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, 2358747273u, 903908492u);
}
