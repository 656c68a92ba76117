#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 localPosition;
in vec3 localTangentU;
in vec3 localTangentV;
uniform float brightness;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

// Sine by lane. As accurate as the sine.
vec3 sine3(vec3 x) {
    return sin(x);
}

// sin(x) / x by lane, x not negative: 1 - x^2 / 6 near 0, where the quotient would lose digits. Error 3e-7.
vec3 sinc(vec3 x) {
    vec3 near = 1.0 - x * x * (1.0 / 6.0);
    vec3 far = sine3(x) / max(x, 1.0e-2);
    return mix(far, near, step(x, vec3(1.0e-2)));
}

// Mean of leopard over a box around p, exact where its axes are independent: (sum of sin)^2 / 9 from the means of sin and sin^2.
// Error 4.3e-7 where sin and cos have 1e-7.
float leopardFiltered(vec3 p, vec3 edge) {
    vec3 sine = sine3(p);
    vec3 mean = sine * sinc(0.5 * edge);
    vec3 square = 0.5 - (0.5 - sine * sine) * sinc(edge);
    float sum = mean.x + mean.y + mean.z;
    return max(sum * sum + dot(square - mean * mean, vec3(1.0)), 0.0) * (1.0 / 9.0);
}

// Distance from the z axis, coordinates cut at 1e37. Divided by the greater one first, so that no square over- or underflows.
// Relative error 2e-7.
float wood(vec3 p) {
    vec2 a = min(abs(p.xy), 1.0e37);
    float greater = max(max(a.x, a.y), 1.0e-37);
    return greater * length(a / greater);
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

// v, taken to [0, 1], as the nearest of 2^bits equal steps, bits <= 16.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// The square root of v, taken to [0, 1], as the nearest of 2^bits equal steps: steps of v that shrink towards 0, as an eye's do.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
}

// Mean over boxes below 1/2 of waves that are 1 for q in [0, 1/2) and -1 in [1/2, 1), period 1; q in [0, 1]. From the distance to the
// nearest edge, which does not cancel: error 1e-7 at any width. A box of at most 1e-6 is the point, which at an edge belongs to the
// upper side.
vec2 stripesNear2(vec2 q, vec2 edges) {
    vec2 side = 1.0 - 2.0 * step(0.5, q);
    vec2 distance = min(min(q, 1.0 - q), abs(q - 0.5));
    return side * max(min(2.0 * distance / max(edges, 1.0e-6), 1.0), step(edges, vec2(1.0e-6)));
}

