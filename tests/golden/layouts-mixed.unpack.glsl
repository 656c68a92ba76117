// matc 0.2.0: reads layout mixed back. The normal is in eye space.

uniform usampler2D matc_gbuffer0;

#define SURFACE_HAS_normal
#define SURFACE_HAS_diffuse
#define SURFACE_HAS_specular
#define SURFACE_HAS_shininess
#define SURFACE_HAS_transparency
#define SURFACE_HAS_transparencyShininess
#define SURFACE_HAS_interpolatedTransparency
#define SURFACE_HAS_diffuseTransparency
#define SURFACE_HAS_ambient
#define SURFACE_HAS_emissive
#define SURFACE_HAS_ior
#define SURFACE_NORMALS_eye
struct Surface {
    vec3 normal; // Shading normal in eye space, unit length.
    vec3 diffuse; // Diffuse color.
    vec3 specular; // Specular color.
    float shininess; // Phong exponent of the specular lobe.
    vec3 transparency; // Transparency, including alpha: 1 + alpha (c - 1).
    float transparencyShininess; // Phong exponent of the transmitted lobe.
    float interpolatedTransparency; // 1 if transparency replaces diffuse and specular, 0 if it adds to them.
    vec3 diffuseTransparency; // Color of diffusely transmitted light.
    vec3 ambient; // Factor on ambient light.
    vec3 emissive; // Light that the surface emits.
    float ior; // Ratio of the indices of refraction.
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

// Inverse of logarithmBits, in [0, 65504].
float logarithmFromBits(uint code, int bits) {
    float place = float(code) - 1.0;
    float value = exp2(place * (19.9992954 / float((1 << bits) - 2)) - 4.0);
    return code == 0u ? 0.0 : min(value, 65504.0);
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

// Inverse of sharedExponentBits: exact for every code.
vec3 sharedExponentFromBits(uint code, int bits) {
    uint mask = (1u << bits) - 1u;
    uvec3 m = uvec3(code, code >> bits, code >> (2 * bits)) & mask;
    return vec3(m) * uintBitsToFloat((code >> (3 * bits)) + uint(112 - bits) << 23);
}

Surface unpackTexels(uvec4 target0) {
    Surface surface;
    surface.normal = octahedralFromBits(target0.x >> 2 & 16777215u, 12);
    surface.diffuse.x = rootFromBits(target0.y >> 20 & 255u, 8);
    surface.diffuse.y = rootFromBits(target0.z & 255u, 8);
    surface.diffuse.z = rootFromBits(target0.z >> 8 & 255u, 8);
    surface.specular = vec3(0.0);
    surface.shininess = 4.0;
    surface.transparency = vec3(0.0);
    surface.transparencyShininess = 65504.0;
    surface.interpolatedTransparency = 1.0;
    surface.diffuseTransparency = vec3(0.0);
    surface.ambient = vec3(0.0);
    surface.emissive = vec3(0.0);
    surface.ior = 1.0;
    uint number = target0.x & 3u;
    if (number == 0u) {
        surface.shininess = logarithmFromBits(target0.y & 1023u, 10);
        surface.diffuse = vec3(rootFromBits(target0.y >> 10 & 255u, 8), rootFromBits(target0.y >> 18 & 255u, 8), rootFromBits(target0.z & 255u, 8));
        surface.specular = vec3(rootFromBits(target0.z >> 8 & 255u, 8), rootFromBits(target0.z >> 16 & 255u, 8), rootFromBits(target0.z >> 24, 8));
        surface.diffuseTransparency = vec3(rootFromBits(target0.w & 255u, 8), rootFromBits(target0.w >> 8 & 255u, 8), rootFromBits(target0.w >> 16 & 255u, 8));
    } else if (number == 1u) {
        surface.emissive = sharedExponentFromBits(target0.x >> 2 & 67108863u, 7);
        surface.normal = octahedralFromBits(target0.y & 16777215u, 12);
        surface.shininess = logarithmFromBits(target0.z & 1023u, 10);
        surface.diffuse = vec3(rootFromBits(target0.y >> 24, 8), rootFromBits(target0.z >> 10 & 255u, 8), rootFromBits(target0.z >> 18 & 255u, 8));
        surface.specular = vec3(rootFromBits(target0.w & 255u, 8), rootFromBits(target0.w >> 8 & 255u, 8), rootFromBits(target0.w >> 16 & 255u, 8));
    } else if (number == 2u) {
        surface.transparencyShininess = logarithmFromBits(target0.y & 1023u, 10);
        surface.ior = logarithmFromBits(target0.y >> 10 & 1023u, 10);
        surface.transparency = vec3(rootFromBits(target0.z >> 16 & 255u, 8), rootFromBits(target0.z >> 24, 8), rootFromBits(target0.w & 255u, 8));
        surface.ambient = vec3(rootFromBits(target0.w >> 8 & 127u, 7) * 0.2, rootFromBits(target0.w >> 15 & 127u, 7) * 0.2, rootFromBits(target0.w >> 22 & 127u, 7) * 0.2);
    } else {
        surface.shininess = logarithmFromBits(target0.y & 1023u, 10);
        surface.ior = logarithmFromBits(target0.y >> 10 & 1023u, 10);
        surface.specular = vec3(rootFromBits(target0.z >> 16 & 255u, 8), rootFromBits(target0.z >> 24, 8), rootFromBits(target0.w & 255u, 8));
        surface.transparency = vec3(rootFromBits(target0.w >> 8 & 255u, 8), rootFromBits(target0.w >> 16 & 255u, 8), rootFromBits(target0.w >> 24, 8));
        surface.interpolatedTransparency = unormFromBits(target0.x >> 26 & 1u, 1);
    }
    return surface;
}

Surface unpackSurface(ivec2 pixel) {
    return unpackTexels(texelFetch(matc_gbuffer0, pixel, 0));
}
