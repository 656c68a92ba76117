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

// Box-filtered square waves for edge < 1/2, component-wise: 1 for q in [0, 1/2), -1 in [1/2, 1); q
// in [0, 1]. From the distance to the nearest transition, without cancellation: error 1e-7 at any
// width. An edge <= 1e-6 gives the point value; a transition belongs to its upper side.
vec3 stripesNear3(vec3 q, vec3 edges) {
    vec3 side = 1.0 - 2.0 * step(0.5, q);
    vec3 distance = min(min(q, 1.0 - q), abs(q - 0.5));
    return side * max(min(2.0 * distance / max(edges, 1.0e-6), 1.0), step(edges, vec3(1.0e-6)));
}

// Box-filtered square waves of period 1, component-wise: 1 for q in [0, 1/2), -1 in [1/2, 1); q in
// [0, 1]. For edge >= 1/2 from the antiderivative. Error 2e-7.
vec3 stripes3(vec3 q, vec3 edges) {
    vec3 low = abs(fract(q - 0.5 * edges) - 0.5);
    vec3 high = abs(fract(q + 0.5 * edges) - 0.5);
    return mix(stripesNear3(q, edges), (low - high) / max(edges, 0.5), step(0.5, edges));
}

// Derivative of stripes3 by q: the waves' difference between the box's ends over the edge; for edge
// < 1/2 from the transition in the box, if any. An edge <= 1e-6 gives 0. Relative error 1.2e-7.
vec3 stripesRate3(vec3 q, vec3 edges) {
    vec3 high = step(0.5, fract(q + 0.5 * edges));
    vec3 low = step(0.5, fract(q - 0.5 * edges));
    vec3 middle = abs(q - 0.5);
    vec3 holds = step(2.0 * min(min(q, 1.0 - q), middle), edges) * step(1.0e-6, edges);
    vec3 near = holds * (2.0 * step(0.25, middle) - 1.0);
    return mix(near, low - high, step(0.5, edges)) * 2.0 / max(edges, 1.0e-6);
}

// Box-filtered ramp 2 fract(v) - 1. For edge < 1/2 from the distance to the jump, without
// cancellation, else from the antiderivative. Error 2e-7. An edge <= 1e-6 gives the point value.
float rampMean(float v, float edge) {
    float t = fract(v);
    float distance = v - floor(v + 0.5); // fract() rounds just below a whole number
    float near = 2.0 * distance - clamp(2.0 * distance / max(edge, 1.0e-6), -1.0, 1.0);
    float a = fract(t - 0.5 * edge);
    float b = fract(t + 0.5 * edge);
    float far = (b * (b - 1.0) - a * (a - 1.0)) / max(edge, 0.25);
    return edge <= 1.0e-6 ? 2.0 * t - 1.0 : edge < 0.5 ? near : far;
}

