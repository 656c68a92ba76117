#version 450 core
// bumpImage.yaml as written by hand: three samples give the colour and both slopes.

layout(location = 1) in vec3 worldNormal;
layout(location = 2) in vec3 worldTangentU;
layout(location = 3) in vec3 worldTangentV;
layout(location = 4) in vec2 uv;
layout(std140, binding = 0) uniform Material {
    mat3 matc_eyeFromWorld;
};
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
    vec2 st = uv * vec2(6.0, 3.0);
    vec4 image = imageBilinear(imageTexture0, st, vec2(64.0));
    float right = imageBilinear(imageTexture0, st + vec2(0.015625, 0.0), vec2(64.0)).r;
    float above = imageBilinear(imageTexture0, st + vec2(0.0, 0.015625), vec2(64.0)).r;
    vec2 slope = 15.36 * (vec2(right, above) - image.r) * inversesqrt(max(dot(worldNormal, worldNormal), 1.0e-37));
    vec3 bent = cross(worldTangentU + slope.x * worldNormal, worldTangentV + slope.y * worldNormal);
    vec3 normal = (gl_FrontFacing ? 1.0 : -1.0) * safeNormalize(matc_eyeFromWorld * bent);
    fragment0 = vec4(encodeSpheremap(normal), 48.993197, 65504.0);
    fragment1 = vec4(image.rgb, 1.0);
    fragment2 = vec4(0.4, 0.4, 0.4, 1.0);
    fragment3 = vec4(vec3(1.0 - image.a), 1.0);
}
