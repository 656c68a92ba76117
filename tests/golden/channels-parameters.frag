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
uniform sampler2D carpenterTexture0;
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

// Low four bits of Jenkins' hash of `count` (2 or 3) integers, |cell| <= 2^24: lookup3's final mix,
// seeded with 0xDEADBEEF + 4 count + 13 as in OSL and MaterialX. For count 2, cell.z is 0. Exact.
uint perlinHashTurned(uint bits, int by) {
    return (bits << by) | (bits >> (32 - by));
}

float perlinHash(vec3 cell, int count) {
    uvec3 h = uvec3(ivec3(cell)) + (0xDEADBEEFu + 13u + 4u * uint(count));
    h.z = (h.z ^ h.y) - perlinHashTurned(h.y, 14);
    h.x = (h.x ^ h.z) - perlinHashTurned(h.z, 11);
    h.y = (h.y ^ h.x) - perlinHashTurned(h.x, 25);
    h.z = (h.z ^ h.y) - perlinHashTurned(h.y, 16);
    h.x = (h.x ^ h.z) - perlinHashTurned(h.z, 4);
    h.y = (h.y ^ h.x) - perlinHashTurned(h.x, 14);
    h.z = (h.z ^ h.y) - perlinHashTurned(h.y, 24);
    return float(h.z & 15u);
}

// Gradient of Perlin noise at a corner, times 0.9820 (3D) or 0.6616 (2D) so that the noise is in
// about [-1, 1]: the middle of one of a cube's 12 edges (four count twice), in 2D (+-1, +-2) or
// (+-2, +-1). Exact but for the factor's rounding.
vec3 perlinDirection(vec3 corner, int dimensions) {
    float h = perlinHash(corner, dimensions);
    float pairs = floor(h * 0.5);
    float s = 1.0 - 2.0 * (h - 2.0 * pairs);
    float t = 1.0 - 2.0 * (pairs - 2.0 * floor(pairs * 0.5));
    if (dimensions < 3)
        return 0.6616 * (h - 8.0 * floor(h * 0.125) < 4.0 ? vec3(s, 2.0 * t, 0.0) : vec3(2.0 * t, s, 0.0));
    if (h < 8.0)
        return 0.982 * (h < 4.0 ? vec3(s, t, 0.0) : vec3(s, 0.0, t));
    return 0.982 * (h == 12.0 || h == 14.0 ? vec3(t, s, 0.0) : vec3(0.0, s, t));
}

// Perlin's improved noise (2002) in 2D or 3D, with the hash of OSL and MaterialX and the fade 6t^5
// - 15t^4 + 10t^3. Coordinates are clamped to 2^24, where floats have no fraction and the noise is
// 0. Error 1e-6.
float perlinOctave(vec3 p, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0) * vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    vec3 cell = floor(q);
    vec3 d = q - cell;
    vec3 far = d * d * d * (d * (d * 6.0 - 15.0) + 10.0);
    float sum = 0.0;
    for (int i = 0; i < 8; i++) {
        if (i > 3 && dimensions < 3) break;
        vec3 corner = vec3(i == 1 || i == 3 || i == 5 || i == 7, i == 2 || i == 3 || i > 5, i > 3);
        vec3 share = mix(1.0 - far, far, corner);
        sum += share.x * share.y * share.z * dot(perlinDirection(cell + corner, dimensions), d - corner);
    }
    return sum;
}

// Fractal Perlin noise: the sum over k < octaves of diminish^k N(lacunarity^k p), coordinates
// clamped to 2^24. Error 2e-6 of the sum of |diminish|^k if lacunarity is a power of two; otherwise
// rounding of coordinates adds to it.
float perlin(vec3 p, int octaves, float lacunarity, float diminish, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0);
    float strength = 1.0;
    float sum = 0.0;
    for (int k = 0; k < octaves; k++) {
        sum += strength * perlinOctave(q, dimensions);
        strength *= diminish;
        q = clamp(q * lacunarity, -16777216.0, 16777216.0);
    }
    return sum;
}

