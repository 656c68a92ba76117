#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec3 localPosition;
in vec3 localTangentU;
in vec3 localTangentV;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

// p + rest as a whole cell and a fraction in [0, 1). The cell is known modulo 65536 or exactly: both are exact.
void latticeCell(vec3 p, vec3 rest, out vec3 cell, out vec3 d) {
    cell = floor(p);
    d = p - cell + rest;
    vec3 over = floor(d);
    d -= over;
    cell = cell - 65536.0 * floor(cell * (1.0 / 65536.0)) + over;
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

// A corner's value and gradient, for the four of a face, times 2^31: its hash shifted left by 0, 7, 14, 21 and read as signed.
void latticeNumbers(uvec4 hash, out vec4 value, out vec4 x, out vec4 y, out vec4 z) {
    value = vec4(ivec4(hash));
    x = vec4(ivec4(hash << 7u));
    y = vec4(ivec4(hash << 14u));
    z = vec4(ivec4(hash << 21u));
}

// Gradient and value of the interpolation between eight corners, given by the hashes of both faces; before latticeScale.
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

// A hash read as a signed number is this much of 1.
const float latticeScale = 1.0 / 2147483648.0;

// Gradient of lattice(cell, d), then its value. Error 2e-6 in each lane.
vec4 latticeSlope(vec3 cell, vec3 d) {
    uvec4 low, high;
    latticeCorners(cell, low, high);
    return latticeRise(low, high, d) * latticeScale;
}

// Gradient of noise(p + rest), then its value; where the noise is clamped the gradient is 0.
vec4 noiseSlope(vec3 p, vec3 rest) {
    vec3 cell, d;
    latticeCell(p, rest, cell, d);
    vec4 slope = 2.0 * latticeSlope(cell, d);
    return abs(slope.w) < 1.0 ? slope : vec4(0.0, 0.0, 0.0, sign(slope.w));
}

// Of noise, measured: its mean and variance, the mean of its magnitude, and how much finer its grain is than that of lattice noise.
const float noiseMean = 0.0;
const float noiseVariance = 0.25;
const float noiseMagnitude = 0.412;
const float noiseGrain = 1.0;

// What all octaves add where they are finer than the pixel: the noise's mean is 0.
float octaveMean(int count, float noiseRatio) {
    return 0.0;
}

// How much of an octave of noise the mean over a square of a given edge loses, in periods of the octave. The best factor by least
// squares is 1 / (1 + q), q = 0.383 w^2 + 0.0467 w^4, measured and fitted to 0.02; of it is taken what makes it end at 2 periods, where
// an octave has little to do with its mean: 1.43 / (1 + q) - 0.43 are left, and these are lost. Exactly 0 for no width, and good to
// its last bits for a narrow one; a width of any size squares to a float.
float octaveLoss(float width) {
    float periods = min(width, 64.0) * noiseGrain;
    float w = periods * periods;
    float q = w * (0.383 + 0.0467 * w);
    return min(1.43 * q / (1.0 + q), 1.0);
}

// How much of an octave of noise is left in the mean over a square of a given edge; 1 for no width.
float octaveShare(float width) {
    return 1.0 - octaveLoss(width);
}

// Gradient by p of turbulenceFiltered(p, rest, ...), then its value. Error 5e-6 to the sum of noiseRatio^k frequencyRatio^k.
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

// Mean over boxes below 1/2 of waves that are 1 for q in [0, 1/2) and -1 in [1/2, 1), period 1; q in [0, 1]. From the distance to the
// nearest edge, which does not cancel: error 1e-7 at any width. A box of at most 1e-6 is the point, which at an edge belongs to the
// upper side.
vec3 stripesNear3(vec3 q, vec3 edges) {
    vec3 side = 1.0 - 2.0 * step(0.5, q);
    vec3 distance = min(min(q, 1.0 - q), abs(q - 0.5));
    return side * max(min(2.0 * distance / max(edges, 1.0e-6), 1.0), step(edges, vec3(1.0e-6)));
}

// Mean over boxes of waves that are 1 for q in [0, 1/2) and -1 in [1/2, 1), period 1; q in [0, 1]. For a box of 1/2 and more from the
// antiderivative. Error 2e-7.
vec3 stripes3(vec3 q, vec3 edges) {
    vec3 low = abs(fract(q - 0.5 * edges) - 0.5);
    vec3 high = abs(fract(q + 0.5 * edges) - 0.5);
    return mix(stripesNear3(q, edges), (low - high) / max(edges, 0.5), step(0.5, edges));
}

// Derivative of stripes3 by q: the difference of the waves at a box's ends over its edge; of a box below 1/2 the edge that it holds,
// if any. A box of at most 1e-6 is the point: 0. Relative error 1.2e-7.
vec3 stripesRate3(vec3 q, vec3 edges) {
    vec3 high = step(0.5, fract(q + 0.5 * edges));
    vec3 low = step(0.5, fract(q - 0.5 * edges));
    vec3 middle = abs(q - 0.5);
    vec3 holds = step(2.0 * min(min(q, 1.0 - q), middle), edges) * step(1.0e-6, edges);
    vec3 near = holds * (2.0 * step(0.25, middle) - 1.0);
    return mix(near, low - high, step(0.5, edges)) * 2.0 / max(edges, 1.0e-6);
}

// Mean of 2 fract(v) - 1 over a box. Below an edge of 1/2 from the distance to the jump, which does not cancel, above from the
// antiderivative: error 2e-7. A box of at most 1e-6 is the point.
float rampMean(float v, float edge) {
    float t = fract(v);
    float distance = v - floor(v + 0.5); // fract() rounds just below a whole number
    float near = 2.0 * distance - clamp(2.0 * distance / max(edge, 1.0e-6), -1.0, 1.0);
    float a = fract(t - 0.5 * edge);
    float b = fract(t + 0.5 * edge);
    float far = (b * (b - 1.0) - a * (a - 1.0)) / max(edge, 0.25);
    return edge <= 1.0e-6 ? 2.0 * t - 1.0 : edge < 0.5 ? near : far;
}

// Derivative of rampMean by v: 2, and below an edge of 1/2 the jump over the edge if the box holds it; above the difference of the
// wave at the box's ends over its edge. A box of at most 1e-6 is the point. Error 2.4e-7 to max(1, |rate|).
float rampRate(float v, float edge) {
    float t = fract(v);
    float distance = abs(v - floor(v + 0.5));
    float jump = 2.0 * distance < edge && edge > 1.0e-6 ? 2.0 / max(edge, 1.0e-6) : 0.0;
    float far = 2.0 * (fract(t + 0.5 * edge) - fract(t - 0.5 * edge)) / max(edge, 0.25);
    return edge < 0.5 ? 2.0 - jump : far;
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

// Sum of octaves noiseRatio^k noise(frequencyRatio^k p), k from 0; at least one. Signed and not normalised.
// Error that of noise, to the sum of the strengths, where frequencyRatio is a power of two; other ratios round p.
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

// v, taken to [0, 1], as the nearest of 2^bits equal steps, bits <= 16.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// The square root of v, taken to [0, 1], as the nearest of 2^bits equal steps: steps of v that shrink towards 0, as an eye's do.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
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

void main() {
    vec3 localPositionByX = dFdx(localPosition);
    vec3 localPositionByY = dFdy(localPosition);
    // brick.yaml:4 wall
    vec3 wall = localPosition * vec3(2.5, 2.5, 6.0);
    vec3 wall_1 = localPositionByX * vec3(2.5, 2.5, 6.0);
    // brick.yaml:8 bond
    vec3 bond = wall_1 * vec3(0.0, 0.0, 1.0) * 0.5;
    vec3 wall_2 = localPositionByY * vec3(2.5, 2.5, 6.0);
    vec3 bond_2 = wall_2 * vec3(0.0, 0.0, 1.0) * 0.5;
    vec3 bond_3 = fract(wall * vec3(0.0, 0.0, 1.0) * 0.5);
    // brick.yaml:25 sand
    vec4 sand = turbulenceGradient(localPosition * 22.0, vec3(0.0), 3, 2.0, 0.7, 0.0);
    vec3 bond_4 = max(abs(bond_2), abs(bond));
    vec3 bond_5 = stripes3(bond_3, bond_4);
    float bond_6 = bond_5.y * bond_5.x;
    float bond_7 = 0.5 - bond_5.z * bond_6 * 0.5;
    float bond_8 = 1.0 - bond_7;
    float bond_9 = stripesRate3(bond_3, bond_4).z;
    // brick.yaml:12 along
    float along_1 = wall.x + 0.5;
    float along_2 = mix(along_1, wall.x, bond_7);
    float along_3 = wall.x - along_1;
    float along_4 = along_3 * -(bond.z * bond_9 * bond_6 * 0.5) + (wall_1.x * bond_8 + wall_1.x * bond_7);
    float along_5 = along_3 * -(bond_2.z * bond_9 * bond_6 * 0.5) + (wall_2.x * bond_8 + wall_2.x * bond_7);
    float along_6 = sqrt(along_5 * along_5 + along_4 * along_4);
    float along = rampMean(along_2, along_6);
    // brick.yaml:13 up
    float up = fract(wall.z) * 2.0 - 1.0;
    // brick.yaml:42 Blend
    float blend;
    float blend_2;
    if (up < -0.86) {
        blend = 0.0;
        blend_2 = 0.0;
    } else {
        vec3 wall_3 = localTangentU * vec3(2.5, 2.5, 6.0);
        vec3 wall_4 = localTangentV * vec3(2.5, 2.5, 6.0);
        // brick.yaml:44 side
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
            // brick.yaml:36 face
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
        bool blend_4 = up < 0.7;
        float blend_5 = (up + 0.7) * 0.71428573;
        bool blend_6 = up < -0.7;
        float blend_7 = (up + 0.86) * 6.25;
        float blend_8 = 1.0 - blend_5;
        float blend_9 = 1.0 - (up - 0.7) * 6.25;
        float blend_10 = wall_3.z * 12.5;
        float blend_11 = wall_4.z * 12.5;
        float blend_12 = -side;
        float blend_13 = blend_4 ? side_1 * blend_5 + side_1 * blend_8 : blend_3 ? side_1 * blend_9 + blend_12 * blend_10 : 0.0;
        float blend_14 = blend_4 ? side_2 * blend_5 + side_2 * blend_8 : blend_3 ? side_2 * blend_9 + blend_12 * blend_11 : 0.0;
        blend = blend_6 ? side_1 * blend_7 + side * blend_10 : blend_13;
        blend_2 = blend_6 ? side_2 * blend_7 + side * blend_11 : blend_14;
    }
    // brick.yaml:50 Blend
    float diffuse_blend_1 = clamp((up + 0.83) * 14.285714, 0.0, 1.0);
    float diffuse_blend_2 = clamp((up + 0.76) * 0.65789473, 0.0, 1.0);
    float diffuse_blend_3 = clamp((up - 0.76) * 14.285714, 0.0, 1.0);
    // brick.yaml:39 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // brick.yaml:27 mortar
    vec3 mortar = mix(vec3(0.2746773, 0.24620132, 0.20155625), vec3(0.48514995, 0.43965718, 0.3662526), clamp(sand.w + 0.5, 0.0, 1.0));
    vec3 bumpMap_3 = cross(bumpMap_1, blend * 0.04 * worldTangentV - blend_2 * 0.04 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_3 : bumpMap_3;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    // brick.yaml:55 lengths
    vec3 lengths;
    if (-0.83 < up && up < 0.83) {
        // brick.yaml:31 clay
        vec3 clay;
        if (-0.93 < along && along < 0.93) {
            // brick.yaml:23 Gradient
            float brick_gradient = floor(wall.z * 0.5 + 0.5);
            // brick.yaml:34 VolumeTurbulence
            float clay_volumeTurbulence = turbulence(localPosition * 5.0, 11, 2.0, 0.5);
            // brick.yaml:20 Gradient
            float brick_gradient2 = floor(along_2 * 0.5 + 0.5);
            // brick.yaml:16 brick
            vec3 brick = vec3(brick_gradient2) * vec3(0.85, 1.55, 2.65) + vec3(brick_gradient) * vec3(2.15, 0.55, 1.45);
            float clay_1 = turbulence(brick, 1, 2.0, 1.0) * 0.6 + clay_volumeTurbulence * 0.4;
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
