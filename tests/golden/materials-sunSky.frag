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

// Angle between two unit vectors in [0, pi], given its cosine. atan, since acos is imprecise near
// 0.
float skyAngle(vec3 view, vec3 sun, float cosine) {
    return atan(length(cross(view, sun)), cosine);
}

// Preetham's sky in a direction of any length, z up: linear sRGB, no component below 0, black below
// the horizon. The arguments' components are luminance Y and chromaticity x, y, from
// sky_coefficients (lib/sky.h): zenithOverF0 is the zenith's value over F(0, sun angle), Y in W/(m2
// sr) times the desired scale; A to E are Perez' coefficients of F; sun is a unit vector. Relative
// error 8e-6.
vec3 skyRadiance(vec3 direction, vec3 sun, vec3 zenithOverF0, vec3 A, vec3 B, vec3 C, vec3 D, vec3 E) {
    vec3 view = safeNormalize(direction);
    if (view.z < 0.0) return vec3(0.0);
    view = normalize(vec3(view.xy, max(view.z, 0.001)));
    float cosine = dot(view, sun);
    float angle = skyAngle(view, sun, cosine);
    vec3 sky = zenithOverF0 * (1.0 + A * exp(B / view.z)) * (1.0 + C * exp(D * angle) + E * cosine * cosine);
    vec3 XYZ = max(sky.x, 0.0) * vec3(sky.y, sky.z, 1.0 - sky.y - sky.z) / max(sky.z, 0.001);
    vec3 rgb = XYZ.x * vec3(3.2404542, -0.9692660, 0.0556434) + XYZ.y * vec3(-1.5371385, 1.8760108, -0.2040259)
             + XYZ.z * vec3(-0.4985314, 0.0415560, 1.0572252);
    return rgb - min(min(min(rgb.r, rgb.g), rgb.b), 0.0);
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
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 emissive = skyRadiance(localPosition, vec3(0.35320863, -0.8830216, 0.30905756), vec3(1.6307038, 0.32276142, 0.33811134), vec3(-0.92687, -0.31697, -0.31085), vec3(-0.63871, -0.19872, -0.27564), vec3(5.25707, 0.21124, 0.18647), vec3(-2.21513, -1.09114, -1.78584), vec3(0.16939, 0.03542, 0.02015)) * 0.3;
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, sharedExponentBits(emissive, 7), 0u, 645922816u);
}
