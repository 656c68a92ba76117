// The surface model Principled, with the functions of surface_model.h: GGX microfacets with Smith's
// height-correlated masking, over a diffuse base or of metal. Light reflected more than once
// between microfacets is Kulla and Conty's lobe (2017), and so is the diffuse base, which reflects
// the light that was not reflected specularly: all three are reciprocal, and a white surface
// reflects all light.
//
// Worked example, reflectance 0.04 and roughness 0, along the normal: E is 1, so 0.04 are
// reflected. The base receives 1 - E(its cosine) from a direction, and emits 1 - E(1) = 0.96: over
// all directions a white base emits 0.96, and together that is 1.
//
// The Fresnel term is Schlick's, white at the horizon; for metal with an edge tint at 82 degrees
// (Hoffman 2019; OpenPBR 1.1). Slots that a layout lacks have the absent values of slots.def. Skies
// are sampled where microfacets mirror them to the eye, area lights use linearly transformed
// cosines; both are normalized to GGX's reflection of uniform light. Follows
// surface_microfacets.glsl and surface_anisotropic.glsl.
struct Lit {
    vec3 normal, toEye, reflected, base, tint, dip, emissive;
    vec3 metalAgain;  // multiple-scattering color of metal
    vec3 even, specular; // albedo for uniform light: of the diffuse and of the specular part
#ifdef LIGHT_HAS_SKY
    vec3 specularRescattered; // specular part that is scattered repeatedly, or spread by layers
#endif
    Roughness microfacets;
    float metal, alpha, cosine, masked, reflectance, kept; // `masked` is maskedOf() toward the eye
    // `again` is multiple scattering; `baseOfEye` the diffuse transmittance to the eye, layers
    // included
    TONE again, baseOfEye;
    TONE baseRatio;  // baseOfEye divided by the mean transmittance
    float lossRatio; // energy ratio for the multiple-scattering lobe
#ifdef LIT_ANISOTROPY
    Anisotropy anisotropy;
#endif
#ifdef LIT_GRAIN
    Grain grain;
    vec3 grainAgain; // the eye's factor of the light scattered within the base
#endif
#ifdef LIT_FILM
    Film film;
    // reflectance with the film: means over all directions; without multiple scattering, times the
    // layers' transmittance
    vec3 filmMean, metalFilmMean, filmLeft;
#endif
#ifdef LIGHT_HAS_AREAS
    mat3 roughnessInto, coatInto; // linear transforms of cosines (LTC), from areaMicrofacets()
#endif
#ifdef LIT_COAT
    vec3 coatTint, coatNormal;
    float coatCosine; // cosine between the eye and the coat's normal
    Roughness coatMicrofacets;
    float coat, coatShine, coatAlpha, coatReflectance, coatSpecular, coatMasked;
    float coatOfEye, coatMean; // transmittance of the coat: toward the eye, and the mean
    vec2 coatVeil;             // result of veiled() for the base's reflection
    Row spread;                // loss of a white rough mirror below the coat, by angle
    float stray;
#endif
#ifdef LIT_FUZZ
    vec3 fuzzColor; // color of the fuzz, multiplied by its weight
    float fuzz, fuzzRough, fuzzOfEye, fuzzMean; // values of the fuzz, as those of the coat
    vec2 fuzzVeil, fuzzCoatVeil;
    Row fuzzSpread;
#endif
#ifdef LIT_BEHIND
    // diffuse transmission through the surface: of a light, and of uniform light
    vec3 behind, evenBehind;
#endif
#ifdef LIT_LAYERS
    bool layered; // the surface has a coat or fuzz
    vec3 metalBounce, dielectricBounce; // reflection by the base of light that layers reflect back
    // multiple-scattering loss, below(), of metal and of the dielectric; over the mean
    vec2 multipleScatteringOfEye, multipleScatteringRatio;
    float multipleScatteringMore;
#endif
};

// Returns albedo() of the base for a direction with this cosine, and over all directions with that
// cosine.
vec2 baseAlbedo(Lit m, vec3 v, float cosine)
{
#ifdef LIT_ANISOTROPY
    return albedoAlong(cosine, anisotropyToward(m.anisotropy, v), m.anisotropy);
#else
    return albedo(cosine, m.microfacets);
#endif
}

