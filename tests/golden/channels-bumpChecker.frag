#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec3 worldNormal;
in vec3 worldTangentU;
in vec3 worldTangentV;
in vec2 uv;
uniform mat3 matc_eyeFromWorld;
layout(location = 0) out uvec4 fragment0;

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

// Transforms a direction from world to eye space. The matrix is a rotation: lengths and angles are
// kept.
vec3 eyeFromWorld(vec3 d) {
    return matc_eyeFromWorld * d;
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

void main() {
    vec2 uvByX = dFdx(uv);
    vec2 uvByY = dFdy(uv);
    // bumpChecker.yaml:4 BumpMap
    vec3 bumpMap_1 = 1.0 / max(length(worldNormal), 1e-30) * worldNormal;
    vec3 bumpMap_2 = cross(worldTangentU, worldTangentV);
    // bumpChecker.yaml:4 Checker
    vec2 checker = fract(uv * vec2(6.0, 3.0));
    vec2 checker_2 = max(abs(uvByY * vec2(6.0, 3.0)), abs(uvByX * vec2(6.0, 3.0)));
    vec2 checker_3 = stripes2(checker, checker_2);
    float checker_4 = 0.5 - checker_3.y * checker_3.x * 0.5;
    vec2 checker_5 = stripes2(fract(checker + vec2(0.05, 0.0)), checker_2);
    vec2 checker_6 = stripes2(fract(checker + vec2(0.0, 0.05)), checker_2);
    vec3 bumpMap_3 = (0.5 - checker_5.y * checker_5.x * 0.5 - checker_4) * 3.6 * worldTangentV - (0.5 - checker_6.y * checker_6.x * 0.5 - checker_4) * 1.8 * worldTangentU;
    vec3 bumpMap_4 = cross(bumpMap_1, bumpMap_3) + bumpMap_2;
    vec3 bumpMap = dot(bumpMap_2, bumpMap_1) < 0.0 ? -bumpMap_4 : bumpMap_4;
    vec3 normal = safeNormalize(eyeFromWorld(bumpMap)) * (gl_FrontFacing ? 1.0 : -1.0);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 67108864u, 0u, 2708833937u, 903913889u);
}
