// The surface model Principled, as surface_model.h asks for one: GGX's microfacets with Smith's masking by height, over a diffuse base, or of metal.
// Light that is reflected more than once between facets is Kulla and Conty's lobe (2017), and so is the diffuse base, which sends what was
// not reflected: all three are the same when light and eye change places, and a white surface sends all that arrives.
//
// Worked example, reflectance 0.04 and roughness 0, seen along the normal: E is 1, so 0.04 are reflected. What reaches the base from a
// direction is 1 - E(its cosine), and what leaves it 1 - E(1) = 0.96: over all directions a white base sends 0.96, and together that is 1.
//
// Fresnel's formulas are Schlick's, with white at the horizon; of metal with an edge tint, its reflection at 82 degrees (Hoffman 2019; OpenPBR
// 1.1). What a layout lacks is as slots.def says of absent slots. Area lights and skies meet a stand-in for the lobe, Phong's, as wide around
// the mirrored direction, of as much light as GGX sends of light from all around: it is exact where light is the same all around.
#if defined(SURFACE_HAS_coat) && !defined(SURFACE_LACKS_coat)
#define LIT_COAT
#endif
#if defined(SURFACE_HAS_fuzz) && !defined(SURFACE_LACKS_fuzz)
#define LIT_FUZZ
#endif
struct Lit {
    vec3 normal, toEye, reflected, base, tint, dip, emissive;
    vec3 metalAgain;  // the share of what was reflected twice and more, of metal
    vec3 even, gloss; // what it sends of light from all around: diffusely, by reflection
    float metal, alpha, rough, cosine, reflectance, again, kept, lossOfEye, baseOfEye, meanLoss, meanBase;
    float grazing; // how much of light from all around is reflected because it grazes
#ifdef LIT_COAT
    vec3 coatTint;
    float coat, coatShine, coatAlpha, coatRough, coatReflectance, coatGloss;
    float coatOfEye, coatMean, coatMatt; // what is let through: of the eye's light, in the mean, in the mean of what goes on to the base
#endif
#ifdef LIT_FUZZ
    vec3 fuzzColor; // its weight in it
    float fuzz, fuzzRough, fuzzOfEye, fuzzMean, fuzzMatt; // the same
#endif
};

// Albedos of the lobe with Fresnel's term 1: x is 1 - E, what is lost to facets behind others, y the part of E that Schlick's (1 - cosine)^5 has.
// Polynomials, fitted to integrals of the lobe: within 0.0075 and 0.0075 for all roughnesses and angles (tests/test_principled.c).
vec2 albedo(float cosine, float alpha, float rough)
{
    vec4 a = vec4(1.0, alpha, alpha * alpha, alpha * alpha * alpha);
    float s = cosine * (1.0 + alpha) / (cosine + alpha);
    float loss = dot(a, vec4(0.00634693698, -0.00473154853, 0.00389329609, 0.00121399513)) +
        s * (dot(a, vec4(-0.0671279429, 0.548630094, 1.97996088, -0.697315134)) +
        s * (dot(a, vec4(2.02100602, -6.3290626, 4.26653632, -3.00341556)) +
        s * (dot(a, vec4(-3.95883663, 15.2380571, -18.2050845, 10.2376181)) +
        s * dot(a, vec4(1.99221029, -9.43930269, 13.7204664, -7.62444489)))));
    vec4 r = vec4(1.0, rough, rough * rough, rough * rough * rough);
    float r4 = r.z * r.z, x = sqrt(cosine + 0.5 * alpha);
    float q = dot(r, vec4(0.998499904, 0.00679777259, -6.03906349, 8.02837019)) + 6.09351893 * r4 +
        x * (dot(r, vec4(-0.013894471, 3.23717483, 16.1780769, -56.1228103)) + 7.70266709 * r4 +
        x * (dot(r, vec4(-1.05040225, -11.3484384, 10.8545589, 59.4177572)) - 25.2731559 * r4 +
        x * (dot(r, vec4(0.168108196, 9.27962622, -26.527742, -2.76189671)) + 7.59827104 * r4)));
    q = clamp(q, 0.0, 1.0);
    loss = clamp(loss, 0.0, 1.0);
    return vec2(loss, (1.0 - loss) * q * q * q * q * q);
}

