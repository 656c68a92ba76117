#version 330 core
// matc 0.1.0: pass gbuffer, layout compact

in vec2 uv;
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

// Box-filtered triangle wave (0 at integers v, 1 a quarter later). For edge < 1/2 from the nearest
// corner, without cancellation; else from the antiderivative. Error 3e-7. Edge 0 gives the point
// value.
float triangleMean(float v, float edge) {
    float t = fract(fract(v) - 0.25);
    float height = abs(4.0 * t - 2.0) - 1.0;
    float corner = 0.25 * (1.0 - abs(height));
    float over = max(0.5 * edge - corner, 0.0);
    float near = height - sign(height) * 4.0 * over * (over / max(edge, 1.0e-37));
    float a = fract(t - 0.5 * edge);
    float b = fract(t + 0.5 * edge);
    vec2 q = vec2(a, b);
    vec2 integral = q * (1.0 - 2.0 * q) + max(q - 0.5, 0.0) * (4.0 * q - 2.0);
    float far = (integral.y - integral.x) / max(edge, 0.25);
    return edge < 0.5 ? near : far;
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

// Quantizes v, clamped to [0, 1], to `bits` <= 16 bits, rounding to nearest.
uint unormBits(float v, int bits) {
    return uint(floor(clamp(v, 0.0, 1.0) * float((1 << bits) - 1) + 0.5));
}

// Quantizes sqrt(v), v clamped to [0, 1], to `bits` bits: finer steps near 0, like perceived
// lightness.
uint rootBits(float v, int bits) {
    return unormBits(sqrt(clamp(v, 0.0, 1.0)), bits);
}

void main() {
    vec3 localPositionByX = dFdx(localPosition);
    vec3 localPositionByY = dFdy(localPosition);
    // window.yaml:29 windows
    float windows_1 = clamp((localPosition.y - 0.5) * 0.25, 0.0, 1.0);
    vec3 normal = safeNormalize(eyeNormal) * (gl_FrontFacing ? 1.0 : -1.0);
    // window.yaml:25 bays
    vec3 bays;
    if (0.49 < localPosition.y && localPosition.y < 4.51) {
        // window.yaml:26 Gradient
        float bays_gradient_1 = localPositionByX.x * 0.333333;
        float bays_gradient_2 = localPositionByY.x * 0.333333;
        float bays_gradient = triangleMean(localPosition.x * 0.333333 + 0.25, sqrt(bays_gradient_2 * bays_gradient_2 + bays_gradient_1 * bays_gradient_1));
        // window.yaml:20 leaded
        vec3 leaded;
        if (-0.34 < bays_gradient) {
            // window.yaml:21 Gradient
            float leaded_gradient = abs(fract(localPosition.x * 2.0 + 0.25) * 4.0 - 1.0) - 2.0;
            // window.yaml:17 Gradient
            float rows_gradient = abs(fract(localPosition.y * 2.0 + 0.25) * 4.0 - 1.0) - 2.0;
            // window.yaml:12 Checker
            vec2 panes_checker_1 = fract(uv * vec2(0.5));
            bool panes_checker_2 = (0.5 <= panes_checker_1.x) != (0.5 <= panes_checker_1.y);
            // window.yaml:11 panes
            vec2 panes_1 = fract(uv);
            vec3 panes = (0.5 <= panes_1.x) != (0.5 <= panes_1.y) ? (panes_checker_2 ? vec3(0.75, 0.01, 0.02) : vec3(1.0, 0.5, 0.02)) : panes_checker_2 ? vec3(0.02, 0.08, 0.85) : vec3(0.02, 0.5, 0.12);
            // window.yaml:16 rows
            vec3 rows = mix(panes, vec3(0.0), clamp((abs(rows_gradient) - 1.84) * 25.0, 0.0, 1.0));
            leaded = mix(rows, vec3(0.0), clamp((abs(leaded_gradient) - 1.84) * 25.0, 0.0, 1.0));
        } else {
            leaded = vec3(0.0);
        }
        bays = leaded * clamp((bays_gradient + 0.34) * 100.0, 0.0, 1.0);
    } else {
        bays = vec3(0.0);
    }
    vec3 windows = bays * (windows_1 - clamp((localPosition.y - 4.5) * 100.0, 0.0, 1.0)) + bays * (clamp((localPosition.y - 0.49) * 100.0, 0.0, 1.0) - windows_1);
    fragment0 = uvec4(octahedralBits(normal, 12) << 2 | 4227858434u, 2307915776u, rootBits(windows.x, 5) << 27 | 891833u, rootBits(windows.y, 5) << 12 | rootBits(windows.z, 5) << 17 | 645922816u);
}
