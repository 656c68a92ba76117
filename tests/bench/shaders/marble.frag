#version 450 core
// marble.yaml as written by hand: a sine along a direction of turbulent space.

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

uvec4 latticeFinal(uvec4 h) {
    h = (h ^ (h >> 16u)) * 0x7FEB352Du;
    h = (h ^ (h >> 15u)) * 0x846CA68Bu;
    return h ^ (h >> 16u);
}

void latticeCorners(vec3 cell, out uvec4 low, out uvec4 high) {
    const uvec3 factor = uvec3(0x9E3779B1u, 0x85EBCA77u, 0xC2B2AE3Du);
    uvec3 c = uvec3(ivec3(cell - 65536.0 * floor(cell * (1.0 / 65536.0))));
    uvec3 c0 = c * factor;
    uvec3 c1 = ((c + 1u) & 65535u) * factor;
    uvec4 square = uvec4(c0.x, c1.x, c0.x, c1.x) ^ uvec4(c0.yy, c1.yy);
    low = latticeFinal(square ^ (c0.z + 0x165667B1u));
    high = latticeFinal(square ^ (c1.z + 0x165667B1u));
}

vec4 latticeTerms(uvec4 hash, vec3 d) {
    vec4 dx = vec4(d.x, d.x - 1.0, d.x, d.x - 1.0);
    vec4 dy = vec4(d.yy, d.yy - 1.0);
    return 0.5 * vec4(ivec4(hash)) + vec4(ivec4(hash << 7u)) * dx + vec4(ivec4(hash << 14u)) * dy
         + vec4(ivec4(hash << 21u)) * d.z;
}

float latticeMix(vec4 low, vec4 high, vec3 d) {
    vec3 s = d * d * (3.0 - 2.0 * d);
    vec4 plane = mix(low, high, s.z);
    vec2 line = mix(plane.xy, plane.zw, s.y);
    return mix(line.x, line.y, s.x);
}

uvec4 latticeNext(uvec4 hash) {
    hash = (hash ^ (hash >> 15u)) * 0x2C1B3C6Du;
    return hash ^ (hash >> 16u);
}

vec3 vectorNoise(vec3 p) {
    vec3 cell = floor(p);
    vec3 d = p - cell;
    vec3 e = d - vec3(0.0, 0.0, 1.0);
    vec3 sum;
    uvec4 low, high;
    latticeCorners(cell, low, high);
    sum.x = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.y = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    low = latticeNext(low);
    high = latticeNext(high);
    sum.z = latticeMix(latticeTerms(low, d), latticeTerms(high, e), d);
    return sum * (1.0 / 2147483648.0);
}

vec3 vectorTurbulence(vec3 p, int octaves, float frequencyRatio, float noiseRatio) {
    int count = octaves > 1 ? octaves : 1;
    float strength = 1.0;
    vec3 sum = vec3(0.0);
    for (int k = 0; k < count; k++) {
        sum += strength * vectorNoise(p);
        strength *= noiseRatio;
        p *= frequencyRatio;
    }
    return sum;
}

void main() {
    vec3 p = localPosition + 0.5 * vectorTurbulence(localPosition, 5, 2.0, 0.5);
    float vein = sin(6.2831853 * fract(dot(p, vec3(1.5, 0.5, 1.5))));
    vec3 color = mix(vec3(0.9, 0.88, 0.8), vec3(0.4, 0.48, 0.45), clamp(vein * 0.625 + 0.625, 0.0, 1.0));
    color = mix(color, vec3(0.03, 0.06, 0.05), clamp(vein * 2.5 - 1.5, 0.0, 1.0));
    vec3 normal = (gl_FrontFacing ? 1.0 : -1.0) * safeNormalize(eyeNormal);
    fragment0 = vec4(encodeSpheremap(normal), 198.99832, 65504.0);
    fragment1 = vec4(color, 1.0);
    fragment2 = vec4(0.35, 0.35, 0.35, 1.0);
    fragment3 = vec4(0.0, 0.0, 0.0, 1.0);
}