// Jenkins' lookup3 hash of `count` (2 or 3) integers, |cell| <= 2^24, over 2^32 - 1, seeded with
// 0xDEADBEEF + 4 count + 13 as in OSL and MaterialX. For count 2, cell.z is 0. Error 1e-7.
// jenkinsPlaces also hashes the component index 0 to `dimensions` - 1.
uint jenkinsTurned(uint bits, int by) {
    return (bits << by) | (bits >> (32 - by));
}

float jenkinsEnd(uvec3 h) {
    h.z = (h.z ^ h.y) - jenkinsTurned(h.y, 14);
    h.x = (h.x ^ h.z) - jenkinsTurned(h.z, 11);
    h.y = (h.y ^ h.x) - jenkinsTurned(h.x, 25);
    h.z = (h.z ^ h.y) - jenkinsTurned(h.y, 16);
    h.x = (h.x ^ h.z) - jenkinsTurned(h.z, 4);
    h.y = (h.y ^ h.x) - jenkinsTurned(h.x, 14);
    h.z = (h.z ^ h.y) - jenkinsTurned(h.y, 24);
    return float(h.z) / 4294967296.0;
}

float jenkins(vec3 cell, int count) {
    return jenkinsEnd(uvec3(ivec3(cell)) + (0xDEADBEEFu + 13u + 4u * uint(count)));
}

vec3 jenkinsPlaces(vec3 cell, int dimensions) {
    if (dimensions < 3)
        return vec3(jenkins(vec3(cell.xy, 0.0), 3), jenkins(vec3(cell.xy, 1.0), 3), 0.0);
    uvec3 h = uvec3(ivec3(cell)) + (0xDEADBEEFu + 13u + 16u);
    h.x = (h.x - h.z) ^ jenkinsTurned(h.z, 4);
    h.z += h.y;
    h.y = (h.y - h.x) ^ jenkinsTurned(h.x, 6);
    h.x += h.z;
    h.z = (h.z - h.y) ^ jenkinsTurned(h.y, 8);
    h.y += h.x;
    h.x = (h.x - h.z) ^ jenkinsTurned(h.z, 16);
    h.z += h.y;
    h.y = (h.y - h.x) ^ jenkinsTurned(h.x, 19);
    h.x += h.z;
    h.z = (h.z - h.y) ^ jenkinsTurned(h.y, 4);
    h.y += h.x;
    return vec3(jenkinsEnd(h), jenkinsEnd(h + uvec3(1u, 0u, 0u)), jenkinsEnd(h + uvec3(2u, 0u, 0u)));
}

// Random number in [0, 1] per unit cube (or unit square), as MaterialX's cellnoise3d and
// cellnoise2d. Coordinates are clamped to 2^24. Error 1e-7.
float cellNoise(vec3 p, int dimensions) {
    vec3 q = clamp(p, -16777216.0, 16777216.0) * vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    return jenkins(floor(q), dimensions);
}

// Finds the nearest cell point in the 3 x 3 (x 3) neighborhood of p: `away` is p minus the point,
// `nearest` its cell. Each cell has one random point; `jitter` scales its offset from the center.
// Coordinates are clamped to 2^24; in 2D z is 0. Error 3e-7.
void worleySearch(vec3 p, float jitter, int dimensions, out vec3 away, out vec3 nearest) {
    vec3 axes = vec3(1.0, 1.0, dimensions < 3 ? 0.0 : 1.0);
    vec3 q = clamp(p, -16777216.0, 16777216.0) * axes;
    vec3 cell = floor(q);
    vec3 d = q - cell;
    float least = 1.0e6;
    away = vec3(0.0);
    nearest = cell;
    for (int i = 0; i < 27; i++) {
        if (i > 8 && dimensions < 3) break;
        float rows = floor((float(i) + 0.5) / 3.0);
        float plane = floor((float(i) + 0.5) / 9.0);
        vec3 beside = (vec3(float(i) - 3.0 * rows, rows - 3.0 * plane, plane) - 1.0) * axes;
        vec3 far = d - beside - ((jenkinsPlaces(cell + beside, dimensions) - 0.5) * jitter + 0.5) * axes;
        float square = dot(far, far);
        if (square < least) {
            least = square;
            away = far;
            nearest = cell + beside;
        }
    }
}

