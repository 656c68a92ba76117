// The surface model Principled, as surface_model.h asks for one: GGX's microfacets with Smith's masking by height, over a diffuse base, or of metal.
// Light that is reflected more than once between facets is Kulla and Conty's lobe (2017), and so is the diffuse base, which sends what was
// not reflected: all three are the same when light and eye change places, and a white surface sends all that arrives.
//
// Worked example, reflectance 0.04 and roughness 0, seen along the normal: E is 1, so 0.04 are reflected. What reaches the base from a
// direction is 1 - E(its cosine), and what leaves it 1 - E(1) = 0.96: over all directions a white base sends 0.96, and together that is 1.
//
// Fresnel's formulas are Schlick's, with white at the horizon; of metal with an edge tint, its reflection at 82 degrees (Hoffman 2019; OpenPBR
// 1.1). What a layout lacks is as slots.def says of absent slots. Skies meet a stand-in for the lobe, Phong's, as wide around the mirrored direction, area lights
// linearly transformed cosines, both of as much light as GGX sends of light from all around. Before it stand surface_facets.glsl and surface_anisotropic.glsl.
struct Lit {
    vec3 normal, toEye, reflected, base, tint, dip, emissive;
    vec3 metalAgain;  // the share of what was reflected twice and more, of metal
    vec3 even, gloss; // what it sends of light from all around: diffusely, by reflection
    Gloss facets;
    float metal, alpha, cosine, reflectance, again, kept;
    float lossOfEye, baseOfEye, meanLoss, meanBase; // as it leaves, and in the mean, with what layers let through of both
#ifdef LIT_ANISOTROPY
    Anisotropy anisotropy;
#endif
#ifdef LIGHT_HAS_AREAS
    mat3 glossInto, coatInto; // areaFacets()
#endif
#ifdef LIT_COAT
    vec3 coatTint;
    Gloss coatFacets;
    float coat, coatShine, coatAlpha, coatReflectance, coatGloss;
    float coatOfEye, coatMean; // what is let through: of the eye's light, in the mean
    Row spread; // what a white rough mirror below lacks, by the angle
    float stray;
#endif
#ifdef LIT_FUZZ
    vec3 fuzzColor; // its weight in it
    float fuzz, fuzzRough, fuzzOfEye, fuzzMean; // the same
    Row fuzzSpread;
#endif
#ifdef LIT_LAYERS
    vec3 metalBounce, dielectricBounce; // what the base reflects of light that layers send back to it
    vec2 strayOfEye, meanStray;         // below(), of metal and of the dielectric
#endif
};

// albedo() of the base, of a direction that has this cosine, and over all that have it.
vec2 baseAlbedo(Lit m, vec3 v, float cosine)
{
#ifdef LIT_ANISOTROPY
    return albedoAlong(cosine, anisotropyToward(m.anisotropy, v), m.anisotropy);
#else
    return albedo(cosine, m.facets);
#endif
}

vec2 baseAround(Lit m, float cosine)
{
#ifdef LIT_ANISOTROPY
    return albedoAround(cosine, m.anisotropy);
#else
    return albedo(cosine, m.facets);
#endif
}

#ifdef LIT_FUZZ
float fuzzThrough(Lit m, float cosine) { return 1.0 - m.fuzz * fuzzAlbedo(cosine, m.fuzzRough); }

#endif

#ifdef LIT_COAT
// What the coat reflects of all that arrives from a direction; light that it reflects more than once goes to what lies below.
float coatAlbedo(vec2 albedo, float reflectance) { return mix(albedo.y, 1.0 - albedo.x, reflectance); }

float coatThrough(Lit m, float cosine) { return 1.0 - m.coat * coatAlbedo(albedo(cosine, m.coatFacets), m.coatReflectance); }

