#version 330 core
// matc 0.1.0: pass gbuffer, layout thesis

in vec3 localPosition;
in vec3 eyeNormal;
layout(location = 0) out vec4 fragment0;
layout(location = 1) out vec4 fragment1;
layout(location = 2) out vec4 fragment2;
layout(location = 3) out vec4 fragment3;

// v / |v| for every finite v; (0, 0, 1) where no component reaches 1e-37. v is divided by its greatest component first, so that
// no square over- or underflows, and a great one is scaled down before, so that its reciprocal does not. Relative error 3e-7.
vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}

// Unit normal n to n.xy / sqrt(8 n.z + 8) + 1/2 in [0, 1]^2, in two forms that are equal for a unit n: this one for n.z >= 0,
// and below it the direction of n.xy times the radius sqrt((1 - n.z) / 8), which holds its digits up to the singularity.
// At (0, 0, -1) itself the direction is +x.
vec2 encodeSpheremap(vec3 n) {
    float square = dot(n.xy, n.xy);
    vec2 direction = square > 1.0e-30 ? n.xy * inversesqrt(max(square, 1.0e-30)) : vec2(1.0, 0.0);
    vec2 front = n.xy * inversesqrt(8.0 * max(n.z, 0.0) + 8.0);
    vec2 back = direction * sqrt(0.125 - 0.125 * min(n.z, 0.0));
    return clamp((n.z < 0.0 ? back : front) + 0.5, 0.0, 1.0);
}

// Preetham's sky along a direction of any length, z up: linear sRGB, no component below 0, black below the horizon.
// Luminance Y and chromaticity x, y are the lanes of the arguments, all from sky_coefficients (lib/sky.h): zenithOverF0 is the
// zenith's value over F(0, angle of the sun), Y in W/(m2 sr) times the scale wanted; A to E are the coefficients of Perez' F;
// sun is a unit vector. Relative error 2e-5. The angle to the sun is taken by atan, as acos has few digits near 0.
vec3 skyRadiance(vec3 direction, vec3 sun, vec3 zenithOverF0, vec3 A, vec3 B, vec3 C, vec3 D, vec3 E) {
    vec3 view = safeNormalize(direction);
    if (view.z < 0.0) return vec3(0.0);
    view = normalize(vec3(view.xy, max(view.z, 0.001)));
    float cosine = dot(view, sun);
    float angle = atan(length(cross(view, sun)), cosine);
    vec3 sky = zenithOverF0 * (1.0 + A * exp(B / view.z)) * (1.0 + C * exp(D * angle) + E * cosine * cosine);
    vec3 XYZ = max(sky.x, 0.0) * vec3(sky.y, sky.z, 1.0 - sky.y - sky.z) / max(sky.z, 0.001);
    vec3 rgb = XYZ.x * vec3(3.2404542, -0.9692660, 0.0556434) + XYZ.y * vec3(-1.5371385, 1.8760108, -0.2040259)
             + XYZ.z * vec3(-0.4985314, 0.0415560, 1.0572252);
    return rgb - min(min(min(rgb.r, rgb.g), rgb.b), 0.0);
}

// Two numbers in [0, 1], cut to seven bits each, in one number of [1, 65504] that a half float holds exactly: x gives the
// exponent and the first three bits of the mantissa, y the other seven. The power of two is exact: exp2 errs by at most 33 ulp
// of 32768, an eighth, before it is rounded to a whole number.
float packPair(vec2 v) {
    vec2 q = floor(127.5 * clamp(v, 0.0, 1.0));
    float exponent = floor(q.x * 0.125);
    float mantissa = 1.0 + (q.x * 0.125 - exponent) + q.y * (1.0 / 1024.0);
    return mantissa * floor(exp2(exponent) + 0.5);
}

void main() {
    // normal
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), 4.0, 65504.0);
    // emissive
    vec3 emissive = skyRadiance(localPosition, vec3(0.35320863, -0.8830216, 0.30905756), vec3(1.6307038, 0.32276142, 0.33811134), vec3(-0.92687, -0.31697, -0.31085), vec3(-0.63871, -0.19872, -0.27564), vec3(5.25707, 0.21124, 0.18647), vec3(-2.21513, -1.09114, -1.78584), vec3(0.16939, 0.03542, 0.02015)) * 0.3;
    fragment1 = vec4(vec3(0.0), packPair(emissive.xy));
    fragment2 = vec4(vec3(0.0), packPair(vec2(emissive.z, 0.0)));
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
