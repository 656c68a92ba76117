#version 450 core
// wood.yaml as written by hand: only x and y of the turned position are needed, and the triangle goes straight into the mix.

layout(location = 5) in vec3 localPosition;
layout(location = 6) in vec3 eyeNormal;
layout(location = 0) out vec4 fragment0;
layout(location = 1) out vec4 fragment1;
layout(location = 2) out vec4 fragment2;
layout(location = 3) out vec4 fragment3;

vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}

vec2 encodeSpheremap(vec3 n) {
    float square = dot(n.xy, n.xy);
    vec2 direction = square > 1.0e-30 ? n.xy * inversesqrt(max(square, 1.0e-30)) : vec2(1.0, 0.0);
    vec2 front = n.xy * inversesqrt(8.0 * max(n.z, 0.0) + 8.0);
    vec2 back = direction * sqrt(0.125 - 0.125 * min(n.z, 0.0));
    return clamp((n.z < 0.0 ? back : front) + 0.5, 0.0, 1.0);
}

float wood(vec3 p) {
    vec2 a = min(abs(p.xy), 1.0e37);
    float greater = max(max(a.x, a.y), 1.0e-37);
    return greater * length(a / greater);
}

void main() {
    vec2 p = vec2(localPosition.x + 0.3, dot(localPosition.yz, vec2(0.36235775, -0.9320391)) + 0.1);
    float triangle = abs(fract(8.0 * wood(vec3(p, 0.0)) - 0.25) * 4.0 - 2.0) - 1.0;
    float ring = clamp(triangle * 0.71428573 + 0.42857143, 0.0, 1.0);
    vec3 normal = (gl_FrontFacing ? 1.0 : -1.0) * safeNormalize(eyeNormal);
    fragment0 = vec4(encodeSpheremap(normal), 21.206507, 65504.0);
    fragment1 = vec4(mix(vec3(0.45, 0.25, 0.1), vec3(0.75, 0.5, 0.25), ring), 1.0);
    fragment2 = vec4(0.2, 0.2, 0.2, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