void litCoat(Surface s, inout Lit m)
{
    m.coat = m.coatShine = clamp(s.coat, 0.0, 1.0);
    m.coatTint = vec3(1.0);
    m.coatReflectance = 0.0;
    float rough = 0.0;
#ifdef SURFACE_HAS_coatTint
    m.coatTint = clamp(s.coatTint, 0.0, 1.0);
#endif
#ifdef SURFACE_HAS_coatRoughness
    rough = s.coatRoughness;
#endif
#ifdef SURFACE_HAS_coatReflectance
    m.coatReflectance = clamp(s.coatReflectance, 0.0, 1.0);
#endif
    m.coatFacets = glossOf(clamp(rough, 0.0316227766, 1.0));
    m.coatAlpha = m.coatFacets.alpha;
#ifdef LIGHT_HAS_AREAS
    m.coatInto = areaFacets(m.coatFacets.rough, m.normal, m.toEye);
#endif
    m.coatOfEye = coatThrough(m, m.cosine);
    m.coatMean = 0.0;
    m.coatGloss = m.kept * (1.0 - m.coatOfEye);
    float smoother = 1.0 - m.coatFacets.rough * m.coatFacets.rough, smoother2 = smoother * smoother;
    float share = m.coat * (1.0 - m.coatReflectance) * smoother2 * smoother2 * smoother * 1.0563; // 1 of a smooth coat of index 1.6
    m.spread = coatSpread(m.facets.rough, share);
    m.stray = 0.022 * share * smoothstep(0.1, 0.35, m.facets.rough);
}
#endif

#ifdef LIT_FUZZ
void litFuzz(Surface s, inout Lit m)
{
    m.fuzz = clamp(s.fuzz, 0.0, 1.0);
    m.fuzzColor = vec3(0.0);
    m.fuzzRough = 0.0;
#ifdef SURFACE_HAS_fuzzColor
    m.fuzzColor = m.fuzz * clamp(s.fuzzColor, 0.0, 1.0);
#endif
#ifdef SURFACE_HAS_fuzzRoughness
    m.fuzzRough = s.fuzzRoughness;
#endif
    m.fuzzRough = clamp(m.fuzzRough, 0.2, 1.0); // narrower fibres of that lobe would send more than arrives
    m.fuzzOfEye = fuzzThrough(m, m.cosine);
    m.fuzzMean = 0.0;
    m.fuzzSpread = fuzzSpread(m.facets.rough, m.fuzz / (0.8 + 1.05 * m.fuzzRough));
}
#endif

