#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec3 localPosition;
in vec3 localTangentU;
in vec3 localTangentV;
uniform float rusting;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

// Splits p + rest into an integer cell, modulo 65536, and a fraction in [0, 1). Exact.
void latticeCell(vec3 p, vec3 rest, out vec3 cell, out vec3 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec3 over = floor(d);
    d -= over;
    cell = cell - 65536.0 * floor(cell * (1.0 / 65536.0)) + over;
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

// Values and gradients of a face's four corners, times 2^31: the hash shifted left by 0, 7, 14, 21,
// read as signed.
void latticeNumbers(uvec4 hash, out vec4 value, out vec4 x, out vec4 y, out vec4 z) {
    value = vec4(ivec4(hash));
    x = vec4(ivec4(hash << 7u));
    y = vec4(ivec4(hash << 14u));
    z = vec4(ivec4(hash << 21u));
}

// Gradient (xyz) and value (w) of the interpolation of eight hashed corners, before latticeScale.
vec4 latticeRise(uvec4 low, uvec4 high, vec3 d) {
    vec4 v0, x0, y0, z0, v1, x1, y1, z1;
    latticeNumbers(low, v0, x0, y0, z0);
    latticeNumbers(high, v1, x1, y1, z1);
    vec4 dx = vec4(d.x, d.x - 1.0, d.x, d.x - 1.0);
    vec4 dy = vec4(d.yy, d.yy - 1.0);
    vec4 t0 = 0.5 * v0 + x0 * dx + y0 * dy + z0 * d.z;
    vec4 t1 = 0.5 * v1 + x1 * dx + y1 * dy + z1 * (d.z - 1.0);
    vec3 s = d * d * (3.0 - 2.0 * d);
    vec3 rise = 6.0 * d * (1.0 - d);
    vec4 plane = mix(t0, t1, s.z);
    vec2 line = mix(plane.xy, plane.zw, s.y);
    vec2 across = mix(plane.xz, plane.yw, s.x);
    vec2 depth = mix((t1 - t0).xy, (t1 - t0).zw, s.y);
    return vec4(latticeMix(x0, x1, d) + rise.x * (line.y - line.x),
                latticeMix(y0, y1, d) + rise.y * (across.y - across.x),
                latticeMix(z0, z1, d) + rise.z * mix(depth.x, depth.y, s.x), mix(line.x, line.y, s.x));
}

// Scales a signed 32-bit hash to [-1, 1].
const float latticeScale = 1.0 / 2147483648.0;

// Gradient (xyz) and value (w) of lattice(cell, d). Error 2e-6.
vec4 latticeSlope(vec3 cell, vec3 d) {
    uvec4 low, high;
    latticeCorners(cell, low, high);
    return latticeRise(low, high, d) * latticeScale;
}

// Gradient (xyz) and value (w) of noise(p + rest); the gradient is 0 where noise is clamped.
vec4 noiseSlope(vec3 p, vec3 rest) {
    vec3 cell, d;
    latticeCell(p, rest, cell, d);
    vec4 slope = 2.0 * latticeSlope(cell, d);
    return abs(slope.w) < 1.0 ? slope : vec4(0.0, 0.0, 0.0, sign(slope.w));
}

// Measured: mean and variance of noise, mean of |noise|, and its frequency relative to lattice
// noise.
const float noiseMean = 0.0;
const float noiseVariance = 0.25;
const float noiseMagnitude = 0.412;
const float noiseGrain = 1.0;

// Sum of the octaves' means: 0, because the noise's mean is 0.
float octaveMean(int count, float noiseRatio) {
    return 0.0;
}

// Fraction of a noise octave that the mean over a square of edge `width` (periods) loses. The
// least-squares factor is 1 / (1 + q), q = 0.383 w^2 + 0.0467 w^4, fitted to 0.02; 1.43 / (1 + q) -
// 0.43 remains, so an octave is dropped at 2 periods. Exactly 0 for width 0, accurate for narrow
// squares; min() avoids overflow.
float octaveLoss(float width) {
    float periods = min(width, 64.0) * noiseGrain;
    float w = periods * periods;
    float q = w * (0.383 + 0.0467 * w);
    return min(1.43 * q / (1.0 + q), 1.0);
}

// Fraction of a noise octave that remains in the mean over a square of edge `width` (periods); 1
// for 0.
float octaveShare(float width) {
    return 1.0 - octaveLoss(width);
}

// Gradient by p (xyz) and value (w) of turbulenceFiltered(p, rest, ...). Error 5e-6 times the sum
// of noiseRatio^k frequencyRatio^k.
vec4 turbulenceGradient(vec3 p, vec3 rest, int octaves, float frequencyRatio, float noiseRatio, float width) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    float frequency = 1.0;
    vec4 sum = vec4(0.0, 0.0, 0.0, octaveMean(count, noiseRatio));
    for (int k = 0; k < count; k++) {
        float share = octaveShare(width);
        if (share <= 0.0 && abs(frequencyRatio) >= 1.0) break;
        vec4 octave = noiseSlope(p, rest);
        sum += strength * share * vec4(frequency * octave.xyz, octave.w - noiseMean);
        strength *= noiseRatio;
        frequency *= frequencyRatio;
        p *= frequencyRatio;
        rest *= frequencyRatio;
        width *= abs(frequencyRatio);
    }
    return sum;
}