// What the dielectric reflects of all that arrives from a direction.
float reflectedOf(vec2 albedo, float reflectance, float again)
{
    return mix(albedo.y, 1.0 - albedo.x, reflectance) + albedo.x * again;
}

// The mean over all directions, by Gauss' rule in the root of the cosine.
vec2 meanAlbedo(float alpha, float rough)
{
    const vec4 PLACE = vec4(0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558);
    const vec4 WEIGHT = vec4(0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 8; i++) {
        float t = 0.5 * PLACE[i & 3] + (i < 4 ? 0.0 : 0.5);
        sum += 2.0 * WEIGHT[i & 3] * t * t * t * albedo(t * t, alpha, rough);
    }
    return sum;
}

// GGX with Smith's masking by height and Fresnel's term 1, over 4 cosine of the eye, as in the header; h is the half vector.
float facets(float alpha, vec3 normal, vec3 h, float cosine, float eye)
{
    float alpha2 = alpha * alpha, high = dot(normal, h);
    vec3 across = cross(normal, h);
    float width = alpha2 * high * high + dot(across, across); // of small angles, too
    float masked = cosine * sqrt(alpha2 + (1.0 - alpha2) * eye * eye) + eye * sqrt(alpha2 + (1.0 - alpha2) * cosine * cosine);
    return 0.5 * cosine * alpha2 / (width * width * masked);
}

#if defined(LIT_COAT) || defined(LIT_FUZZ)
// What a layer leaves of light that goes in by one direction and out by another, by what it lets through of each, and of all in the mean: the same when
// both change places. A mirror below has the same share both ways, which counts once; what is sent evenly counts the one over the mean, times the
// other. A rough mirror is between: `even` was fitted so that white below stays white within 0.03 (tests/test_principled.c).
float veil(float through, float eye, float mean, float even)
{
    return through * eye * inversesqrt(max(mix(through, mean, even) * mix(eye, mean, even), 1e-8));
}

float evenOf(float rough) { return 0.85 * smoothstep(0.05, 0.75, rough); }
#endif

#ifdef LIT_FUZZ
// All that fuzz of weight 1 sends of light from a direction: a polynomial, fitted to integrals of its lobe within 0.005 for cosines from 0.04 on.
float fuzzAlbedo(float cosine, float rough)
{
    vec4 r = vec4(1.0, rough, rough * rough, rough * rough * rough);
    float x = sqrt(cosine);
    return clamp(dot(r, vec4(1.56415816, -3.06939249, 3.85871481, -1.6926477)) +
        x * (dot(r, vec4(-2.30757704, 6.7952917, -9.34145144, 4.31469007)) +
        x * (dot(r, vec4(-0.372148166, 0.129239755, 1.2437114, -0.989127772)) +
        x * dot(r, vec4(1.08179061, -3.5441627, 4.07626323, -1.60441801)))), 0.0, 1.0);
}

float fuzzMean(float r) { return 0.0881620773 + r * (0.42777512 + r * (-0.456029773 + r * 0.182884797)); }

// Fibres that stand up, by the sine of the half angle (Estevez and Kulla 2017), masked as Neubelt and Pettineo have it.
float fibres(float rough, float high, float cosine, float eye)
{
    float power = 0.5 / rough;
    return 0.5 * cosine * (1.0 + power) * pow(max(1.0 - high * high, 1e-6), power) / (2.0 * (cosine + eye - cosine * eye));
}
#endif

#ifdef LIT_COAT
// What the coat reflects of all that arrives from a direction; light that it reflects more than once goes to what lies below.
float coatAlbedo(vec2 albedo, float reflectance) { return mix(albedo.y, 1.0 - albedo.x, reflectance); }