// Derivative of rampMean by v: for edge < 1/2, 2 minus the jump over the edge if the box has the
// jump; else the wave's difference between the box's ends over the edge. An edge <= 1e-6 gives the
// point's derivative. Error 2.4e-7 max(1, |rate|).
float rampRate(float v, float edge) {
    float t = fract(v);
    float distance = abs(v - floor(v + 0.5));
    float jump = 2.0 * distance < edge && edge > 1.0e-6 ? 2.0 / max(edge, 1.0e-6) : 0.0;
    float far = 2.0 * (fract(t + 0.5 * edge) - fract(t - 0.5 * edge)) / max(edge, 0.25);
    return edge < 0.5 ? 2.0 - jump : far;
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
    vec3 localPositionByX = dFdx(localPosition);
    vec3 localPositionByY = dFdy(localPosition);
    vec3 worldNormalByX = dFdx(worldNormal);
    vec3 worldNormalByY = dFdy(worldNormal);
    // displaced.yaml:12 wall
    vec3 wall = localPosition * vec3(2.5, 2.5, 6.0);
    vec3 wall_1 = localPositionByX * vec3(2.5, 2.5, 6.0);
    vec3 wall_2 = localPositionByY * vec3(2.5, 2.5, 6.0);
    // displaced.yaml:16 bond
    vec3 bond = wall_1 * vec3(0.0, 0.0, 1.0) * 0.5;
    vec3 bond_2 = wall_2 * vec3(0.0, 0.0, 1.0) * 0.5;
    vec3 bond_3 = fract(wall * vec3(0.0, 0.0, 1.0) * 0.5);
    // displaced.yaml:33 sand
    vec4 sand = turbulenceGradient(localPosition * 22.0, vec3(0.0), 3, 2.0, 0.7, 0.0);
    vec3 bond_4 = max(abs(bond_2), abs(bond));
    vec3 bond_5 = stripes3(bond_3, bond_4);
    float bond_6 = bond_5.y * bond_5.x;
    float bond_7 = 0.5 - bond_5.z * bond_6 * 0.5;
    float bond_8 = 1.0 - bond_7;
    float bond_9 = stripesRate3(bond_3, bond_4).z;
    // displaced.yaml:20 along
    float along_1 = wall.x + 0.5;
    float along_2 = mix(along_1, wall.x, bond_7);
    float along_3 = wall.x - along_1;
    float along_4 = along_3 * -(bond.z * bond_9 * bond_6 * 0.5) + (wall_1.x * bond_8 + wall_1.x * bond_7);
    float along_5 = along_3 * -(bond_2.z * bond_9 * bond_6 * 0.5) + (wall_2.x * bond_8 + wall_2.x * bond_7);
    float along_6 = sqrt(along_5 * along_5 + along_4 * along_4);
    float along = rampMean(along_2, along_6);
    // displaced.yaml:21 up
    float up_1 = sqrt(wall_2.z * wall_2.z + wall_1.z * wall_1.z);
    float up = rampMean(wall.z, up_1);
    // displaced.yaml:49 Blend
    float blend;
    float blend_1;
    float blend_2;
    if (up < -0.86) {
        blend = 0.0;
        blend_1 = 0.0;
        blend_2 = 0.0;
    } else {
        vec3 wall_3 = localTangentU * vec3(2.5, 2.5, 6.0);
        vec3 wall_4 = localTangentV * vec3(2.5, 2.5, 6.0);
        // displaced.yaml:51 side
        float side;
        float side_1;
        float side_2;
        if (along < -0.94) {
            side = 0.0;
            side_1 = 0.0;
            side_2 = 0.0;
        } else {
            vec3 bond_10 = stripes3(fract(bond_3 + vec3(0.0, 0.0, 0.05)), bond_4);
            float bond_11 = (0.5 - bond_10.z * (bond_10.y * bond_10.x) * 0.5 - bond_7) * 20.0;
            // displaced.yaml:44 face
            float face = mix(0.9, 1.1, clamp((sand.w + 1.0) * 0.5, 0.0, 1.0));
            float side_3 = -face;
            float face_1 = step(sand.w, 1.0) * step(-1.0, sand.w) * 0.1;
            float face_2 = face_1 * dot(sand.xyz, localTangentU * 22.0);
            float face_3 = face_1 * dot(sand.xyz, localTangentV * 22.0);
            bool side_4 = along <= 0.94;
            float side_5 = (along - 0.86) * 12.5;
            bool side_6 = along < 0.86;
            float side_7 = (along + 0.86) * 0.5813953;
            bool side_8 = along < -0.86;
            float side_9 = (along + 0.94) * 12.5;
            float along_7 = rampRate(along_2, along_6);
            float side_10 = 1.0 - side_7;
            float side_11 = 1.0 - side_5;
            float along_8 = along_3 * (wall_3.z * 0.5 * bond_11) + (wall_3.x * bond_8 + wall_3.x * bond_7);
            float side_12 = along_8 * along_7 * 12.5;
            float along_9 = along_3 * (wall_4.z * 0.5 * bond_11) + (wall_4.x * bond_8 + wall_4.x * bond_7);
            float side_13 = along_9 * along_7 * 12.5;
            float side_14 = side_6 ? side_7 * face_2 + side_10 * face_2 : side_4 ? side_12 * side_3 + side_11 * face_2 : 0.0;
            float side_15 = side_6 ? side_7 * face_3 + side_10 * face_3 : side_4 ? side_13 * side_3 + side_11 * face_3 : 0.0;
            side = side_8 ? side_9 * face : side_6 ? face : side_4 ? mix(face, 0.0, side_5) : 0.0;
            side_1 = side_8 ? side_12 * face + side_9 * face_2 : side_14;
            side_2 = side_8 ? side_13 * face + side_9 * face_3 : side_15;
        }
        bool blend_3 = up <= 0.86;
        float blend_4 = (up - 0.7) * 6.25;
        bool blend_5 = up < 0.7;
        float blend_6 = (up + 0.7) * 0.71428573;
        bool blend_7 = up < -0.7;
        float blend_8 = (up + 0.86) * 6.25;
        float up_2 = rampRate(wall.z, up_1);
        float blend_9 = 1.0 - blend_6;
        float blend_10 = 1.0 - blend_4;
        float blend_11 = wall_3.z * up_2 * 6.25;
        float blend_12 = wall_4.z * up_2 * 6.25;
        float blend_13 = -side;
        float blend_14 = blend_5 ? side_1 * blend_6 + side_1 * blend_9 : blend_3 ? side_1 * blend_10 + blend_13 * blend_11 : 0.0;
        float blend_15 = blend_5 ? side_2 * blend_6 + side_2 * blend_9 : blend_3 ? side_2 * blend_10 + blend_13 * blend_12 : 0.0;
        blend = blend_7 ? side * blend_8 : blend_5 ? side : blend_3 ? mix(side, 0.0, blend_4) : 0.0;
        blend_1 = blend_7 ? side_1 * blend_8 + side * blend_11 : blend_14;
        blend_2 = blend_7 ? side_2 * blend_8 + side * blend_12 : blend_15;
    }
    float normal_1 = uvByY.y * uvByX.x - uvByY.x * uvByX.y;
    bool normal_2 = abs(normal_1) < 1e-30;
    float normal_3 = normal_2 ? 0.0 : 1.0 / (normal_2 ? 1.0 : normal_1);
    vec3 normal_4 = (uvByY.y * worldNormalByX - uvByX.y * worldNormalByY) * normal_3;
    float normal_5 = 1.0 / max(length(worldNormal), 1e-30);
    vec3 normal_6 = normal_5 * worldNormal;
    vec3 normal_7 = (uvByX.x * worldNormalByY - uvByY.x * worldNormalByX) * normal_3;
    // displaced.yaml:58 Blend
    float diffuse_blend_1 = clamp((up + 0.83) * 14.285714, 0.0, 1.0);
    float diffuse_blend_2 = clamp((up + 0.76) * 0.65789473, 0.0, 1.0);
    float diffuse_blend_3 = clamp((up - 0.76) * 14.285714, 0.0, 1.0);
    // displaced.yaml:35 mortar
    vec3 mortar = mix(vec3(0.2746773, 0.24620132, 0.20155625), vec3(0.48514995, 0.43965718, 0.3662526), clamp(sand.w + 0.5, 0.0, 1.0));
    float normal_8 = blend * 0.04;
    vec3 normal_9 = normal_8 * ((normal_4 - dot(normal_6, normal_4) * normal_6) * normal_5) + worldTangentU;
    vec3 normal_10 = normal_8 * ((normal_7 - dot(normal_6, normal_7) * normal_6) * normal_5) + worldTangentV;
    vec3 normal_11 = cross(normal_6, blend_1 * 0.04 * normal_10 - blend_2 * 0.04 * normal_9) + cross(normal_9, normal_10);
    vec3 normal_12 = safeNormalize(eyeFromWorld(dot(cross(worldTangentU, worldTangentV), normal_6) < 0.0 ? -normal_11 : normal_11));
    vec3 normal = normal_12 * (gl_FrontFacing ? 1.0 : -1.0);
    // displaced.yaml:63 lengths
    vec3 lengths;
    if (-0.83 < up && up < 0.83) {
        // displaced.yaml:39 clay
        vec3 clay;
        if (-0.93 < along && along < 0.93) {
            // displaced.yaml:31 Gradient
            float brick_gradient = floor(wall.z * 0.5 + 0.5);
            // displaced.yaml:42 VolumeTurbulence
            float clay_volumeTurbulence = turbulence(localPosition * 5.0, 11, 2.0, 0.5);
            // displaced.yaml:28 Gradient
            float brick_gradient2_1 = along_2 * 0.5 + 0.5;
            float brick_gradient2_2 = along_4 * 0.5;
            float brick_gradient2_3 = along_5 * 0.5;
            float brick_gradient2_4 = (rampMean(brick_gradient2_1, sqrt(brick_gradient2_3 * brick_gradient2_3 + brick_gradient2_2 * brick_gradient2_2)) + 1.0) * 0.5;
            float brick_gradient2 = brick_gradient2_1 - brick_gradient2_4;
            // displaced.yaml:24 brick
            vec3 brick = vec3(brick_gradient2) * vec3(0.85, 1.55, 2.65) + vec3(brick_gradient) * vec3(2.15, 0.55, 1.45);
            float clay_1 = clay_volumeTurbulence * 0.4 + turbulence(brick, 1, 2.0, 1.0) * 0.6;
            clay = mix(mix(vec3(0.15292615, 0.024157632, 0.011612245), vec3(0.3231432, 0.05612849, 0.02518686), clamp((clay_1 + 0.5) * 2.0, 0.0, 1.0)), vec3(0.50888133, 0.15592647, 0.064803265), clamp(clay_1 * 2.0, 0.0, 1.0));
        } else {
            clay = vec3(0.0);
        }
        lengths = mix(mix(mortar, clay, clamp((along + 0.93) * 25.0, 0.0, 1.0)), mortar, clamp((along - 0.89) * 25.0, 0.0, 1.0));
    } else {
        lengths = vec3(0.0);
    }
    vec3 diffuse_blend_4 = lengths * (diffuse_blend_2 - diffuse_blend_3) + (lengths * (diffuse_blend_1 - diffuse_blend_2) + mortar * (1.0 - diffuse_blend_1));
    vec3 diffuse_blend = diffuse_blend_4 + mortar * diffuse_blend_3;
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, surface_bits | 956301312u, 534788409u);
}