// Fraction of an octave of |noise| that the mean over a square loses, see octaveLoss: q = 1.08 w^2
// + 0.19 w^4; 1 at 1.4 periods.
float magnitudeLoss(float width) {
    float periods = min(width, 64.0) * noiseGrain;
    float w = periods * periods;
    float q = w * (1.08 + 0.19 * w);
    return min(1.35 * q / (1.0 + q), 1.0);
}

// Fraction of |noise| that the mean over a square keeps.
float magnitudeShare(float width) {
    return 1.0 - magnitudeLoss(width);
}

// Gradient by p (xyz) and value (w) of graniteFiltered(p, rest, width). Error 1e-4.
vec4 graniteGradient(vec3 p, vec3 rest, float width) {
    float frequency = 4.0;
    float strength = 1.0;
    vec4 sum = vec4(0.0, 0.0, 0.0, (noiseMagnitude - 0.5) * (63.0 / 32.0));
    for (int k = 0; k < 6; k++) {
        float share = magnitudeShare(frequency * width);
        if (share <= 0.0) break;
        vec4 octave = noiseSlope(frequency * p, frequency * rest);
        octave *= octave.w < 0.0 ? -1.0 : 1.0;
        sum += strength * share * vec4(frequency * octave.xyz, octave.w - noiseMagnitude);
        strength *= 0.5;
        frequency *= 2.0;
    }
    return sum;
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
    // rustedMetal.yaml:17 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    // rustedMetal.yaml:6 mask
    vec4 mask_1 = turbulenceGradient(localPosition * 1.7, vec3(0.0), 6, 2.0, 0.6, 0.0);
    // rustedMetal.yaml:7 scale
    vec4 scale = graniteGradient(localPosition * 2.0, vec3(0.0), 0.0);
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    float mask = mask_1.w + rusting;
    // rustedMetal.yaml:9 rustTones
    vec3 rustTones = mix(mix(vec3(0.051269457, 0.011612245, 0.004024717), vec3(0.2541521, 0.051269457, 0.008023193), clamp((scale.w + 0.5) * 1.6666666, 0.0, 1.0)), vec3(0.52099556, 0.19461784, 0.035601314), clamp((scale.w - 0.1) * 2.0, 0.0, 1.0));
    // rustedMetal.yaml:24 Blend
    float diffuse_blend_1 = clamp((mask + 0.05) * 6.6666665, 0.0, 1.0);
    // rustedMetal.yaml:21 Blend
    float blend = mix(0.2, 1.0, clamp((scale.w + 1.0) * 0.5, 0.0, 1.0));
    // rustedMetal.yaml:20 Blend
    float blend2 = clamp((mask + 0.1) * 5.0, 0.0, 1.0);
    // rustedMetal.yaml:28 Blend
    vec3 specular_blend = mix(vec3(0.2663556, 0.28744084, 0.31854677), vec3(0.02), diffuse_blend_1);
    float shininess = phongExponent(mix(0.75, 0.1, diffuse_blend_1));
    uint surface_bits = rootBits(specular_blend.y, 8) | rootBits(specular_blend.z, 8) << 8 | logarithmBits(shininess, 10) << 21;
    float blend_1 = step(scale.w, 1.0) * step(-1.0, scale.w) * 0.4;
    vec3 diffuse_blend = mix(vec3(0.08021982, 0.093058966, 0.10946171), rustTones, diffuse_blend_1);
    float blend2_2 = blend * 5.0 * (step(mask, 0.1) * step(-0.1, mask));
    uint surface_bits2 = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    float blend2_3 = blend_1 * dot(scale.xyz, localTangentU * 2.0) * blend2 + blend2_2 * dot(mask_1.xyz, localTangentU * 1.7);
    float blend2_4 = blend_1 * dot(scale.xyz, localTangentV * 2.0) * blend2 + blend2_2 * dot(mask_1.xyz, localTangentV * 1.7);
    vec3 bumpMap_3 = cross(bumpMap_1, blend2_3 * 0.05 * worldTangentV - blend2_4 * 0.05 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_3 : bumpMap_3;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits2 | rootBits(specular_blend.x, 8) << 24, surface_bits);
}
