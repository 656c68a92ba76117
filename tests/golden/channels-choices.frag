#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
in vec3 localPosition;
in vec3 localTangentU;
in vec3 localTangentV;
uniform float turn;
uniform mat3 matc_eyeFromWorld;
uniform sampler2D carpenterTexture0;
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

// ((sin x + sin y + sin z) / 3)^2, in [0, 1]. Error of sin(): 3e-7 on llvmpipe up to 1e6; GLSL has
// no bound.
float leopard(vec3 p) {
    float mean = dot(sin(p), vec3(1.0 / 3.0));
    return mean * mean;
}

// Gradient (xyz; 0 on the axis) and value (w) of wood. Error 3e-7, relative for the value.
vec4 woodGradient(vec3 p) {
    vec2 a = clamp(p.xy, -1.0e37, 1.0e37);
    float greater = max(max(abs(a.x), abs(a.y)), 1.0e-37);
    vec2 unit = a / greater;
    float size = length(unit);
    return vec4(unit / max(size, 1.0), 0.0, greater * size);
}

// Gradient (xyz) and value (w) of leopard. Error 4.3e-7 if sin and cos err by 1e-7.
vec4 leopardGradient(vec3 p) {
    float mean = dot(sin(p), vec3(1.0 / 3.0));
    return vec4(cos(p) * (mean * (2.0 / 3.0)), mean * mean);
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

// Transforms a direction from world to eye space. The matrix is a rotation: lengths and angles are
// kept.
vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
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
    // choices.yaml:7 Leopard
    float specular_leopard = leopardFiltered(localPosition, max(abs(localPositionByY), abs(localPositionByX)));
    // choices.yaml:6 Checker
    vec2 diffuse_checker = stripes2(fract(uv), max(abs(uvByY), abs(uvByX)));
    float diffuse_checker_2 = 0.5 - diffuse_checker.y * diffuse_checker.x * 0.5;
    // choices.yaml:10 XYZTransform
    vec3 diffuseTransparency_xyzTransform = mat3(vec3(0.74959624, 0.15195069, -0.64421767), vec3(0.06288291, 0.9525413, 0.29784358), vec3(0.6589015, -0.26377273, 0.7044663)) * localPosition;
    // choices.yaml:10 Checker
    vec2 diffuseTransparency_checker_1 = fract(diffuseTransparency_xyzTransform.yz);
    float diffuseTransparency_checker = (0.5 <= diffuseTransparency_checker_1.x) != (0.5 <= diffuseTransparency_checker_1.y) ? 1.0 : 0.2;
    // choices.yaml:10 Triplanar
    vec3 diffuseTransparency_triplanar_1 = pow(max(abs(safeNormalize(cross(localTangentU, localTangentV))), vec3(1e-37)), vec3(4.0));
    vec3 diffuseTransparency_triplanar_2 = max(diffuseTransparency_triplanar_1 / dot(diffuseTransparency_triplanar_1, vec3(1.0)) - vec3(0.015625), vec3(0.0));
    vec3 diffuseTransparency_triplanar_3 = diffuseTransparency_triplanar_2 / dot(diffuseTransparency_triplanar_2, vec3(1.0));
    // choices.yaml:10 Leopard
    float diffuseTransparency_leopard = leopard(localPosition * 2.0);
    float diffuseTransparency_triplanar = diffuseTransparency_triplanar_3.z * diffuseTransparency_leopard + (diffuseTransparency_triplanar_3.y * diffuseTransparency_leopard + diffuseTransparency_triplanar_3.x * diffuseTransparency_leopard);
    // choices.yaml:10 Ramp
    float diffuseTransparency_ramp_1 = clamp(diffuseTransparency_xyzTransform.x, 0.0, 1.0);
    // choices.yaml:8 Ramp
    float emissive_ramp_1 = clamp(uv.y, 0.0, 1.0);
    // choices.yaml:8 Switch
    float emissive_chosen = mix(0.2, mix(0.7, 0.1, emissive_ramp_1), diffuse_checker_2);
    // choices.yaml:12 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    // choices.yaml:12 Ramp
    bool ramp = localPosition.x <= 1.0;
    bool ramp_2 = localPosition.x < 0.0;
    // choices.yaml:8 Wood
    vec3 emissive_wood = woodGradient(localPosition).xyz;
    // choices.yaml:12 Leopard
    vec4 leopard2 = leopardGradient(localPosition);
    float leopard2_2 = dot(leopard2.xyz, localTangentU);
    float leopard2_3 = dot(leopard2.xyz, localTangentV);
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // choices.yaml:7 CornerRamp
    float specular_cornerRamp_1 = clamp(uv.x, 0.0, 1.0);
    // choices.yaml:10 Triplanar
    vec3 diffuseTransparency_triplanar2_1 = pow(max(abs(safeNormalize(cross(mat3(vec3(0.74959624, 0.15195069, -0.64421767), vec3(0.06288291, 0.9525413, 0.29784358), vec3(0.6589015, -0.26377273, 0.7044663)) * localTangentU, mat3(vec3(0.74959624, 0.15195069, -0.64421767), vec3(0.06288291, 0.9525413, 0.29784358), vec3(0.6589015, -0.26377273, 0.7044663)) * localTangentV))), vec3(1e-37)), vec3(3.0));
    vec3 diffuseTransparency_triplanar2_2 = max(diffuseTransparency_triplanar2_1 / dot(diffuseTransparency_triplanar2_1, vec3(1.0)) - vec3(0.015625), vec3(0.0));
    vec3 diffuseTransparency_triplanar2_3 = diffuseTransparency_triplanar2_2 / dot(diffuseTransparency_triplanar2_2, vec3(1.0));
    float ramp_3 = leopard2.w - 0.1;
    // choices.yaml:5 Remap
    float diffuse_remap = specular_leopard * 7.5 - 1.0;
    // choices.yaml:12 Carpenter
    float carpenter_map = carpenterRelief(carpenterTexture0, localPosition.xz, vec2(256.0));
    vec2 carpenter_map_1 = floor(localPosition.xz);
    vec2 carpenter_map_2 = localPosition.xz - (carpenter_map_1 - clamp(carpenter_map_1, vec2(-2.0), vec2(1.0)));
    float carpenter_map_3 = (carpenterRelief(carpenterTexture0, carpenter_map_2 + vec2(0.005, 0.0), vec2(256.0)) - carpenter_map) * 200.0;
    float carpenter_map_4 = (carpenterRelief(carpenterTexture0, carpenter_map_2 + vec2(0.0, 0.005), vec2(256.0)) - carpenter_map) * 200.0;
    // choices.yaml:12 Triplanar
    float triplanar = (localTangentU.z * carpenter_map_4 + carpenter_map_3 * localTangentU.x) * diffuseTransparency_triplanar_3.y + dot(emissive_wood, localTangentU) * diffuseTransparency_triplanar_3.x;
    float triplanar_2 = (localTangentV.z * carpenter_map_4 + carpenter_map_3 * localTangentV.x) * diffuseTransparency_triplanar_3.y + dot(emissive_wood, localTangentV) * diffuseTransparency_triplanar_3.x;
    // choices.yaml:11 Ramp
    float shininess_ramp = mix(0.3, 0.6, clamp(uv.x * 3.0, 0.0, 1.0));
    float triplanar_3 = (ramp ? (ramp_2 ? 0.0 : leopard2_2 * localPosition.x + ramp_3 * localTangentU.x) : leopard2_2) * diffuseTransparency_triplanar_3.z + triplanar;
    float triplanar_4 = (ramp ? (ramp_2 ? 0.0 : leopard2_3 * localPosition.x + ramp_3 * localTangentV.x) : leopard2_3) * diffuseTransparency_triplanar_3.z + triplanar_2;
    vec3 bumpMap_3 = cross(bumpMap_1, triplanar_3 * 0.02 * worldTangentV - triplanar_4 * 0.02 * worldTangentU) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_3 : bumpMap_3;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    // choices.yaml:4 Switch
    vec4 diffuse_chosen;
    if (diffuse_remap < 1.5) {
        if (diffuse_remap < 0.5) {
            // choices.yaml:6 HSV
            vec3 diffuse_hsv_1 = clamp(abs(fract(turn + vec3(0.05, 0.71666664, 0.38333333)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
            vec3 diffuse_hsv_2 = clamp(abs(fract(turn + vec3(0.61904764, 1.2857143, 0.95238096)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
            diffuse_chosen = mix(vec4(mix(vec3(1.0), diffuse_hsv_2, 0.62222224) * 1.08, 0.5), vec4(mix(vec3(1.0), diffuse_hsv_1, 0.61538464) * 0.97882354, 1.0), diffuse_checker_2);
        } else {
            diffuse_chosen = vec4(0.5, 0.5, 0.5, 1.0);
        }
    } else {
        vec3 diffuse_chosen_1;
        if (diffuse_remap < 2.5) {
            // choices.yaml:6 Granite
            float diffuse_granite = granite(localPosition);
            diffuse_chosen_1 = vec3(diffuse_granite);
        } else {
            diffuse_chosen_1 = vec3(0.1, 0.2, 0.0);
        }
        diffuse_chosen = vec4(diffuse_chosen_1, 1.0);
    }
    vec3 transparency = vec3(1.0) - diffuse_chosen.www;
    uint surface_bits = rootBits(diffuse_chosen.x, 6) | rootBits(diffuse_chosen.y, 6) << 6 | rootBits(diffuse_chosen.z, 6) << 12;
    float diffuseTransparency_ramp = diffuseTransparency_ramp_1 * diffuseTransparency_triplanar + (1.0 - diffuseTransparency_ramp_1) * 0.2;
    vec4 specular_cornerRamp_2 = vec4(vec3(specular_leopard) * specular_cornerRamp_1 + (1.0 - specular_cornerRamp_1) * vec3(0.2509804, 0.5019608, 0.7529412), 1.0) * emissive_ramp_1;
    vec4 specular_cornerRamp = specular_cornerRamp_2 + (1.0 - emissive_ramp_1) * mix(vec4(1.0, 0.0, 0.0, 0.5), vec4(0.3, 0.3, 0.3, 1.0), specular_cornerRamp_1);
    // choices.yaml:7 HSV
    float specular_hsv = max(max(specular_cornerRamp.y, specular_cornerRamp.x), specular_cornerRamp.z);
    float specular_hsv_2 = specular_hsv - min(min(specular_cornerRamp.y, specular_cornerRamp.x), specular_cornerRamp.z);
    bool specular_hsv_3 = specular_hsv == specular_cornerRamp.x;
    bool specular_hsv_4 = specular_hsv == specular_cornerRamp.y;
    bool specular_hsv_5 = abs(specular_hsv_2) < 1e-30;
    float specular_hsv_6 = (specular_hsv_5 ? 0.0 : specular_hsv_3 ? specular_cornerRamp.y - specular_cornerRamp.z : specular_hsv_4 ? specular_cornerRamp.z - specular_cornerRamp.x : specular_cornerRamp.x - specular_cornerRamp.y) / (specular_hsv_5 ? 1.0 : specular_hsv_2);
    bool specular_hsv_7 = abs(specular_hsv) < 1e-30;
    vec3 specular_hsv_8 = vec3(specular_hsv_5 ? 0.0 : fract((specular_hsv_6 + (specular_hsv_3 ? 0.0 : specular_hsv_4 ? 2.0 : 4.0)) * 0.16666667), (specular_hsv_7 ? 0.0 : specular_hsv_2) / (specular_hsv_7 ? 1.0 : specular_hsv), specular_hsv);
    vec3 specular_hsv_9 = (specular_hsv_8 + vec3(-0.4, 0.0, 0.0)) * vec3(1.0, 1.5, 1.0);
    vec3 specular_hsv_10 = clamp(abs(fract(specular_hsv_9.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
    vec3 specular = mix(vec3(1.0), specular_hsv_10, specular_hsv_9.y) * specular_hsv_9.z;
    float diffuseTransparency_triplanar2 = diffuseTransparency_ramp * diffuseTransparency_triplanar2_3.z + (diffuseTransparency_ramp * diffuseTransparency_triplanar2_3.y + diffuseTransparency_triplanar2_3.x * diffuseTransparency_checker);
    uint diffuseTransparency_bits = rootBits(diffuseTransparency_triplanar2, 4);
    uint surface_bits2 = surface_bits | rootBits(specular.x, 5) << 18 | rootBits(specular.y, 5) << 23 | rootBits(transparency.x, 4) << 28;
    uint surface_bits3 = rootBits(specular.z, 5) | rootBits(transparency.y, 4) << 5 | rootBits(transparency.z, 4) << 9;
    uint surface_bits4 = surface_bits3 | diffuseTransparency_bits << 13 | diffuseTransparency_bits << 17 | diffuseTransparency_bits << 21 | logarithmBits(phongExponent(shininess_ramp), 7) << 25;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 4227858435u, sharedExponentBits(vec3(emissive_chosen), 5) | 2290089984u, surface_bits2, surface_bits4);
}