// Distance to the nearest random point or, for style 1, its cell's number, as MaterialX's
// worleynoise3d and worleynoise2d. Error 1e-6.
float worley(vec3 p, float jitter, int style, int dimensions) {
    vec3 away, nearest;
    worleySearch(p, jitter, dimensions, away, nearest);
    return style > 0 ? jenkins(nearest, dimensions) : length(away);
}

// Julia set of c = (cx, cy): z starts at 4 fract(p.xy) - 2. Returns the fraction of `iterations`
// steps z^2 + c with |z| <= 2, scaled to [-1, 1]. Rounding may change the count near the set's
// border.
float julia(vec3 p, int iterations, float cx, float cy) {
    vec2 z = 4.0 * fract(p.xy) - 2.0;
    int steps = 0;
    for (int k = 0; k < iterations; k++) {
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + vec2(cx, cy);
        if (dot(z, z) > 4.0) break;
        steps++;
    }
    return 2.0 * float(steps) / max(float(iterations), 1.0) - 1.0;
}

// Gradient (xyz; 0 on the axis) and value (w) of wood. Error 3e-7, relative for the value.
vec4 woodGradient(vec3 p) {
    vec2 a = clamp(p.xy, -1.0e37, 1.0e37);
    float greater = max(max(abs(a.x), abs(a.y)), 1.0e-37);
    vec2 unit = a / greater;
    float size = length(unit);
    return vec4(unit / max(size, 1.0), 0.0, greater * size);
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

// Mandelbrot set: c = 4 fract(p.xy) - 2, z starts at c. Returns the fraction of `iterations` steps
// z^2 + c with |z| <= 2, scaled to [-1, 1]. Rounding may change the count near the set's border.
float mandel(vec3 p, int iterations) {
    vec2 c = 4.0 * fract(p.xy) - 2.0;
    vec2 z = c;
    int steps = 0;
    for (int k = 0; k < iterations; k++) {
        z = vec2(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y) + c;
        if (dot(z, z) > 4.0) break;
        steps++;
    }
    return 2.0 * float(steps) / max(float(iterations), 1.0) - 1.0;
}

// Derives a second, unrelated hash from a corner's hash. One round suffices for a mixed hash.
uvec4 latticeNext(uvec4 hash) {
    hash = (hash ^ (hash >> 15u)) * 0x2C1B3C6Du;
    return hash ^ (hash >> 16u);
}

// Three lattice noises at position d in a cell: x is lattice(cell, d); y and z use further hashes.
vec3 vectorNoise(vec3 cell, vec3 d) {
    vec3 e = d - vec3(0.0, 0.0, 1.0);
    vec3 sum;
    uvec4 low, high;
    latticeCorners(cell, low, high);
    sum.x = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.y = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.z = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    return sum * latticeScale;
}

// Sum of octaves noiseRatio^k vectorNoise(frequencyRatio^k p), k from 0; at least one. Signed, not
// normalized. Error of turbulence.
vec3 vectorTurbulence(vec3 p, int octaves, float frequencyRatio, float noiseRatio) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    vec3 sum = vec3(0.0);
    for (int k = 0; k < count; k++) {
        vec3 cell = floor(p);
        sum += strength * vectorNoise(cell, p - cell);
        strength *= noiseRatio;
        p *= frequencyRatio;
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

// Component-wise cosine. Error of cos().
vec3 cosine3(vec3 x) {
    return cos(x);
}

// Gradient by p (xyz) and value (w) of leopardFiltered. Error 5e-7 if sin and cos err by 1e-7.
vec4 leopardFilteredGradient(vec3 p, vec3 edge) {
    vec3 sine = sine3(p);
    vec3 left = sinc(0.5 * edge);
    vec3 leftOfTwice = sinc(edge);
    vec3 mean = sine * left;
    vec3 square = 0.5 - (0.5 - sine * sine) * leftOfTwice;
    float sum = mean.x + mean.y + mean.z;
    float value = max(sum * sum + dot(square - mean * mean, vec3(1.0)), 0.0) * (1.0 / 9.0);
    return vec4(cosine3(p) * ((sum - mean) * left + sine * leftOfTwice) * (2.0 / 9.0), value);
}

// sin(x / 2) / (x / 2), x >= 0: attenuation of a sine by a box of edge x. Error 2e-7.
float sincMean(float x) {
    float h = 0.5 * x;
    return h < 1.0e-2 ? 1.0 - h * h * (1.0 / 6.0) : sin(h) / max(h, 1.0e-2);
}

// Texel (i.x, i.y) of mipmap level 0, independent of the sampler; i is integral and inside the
// image.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texelFetch(s, ivec2(i), 0);
}

// Samples a synthetic single-channel texture, repeated and bilinear as in GroIMP: size * uv is
// truncated toward zero, so a negative coordinate extrapolates with a negative weight. fract()
// removes whole periods exactly.
float carpenterRelief(sampler2D s, vec2 uv, vec2 size) {
    vec2 side = 1.0 - 2.0 * vec2(lessThan(uv, vec2(0.0)));
    vec2 at = fract(abs(uv)) * size;
    vec2 low = side * floor(at);
    vec2 weight = side * at - low;
    low += size * vec2(lessThan(low, vec2(0.0)));
    low -= size * step(size, low);
    vec2 high = low + 1.0;
    high -= size * step(size, high);
    return mix(mix(texel(s, low, size).r, texel(s, vec2(high.x, low.y), size).r, weight.x),
               mix(texel(s, vec2(low.x, high.y), size).r, texel(s, high, size).r, weight.x), weight.y);
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

// Quantizes v in equal steps of log2: code 0 is 0, code 1 is 1/16, the last is 65504 =
// 2^(19.9992954 - 4). Values below 1/32 become 0. bits in [4, 16].
uint logarithmBits(float v, int bits) {
    int steps = (1 << bits) - 2;
    float place = (log2(clamp(v, 0.0625, 65504.0)) + 4.0) * (float(steps) / 19.9992954);
    return v < 0.03125 ? 0u : uint(clamp(floor(place + 0.5), 0.0, float(steps))) + 1u;
}

void main() {
    vec3 localPositionByX = dFdx(localPosition);
    vec3 localPositionByY = dFdy(localPosition);
    // parameters.yaml:3 UVTransform
    vec2 diffuse_uvTransform = uv * vec2(0.5, 1.0);
    // parameters.yaml:3 CornerRamp
    vec3 diffuse_cornerRamp = clamp(diffuse_uvTransform.y, 0.0, 1.0) * mix(vec3(1.0), vec3(0.5, 0.25, 1.0), clamp(diffuse_uvTransform.x, 0.0, 1.0));
    // parameters.yaml:3 Granite
    float diffuse_granite = abs(granite(diffuse_cornerRamp));
    // parameters.yaml:6 Noise
    float transparency_perlin = abs(perlin(localPosition, 2, 3.0, 0.25, 2) * 0.5 + 0.125);
    // parameters.yaml:10 XYZTransform
    vec3 transparencyShininess_xyzTransform_1 = localPositionByX * 5.0;
    vec3 transparencyShininess_xyzTransform_2 = localPositionByY * 5.0;
    // parameters.yaml:7 XYZTransform
    vec3 diffuseTransparency_xyzTransform = localPosition * 3.0;
    // parameters.yaml:7 CellNoise
    float diffuseTransparency_cellNoise_1 = abs(fract(cellNoise(diffuseTransparency_xyzTransform, 2) * 0.5 + 0.25) * 4.0 - 1.0);
    float diffuseTransparency_cellNoise = abs(diffuseTransparency_cellNoise_1 - 2.0) - 1.0;
    // parameters.yaml:8 Worley
    float ambient_worley = abs(worley(diffuseTransparency_xyzTransform, 1.0, 1, 2) * 0.75 + 0.25);
    // parameters.yaml:5 Julia
    float emissive_julia = julia(localPosition * 0.7, 10, 0.6, 0.6) * 0.5 + 0.25;
    // parameters.yaml:11 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    // parameters.yaml:11 Wood
    vec4 wood2 = woodGradient(localPosition);
    float wood2_2 = dot(wood2.xyz, localPositionByX);
    float wood2_3 = dot(wood2.xyz, localPositionByY);
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    uint ambient_bits = rootBits(ambient_worley, 4);
    uint surface_bits = sharedExponentBits(vec3(emissive_julia), 5) | ambient_bits << 20 | ambient_bits << 24 | ambient_bits << 28;
    uint diffuse_bits = rootBits(diffuse_granite, 6);
    // parameters.yaml:4 Mandel
    float specular_mandel_1 = abs(fract(mandel(localPosition, 10) * 0.5 + 0.25) * 4.0 - 1.0);
    float specular_mandel = abs(specular_mandel_1 - 2.0) - 1.0;
    uint specular_bits = rootBits(specular_mandel, 5);
    uint surface_bits2 = diffuse_bits | diffuse_bits << 6 | diffuse_bits << 12 | specular_bits << 18 | specular_bits << 23;
    uint transparency_bits = rootBits(transparency_perlin, 4);
    uint diffuseTransparency_bits = rootBits(diffuseTransparency_cellNoise, 4);
    uint surface_bits3 = specular_bits | transparency_bits << 5 | transparency_bits << 9 | diffuseTransparency_bits << 13 | diffuseTransparency_bits << 17;
    // parameters.yaml:9 Turbulence
    vec3 shininess_turbulence = vectorTurbulence(localPosition, 2, 3.0, 2.0) * vec3(0.1) + localPosition;
    float shininess = phongExponent(turbulence(shininess_turbulence, 2, 3.0, 1.0));
    // parameters.yaml:10 Leopard
    vec4 transparencyShininess_leopard_1 = leopardFilteredGradient(localPosition * 5.0, max(abs(transparencyShininess_xyzTransform_2), abs(transparencyShininess_xyzTransform_1)));
    float transparencyShininess_leopard_2 = dot(transparencyShininess_leopard_1.xyz, transparencyShininess_xyzTransform_1);
    float transparencyShininess_leopard_3 = dot(transparencyShininess_leopard_1.xyz, transparencyShininess_xyzTransform_2);
    float wood2_4 = sincMean(sqrt(wood2_3 * wood2_3 + wood2_2 * wood2_2));
    float wood2_5 = cos(wood2.w + 0.3);
    float transparencyShininess_leopard = sin(fract(transparencyShininess_leopard_1.w) * 6.2831855) * sincMean(sqrt(transparencyShininess_leopard_3 * transparencyShininess_leopard_3 + transparencyShininess_leopard_2 * transparencyShininess_leopard_2) * 6.2831855);
    // parameters.yaml:11 Carpenter
    float carpenter_map = carpenterRelief(carpenterTexture0, uv, vec2(16.0));
    vec2 carpenter_map_1 = floor(uv);
    vec2 carpenter_map_2 = uv - (carpenter_map_1 - clamp(carpenter_map_1, vec2(-2.0), vec2(1.0)));
    // parameters.yaml:11 Add
    float sum = (carpenterRelief(carpenterTexture0, carpenter_map_2 + vec2(0.005, 0.0), vec2(16.0)) - carpenter_map) * 200.0 + wood2_5 * dot(wood2.xyz, localTangentU) * wood2_4;
    float sum_2 = (carpenterRelief(carpenterTexture0, carpenter_map_2 + vec2(0.0, 0.005), vec2(16.0)) - carpenter_map) * 200.0 + wood2_5 * dot(wood2.xyz, localTangentV) * wood2_4;
    vec3 bumpMap_3 = cross(bumpMap_1, sum * 0.02 * worldTangentV - sum_2 * 0.02 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_3 : bumpMap_3;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    uint surface_bits4 = octahedralBits(normal, 12) << 2 | logarithmBits(phongExponent(transparencyShininess_leopard), 5) << 27 | 67108867u;
    fragment0 = uvec4(surface_bits4, surface_bits, surface_bits2 | transparency_bits << 28, surface_bits3 | diffuseTransparency_bits << 21 | logarithmBits(shininess, 7) << 25);
}
