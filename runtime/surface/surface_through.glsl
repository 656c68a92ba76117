// Transmittance of every surface model: the share of the light behind it that passes straight
// through, without refraction. For a transmissive Principled it is the cut-out share plus the share
// that its layers do not reflect toward toEye.
#ifdef LIT_CLEAR
vec3 notReflected(Surface s, vec3 toEye)
{
    float cosine = clamp(abs(dot(s.normal, toEye)), 1e-3, 1.0), rough = 0.0, reflectance = 0.0;
    vec3 left = vec3(1.0);
#ifdef SURFACE_HAS_roughness
    rough = s.roughness;
#endif
#ifdef SURFACE_HAS_reflectance
    reflectance = clamp(s.reflectance, 0.0, 1.0);
#endif
    rough = clamp(rough, 0.0316227766, 1.0);
    vec2 base = albedo(cosine, roughnessOf(rough));
#ifdef LIT_FILM
    left *= 1.0 - filmedOf(filmOf(s), base, vec2(cosine, rough * rough), reflectance, vec3(0.0));
#else
    left *= 1.0 - reflectedOf(base, reflectance, 0.0);
#endif
#ifdef LIT_COAT
    if (s.coat > 0.0) {
        Coat coat = coatOf(s);
        float ofCoat = clamp(abs(dot(coatNormalOf(s, s.normal), toEye)), 1e-3, 1.0);
        left *= coat.tint * (1.0 - min(s.coat, 1.0) *
            coatAlbedo(albedo(ofCoat, roughnessOf(coat.rough)), coat.reflectance));
    }
#endif
#ifdef LIT_FUZZ
    left *= 1.0 - s.fuzz * fuzzAlbedo(cosine, fuzzRoughOf(s));
#endif
    return left;
}
#endif

vec3 surfaceThrough(Surface s, vec3 toEye)
{
#ifdef SURFACE_HAS_transparency
#ifdef LIT_CLEAR
    if (s.transmission > 0.0) {
        float holes = holesOf(s);
        return holes + (s.transparency - holes) * notReflected(s, toEye);
    }
#endif
    return s.transparency;
#else
    return vec3(0.0);
#endif
}