// Mean over boxes of waves that are 1 for q in [0, 1/2) and -1 in [1/2, 1), period 1; q in [0, 1]. For a box of 1/2 and more from the
// antiderivative. Error 2e-7.
vec2 stripes2(vec2 q, vec2 edges) {
    vec2 low = abs(fract(q - 0.5 * edges) - 0.5);
    vec2 high = abs(fract(q + 0.5 * edges) - 0.5);
    return mix(stripesNear2(q, edges), (low - high) / max(edges, 0.5), step(0.5, edges));
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

// Three numbers >= 0 with one exponent: mantissas m of `bits` bits, 4 to 9, and above them an exponent e of 5:
// v = m 2^(e - 15 - bits), at most 65536 (1 - 2^-bits). With 9 bits that is the texture format RGB9E5. The exponent is read from
// the float's own, so that no logarithm errs; where a mantissa is rounded up to 2^bits, the next exponent is taken.
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

void main() {
    vec2 uvByX = dFdx(uv);
    vec2 uvByY = dFdy(uv);
    vec3 localPositionByX = dFdx(localPosition);
    vec3 localPositionByY = dFdy(localPosition);
    // arithmeticVaries.yaml:15 Leopard
    float diffuse_leopard = leopardFiltered(localPosition, max(abs(localPositionByY), abs(localPositionByX)));
    // arithmeticVaries.yaml:13 HSV
    vec3 diffuse_hsv = vec3(1.0, diffuse_leopard, brightness) * (vec3(uv.x / 3.0, 0.0, 0.0) + vec3(0.055555556, 0.75, 0.8));
    vec3 diffuse_hsv_2 = clamp(abs(fract(diffuse_hsv.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    vec3 diffuse = mix(vec3(1.0), diffuse_hsv_2, diffuse_hsv.y) * diffuse_hsv.z;
    // arithmeticVaries.yaml:30 Wood
    float transparency_wood = wood(localPosition);
    // arithmeticVaries.yaml:28 Contrast
    vec3 transparency_contrast = (vec3(0.2, 0.4, 0.6) - transparency_wood) * granite(localPosition) + transparency_wood;
    vec3 transparency = (transparency_contrast - vec3(1.0)) * 0.9 + vec3(1.0);
    // arithmeticVaries.yaml:26 Expression
    float emissive_expression = floor(uv.x * 4.0) * 0.25;
    // arithmeticVaries.yaml:26 Remap
    float emissive_remap_1 = 0.75 - emissive_expression;
    bool emissive_remap_2 = abs(emissive_remap_1) < 1e-30;
    vec3 emissive_remap = (vec3(uv.x, uv.y, localPosition.x) - emissive_expression) * ((emissive_remap_2 ? 0.0 : 0.6901961) / (emissive_remap_2 ? 1.0 : emissive_remap_1));
    // arithmeticVaries.yaml:25 Expression
    float emissive_expression2 = (uv.x - 0.3) * 40.0 + localPosition.x;
    // arithmeticVaries.yaml:24 Power
    float emissive_power_1 = clamp(emissive_expression2, 0.0, 64.0);
    float emissive_power_2 = pow(1e+37, 1.0 / max(emissive_power_1, 1.0));
    vec3 emissive_power = min(pow(max(min(vec3(emissive_power_2), emissive_remap), 1e-37), vec3(emissive_power_1)), 1e+37);
    // arithmeticVaries.yaml:4 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    // arithmeticVaries.yaml:7 Expression
    float expression_1 = sin(uv.y);
    // arithmeticVaries.yaml:8 Expression
    float expression2_1 = cos(uv.x);
    // arithmeticVaries.yaml:10 Expression
    float expression3_1 = sin(uv.x);
    // arithmeticVaries.yaml:10 Expression
    float expression4 = expression3_1 * 0.5 + 1.0;
    // arithmeticVaries.yaml:10 Expression
    float expression5_1 = cos(uv.y);
    float expression5 = expression5_1 * 0.5;
    // arithmeticVaries.yaml:10 Contrast
    float contrast_1 = expression3_1 * expression_1 - expression5;
    float contrast = contrast_1 * expression4 + expression5;
    // arithmeticVaries.yaml:6 Remap
    float remap = expression2_1 + 1.5 - (expression_1 - 1.5);
    float remap_2 = 1.5 - expression_1 + dot(localPosition, vec3(0.3, 0.2, 0.1));
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    uint surface_bits = rootBits(diffuse.x, 7) | rootBits(diffuse.y, 7) << 7 | rootBits(diffuse.z, 7) << 14;
    // arithmeticVaries.yaml:21 Expression
    float specular_expression = uv.x * 0.5 + 0.5;
    // arithmeticVaries.yaml:20 Checker
    vec2 specular_checker_1 = stripes2(fract(uv * vec2(4.0)), max(abs(uvByY * vec2(4.0)), abs(uvByX * vec2(4.0))));
    float specular_checker = mix(0.3, 0.1, 0.5 - specular_checker_1.y * specular_checker_1.x * 0.5);
    // arithmeticVaries.yaml:19 Clamp
    float specular_clamped = min(max(specular_checker, diffuse_leopard), specular_expression);
    uint specular_bits = rootBits(specular_clamped, 6);
    uint surface_bits2 = specular_bits | specular_bits << 6 | rootBits(transparency.y, 5) << 12 | rootBits(transparency.z, 5) << 17;
    float expression5_2 = -expression_1 * 0.5;
    float remap_3 = (contrast - 0.1) / remap;
    float remap_4 = expression2_1 * 0.5 * contrast_1 + expression2_1 * expression_1 * expression4 - remap_3 * -expression3_1;
    float remap_5 = (expression5_1 * expression3_1 - expression5_2) * expression4 + expression5_2 - remap_3 * -expression5_1;
    float bumpMap_3 = (remap_5 / remap * remap_2 + remap_3 * (dot(localTangentV, vec3(0.3, 0.2, 0.1)) - expression5_1)) * 0.02;
    vec3 bumpMap_4 = (remap_4 / remap * remap_2 + remap_3 * dot(localTangentU, vec3(0.3, 0.2, 0.1))) * 0.02 * worldTangentV;
    vec3 bumpMap_5 = cross(bumpMap_1, bumpMap_4 - bumpMap_3 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_5 : bumpMap_5;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 4227858434u, sharedExponentBits(emissive_power, 5), surface_bits | specular_bits << 21 | rootBits(transparency.x, 5) << 27, surface_bits2 | 645922816u);
}
