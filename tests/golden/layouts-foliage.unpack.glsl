// matc 0.2.0: reads layout foliage back. The normal is in eye space.

uniform usampler2D matc_gbuffer0;
uniform usampler2D matc_gbuffer1;

#define SURFACE_HAS_normal
#define SURFACE_HAS_diffuse
#define SURFACE_HAS_specular
#define SURFACE_HAS_shininess
#define SURFACE_HAS_transparency
#define SURFACE_HAS_diffuseTransparency
#define SURFACE_NORMALS_eye
struct Surface {
    vec3 normal; // Shading normal in eye space, unit length.
    vec3 diffuse; // Diffuse color.
    vec3 specular; // Specular color.
    float shininess; // Phong exponent of the specular lobe.
    vec3 transparency; // Transparency, including alpha: 1 + alpha (c - 1).
    vec3 diffuseTransparency; // Color of diffusely transmitted light.
};

// Inverse of encodeOctahedral: a unit vector for any e in [-1, 1]^2. The length before normalize()
// is >= 1/sqrt(3).
vec3 decodeOctahedral(vec2 e) {
    float z = 1.0 - abs(e.x) - abs(e.y);
    float fold = max(-z, 0.0);
    return normalize(vec3(e.x + (e.x < 0.0 ? fold : -fold), e.y + (e.y < 0.0 ? fold : -fold), z));
}

// Inverse of octahedralWhole: a unit vector. Angular error at most 242.5 / (2^bits - 2) degrees.
vec3 octahedralFromWhole(vec2 whole, int bits) {
    float scale = floor(exp2(float(bits - 1)) + 0.5) - 1.0;
    return decodeOctahedral(whole / scale);
}

// Inverse of octahedralBits: a unit vector for every code.
vec3 octahedralFromBits(uint code, int bits) {
    float scale = float((1 << (bits - 1)) - 1);
    vec2 whole = vec2(code & ((1u << bits) - 1u), code >> bits) - scale;
    return octahedralFromWhole(whole, bits);
}

// Inverse of unormBits, in [0, 1].
float unormFromBits(uint code, int bits) {
    return float(code) / float((1 << bits) - 1);
}

// Inverse of rootBits, in [0, 1]. Error at most 1 / (2^bits - 1).
float rootFromBits(uint code, int bits) {
    float root = unormFromBits(code, bits);
    return root * root;
}

Surface unpackTexels(uvec4 target0, uvec4 target1) {
    Surface surface;
    surface.normal = octahedralFromBits(target0.x >> 1 & 16777215u, 12);
    surface.shininess = 10.0;
    surface.transparency = vec3(0.0);
    surface.diffuseTransparency = vec3(0.0);
    uint number = target0.x & 1u;
    if (number == 0u) {
        surface.diffuse = vec3(rootFromBits(target0.y & 1023u, 10), rootFromBits(target0.y >> 10 & 1023u, 10), rootFromBits(target0.y >> 20 & 1023u, 10));
        surface.specular = vec3(unormFromBits(target1.x & 255u, 8) * 0.2);
    } else {
        surface.diffuse = vec3(rootFromBits(target0.y & 255u, 8), rootFromBits(target0.y >> 8 & 255u, 8), rootFromBits(target0.y >> 16 & 255u, 8));
        surface.specular = vec3(unormFromBits(target0.x >> 25 & 63u, 6) * 0.2);
        surface.diffuseTransparency = vec3(rootFromBits(target0.y >> 24 & 63u, 6), rootFromBits(target1.x & 63u, 6), rootFromBits(target1.x >> 6 & 63u, 6));
        surface.transparency = vec3(unormFromBits(target1.x >> 12 & 15u, 4));
    }
    return surface;
}

Surface unpackSurface(ivec2 pixel) {
    return unpackTexels(texelFetch(matc_gbuffer0, pixel, 0), texelFetch(matc_gbuffer1, pixel, 0));
}