vec2 baseAround(Lit m, float cosine)
{
#ifdef LIT_ANISOTROPY
    return albedoAround(cosine, m.anisotropy);
#else
    return albedo(cosine, m.microfacets);
#endif
}

// Returns the directional albedo of the dielectric, from albedo() and the cosine.
TONE baseReflected(Lit m, vec2 albedo, float cosine)
{
#ifdef LIT_FILM
    return filmedOf(m.film, albedo, vec2(cosine, m.alpha), m.reflectance, m.again);
#else
    return reflectedOf(albedo, m.reflectance, m.again);
#endif
}

#ifdef LIT_FUZZ
float fuzzThrough(Lit m, float cosine) { return 1.0 - m.fuzz * fuzzAlbedo(cosine, m.fuzzRough); }

#endif

#ifdef LIT_COAT
// Returns the directional albedo of the coat; light that it reflects more than once goes to the
// layer below.
float coatAlbedo(vec2 albedo, float reflectance)
{
    return mix(albedo.y, 1.0 - albedo.x, reflectance);
}

float coatThrough(Lit m, float cosine)
{
    return 1.0 - m.coat * coatAlbedo(albedo(cosine, m.coatMicrofacets), m.coatReflectance);
}

void litCoat(Surface s, inout Lit m)
{
    Coat coat = coatOf(s);
    m.coat = m.coatShine = clamp(s.coat, 0.0, 1.0);
    m.coatTint = coat.tint;
    m.coatNormal = coatNormalOf(s, m.normal);
    m.coatCosine = clamp(dot(m.coatNormal, m.toEye), 1e-3, 1.0);
    m.coatReflectance = coat.reflectance;
    m.coatMicrofacets = roughnessOf(coat.rough);
    m.coatAlpha = m.coatMicrofacets.alpha;
#ifdef LIGHT_HAS_AREAS
    m.coatInto = areaMicrofacets(m.coatMicrofacets.rough, m.coatNormal, m.toEye);
#endif
    m.coatMasked = maskedOf(m.coatAlpha, m.coatCosine);
    m.coatOfEye = coatThrough(m, m.coatCosine);
    m.coatMean = 0.0;
    m.layered = m.coat > 0.0;
    m.coatSpecular = m.kept * (1.0 - m.coatOfEye);
    float smoother = 1.0 - m.coatMicrofacets.rough * m.coatMicrofacets.rough,
        smoother2 = smoother * smoother;
    // the share is 1 for a smooth coat of index 1.6
    float share = m.coat * (1.0 - m.coatReflectance) * smoother2 * smoother2 * smoother * 1.0563;
    m.spread = coatSpread(m.microfacets.rough, share);
    m.stray = 0.022 * share * smoothstep(0.1, 0.35, m.microfacets.rough);
}
#endif

#ifdef LIT_FUZZ
void litFuzz(Surface s, inout Lit m)
{
    m.fuzz = clamp(s.fuzz, 0.0, 1.0);
    m.fuzzColor = vec3(0.0);
#ifdef SURFACE_HAS_fuzzColor
    m.fuzzColor = m.fuzz * clamp(s.fuzzColor, 0.0, 1.0);
#endif
    m.fuzzRough = fuzzRoughOf(s);
    m.fuzzOfEye = fuzzThrough(m, m.cosine);
    m.fuzzMean = 0.0;
    m.layered = m.layered || m.fuzz > 0.0;
    m.fuzzSpread = fuzzSpread(m.microfacets.rough, m.fuzz / (0.8 + 1.05 * m.fuzzRough));
}
#endif

#ifdef LIT_LAYERS
// Returns the cosine of a direction against the coat's normal, from its cosine against the base's.
float coatCosineOf(Lit m, vec3 v, float cosine)
{
#ifdef LIT_COAT_NORMAL
    return clamp(dot(m.coatNormal, v), 1e-3, 1.0);
#else
    return cosine;
#endif
}

