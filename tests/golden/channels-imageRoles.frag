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

// Width and height of a picture, texels.
vec2 pictureSize(sampler2D s) {
    return vec2(textureSize(s, 0));
}

// A picture by its sampler, which takes the footprint from the neighbouring pixels: not in branches. A texel's value stands at its
// lower corner, the sampler's at its centre. Below a texel a pixel the sampler's weights err by 1/256.
vec4 imageSampled(sampler2D s, vec2 uv, vec2 size) {
    return texture(s, uv + 0.5 / size);
}

// v, taken to [0, 1], as the nearest of 2^bits equal steps, bits <= 16.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// The square root of v, taken to [0, 1], as the nearest of 2^bits equal steps: steps of v that shrink towards 0, as an eye's do.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
}

// Texel (i.x, i.y) of the base level, whatever the sampler's state; i is whole and inside the picture.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texelFetch(s, ivec2(i), 0);
}

// How the mix of four texels rises from one to the next along u and along v: of three rows of three, the lowest first; the last
// texel of the top row has no part in it. Differences come before the mix, so that nothing cancels.
vec2 texelsRise(vec3 row, vec3 above, vec3 top, vec2 weight) {
    vec2 low = mix(vec2(row.y - row.x, above.x - row.x), vec2(row.z - row.y, top.x - above.x), weight);
    vec2 high = mix(vec2(above.y - above.x, above.y - row.y), vec2(above.z - above.y, top.y - above.y), weight);
    return mix(low, high, weight.yx);
}

// By how much a lane of imageBilinear(s, uv, size) is greater one texel further along u and along v, over a texel: eight texels
// stand for the twelve of three places. Error 6e-7 of the size.
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

// By how much a lane of what the sampler shows over a footprint is greater one texel further along u and along v, over a texel.
vec2 imageRiseSampled(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up) {
    vec2 at = uv + 0.5 / size;
    float here = textureGrad(s, at, right, up)[lane];
    float beyondU = textureGrad(s, at + vec2(1.0 / size.x, 0.0), right, up)[lane];
    float beyondV = textureGrad(s, at + vec2(0.0, 1.0 / size.y), right, up)[lane];
    return (vec2(beyondU, beyondV) - here) * size;
}

// imageRise up to a texel a pixel, where the sampler's weights have eight bits, too few for a difference times the size; from there
// on the rise of what it shows. Beyond 65536 texels floats keep a step of a texel to less than 1/256: there whole turns are dropped, and
// the sampler is told the footprint, so that it sees no seam.
vec2 imageRiseNear(sampler2D s, vec2 uv, vec2 size, int lane, vec2 right, vec2 up, vec2 shown) {
    vec2 across = right * size, along = up * size, far = abs(uv) * size;
    if (max(dot(across, across), dot(along, along)) <= 1.0)
        return imageRise(s, uv, size, lane);
    if (max(far.x, far.y) > 65536.0)
        return imageRiseSampled(s, fract(uv), size, lane, right, up);
    return shown;
}

// v / |v| for every finite v; (0, 0, 1) where no component reaches 1e-37. v is divided by its greatest component first, so that
// no square over- or underflows, and a great one is scaled down before, so that its reciprocal does not. Relative error 2e-7.
vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}

// A world direction in eye space; the matrix is a rotation, so that lengths and angles stay.
vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
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

// v by equal steps of its logarithm: code 0 is 0, code 1 is 1/16, the last is 65504 = 2^(19.9992954 - 4); below 1/32 it is 0.
// bits from 4 to 16.
uint logarithmBits(float v, int bits) {
    int steps = (1 << bits) - 2;
    float place = (log2(clamp(v, 0.0625, 65504.0)) + 4.0) * (float(steps) / 19.9992954);
    return v < 0.03125 ? 0u : uint(clamp(floor(place + 0.5), 0.0, float(steps))) + 1u;
}

// Exponent of a Phong lobe for a shininess x: -2 / ln y, y = x (2 - x), 0 for y <= 0, at most 65504. Relative error 8e-7.
// Near x = 1 the logarithm would lose its digits: there, with w = 1 - y = (1 - x)^2 and s = w / (2 - w), ln y is
// -2 (s + s^3/3 + s^5/5 + s^7/7 + ...); for w <= 1/4 the rest is below 2e-8 of it.
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
    // imageRoles.yaml:8 ImageMap
    vec2 diffuse_image = pictureSize(imageTexture0);
    // imageRoles.yaml:6 Blend
    float diffuse_blend = imageSampled(imageTexture0, uv * vec2(3.0, 1.0), diffuse_image).x;
    // imageRoles.yaml:7 ImageMap
    vec3 diffuse_image2 = imageSampled(imageTexture1, uv, pictureSize(imageTexture1)).xyz;
    vec3 diffuse = diffuse_blend <= 1.0 ? (diffuse_blend < 0.0 ? vec3(0.014443844, 0.029556835, 0.051269457) : mix(vec3(0.014443844, 0.029556835, 0.051269457), diffuse_image2, diffuse_blend)) : diffuse_image2;
    // imageRoles.yaml:4 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    uint surface_bits = rootBits(diffuse.x, 8) | rootBits(diffuse.y, 8) << 8 | rootBits(diffuse.z, 8) << 16;
    float shininess_1 = imageSampled(imageTexture0, uv, diffuse_image).x;
    // imageRoles.yaml:4 ImageMap
    vec2 image = vec2((imageSampled(imageTexture0, vec2(1.0 / diffuse_image.x, 0.0) + uv, diffuse_image).x - shininess_1) * diffuse_image.x, (imageSampled(imageTexture0, vec2(0.0, 1.0 / diffuse_image.y) + uv, diffuse_image).x - shininess_1) * diffuse_image.y);
    vec2 image_2 = imageRiseNear(imageTexture0, uv, diffuse_image, 0, uvByX, uvByY, image);
    vec3 bumpMap_3 = cross(bumpMap_1, image_2.x * 0.04 * worldTangentV - image_2.y * 0.04 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_3 : bumpMap_3;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits, logarithmBits(phongExponent(shininess_1), 10) << 21);
}
