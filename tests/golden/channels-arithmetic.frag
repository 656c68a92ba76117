#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 localPosition;
in vec3 localTangentU;
in vec3 localTangentV;
uniform float harder;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

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

// ((sin x + sin y + sin z) / 3)^2, in [0, 1]. Error of sin(): 3e-7 on llvmpipe up to 1e6; GLSL has
// no bound.
float leopard(vec3 p) {
    float mean = dot(sin(p), vec3(1.0 / 3.0));
    return mean * mean;
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

// Gradient (xyz) and value (w) of leopard. Error 4.3e-7 if sin and cos err by 1e-7.
vec4 leopardGradient(vec3 p) {
    float mean = dot(sin(p), vec3(1.0 / 3.0));
    return vec4(cos(p) * (mean * (2.0 / 3.0)), mean * mean);
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
    // arithmetic.yaml:6 Checker
    vec2 diffuse_checker = fract(uv);
    vec2 diffuse_checker_2 = stripes2(diffuse_checker, max(abs(uvByY), abs(uvByX)));
    // arithmetic.yaml:7 Checker
    float diffuse_checker2 = 0.5 - diffuse_checker_2.y * diffuse_checker_2.x * 0.5;
    // arithmetic.yaml:7 Leopard
    float diffuse_leopard = leopard(mix(vec3(1.0), vec3(2.0, 3.0, 4.0), diffuse_checker2));
    // arithmetic.yaml:7 Clamp
    float diffuse_clamped = min(max(diffuse_leopard, 0.3), 0.8);
    // arithmetic.yaml:9 Clamp
    float emissive_clamped = min(max(granite(localPosition), 0.25), 0.5);
    // arithmetic.yaml:13 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    // arithmetic.yaml:13 Leopard
    vec4 leopard2 = leopardGradient(localPosition);
    // arithmetic.yaml:13 Leopard
    vec4 leopard3 = leopardGradient(localPosition * 2.0);
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // arithmetic.yaml:8 Checker
    float specular_checker = (0.5 <= diffuse_checker.x) != (0.5 <= diffuse_checker.y) ? 1.0 : 0.0;
    // arithmetic.yaml:13 Add
    float sum = leopard2.w + 1.0;
    // arithmetic.yaml:13 Power
    float power_1 = max(sum, 1e-37);
    float power_2 = step(1e-37, sum);
    // arithmetic.yaml:12 Remap
    float shininess_remap = sum * 0.23333333 + 0.1;
    // arithmetic.yaml:6 Contrast
    float diffuse_contrast = (mix(0.7, 0.1, diffuse_checker2) - 0.5) * harder + 0.5;
    // arithmetic.yaml:4 Mix
    vec4 diffuse_mix = mix(vec4(0.2, 0.4, 0.3, 1.0), vec4(vec3(diffuse_contrast), 1.0), diffuse_clamped);
    uint surface_bits = rootBits(diffuse_mix.x, 6) | rootBits(diffuse_mix.y, 6) << 6 | rootBits(diffuse_mix.z, 6) << 12;
    float power = power_1 * power_1;
    float power_3 = power_2 * dot(leopard2.xyz, localTangentU) * power_1;
    float power_4 = power_2 * dot(leopard2.xyz, localTangentV) * power_1;
    // arithmetic.yaml:8 Power
    vec3 specular_power = pow(max(vec3(0.2, leopard2.w, specular_checker), 1e-37), vec3(1.5));
    uint surface_bits2 = rootBits(specular_power.z, 5) | 65536u | 1048576u | 16777216u | logarithmBits(phongExponent(shininess_remap), 7) << 25;
    float bumpMap_3 = (power * dot(leopard3.xyz, localTangentU * 2.0) + (power_3 + power_3) * leopard3.w) * 0.02;
    float bumpMap_4 = (power * dot(leopard3.xyz, localTangentV * 2.0) + (power_4 + power_4) * leopard3.w) * 0.02;
    vec3 bumpMap_5 = cross(bumpMap_1, bumpMap_3 * worldTangentV - bumpMap_4 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_5 : bumpMap_5;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 4227858435u, sharedExponentBits(vec3(emissive_clamped), 5) | 2290089984u, surface_bits | rootBits(specular_power.y, 5) << 23 | 2359296u, surface_bits2);
}