#ifdef LIT_LAYERS
// Layers from a direction: x, y what coat and fuzz let through; z both; w what a white rough mirror below lacks of that, since light comes to the eye
// by one way and goes by another, which the product of veil() cannot tell. It is spread as what facets reflect twice is. Of each layer it is a polynomial
// in the base's roughness and the root of the cosine, fitted to integrals within 0.011 of all light; a small share more, `stray`, keeps it above 0.
vec4 below(Lit m, float cosine, float loss)
{
    vec4 found = vec4(1.0, 1.0, 1.0, 0.0);
    float x = sqrt(cosine);
#ifdef LIT_COAT
    found.x = coatThrough(m, cosine);
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

// Of a white mirror, and of one that reflects as the dielectric does, by the share that it reflects of a direction; most from those from which layers
// let least through, so that a rough one lacks up to 2.75 times as much.
vec2 strayed(Lit m, float stray, vec2 own)
{
    float more = 1.0 + 1.75 * smoothstep(0.15, 0.4, m.facets.rough);
    return stray * vec2(1.0, more * mix(own.y / max(1.0 - own.x, 1e-3), 1.0, m.reflectance));
}
#endif

// Means over all directions by Gauss' rule in the root of the cosine: of 1, and of albedo(); left, of the same times what layers let through.
void litMeans(inout Lit m, out vec3 mean, out vec3 left)
{
    const vec3 PLACE = vec3(0.0337652429, 0.1693953068, 0.380690407), WEIGHT = vec3(0.0856622462, 0.1803807865, 0.2339569673);
    mean = left = vec3(0.0);
#ifdef LIT_LAYERS
    m.meanStray = vec2(0.0);
#endif
    for (int i = 0; i < 6; i++) {
        float t = i < 3 ? PLACE[i] : 1.0 - PLACE[5 - i], share = 4.0 * WEIGHT[i < 3 ? i : 5 - i] * t * t * t;
        vec3 own = share * vec3(1.0, baseAround(m, t * t));
        mean += own;
#ifdef LIT_LAYERS
        vec4 layers = below(m, t * t, own.y / share);
        m.meanStray += share * strayed(m, layers.w, own.yz / share);
#ifdef LIT_COAT
        m.coatMean += share * layers.x;
#endif
#ifdef LIT_FUZZ
        m.fuzzMean += share * layers.y;
#endif
        own *= layers.z;
#endif
        left += own;
    }
#ifdef LIT_LAYERS
    m.meanStray = max(m.meanStray, vec2(1e-6));
#endif
}

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
    m.kept = 1.0 - clamp(max(s.transparency.x, max(s.transparency.y, s.transparency.z)), 0.0, 1.0);
#endif
    m.facets = glossOf(clamp(rough, 0.0316227766, 1.0)); // of floats: a narrower lobe would lie between them
#ifdef LIT_ANISOTROPY
    m.anisotropy = anisotropyOf(s.anisotropy, m.normal, m.facets.rough);
#endif
    m.alpha = m.facets.alpha;
    m.cosine = clamp(dot(m.normal, toEye), 1e-3, 1.0);
#ifdef LIGHT_HAS_AREAS
    m.glossInto = areaFacets(m.facets.rough, m.normal, toEye);
#endif
#ifdef LIT_COAT
    litCoat(s, m);
#endif
#ifdef LIT_FUZZ
    litFuzz(s, m);
#endif
    vec3 mean, left;
    litMeans(m, mean, left);

    vec2 eye = baseAlbedo(m, toEye, m.cosine);
    float fresnel = mix(1.0 / 21.0, 1.0, m.reflectance);
    m.again = fresnel * fresnel * (1.0 - mean.y) / (1.0 - fresnel * mean.y);
    m.lossOfEye = eye.x;
    m.baseOfEye = 1.0 - reflectedOf(eye, m.reflectance, m.again);
    m.meanLoss = max(left.y, 1e-3); // so smooth that a second reflection is nothing
    m.meanBase = max(left.x - mix(left.z, left.x - left.y, m.reflectance) - left.y * m.again, 1e-4);

    m.dip = mix(vec3(0.4626641), vec3(1.0), m.base) * (1.0 - m.tint) * 17.6512; // (6/7)^5; 7 (7/6)^6
    vec3 metal = mix(vec3(1.0 / 21.0), vec3(1.0), m.base) - m.dip / 126.0;
    m.metalAgain = metal * metal * (1.0 - mean.y) / (1.0 - metal * mean.y);
    float rest = 1.0 - m.cosine, rest3 = rest * rest * rest;
    vec3 ofMetal = mix(vec3(eye.y), vec3(1.0 - eye.x), m.base) + eye.x * m.metalAgain -
        m.dip * (m.cosine * rest3 * rest3 * (1.0 - eye.x));
    m.even = m.kept * (1.0 - m.metal) * m.baseOfEye * m.base;
    m.gloss = m.kept * mix((1.0 - m.baseOfEye) * m.tint, max(ofMetal, 0.0), m.metal);
#ifdef LIT_LAYERS
    vec4 layers = below(m, m.cosine, eye.x);
    m.metalBounce = m.metal * max(metal, 0.0);
    m.dielectricBounce = (1.0 - m.metal) * m.tint;
    m.strayOfEye = strayed(m, layers.w, eye);
    m.even *= layers.z;
    m.gloss *= layers.z;
    m.emissive *= layers.z;
    m.lossOfEye *= layers.z;
    m.baseOfEye *= layers.z;
#ifdef LIT_COAT
    m.even *= m.coatTint;
    m.gloss *= m.coatTint;
    m.coatGloss *= layers.y;
#endif
#ifdef LIT_FUZZ
    m.even += m.kept * (1.0 - layers.y) / max(m.fuzz, 1e-6) * m.fuzzColor;
#endif
#endif
    return m;
}

vec3 surfaceOwn(Lit m) { return m.emissive; }

// What it reflects of light from all around, the coat's share too.
vec3 glossAround(Lit m)
{
#ifdef LIT_COAT
    return m.gloss + m.coatGloss;
#else
    return m.gloss;
#endif
}

vec3 surfaceAmbient(Lit m, vec3 ambient) { return (m.even + glossAround(m)) * ambient; }
vec3 surfaceEven(Lit m) { return m.even; }

// Without its tint nothing is reflected by the dielectric; metal reflects alone.
Lit surfaceMatt(Lit m)
{
    m.base *= 1.0 - m.metal;
    m.metal = 0.0;
    m.tint = m.gloss = vec3(0.0);
#ifdef LIT_LAYERS
    m.metalBounce = m.dielectricBounce = vec3(0.0);
#endif
#ifdef LIT_COAT
    m.coatShine = m.coatGloss = 0.0;
#endif
    return m;
}

