#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec4 matc_attribute_color;
in float matc_attribute_wetness;
in vec2 matc_attribute_uv1;
uniform float matc_object;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

// Quantizes v, clamped to [0, 1], to `bits` <= 16 bits, rounding to nearest.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// Quantizes sqrt(v), v clamped to [0, 1], to `bits` bits: finer steps near 0, like perceived
// lightness.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
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

// Quantizes v in equal steps of log2: code 0 is 0, code 1 is 1/16, the last is 65504 =
// 2^(19.9992954 - 4). Values below 1/32 become 0. bits in [4, 16].
uint logarithmBits(float v, int bits) {
    int steps = (1 << bits) - 2;
    float place = (log2(clamp(v, 0.0625, 65504.0)) + 4.0) * (float(steps) / 19.9992954);
    return v < 0.03125 ? 0u : uint(clamp(floor(place + 0.5), 0.0, float(steps))) + 1u;
}

void main() {
    vec2 uvByX = dFdx(uv);
    vec2 uvByY = dFdy(uv);
    float matc_attribute_wetnessByX = dFdx(matc_attribute_wetness);
    float matc_attribute_wetnessByY = dFdy(matc_attribute_wetness);
    // attributes.yaml:3 Expression
    vec3 diffuse_expression = mix(0.6, 1.0, matc_object) * matc_attribute_color.xyz;
    // attributes.yaml:7 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // attributes.yaml:6 Expression
    vec3 emissive_expression = step(0.9, matc_attribute_uv1.x) * vec3(0.02, 0.01, 0.0);
    uint surface_bits = rootBits(diffuse_expression.x, 8) | rootBits(diffuse_expression.y, 8) << 8 | rootBits(diffuse_expression.z, 8) << 16;
    uint specular_bits = rootBits(matc_attribute_wetness * 0.2, 8);
    float shininess = phongExponent(mix(0.3, 0.9, matc_attribute_wetness));
    // attributes.yaml:7 Expression
    float expression = uvByY.y * uvByX.x - uvByY.x * uvByX.y;
    bool expression_2 = abs(expression) < 1e-30;
    float expression_3 = expression_2 ? 0.0 : 1.0 / (expression_2 ? 1.0 : expression);
    vec3 bumpMap_3 = (uvByY.y * matc_attribute_wetnessByX - uvByX.y * matc_attribute_wetnessByY) * expression_3 * 0.04 * worldTangentV - (uvByX.x * matc_attribute_wetnessByY - uvByY.x * matc_attribute_wetnessByX) * expression_3 * 0.04 * worldTangentU;
    vec3 bumpMap_4 = cross(bumpMap_1, bumpMap_3) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_4 : bumpMap_4;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, sharedExponentBits(emissive_expression, 7), surface_bits | specular_bits << 24, specular_bits | specular_bits << 8 | logarithmBits(shininess, 10) << 21);
}
