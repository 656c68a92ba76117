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

// Distance from the z axis, coordinates cut at 1e37. Divided by the greater one first, so that no square over- or underflows.
// Relative error 2e-7.
float wood(vec3 p) {
    vec2 a = min(abs(p.xy), 1.0e37);
    float greater = max(max(a.x, a.y), 1.0e-37);
    return greater * length(a / greater);
}

void main() {
    // normal
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), 4.0, 65504.0);
    // XYZTransform
    vec3 xyzTransform = mat3(vec3(0.9800666, 0.0, -0.19866933), vec3(0.18516758, 0.36235777, 0.9134604), vec3(0.07198937, -0.9320391, 0.35513473)) * localPosition + vec3(0.0, 0.2, 0.0);
    // Wood
    float wood_1 = fract(wood(xyzTransform) * 5.0);
    float wood_2 = (6.0 - wood_1 * 4.0) * (wood_1 * wood_1) - 1.0;
    // Blend
    vec3 blend = mix(mix(vec3(0.043137256, 0.003921569, 0.02745098), vec3(0.5411765, 0.05882353, 0.105882354), clamp(wood_2 + 1.0, 0.0, 1.0)), vec3(0.9647059, 0.74509805, 0.38039216), clamp(wood_2, 0.0, 1.0));
    fragment1 = vec4(blend, 1.0);
    fragment2 = vec4(0.0, 0.0, 0.0, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