vec3 surfaceLobe(Lit m, vec3 l)
{
    float cosine = dot(m.normal, l);
    if (cosine <= 0.0) return vec3(0.0);
    vec3 between = l + m.toEye;
    vec3 h = between * inversesqrt(max(dot(between, between), 1e-12));
    float facing = clamp(dot(h, l), 0.0, 1.0), rest = 1.0 - facing, rest5 = rest * rest * rest * rest * rest;
#ifdef LIT_ANISOTROPY
    float once = facetsAlong(m.anisotropy, m.normal, l, m.toEye, vec2(cosine, m.cosine));
#else
    float once = facets(m.alpha, m.normal, h, cosine, m.cosine);
#endif
    vec2 own = baseAlbedo(m, l, cosine);
    float again = cosine * own.x * m.lossOfEye / m.meanLoss;
    float matt = cosine * (1.0 - reflectedOf(own, m.reflectance, m.again)) * m.baseOfEye / m.meanBase;
#ifdef LIT_LAYERS
    vec4 layers = below(m, cosine, own.x);
    vec2 even = evenOf(m.facets.rough, vec2(cosine, m.cosine)), stray = cosine * strayed(m, layers.w, own) * m.strayOfEye / m.meanStray;
#ifdef LIT_COAT
    once *= (1.0 - m.stray) * veil(layers.x, m.coatOfEye, m.coatMean, even);
#endif
#ifdef LIT_FUZZ
    once *= veil(layers.y, m.fuzzOfEye, m.fuzzMean, even);
#endif
    matt *= layers.z;
    again *= layers.z;
#endif
    vec3 dielectric = matt * m.base + m.tint * (once * mix(rest5, 1.0, m.reflectance) + again * m.again);
    vec3 fresnel = max(mix(vec3(rest5), vec3(1.0), m.base) - m.dip * (facing * rest5 * rest), 0.0);
    vec3 sum = mix(dielectric, once * fresnel + again * m.metalAgain, m.metal);
#ifdef LIT_LAYERS
    sum += stray.x * m.metalBounce + stray.y * m.dielectricBounce;
#endif
#ifdef LIT_COAT
    float shine = m.coatShine * facets(m.coatAlpha, m.normal, h, cosine, m.cosine) * mix(rest5, 1.0, m.coatReflectance);
#ifdef LIT_FUZZ
    shine *= veil(layers.y, m.fuzzOfEye, m.fuzzMean, evenOf(m.coatFacets.rough, vec2(cosine, m.cosine)));
#endif
    sum = sum * m.coatTint + shine;
#endif
#ifdef LIT_FUZZ
    sum += m.fuzzColor * fibres(m.fuzzRough, dot(m.normal, h), cosine, m.cosine);
#endif
    return m.kept * sum;
}

// Of Phong's lobe that is as wide around the mirrored direction.
float standInExponent(float alpha) { return clamp(0.5 / (alpha * alpha) - 0.5, 0.0, 65504.0); }

#ifdef LIGHT_HAS_SKY
vec3 skyMirrored(Lit m, vec3 gloss, float alpha)
{
    float exponent = standInExponent(alpha);
    return gloss * (0.5 * exponent + 1.0) * skyLobe(m.reflected, m.reflected, exponent);
}

vec3 surfaceSky(Lit m)
{
    vec3 sum = m.even * skyIrradiance(m.normal) + skyMirrored(m, m.gloss, m.alpha);
#ifdef LIT_COAT
    if (m.coatGloss > 0.0) sum += skyMirrored(m, vec3(m.coatGloss), m.coatAlpha);
#endif
    return sum;
}
#endif

#ifdef LIGHT_HAS_HEMISPHERE
vec3 surfaceHemisphere(Lit m) { return m.even * hemisphereMatt(m.normal) + glossAround(m) * hemisphereMirrored(m.reflected); }
#endif

#ifdef LIGHT_HAS_AREAS
int surfaceAreaSides(Lit m)
{
#ifdef LIT_COAT
    if (m.coatGloss > 0.0) return 3;
#endif
    return 2;
}

// What it sends evenly, what the base reflects, what the coat reflects.
AreaSide surfaceAreaSide(Lit m, int i)
{
    AreaSide side = areaPowers(m.normal, i == 0 ? m.even : m.gloss, vec3(0.0), m.normal, m.normal, i == 0 ? 0.0 : -1.0);
    side.into = m.glossInto;
#ifdef LIT_COAT
    if (i == 2) side.even = vec3(m.coatGloss);
    if (i == 2) side.into = m.coatInto;
#endif
    return side;
}

vec3 surfaceArea(Lit m, Area light)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < surfaceAreaSides(m); i++) sum += areaOfSide(light, surfaceAreaSide(m, i));
    return sum;
}
#endif