// Returns the transmittance of the layers for a direction, by its cosines against the base and the
// coat: x, y of coat and fuzz; z of both; w the additional loss of a white rough mirror below,
// since light enters and leaves by different directions, which the product of veil() neglects. The
// loss is spread like multiple scattering. Per layer it is a polynomial in the base's roughness and
// the square root of the cosine, fitted to integrals within 0.011 of all light; a small additional
// share, `stray`, keeps it above 0.
vec4 below(Lit m, float cosine, float ofCoat, float loss)
{
    vec4 found = vec4(1.0, 1.0, 1.0, 0.0);
    float x = sqrt(cosine);
#ifdef LIT_COAT
    found.x = coatThrough(m, ofCoat);
    found.w = rowAt(m.spread, x);
    found.w = (1.0 - m.stray) * found.w + m.stray * (1.0 - loss) * found.x;
#endif
#ifdef LIT_FUZZ
    found.y = fuzzThrough(m, cosine);
    found.w = found.w * found.y + found.x * rowAt(m.fuzzSpread, x);
#endif
    found.z = found.x * found.y;
    found.w = max(found.w, 0.0);
    return found;
}

// Returns the multiple-scattering loss of a white mirror, and of one that reflects as the
// dielectric does, by its directional reflectance; greatest from directions where layers transmit
// least, so that a rough mirror loses up to 2.75 times as much.
vec2 strayed(Lit m, float stray, vec2 own)
{
    return stray * vec2(1.0, m.multipleScatteringMore *
        mix(own.y / max(1.0 - own.x, 1e-3), 1.0, m.reflectance));
}
#endif

// Computes means over all directions by Gaussian quadrature in the square root of the cosine:
// `mean` of 1 and of albedo(); `left` of the same times the layers' transmittance;
// `meanMultipleScattering` of strayed().
void litMeans(inout Lit m, out vec3 mean, out vec3 left, out vec2 meanMultipleScattering)
{
    const vec3 PLACE = vec3(0.0337652429, 0.1693953068, 0.380690407),
        WEIGHT = vec3(0.0856622462, 0.1803807865, 0.2339569673);
    mean = left = vec3(0.0);
#ifdef LIT_FILM
    m.filmMean = m.metalFilmMean = m.filmLeft = vec3(0.0);
#endif
    meanMultipleScattering = vec2(0.0);
#ifdef LIT_LAYERS
    m.multipleScatteringMore = 1.0 + 1.75 * smoothstep(0.15, 0.4, m.microfacets.rough);
#endif
    for (int i = 0; i < 6; i++) {
        float t = i < 3 ? PLACE[i] : 1.0 - PLACE[5 - i],
            share = 4.0 * WEIGHT[i < 3 ? i : 5 - i] * t * t * t;
        vec3 own = share * vec3(1.0, baseAround(m, t * t));
        mean += own;
#ifdef LIT_FILM
        vec3 filmed = (own.x - own.y) * filmAround(m.film, t * t, m.alpha, vec3(m.reflectance));
        m.filmMean += share * filmReflected(m.film, t * t, vec3(m.reflectance));
        m.metalFilmMean += share * filmReflected(m.film, t * t, m.base);
#endif
#ifdef LIT_LAYERS
        vec4 layers = below(m, t * t, t * t, own.y / share);
        meanMultipleScattering += share * strayed(m, layers.w, own.yz / share);
#ifdef LIT_COAT
        m.coatMean += share * layers.x;
#endif
#ifdef LIT_FUZZ
        m.fuzzMean += share * layers.y;
#endif
        own *= layers.z;
#ifdef LIT_FILM
        filmed *= layers.z;
#endif
#endif
        left += own;
#ifdef LIT_FILM
        m.filmLeft += filmed;
#endif
    }
    meanMultipleScattering = max(meanMultipleScattering, vec2(1e-6));
}

#ifdef LIT_GRAIN
// Returns the share of light from directions with that cosine that reaches the base.
TONE comesToBase(Lit m, float cosine)
{
    vec2 own = baseAround(m, cosine);
#ifdef LIT_LAYERS
    return (1.0 - baseReflected(m, own, cosine)) * below(m, cosine, cosine, own.x).z;
#else
    return 1.0 - baseReflected(m, own, cosine);
#endif
}

