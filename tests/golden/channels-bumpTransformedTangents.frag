#version 330 core
// matc 0.1.0: pass gbuffer, layout thesis

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
uniform mat3 matc_eyeFromWorld;
uniform sampler2D imageTexture0;
layout(location = 0) out vec4 fragment0;
layout(location = 1) out vec4 fragment1;
layout(location = 2) out vec4 fragment2;
layout(location = 3) out vec4 fragment3;

// Texel (i.x, i.y) of the base level, whatever the sampler's state; i is whole and inside the picture.
vec4 texel(sampler2D s, vec2 i, vec2 size) {
    return texelFetch(s, ivec2(i), 0);
}

// The four texels from floor(size * fraction of uv) on, repeated, mixed by the fraction of that: a texel's value stands at its
// lower corner, not at its centre. The first step is for a fraction that rounds up to 1. Error 2e-6.
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

// v / |v| for every finite v; (0, 0, 1) where no component reaches 1e-37. v is divided by its greatest component first, so that
// no square over- or underflows, and a great one is scaled down before, so that its reciprocal does not. Relative error 3e-7.
vec3 safeNormalize(vec3 v) {
    float greatest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    float scale = greatest > 1.0e37 ? 1.0 / 1024.0 : 1.0;
    vec3 scaled = v * scale / max(greatest * scale, 1.0e-37);
    vec3 unit = scaled * inversesqrt(max(dot(scaled, scaled), 0.5));
    return greatest < 1.0e-37 ? vec3(0.0, 0.0, 1.0) : unit;
}

// A world direction in eye space; the matrix is a rotation, so that lengths and angles stay.

vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
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

void main() {
    // UVTransform
    vec3 uvTransform = worldTangentV * 0.06490306 + worldTangentU * 0.15351017;
    vec3 uvTransform2 = worldTangentV * 0.32000095 + worldTangentU * -0.099104084;
    // BumpMap
    float bumpMap_1 = 0.04 / max(length(worldNormal), 1e-30);
    // UVTransform
    vec2 uvTransform_1 = mat2(vec2(5.760017, -1.168255), vec2(1.7838734, 2.7631829)) * uv;
    // ImageMap
    vec4 image_1 = imageBilinear(imageTexture0, uvTransform_1, vec2(64.0));
    vec2 image_2 = fract(uvTransform_1);
    // BumpMap
    vec3 bumpMap_2 = (imageBilinear(imageTexture0, image_2 + vec2(0.015625, 0.0), vec2(64.0)).x - image_1.x) * 64.0 * bumpMap_1 * worldNormal + uvTransform;
    vec3 bumpMap_3 = (imageBilinear(imageTexture0, image_2 + vec2(0.0, 0.015625), vec2(64.0)).x - image_1.x) * 64.0 * bumpMap_1 * worldNormal + uvTransform2;
    // normal
    vec3 normal = safeNormalize(eyeFromWorld(cross(bumpMap_2, bumpMap_3))) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = vec4(encodeSpheremap(normal), 4.0, 65504.0);
    fragment1 = vec4(image_1.xyz, 1.0);
    fragment2 = vec4(0.0, 0.0, 0.0, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
