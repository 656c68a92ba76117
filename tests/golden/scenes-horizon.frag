#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 localPosition;
in vec3 localTangentU;
in vec3 localTangentV;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

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

// Sum of octaves noiseRatio^k noise(frequencyRatio^k p), k from 0; at least one. Signed, not
// normalized. Error of noise times the sum of amplitudes if frequencyRatio is a power of two; other
// ratios round p.
float turbulence(vec3 p, int octaves, float frequencyRatio, float noiseRatio) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    float sum = 0.0;
    for (int k = 0; k < count; k++) {
        sum += strength * noise(p);
        strength *= noiseRatio;
        p *= frequencyRatio;
    }
    return sum;
}

// Splits p + rest into an integer cell, modulo 65536, and a fraction in [0, 1). Exact.
void latticeCell(vec3 p, vec3 rest, out vec3 cell, out vec3 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec3 over = floor(d);
    d -= over;
    cell = cell - 65536.0 * floor(cell * (1.0 / 65536.0)) + over;
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

// Quantizes v, clamped to [0, 1], to `bits` <= 16 bits, rounding to nearest.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// Quantizes sqrt(v), v clamped to [0, 1], to `bits` bits: finer steps near 0, like perceived
// lightness.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
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
    vec3 worldNormalByX = dFdx(worldNormal);
    vec3 worldNormalByY = dFdy(worldNormal);
    // horizon.yaml:14 grain
    float grain = turbulence(localPosition * 12.0, 5, 2.0, 0.6);
    // horizon.yaml:20 meadow
    float meadow_1 = grain + 0.5;
    vec3 meadow = mix(vec3(0.046665087, 0.06847817, 0.015996294), vec3(0.18447499, 0.17788842, 0.045186203), clamp(meadow_1, 0.0, 1.0));
    // horizon.yaml:16 rock
    vec3 rock = mix(mix(vec3(0.10224173, 0.08228271, 0.064803265), vec3(0.25818285, 0.21223076, 0.16202937), clamp(meadow_1 * 1.6666666, 0.0, 1.0)), vec3(0.39157248, 0.3277781, 0.24620132), clamp((grain - 0.1) * 2.5, 0.0, 1.0));
    // horizon.yaml:13 mountains
    vec4 mountains = turbulenceGradient(localPosition * 0.35, vec3(0.0), 8, 2.0, 0.46, 0.0);
    float normal_1 = uvByY.y * uvByX.x - uvByY.x * uvByX.y;
    bool normal_2 = abs(normal_1) < 1e-30;
    float normal_3 = normal_2 ? 0.0 : 1.0 / (normal_2 ? 1.0 : normal_1);
    vec3 normal_4 = (uvByY.y * worldNormalByX - uvByX.y * worldNormalByY) * normal_3;
    float normal_5 = 1.0 / max(length(worldNormal), 1e-30);
    vec3 normal_6 = normal_5 * worldNormal;
    vec3 normal_7 = (uvByX.x * worldNormalByY - uvByY.x * worldNormalByX) * normal_3;
    // horizon.yaml:26 Remap
    float remap = (mountains.w + 1.0) * 0.5;
    // horizon.yaml:26 Power
    float power_1 = max(remap, 1e-37);
    float power_2 = min(power_1, 6.3095734e+14);
    float power = pow(power_2, 2.5);
    float normal_8 = power * 1.8;
    float power_3 = step(1e-37, remap);
    float power_4 = step(power_1, 6.3095734e+14);
    float power_5 = min(power, 1e+18) / max(power_2, 1e-18) * 2.5;
    vec3 normal_9 = normal_8 * ((normal_4 - dot(normal_6, normal_4) * normal_6) * normal_5) + worldTangentU;
    vec3 normal_10 = normal_8 * ((normal_7 - dot(normal_6, normal_7) * normal_6) * normal_5) + worldTangentV;
    float normal_11 = dot(mountains.xyz, localTangentU * 0.35) * 0.5 * power_3 * power_4 * power_5 * 1.8;
    float normal_12 = dot(mountains.xyz, localTangentV * 0.35) * 0.5 * power_3 * power_4 * power_5 * 1.8;
    vec3 normal_13 = cross(normal_6, normal_11 * normal_10 - normal_12 * normal_9) + cross(normal_9, normal_10);
    vec3 normal_14 = safeNormalize(eyeFromWorld(dot(cross(worldTangentU, worldTangentV), normal_6) < 0.0 ? -normal_13 : normal_13));
    vec3 normal = normal_14 * (gl_FrontFacing ? 1.0 : -1.0);
    // horizon.yaml:29 Blend
    vec3 diffuse_blend = mix(mix(meadow, rock, clamp((mountains.w + 0.2) * 5.0, 0.0, 1.0)), vec3(0.6866853, 0.7230551, 0.7912979), clamp((mountains.w - 0.32) * 8.333333, 0.0, 1.0));
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits, 645922816u);
}
