// matc 0.2.0: reads layout halves back. The normal is in eye space.

uniform sampler2D matc_gbuffer0;
uniform sampler2D matc_gbuffer1;

#define SURFACE_HAS_normal
#define SURFACE_HAS_diffuse
#define SURFACE_HAS_specular
#define SURFACE_HAS_shininess
#define SURFACE_HAS_emissive
#define SURFACE_NORMALS_eye
struct Surface {
    vec3 normal; // Shading normal in eye space, unit length.
    vec3 diffuse; // Diffuse color.
    vec3 specular; // Specular color.
    float shininess; // Phong exponent of the specular lobe.
    vec3 emissive; // Light that the surface emits.
};

// Inverse of halfFromCode: an integer in [0, 61439] for any value. Comparisons find the exponent;
// every step is exact.
float codeFromHalf(float value) {
    float v = clamp(abs(value) * 16384.0, 1.0, 1073217536.0);
    float exponent = 0.0;
    if (v >= 65536.0) { v *= 1.0 / 65536.0; exponent += 16.0; }
    if (v >= 256.0) { v *= 1.0 / 256.0; exponent += 8.0; }
    if (v >= 16.0) { v *= 1.0 / 16.0; exponent += 4.0; }
    if (v >= 4.0) { v *= 1.0 / 4.0; exponent += 2.0; }
    if (v >= 2.0) { v *= 1.0 / 2.0; exponent += 1.0; }
    return 1024.0 * exponent + floor(1024.0 * (v - 1.0)) + (value < 0.0 ? 30720.0 : 0.0);
}

// Inverse of encodeOctahedral: a unit vector for any e in [-1, 1]^2. The length before normalize()
// is >= 1/sqrt(3).
vec3 decodeOctahedral(vec2 e) {
    float z = 1.0 - abs(e.x) - abs(e.y);
    float fold = max(-z, 0.0);
    return normalize(vec3(e.x + (e.x < 0.0 ? fold : -fold), e.y + (e.y < 0.0 ? fold : -fold), z));
}

// Inverse of octahedralRadix: a unit vector for any value. Angular error at most 0.99 degrees.
vec3 octahedralFromRadix(float value) {
    float code = codeFromHalf(value);
    float y = floor((code + 0.5) * (1.0 / 247.0));
    return decodeOctahedral(min((vec2(code - 247.0 * y, y) - 123.0) / 123.0, 1.0));
}

// Inverse of packRadix: multiples of 1/246 and 1/247, rounded to nearest; in [0, 1]^2 for any
// value. The half step makes the division robust to rounding.
vec2 unpackRadix(float value) {
    float code = codeFromHalf(value);
    float y = floor((code + 0.5) * (1.0 / 247.0));
    return min(vec2(code - 247.0 * y, y) / vec2(246.0, 247.0), 1.0);
}

Surface unpackTexels(vec4 target0, vec4 target1) {
    Surface surface;
    surface.normal = octahedralFromRadix(target0.x);
    surface.shininess = target0.y;
    vec2 group2 = unpackRadix(target0.z);
    surface.diffuse.x = group2.x;
    surface.diffuse.y = group2.y;
    vec2 group3 = unpackRadix(target0.w);
    surface.diffuse.z = group3.x;
    surface.specular.x = group3.y;
    vec2 group4 = unpackRadix(target1.x);
    surface.specular.y = group4.x;
    surface.specular.z = group4.y;
    surface.emissive = vec3(target1.y, target1.z, target1.w);
    return surface;
}

Surface unpackSurface(ivec2 pixel) {
    return unpackTexels(texelFetch(matc_gbuffer0, pixel, 0), texelFetch(matc_gbuffer1, pixel, 0));
}
