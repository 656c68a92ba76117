#version 450 core
// plain.yaml as written by hand: one colour.

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

void main() {
    vec3 normal = (gl_FrontFacing ? 1.0 : -1.0) * safeNormalize(eyeNormal);
    fragment0 = vec4(encodeSpheremap(normal), 11.470956, 65504.0);
    fragment1 = vec4(0.1, 0.4, 0.3, 1.0);
    fragment2 = vec4(0.4, 0.4, 0.4, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
