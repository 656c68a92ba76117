#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
uniform mat3 matc_eyeFromWorld;
uniform sampler2D imageTexture0;
uniform sampler2D imageTexture1;
uniform sampler2D imageTexture2;
uniform sampler2D imageTexture3;
uniform sampler2D imageTexture4;
layout(location = 0) out uvec4 fragment0;

// Width and height of an image in texels.
vec2 pictureSize(sampler2D s) {
    return vec2(textureSize(s, 0));
}

// Texel (i.x, i.y) of mipmap level 0, independent of the sampler; i is integral and inside the
// image.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texelFetch(s, ivec2(i), 0);
}

// Nearest lookup with repeat: texel floor(size * fract(uv)). min() handles a fract() that rounds to
// 1.
vec4 imageNearest(sampler2D s, vec2 uv, vec2 size) {
    return texel(s, min(floor(fract(uv) * size), size - 1.0), size);
}

// Samples an image, texel values at texel centers. Uses implicit derivatives: not in branches.
// Under magnification the sampler's weights err by 1/256.
vec4 imageCentred(sampler2D s, vec2 uv) {
    return texture(s, uv);
}

// Packs three numbers >= 0 with a shared exponent: mantissas m of `bits` bits (4 to 9), then a
// 5-bit exponent e: v = m 2^(e - 15 - bits), at most 65536 (1 - 2^-bits). 9 bits are the format
// RGB9E5. The float's own exponent is used, so no logarithm errs. A mantissa that rounds to 2^bits
// uses the next exponent.
uint sharedExponentBits(vec3 v, int bits) {
    float steps = float(1 << bits);
    vec3 c = clamp(v, 0.0, 65536.0 - 65536.0 / steps);
    float greatest = max(max(c.x, c.y), max(c.z, 1.0 / 65536.0));
    int e = int(floatBitsToUint(greatest) >> 23) - 111;
    float scale = uintBitsToFloat(uint(142 + bits - e) << 23);
    if (floor(greatest * scale + 0.5) >= steps) { e += 1; scale *= 0.5; }
    uvec3 m = uvec3(floor(c * scale + 0.5));
    return m.x | m.y << bits | m.z << (2 * bits) | uint(e) << (3 * bits);
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

// Samples an image, texel values at the texels' lower corners (hence the half-texel offset). Uses
// implicit derivatives: not in branches. Under magnification the sampler's weights err by 1/256.
vec4 imageSampled(sampler2D s, vec2 uv, vec2 size) {
    return texture(s, uv + 0.5 / size);
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

// imageRise under magnification, because the sampler's 8-bit weights are too coarse for a
// difference times the size; else the given difference `shown`. Outside 65536 texels a float cannot
// step 1/256 texel: whole periods are dropped, and the explicit footprint avoids a seam.
vec2 imageRiseNear(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up, vec2 shown) {
    vec2 across = right * size, along = up * size, far = abs(uv) * size;
    if (max(dot(across, across), dot(along, along)) <= 1.0)
        return imageRise(s, uv, size, lane);
    if (max(far.x, far.y) > 65536.0)
        return imageRiseSampled(s, fract(uv), size, lane, right, up);
    return shown;
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
    // imageCentre.yaml:3 around
    vec2 around = (uv + vec2(0.7, 0.8)) * vec2(2.5);
    // imageCentre.yaml:7 ImageMap
    vec2 transparency_image = pictureSize(imageTexture1);
    // imageCentre.yaml:6 ImageMap
    vec4 ambient_image = imageNearest(imageTexture2, around, vec2(64.0));
    // imageCentre.yaml:8 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // imageCentre.yaml:3 ImageMap
    vec4 diffuse_image = imageCentred(imageTexture0, around);
    vec4 transparency_image_2 = imageCentred(imageTexture1, uv * vec2(90.0, 70.0));
    uint surface_bits = sharedExponentBits(imageCentred(imageTexture3, around).xyz, 5) | rootBits(ambient_image.x, 4) << 20 | rootBits(ambient_image.y, 4) << 24;
    uint surface_bits2 = rootBits(diffuse_image.x, 7) | rootBits(diffuse_image.y, 7) << 7 | rootBits(diffuse_image.z, 7) << 14;
    // imageCentre.yaml:4 ImageMap
    vec4 specular_image = imageCentred(imageTexture4, around);
    uint surface_bits3 = rootBits(specular_image.y, 6) | rootBits(specular_image.z, 6) << 6 | rootBits(transparency_image_2.y, 5) << 12;
    // imageCentre.yaml:8 ImageMap
    vec2 image = uv - vec2(0.5) / transparency_image;
    float image_2 = imageCentred(imageTexture1, uv).x;
    vec2 image_3 = vec2((imageSampled(imageTexture1, image + vec2(1.0 / transparency_image.x, 0.0), transparency_image).x - image_2) * transparency_image.x, (imageSampled(imageTexture1, image + vec2(0.0, 1.0 / transparency_image.y), transparency_image).x - image_2) * transparency_image.y);
    vec2 image_4 = imageRiseNear(imageTexture1, image, transparency_image, 0, uvByX, uvByY, image_3);
    vec3 bumpMap_3 = cross(bumpMap_1, image_4.x * 0.02 * worldTangentV - image_4.y * 0.02 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_3 : bumpMap_3;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 4227858434u, surface_bits | rootBits(ambient_image.z, 4) << 28, surface_bits2 | rootBits(specular_image.x, 6) << 21 | rootBits(transparency_image_2.x, 5) << 27, surface_bits3 | rootBits(transparency_image_2.z, 5) << 17 | 645922816u);
}
