#version 330 core
// matc 0.1.0: pass gbuffer, layout thesis

in vec3 localPosition;
in vec3 eyeNormal;
layout(location = 0) out vec4 fragment0;
layout(location = 1) out vec4 fragment1;
layout(location = 2) out vec4 fragment2;
layout(location = 3) out vec4 fragment3;

// v / |v| for every finite v; (0, 0, 1) where no component reaches 1e-37. v is divided by its greatest component first, so that
// no square over- or underflows, and a great one is scaled down before, so that its reciprocal does not. Relative error 3e-7.
vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}

// A bijective finaliser, two rounds of shift and multiply, so that the top bits of every shift of the hash are good.
uvec4 latticeFinal(uvec4 h) {
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}

// Hashes of the eight corners of a cell, lanes as latticeMix takes them: xor of the coordinates' products, then a finaliser.
// The wrap to [0, 65536) is exact for every finite cell: its steps only scale by powers of two and drop high digits.
void latticeCorners(vec3 cell, out uvec4 low, out uvec4 high) {
    const uvec3 factor = uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uvec3 c = uvec3(ivec3(cell - 65536.0 * floor(cell * (1.0 / 65536.0))));
    uvec3 c0 = c * factor;
    uvec3 c1 = ((c + 1u) & 65535u) * factor;
    uvec4 square = uvec4(c0.x, c1.x, c0.x, c1.x) ^ uvec4(c0.yy, c1.yy);
    low = latticeFinal(square ^ (c0.z + 0x165667B1u));
    high = latticeFinal(square ^ (c1.z + 0x165667B1u));
}

// Mixes eight corner terms, lanes (x, y) = (0,0) (1,0) (0,1) (1,1), z = 0 in `low` and 1 in `high`, with weights 3d^2 - 2d^3.
float latticeMix(vec4 low, vec4 high, vec3 d) {
    vec3 s = d * d * (3.0 - 2.0 * d);
    vec4 plane = mix(low, high, s.z);
    vec2 line = mix(plane.xy, plane.zw, s.y);
    return mix(line.x, line.y, s.x);
}

// A hash read as a signed number is this much of 1.
const float latticeScale = 1.0 / 2147483648.0;

// Value plus gradient terms of a face's four corners, times 2^31; d is the offset from the first corner.
// A corner's numbers are its hash shifted left by 0, 7, 14, 21 and read as signed: uniform, symmetric to 2^-11, no masks.
vec4 latticeTerms(uvec4 hash, vec3 d) {
    vec4 dx = vec4(d.x, d.x - 1.0, d.x, d.x - 1.0);
    vec4 dy = vec4(d.yy, d.yy - 1.0);
    return 0.5 * vec4(ivec4(hash)) + vec4(ivec4(hash << 7u)) * dx + vec4(ivec4(hash << 14u)) * dy
         + vec4(ivec4(hash << 21u)) * d.z;
}

// Lattice noise at a point of a cell, d in [0, 1): at each corner a value and a gradient from a hash, smoothly interpolated.
// About [-1, 1], standard deviation 1/4, period 65536 an axis. Error below 1e-6 of the reference at the same floats.
float lattice(vec3 cell, vec3 d) {
    uvec4 low, high;
    latticeCorners(cell, low, high);
    return latticeMix(latticeTerms(low, d), latticeTerms(high, d - vec3(0.0, 0.0, 1.0)), d) * latticeScale;
}

// Noise in [-1, 1], standard deviation 1/2. About one sample in twenty is clamped. Error 2e-6, in simplex noise too.
float noise(vec3 p) {
    vec3 cell = floor(p);
    return clamp(2.0 * lattice(cell, p - cell), -1.0, 1.0);
}

// Six octaves of |noise(4 2^k p)| - 1/2, each half as strong as the last; in [-63/64, 63/64]. Error 4e-6.
float granite(vec3 p) {
    vec3 q = 4.0 * p;
    float strength = 1.0;
    float sum = 0.0;
    for (int k = 0; k < 6; k++) {
        sum += strength * (abs(noise(q)) - 0.5);
        strength *= 0.5;
        q *= 2.0;
    }
    return sum;
}

// Unit normal n to n.xy / sqrt(8 n.z + 8) + 1/2 in [0, 1]^2, in two forms that are equal for a unit n: this one for n.z >= 0,
// and below it the direction of n.xy times the radius sqrt((1 - n.z) / 8), which holds its digits up to the singularity.
// At (0, 0, -1) itself the direction is +x.
vec2 encodeSpheremap(vec3 n) {
    float square = dot(n.xy, n.xy);
    vec2 direction = square > 1.0e-30 ? n.xy * inversesqrt(max(square, 1.0e-30)) : vec2(1.0, 0.0);
    vec2 front = n.xy * inversesqrt(8.0 * max(n.z, 0.0) + 8.0);
    vec2 back = direction * sqrt(0.125 - 0.125 * min(n.z, 0.0));
    return clamp((n.z < 0.0 ? back : front) + 0.5, 0.0, 1.0);
}

// Exponent of a Phong lobe for a shininess x: -2 / ln y, y = x (2 - x), 0 for y <= 0, at most 65504. Relative error 3e-6.
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

// Two numbers in [0, 1], cut to seven bits each, in one number of [1, 65504] that a half float holds exactly: x gives the
// exponent and the first three bits of the mantissa, y the other seven. The power of two is exact: exp2 errs by at most 33 ulp
// of 32768, an eighth, before it is rounded to a whole number.
float packPair(vec2 v) {
    vec2 q = floor(127.5 * clamp(v, 0.0, 1.0));
    float exponent = floor(q.x * 0.125);
    float mantissa = 1.0 + (q.x * 0.125 - exponent) + q.y * (1.0 / 1024.0);
    return mantissa * floor(exp2(exponent) + 0.5);
}

void main() {
    // normal
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    // Granite
    float graniteValue = granite(localPosition) * 0.6 + 0.5;
    fragment0 = vec4(encodeSpheremap(normal), phongExponent(graniteValue), 65504.0);
    // Blend
    vec3 blend = mix(vec3(0.023529412, 0.023529412, 0.03137255), vec3(0.58431375, 0.4862745, 0.39607844), clamp((graniteValue - 0.1) * 1.4285715, 0.0, 1.0));
    vec3 blend2 = mix(vec3(0.0), vec3(0.4, 0.2, 0.1), clamp((graniteValue - 0.7) * 5.0, 0.0, 1.0));
    fragment1 = vec4(blend, packPair(blend2.xy));
    fragment2 = vec4(clamp(vec3(graniteValue), -65504.0, 65504.0), packPair(vec2(blend2.z, 0.0)));
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
