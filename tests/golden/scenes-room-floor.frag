#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 localPosition;
in vec3 eyeNormal;
layout(location = 0) out uvec4 fragment0;

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

// Box-filtered triangle wave (0 at integers v, 1 a quarter later). For edge < 1/2 from the nearest
// corner, without cancellation; else from the antiderivative. Error 3e-7. Edge 0 gives the point
// value.
float triangleMean(float v, float edge) {
    float t = fract(fract(v) - 0.25);
    float height = abs(4.0 * t - 2.0) - 1.0;
    float corner = 0.25 * (1.0 - abs(height));
    float over = max(0.5 * edge - corner, 0.0);
    float near = height - sign(height) * 4.0 * over * (over / max(edge, 1.0e-37));
    float a = fract(t - 0.5 * edge);
    float b = fract(t + 0.5 * edge);
    vec2 q = vec2(a, b);
    vec2 integral = q * (1.0 - 2.0 * q) + max(q - 0.5, 0.0) * (4.0 * q - 2.0);
    float far = (integral.y - integral.x) / max(edge, 0.25);
    return edge < 0.5 ? near : far;
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
    vec3 localPositionByX = dFdx(localPosition);
    vec3 localPositionByY = dFdy(localPosition);
    // room.yaml:38 Gradient
    float diffuse_gradient_1 = localPositionByX.y * 6.0;
    float diffuse_gradient_2 = localPositionByY.y * 6.0;
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    float diffuse_gradient = triangleMean(localPosition.y * 6.0, sqrt(diffuse_gradient_2 * diffuse_gradient_2 + diffuse_gradient_1 * diffuse_gradient_1));
    // room.yaml:12 boards
    vec3 boards;
    if (-0.99 < diffuse_gradient) {
        // room.yaml:13 VolumeTurbulence
        float boards_volumeTurbulence = turbulence(localPosition * vec3(1.5, 14.0, 4.0), 4, 2.0, 0.6);
        boards = mix(vec3(0.2, 0.1, 0.045), vec3(0.46, 0.26, 0.12), clamp((boards_volumeTurbulence + 0.6) * 0.8333333, 0.0, 1.0));
    } else {
        boards = vec3(0.0);
    }
    // room.yaml:37 Blend
    vec3 diffuse_blend = mix(vec3(0.05, 0.025, 0.012), boards, clamp((diffuse_gradient + 0.99) * 25.0, 0.0, 1.0));
    uint surface_bits = rootBits(diffuse_blend.x, 8) | rootBits(diffuse_blend.y, 8) << 8 | rootBits(diffuse_blend.z, 8) << 16;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 4227858432u, 2080374784u, surface_bits | 1207959552u, 1033848904u);
}