// Returns the reflection of uniform light, relative to that of a Lambertian base.
vec3 litGrain(Surface s, TONE meanBase, inout Lit m)
{
    m.grain = grainOf(clamp(s.diffuseRoughness, 0.0, 1.0), comesToBase(m, 1.0),
        comesToBase(m, 0.25), meanBase);
    TONE lost = grainLost(m.grain, m.cosine);
    m.grainAgain = grainAgain(m.grain, m.base) * lost;
    return m.base * (1.0 - lost) + m.grainAgain * (1.0 - m.grain.all);
}
#endif

Lit surfaceLit(Surface s, vec3 toEye)
{
    Lit m;
    m.normal = vec3(0.0, 0.0, 1.0);
#ifdef SURFACE_HAS_normal
    m.normal = s.normal;
#endif
    m.toEye = toEye;
    m.reflected = reflect(-toEye, m.normal);
    m.base = m.tint = m.emissive = vec3(0.0);
    m.metal = m.reflectance = 0.0;
    m.kept = 1.0;
    float rough = 0.0;
#ifdef SURFACE_HAS_diffuse
    m.base = clamp(s.diffuse, 0.0, 1.0);
#endif
#ifdef SURFACE_HAS_specular
    m.tint = clamp(s.specular, 0.0, 1.0);
#endif
#ifdef SURFACE_HAS_emissive
    m.emissive = s.emissive;
#endif
#ifdef SURFACE_HAS_metalness
    m.metal = clamp(s.metalness, 0.0, 1.0);
#endif
#ifdef SURFACE_HAS_roughness
    rough = s.roughness;
#endif
#ifdef SURFACE_HAS_reflectance
    m.reflectance = clamp(s.reflectance, 0.0, 1.0);
#endif
#ifdef SURFACE_HAS_transparency
    m.kept = 1.0 - holesOf(s);
#endif
    // min roughness, limited by float precision: a narrower lobe would fall between floats
    m.microfacets = roughnessOf(clamp(rough, 0.0316227766, 1.0));
#ifdef LIT_ANISOTROPY
    m.anisotropy = anisotropyOf(s.anisotropy, m.normal, m.microfacets.rough);
#endif
    m.alpha = m.microfacets.alpha;
#ifdef LIT_FILM
    m.film = filmOf(s);
#endif
    m.cosine = clamp(dot(m.normal, toEye), 1e-3, 1.0);
#ifdef LIGHT_HAS_AREAS
    m.roughnessInto = areaMicrofacets(m.microfacets.rough, m.normal, toEye);
#endif
#ifdef LIT_LAYERS
    m.layered = false;
#endif
#ifdef LIT_COAT
    litCoat(s, m);
#endif
#ifdef LIT_FUZZ
    litFuzz(s, m);
#endif
    vec3 mean, left;
    vec2 meanMultipleScattering;
    litMeans(m, mean, left, meanMultipleScattering);
#ifdef LIT_ANISOTROPY
    m.masked = maskedAlong(m.anisotropy, toEye, m.cosine);
#else
    m.masked = maskedOf(m.alpha, m.cosine);
#endif

    vec2 eye = baseAlbedo(m, toEye, m.cosine);
    TONE fresnel = TONE(mix(1.0 / 21.0, 1.0, m.reflectance));
#ifdef LIT_FILM
    fresnel = mix(fresnel, m.filmMean, m.film.weight);
#endif
    m.again = fresnel * fresnel * (1.0 - mean.y) / (1.0 - fresnel * mean.y);
    m.baseOfEye = 1.0 - baseReflected(m, eye, m.cosine);
    // bounds the divisor, as smooth surfaces have no multiple scattering
    m.lossRatio = eye.x / max(left.y, 1e-3);
    TONE reflected = TONE(mix(left.z, left.x - left.y, m.reflectance));
#ifdef LIT_FILM
    reflected = mix(reflected, m.filmLeft, m.film.weight);
#endif
    TONE meanBase = max(left.x - reflected - left.y * m.again, TONE(1e-4));

    // 17.6512 = 7 (7/6)^6, 0.4626641 = (6/7)^5
    m.dip = mix(vec3(0.4626641), vec3(1.0), m.base) * (1.0 - m.tint) * 17.6512;
    vec3 metal = mix(vec3(1.0 / 21.0), vec3(1.0), m.base) - m.dip / 126.0;
#ifdef LIT_FILM
    metal = mix(metal, m.metalFilmMean, m.film.weight);
#endif
    m.metalAgain = metal * metal * (1.0 - mean.y) / (1.0 - metal * mean.y);
    float rest = 1.0 - m.cosine, rest3 = rest * rest * rest;
    vec3 ofMetal = mix(vec3(eye.y), vec3(1.0 - eye.x), m.base) + eye.x * m.metalAgain -
        m.dip * (m.cosine * rest3 * rest3 * (1.0 - eye.x));
#ifdef LIT_FILM
    if (m.film.weight > 0.0 && m.metal > 0.0)
        ofMetal = mix(ofMetal, (1.0 - eye.x) * filmAround(m.film, m.cosine, m.alpha, m.base) +
            eye.x * m.metalAgain, m.film.weight);
#endif
#ifdef LIT_GRAIN
    vec3 sent = litGrain(s, meanBase, m);
#else
    vec3 sent = m.base;
#endif
    m.even = m.kept * (1.0 - m.metal) * m.baseOfEye * sent;
    m.specular = m.kept * mix((1.0 - m.baseOfEye) * m.tint, max(ofMetal, 0.0), m.metal);
#ifdef LIGHT_HAS_SKY
    m.specularRescattered = m.kept * eye.x * mix(m.again * m.tint, m.metalAgain, m.metal);
#endif
#ifdef LIT_BEHIND
    m.behind = clamp(s.diffuseTransparency, 0.0, 1.0);
    m.evenBehind = m.kept * m.baseOfEye * m.behind;
#endif
#ifdef LIT_LAYERS
    vec4 layers = below(m, m.cosine, coatCosineOf(m, toEye, m.cosine), eye.x);
    m.metalBounce = m.metal * max(metal, 0.0);
    m.dielectricBounce = (1.0 - m.metal) * m.tint;
    m.multipleScatteringOfEye = strayed(m, layers.w, eye);
    m.multipleScatteringRatio = m.multipleScatteringOfEye / meanMultipleScattering;
    m.even *= layers.z;
#ifdef LIT_BEHIND
    m.evenBehind *= layers.z;
#endif
    m.specular *= layers.z;
#ifdef LIGHT_HAS_SKY
    m.specularRescattered = m.specularRescattered * layers.z +
        m.kept * (m.multipleScatteringOfEye.x * m.metalBounce +
        m.multipleScatteringOfEye.y * m.dielectricBounce);
#endif
    m.emissive *= layers.z;
    m.lossRatio *= layers.z;
    m.baseOfEye *= layers.z;
#ifdef LIT_COAT
    m.coatVeil = veiled(m.coatOfEye, m.coatMean, m.microfacets.rough, m.cosine);
    m.even *= m.coatTint;
#ifdef LIT_BEHIND
    m.evenBehind *= m.coatTint;
#endif
    m.specular *= m.coatTint;
    m.coatSpecular *= layers.y;
#ifdef LIGHT_HAS_SKY
    m.specularRescattered *= m.coatTint;
#endif
#endif
#ifdef LIT_FUZZ
    m.fuzzVeil = veiled(m.fuzzOfEye, m.fuzzMean, m.microfacets.rough, m.cosine);
#ifdef LIT_COAT
    m.fuzzCoatVeil = veiled(m.fuzzOfEye, m.fuzzMean, m.coatMicrofacets.rough, m.coatCosine);
#endif
    m.even += m.kept * (1.0 - layers.y) / max(m.fuzz, 1e-6) * m.fuzzColor;
#endif
#endif
    m.baseRatio = m.baseOfEye / meanBase;
#ifdef LIGHT_HAS_SKY
    m.specularRescattered = clamp(m.specularRescattered, vec3(0.0), m.specular);
#endif
    return m;
}
