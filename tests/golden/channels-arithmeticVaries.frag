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

// Component-wise sine. Error of sin().
vec3 sine3(vec3 x) {
    return sin(x);
}

// Component-wise sin(x) / x, x >= 0; 1 - x^2 / 6 near 0 avoids loss of digits. Error 3e-7.
vec3 sinc(vec3 x) {
    vec3 near = 1.0 - x * x * (1.0 / 6.0);
    vec3 far = sine3(x) / max(x, 1.0e-2);
    return mix(far, near, step(x, vec3(1.0e-2)));
}

// Mean of leopard over a box around p: (sum of sin)^2 / 9 from the means of sin and sin^2, exact
// for independent axes. Error 4.3e-7 if sin and cos err by 1e-7.
float leopardFiltered(vec3 p, vec3 edge) {
    vec3 sine = sine3(p);
    vec3 mean = sine * sinc(0.5 * edge);
    vec3 square = 0.5 - (0.5 - sine * sine) * sinc(edge);
    float sum = mean.x + mean.y + mean.z;
    return max(sum * sum + dot(square - mean * mean, vec3(1.0)), 0.0) * (1.0 / 9.0);
}

// Distance from the z axis, coordinates clamped to 1e37 and scaled so that no square over- or
// underflows. Relative error 2e-7.
float wood(vec3 p) {
    vec2 a = min(abs(p.xy), 1.0e37);
    float greater = max(max(a.x, a.y), 1.0e-37);
    return greater * length(a / greater);
}

// Bijective hash finalizer, two xorshift-multiply rounds: the top bits of every shifted hash are
// well mixed.
uvec4 latticeFinal(uvec4 h) {
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}

// Hashes of a cell's eight corners, in latticeMix's order: xor of products, then a finalizer. The
// wrap to [0, 65536) is exact for every finite cell.
void latticeCorners(vec3 cell, out uvec4 low, out uvec4 high) {
    const uvec3 factor = uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uvec3 c = uvec3(ivec3(cell - 65536.0 * floor(cell * (1.0 / 65536.0))));
    uvec3 c0 = c * factor;
    uvec3 c1 = ((c + 1u) & 65535u) * factor;
    uvec4 square = uvec4(c0.x, c1.x, c0.x, c1.x) ^ uvec4(c0.yy, c1.yy);
    low = latticeFinal(square ^ (c0.z + 0x165667B1u));
    high = latticeFinal(square ^ (c1.z + 0x165667B1u));
}

// Mixes eight corner terms with weights 3d^2 - 2d^3. Order: (x, y) = (0,0) (1,0) (0,1) (1,1), z = 0
// in `low` and 1 in `high`.
float latticeMix(vec4 low, vec4 high, vec3 d) {
    vec3 s = d * d * (3.0 - 2.0 * d);
    vec4 plane = mix(low, high, s.z);
    vec2 line = mix(plane.xy, plane.zw, s.y);
    return mix(line.x, line.y, s.x);
}

// Scales a signed 32-bit hash to [-1, 1].
const float latticeScale = 1.0 / 2147483648.0;

// Value plus gradient terms of a face's four corners, times 2^31; d is the offset from the first
// corner. The numbers are the hash shifted left by 0, 7, 14, 21, read as signed: uniform, symmetric
// to 2^-11.
vec4 latticeTerms(uvec4 hash, vec3 d) {
    vec4 dx = vec4(d.x, d.x - 1.0, d.x, d.x - 1.0);
    vec4 dy = vec4(d.yy, d.yy - 1.0);
    return 0.5 * vec4(ivec4(hash)) + vec4(ivec4(hash << 7u)) * dx + vec4(ivec4(hash << 14u)) * dy
         + vec4(ivec4(hash << 21u)) * d.z;
}

// Lattice noise at position d in [0, 1) in a cell: hashed value and gradient per corner, smoothly
// interpolated. About [-1, 1], standard deviation 1/4, period 65536 per axis. Error 1e-6.
float lattice(vec3 cell, vec3 d) {
    uvec4 low, high;
    latticeCorners(cell, low, high);
    return latticeMix(latticeTerms(low, d), latticeTerms(high, d - vec3(0.0, 0.0, 1.0)), d) * latticeScale;
}

// Noise in [-1, 1], standard deviation 1/2. About 1 sample in 20 is clamped. Error 2e-6, also for
// simplex noise.
float noise(vec3 p) {
    vec3 cell = floor(p);
    return clamp(2.0 * lattice(cell, p - cell), -1.0, 1.0);
}

// Six octaves of |noise(4 2^k p)| - 1/2 with amplitudes 2^-k; in [-63/64, 63/64]. Error 4e-6.
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

// Quantizes v, clamped to [0, 1], to `bits` <= 16 bits, rounding to nearest.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// Quantizes sqrt(v), v clamped to [0, 1], to `bits` bits: finer steps near 0, like perceived
// lightness.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
}

// Box-filtered square waves for edge < 1/2, component-wise: 1 for q in [0, 1/2), -1 in [1/2, 1); q
// in [0, 1]. From the distance to the nearest transition, without cancellation: error 1e-7 at any
// width. An edge <= 1e-6 gives the point value; a transition belongs to its upper side.
vec2 stripesNear2(vec2 q, vec2 edges) {
    vec2 side = 1.0 - 2.0 * step(0.5, q);
    vec2 distance = min(min(q, 1.0 - q), abs(q - 0.5));
    return side * max(min(2.0 * distance / max(edges, 1.0e-6), 1.0), step(edges, vec2(1.0e-6)));
}

// Box-filtered square waves of period 1, component-wise: 1 for q in [0, 1/2), -1 in [1/2, 1); q in
// [0, 1]. For edge >= 1/2 from the antiderivative. Error 2e-7.
vec2 stripes2(vec2 q, vec2 edges) {
    vec2 low = abs(fract(q - 0.5 * edges) - 0.5);
    vec2 high = abs(fract(q + 0.5 * edges) - 0.5);
    return mix(stripesNear2(q, edges), (low - high) / max(edges, 0.5), step(0.5, edges));
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