// Means of albedo over all directions, by polynomials in the roughness: of what a coat reflects within 0.0005.
vec2 coatMeans(float rough)
{
    float r = rough;
    return clamp(vec2(0.00146749718 + r * (-0.0284925137 + r * (-0.0733768949 + r * (1.71938923 - r * 1.02655571))),
                      0.0481269953 + r * (0.0686805341 + r * (-0.537455356 + r * (0.716137831 - r * 0.292122978)))), 0.0, 1.0);
}

void litCoat(Surface s, inout Lit m)
{
    m.coat = m.coatShine = clamp(s.coat, 0.0, 1.0);
    m.coatTint = vec3(1.0);
    m.coatRough = m.coatReflectance = 0.0;
#ifdef SURFACE_HAS_coatTint
    m.coatTint = clamp(s.coatTint, 0.0, 1.0);
#endif
#ifdef SURFACE_HAS_coatRoughness
    m.coatRough = s.coatRoughness;
#endif
#ifdef SURFACE_HAS_coatReflectance
    m.coatReflectance = clamp(s.coatReflectance, 0.0, 1.0);
#endif
    m.coatRough = clamp(m.coatRough, 0.0316227766, 1.0);
    m.coatAlpha = m.coatRough * m.coatRough;
    m.coatOfEye = 1.0 - m.coat * coatAlbedo(albedo(m.cosine, m.coatAlpha, m.coatRough), m.coatReflectance);
    vec2 mean = coatMeans(m.coatRough);
    m.coatMean = max(1.0 - m.coat * coatAlbedo(mean, m.coatReflectance), 1e-3);
    m.coatMatt = m.coatMean + 1.4 * (1.0 - m.coatRough) * (1.0 - m.coatMean) * m.grazing; // both keep off what grazes: once is enough
    m.grazing += m.coat * (1.0 - m.coatReflectance) * mean.y;
    m.coatGloss = m.kept * (1.0 - m.coatOfEye);
    m.even *= m.coatTint * m.coatOfEye;
    m.gloss *= m.coatTint * m.coatOfEye;
    m.emissive *= m.coatOfEye;
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
    float r = m.fuzzRough, sent = fuzzAlbedo(m.cosine, r);
    m.fuzzOfEye = 1.0 - m.fuzz * sent;
    m.fuzzMean = 1.0 - m.fuzz * fuzzMean(r);
    m.fuzzMatt = m.fuzzMean + (1.4 - r) * (1.0 - m.fuzzMean) * m.grazing;
    m.even = m.even * m.fuzzOfEye + m.kept * sent * m.fuzzColor;
    m.gloss *= m.fuzzOfEye;
    m.emissive *= m.fuzzOfEye;
#ifdef LIT_COAT
    m.coatGloss *= m.fuzzOfEye;
#endif
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
    m.metal = m.rough = m.reflectance = 0.0;
    m.kept = 1.0;
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
    m.rough = s.roughness;
#endif
#ifdef SURFACE_HAS_reflectance
    m.reflectance = clamp(s.reflectance, 0.0, 1.0);
#endif
#ifdef SURFACE_HAS_transparency
    m.kept = 1.0 - clamp(max(s.transparency.x, max(s.transparency.y, s.transparency.z)), 0.0, 1.0);
#endif
    m.rough = clamp(m.rough, 0.0316227766, 1.0); // of floats: a narrower lobe would lie between them
    m.alpha = m.rough * m.rough;
    m.cosine = clamp(dot(m.normal, toEye), 1e-3, 1.0);

    vec2 mean = meanAlbedo(m.alpha, m.rough), eye = albedo(m.cosine, m.alpha, m.rough);
    float fresnel = mix(1.0 / 21.0, 1.0, m.reflectance);
    m.again = fresnel * fresnel * (1.0 - mean.x) / (1.0 - fresnel * mean.x);
    m.meanLoss = max(mean.x, 1e-3); // so smooth that a second reflection is nothing
    m.lossOfEye = eye.x;
    m.baseOfEye = 1.0 - reflectedOf(eye, m.reflectance, m.again);
    m.meanBase = max(1.0 - reflectedOf(mean, m.reflectance, m.again), 1e-4);

    m.dip = mix(vec3(0.4626641), vec3(1.0), m.base) * (1.0 - m.tint) * 17.6512; // (6/7)^5; 7 (7/6)^6
    vec3 metal = mix(vec3(1.0 / 21.0), vec3(1.0), m.base) - m.dip / 126.0;
    m.metalAgain = metal * metal * (1.0 - mean.x) / (1.0 - metal * mean.x);
    float rest = 1.0 - m.cosine, rest3 = rest * rest * rest;
    vec3 ofMetal = mix(vec3(eye.y), vec3(1.0 - eye.x), m.base) + eye.x * m.metalAgain -
        m.dip * (m.cosine * rest3 * rest3 * (1.0 - eye.x));
    m.even = m.kept * (1.0 - m.metal) * m.baseOfEye * m.base;
    m.gloss = m.kept * mix((1.0 - m.baseOfEye) * m.tint, max(ofMetal, 0.0), m.metal);
    m.grazing = (1.0 - m.reflectance) * mean.y;
#ifdef LIT_COAT
    litCoat(s, m);
#endif
#ifdef LIT_FUZZ
    litFuzz(s, m);
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
    float once = facets(m.alpha, m.normal, h, cosine, m.cosine);
    vec2 own = albedo(cosine, m.alpha, m.rough);
    float again = cosine * own.x * m.lossOfEye / m.meanLoss;
    float matt = cosine * (1.0 - reflectedOf(own, m.reflectance, m.again)) * m.baseOfEye / m.meanBase;
#if defined(LIT_COAT) || defined(LIT_FUZZ)
    float even = evenOf(m.rough);
    vec2 left = vec2(1.0); // of what is sent evenly, and of reflections
#ifdef LIT_COAT
    float coat = 1.0 - m.coat * coatAlbedo(albedo(cosine, m.coatAlpha, m.coatRough), m.coatReflectance);
    left *= vec2(coat * m.coatOfEye / m.coatMatt, veil(coat, m.coatOfEye, m.coatMean, even));
#endif
#ifdef LIT_FUZZ
    float fuzz = 1.0 - m.fuzz * fuzzAlbedo(cosine, m.fuzzRough);
    left *= vec2(fuzz * m.fuzzOfEye / m.fuzzMatt, veil(fuzz, m.fuzzOfEye, m.fuzzMean, even));
#endif
    matt *= left.x;
    again *= left.x;
    once *= left.y;
#endif
    vec3 dielectric = matt * m.base + m.tint * (once * mix(rest5, 1.0, m.reflectance) + again * m.again);
    vec3 fresnel = max(mix(vec3(rest5), vec3(1.0), m.base) - m.dip * (facing * rest5 * rest), 0.0);
    vec3 sum = mix(dielectric, once * fresnel + again * m.metalAgain, m.metal);
#ifdef LIT_COAT
    float shine = m.coatShine * facets(m.coatAlpha, m.normal, h, cosine, m.cosine) * mix(rest5, 1.0, m.coatReflectance);
#ifdef LIT_FUZZ
    shine *= veil(fuzz, m.fuzzOfEye, m.fuzzMean, evenOf(m.coatRough));
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
    return m.coatGloss > 0.0 ? 2 : 1;
#else
    return 1;
#endif
}

// What it sends evenly and what the base reflects; then what the coat reflects.
AreaSide surfaceAreaSide(Lit m, int i)
{
    vec3 even = m.even, gloss = m.gloss;
    float alpha = m.alpha;
#ifdef LIT_COAT
    if (i == 1) {
        even = vec3(0.0);
        gloss = vec3(m.coatGloss);
        alpha = m.coatAlpha;
    }
#endif
    float exponent = standInExponent(alpha);
    return AreaSide(m.normal, even, gloss * (0.5 * exponent + 1.0), m.reflected, m.reflected, exponent);
}

vec3 surfaceArea(Lit m, Area light)
{
    vec3 sum = vec3(0.0);
    int sides = surfaceAreaSides(m);
    for (int i = 0; i < sides; i++) sum += areaOfSide(light, surfaceAreaSide(m, i));
    return sum;
}
#endif
