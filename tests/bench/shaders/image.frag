#version 450 core
// image.yaml as written by hand: the picture has alpha, which makes the surface clear.

layout(location = 4) in vec2 uv;
layout(location = 6) in vec3 eyeNormal;
layout(binding = 1) uniform sampler2D imageTexture0;
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

vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texelFetch(s, ivec2(i), 0);
}

vec4 imageBilinear(sampler2D s, vec2 uv, vec2 size) {
    vec2 at = fract(uv) * size;
    vec2 low = floor(at);
    vec2 weight = at - low;
    low -= size * step(size, low);
    vec2 high = low + 1.0;
    high -= size * step(size, high);
    return mix(mix(texel(s, low, size), texel(s, vec2(high.x, low.y), size), weight.x),
               mix(texel(s, vec2(low.x, high.y), size), texel(s, high, size), weight.x), weight.y);
}

void main() {
    vec4 image = imageBilinear(imageTexture0, uv * vec2(6.0, 3.0), vec2(64.0));
    vec3 normal = (gl_FrontFacing ? 1.0 : -1.0) * safeNormalize(eyeNormal);
    fragment0 = vec4(encodeSpheremap(normal), 48.993197, 65504.0);
    fragment1 = vec4(image.rgb, 1.0);
    fragment2 = vec4(0.35, 0.35, 0.35, 1.0);
    fragment3 = vec4(vec3(1.0 - image.a), 1.0);
}
