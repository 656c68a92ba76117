#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec2 uv;
in vec3 eyeNormal;
uniform sampler2D imageTexture0;
uniform sampler2D imageTexture1;
uniform sampler2D imageTexture2;
uniform sampler2D imageTexture3;
uniform sampler2D imageTexture4;
layout(location = 0) out uvec4 fragment0;

// Samples an image, texel values at the texels' lower corners (hence the half-texel offset). Uses
// implicit derivatives: not in branches. Under magnification the sampler's weights err by 1/256.
vec4 imageSampled(sampler2D s, vec2 uv, vec2 size) {
    return texture(s, uv + 0.5 / size);
}

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
    // imageAddress.yaml:3 around
    vec2 around = (uv + vec2(0.7, 0.8)) * vec2(2.5);
    // imageAddress.yaml:3 ImageMap
    vec4 diffuse_image = imageSampled(imageTexture0, around, pictureSize(imageTexture0));
    // imageAddress.yaml:7 ImageMap
    vec2 transparency_image_1 = (floor(around * vec2(64.0)) + vec2(0.5)) * vec2(0.015625);
    vec2 transparency_image_2 = step(vec2(0.0), around) - step(vec2(1.0), around);
    float transparency_image_3 = transparency_image_2.y * transparency_image_2.x;
    vec4 transparency_image = vec4(transparency_image_3) * imageNearest(imageTexture1, clamp(transparency_image_1, vec2(0.0078125), vec2(0.9921875)), vec2(64.0));
    // imageAddress.yaml:6 ImageMap
    vec2 ambient_image = clamp(vec2(1.0) - abs(vec2(1.0) - fract(transparency_image_1 * 0.5) * 2.0), vec2(0.0078125), vec2(0.9921875));
    vec4 ambient_image_2 = imageNearest(imageTexture2, ambient_image, vec2(64.0));
    // imageAddress.yaml:5 ImageMap
    vec4 emissive_image = imageSampled(imageTexture3, around, pictureSize(imageTexture3));
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    uint surface_bits = sharedExponentBits(emissive_image.xyz, 5) | rootBits(ambient_image_2.x, 4) << 20 | rootBits(ambient_image_2.y, 4) << 24;
    uint surface_bits2 = rootBits(diffuse_image.x, 7) | rootBits(diffuse_image.y, 7) << 7 | rootBits(diffuse_image.z, 7) << 14;
    // imageAddress.yaml:4 ImageMap
    vec4 specular_image = imageSampled(imageTexture4, around, pictureSize(imageTexture4));
    uint surface_bits3 = rootBits(specular_image.y, 6) | rootBits(specular_image.z, 6) << 6 | rootBits(transparency_image.y, 5) << 12;
    uint surface_bits4 = surface_bits3 | rootBits(transparency_image.z, 5) << 17 | logarithmBits(phongExponent(emissive_image.w), 9) << 22;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 4227858434u, surface_bits | rootBits(ambient_image_2.z, 4) << 28, surface_bits2 | rootBits(specular_image.x, 6) << 21 | rootBits(transparency_image.x, 5) << 27, surface_bits4);
}
