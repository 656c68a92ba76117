#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
uniform mat3 matc_eyeFromWorld;
uniform sampler2D imageTexture0;
uniform sampler2D imageTexture1;
layout(location = 0) out uvec4 fragment0;

// Width and height of an image in texels.
vec2 pictureSize(sampler2D s) {
    return vec2(textureSize(s, 0));
}

// Samples an image, texel values at the texels' lower corners (hence the half-texel offset). Uses
// implicit derivatives: not in branches. Under magnification the sampler's weights err by 1/256.
vec4 imageSampled(sampler2D s, vec2 uv, vec2 size) {
    return texture(s, uv + 0.5 / size);
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

// Quantizes v in equal steps of log2: code 0 is 0, code 1 is 1/16, the last is 65504 =
// 2^(19.9992954 - 4). Values below 1/32 become 0. bits in [4, 16].
uint logarithmBits(float v, int bits) {
    int steps = (1 << bits) - 2;
    float place = (log2(clamp(v, 0.0625, 65504.0)) + 4.0) * (float(steps) / 19.9992954);
    return v < 0.03125 ? 0u : uint(clamp(floor(place + 0.5), 0.0, float(steps))) + 1u;
}

// Phong exponent of a shininess x: -2 / ln y, y = x (2 - x), at most 65504; 0 for y <= 0. Relative
// error 8e-7. Near x = 1 a series avoids cancellation: with w = (1 - x)^2 and s = w / (2 - w), ln y
// is -2 (s + s^3/3 + s^5/5 + s^7/7 + ...); for w <= 1/4 the remainder is below 2e-8 relative.
float phongExponent(float x) {
    float y = x * (2.0 - x);
    float w = min((1.0 - x) * (1.0 - x), 0.25);
    float s = w / (2.0 - w);
    float s2 = s * s;
    float series = s * (1.0 + s2 * (1.0 / 3.0 + s2 * (1.0 / 5.0 + s2 * (1.0 / 7.0))));
    float logarithm = -0.5 * log(clamp(y, 1.17549435e-38, 0.76));
    float exponent = min(1.0 / max(y < 0.75 ? logarithm : series, 1.0 / 65504.0), 65504.0);
    return y > 0.0 ? exponent : 0.0;
}

void main() {
    vec2 uvByX = dFdx(uv);
    vec2 uvByY = dFdy(uv);
    // imageChannel.yaml:4 ImageMap
    vec2 diffuse_image = pictureSize(imageTexture0);
    vec4 diffuse_image_2 = imageSampled(imageTexture0, uv, diffuse_image);
    // imageChannel.yaml:3 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    uint diffuse_bits = rootBits(diffuse_image_2.y, 8);
    uint specular_bits = rootBits(imageNearest(imageTexture1, uv, vec2(64.0)).x, 8);
    // imageChannel.yaml:3 ImageMap
    vec2 image = vec2((imageSampled(imageTexture0, vec2(1.0 / diffuse_image.x, 0.0) + uv, diffuse_image).z - diffuse_image_2.z) * diffuse_image.x, (imageSampled(imageTexture0, vec2(0.0, 1.0 / diffuse_image.y) + uv, diffuse_image).z - diffuse_image_2.z) * diffuse_image.y);
    vec2 image_2 = imageRiseNear(imageTexture0, uv, diffuse_image, 2, uvByX, uvByY, image);
    vec3 bumpMap_3 = cross(bumpMap_1, image_2.x * 0.02 * worldTangentV - image_2.y * 0.02 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_3 : bumpMap_3;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 34611264u, diffuse_bits | diffuse_bits << 8 | diffuse_bits << 16 | specular_bits << 24, specular_bits | specular_bits << 8 | logarithmBits(phongExponent(diffuse_image_2.z), 10) << 21);
}
