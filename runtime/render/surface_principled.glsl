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
struct Lit {
    vec3 normal, toEye, reflected, base, tint, dip, emissive;
    vec3 metalAgain;  // the share of what was reflected twice and more, of metal
    vec3 even, gloss; // what it sends of light from all around: diffusely, by reflection
    float metal, alpha, rough, cosine, reflectance, again, kept, lossOfEye, baseOfEye, meanLoss, meanBase;
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

// The share of light that the layers above let through.
vec3 surfaceThrough(Surface s)
{
#ifdef SURFACE_HAS_transparency
    return s.transparency;
#else
    return vec3(0.0);
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
    return m;
}

vec3 surfaceOwn(Lit m) { return m.emissive; }
vec3 surfaceAmbient(Lit m, vec3 ambient) { return (m.even + m.gloss) * ambient; }
vec3 surfaceEven(Lit m) { return m.even; }

// Without its tint nothing is reflected by the dielectric; metal reflects alone.
Lit surfaceMatt(Lit m)
{
    m.base *= 1.0 - m.metal;
    m.metal = 0.0;
    m.tint = m.gloss = vec3(0.0);
    return m;
}

vec3 surfaceLobe(Lit m, vec3 l)
{
    float cosine = dot(m.normal, l);
    if (cosine <= 0.0) return vec3(0.0);
    vec3 between = l + m.toEye;
    vec3 h = between * inversesqrt(max(dot(between, between), 1e-12));
    float alpha2 = m.alpha * m.alpha, high = dot(m.normal, h), facing = clamp(dot(h, l), 0.0, 1.0);
    vec3 across = cross(m.normal, h);
    float width = alpha2 * high * high + dot(across, across); // of small angles, too
    float masked = cosine * sqrt(alpha2 + (1.0 - alpha2) * m.cosine * m.cosine) +
        m.cosine * sqrt(alpha2 + (1.0 - alpha2) * cosine * cosine);
    float once = 0.5 * cosine * alpha2 / (width * width * masked);

    vec2 own = albedo(cosine, m.alpha, m.rough);
    float again = cosine * own.x * m.lossOfEye / m.meanLoss;
    float rest = 1.0 - facing, rest5 = rest * rest * rest * rest * rest;
    float matt = cosine * (1.0 - reflectedOf(own, m.reflectance, m.again)) * m.baseOfEye / m.meanBase;
    vec3 dielectric = matt * m.base + m.tint * (once * mix(rest5, 1.0, m.reflectance) + again * m.again);
    vec3 fresnel = max(mix(vec3(rest5), vec3(1.0), m.base) - m.dip * (facing * rest5 * rest), 0.0);
    return m.kept * mix(dielectric, once * fresnel + again * m.metalAgain, m.metal);
}

// Of Phong's lobe that is as wide around the mirrored direction.
float standInExponent(Lit m) { return clamp(0.5 / (m.alpha * m.alpha) - 0.5, 0.0, 65504.0); }

#ifdef LIGHT_HAS_SKY
vec3 surfaceSky(Lit m)
{
    float exponent = standInExponent(m);
    return m.even * skyIrradiance(m.normal) + m.gloss * (0.5 * exponent + 1.0) * skyLobe(m.reflected, m.reflected, exponent);
}
#endif

#ifdef LIGHT_HAS_HEMISPHERE
vec3 surfaceHemisphere(Lit m) { return m.even * hemisphereMatt(m.normal) + m.gloss * hemisphereMirrored(m.reflected); }
#endif

#ifdef LIGHT_HAS_AREAS
AreaSide surfaceAreaSide(Lit m)
{
    float exponent = standInExponent(m);
    return AreaSide(m.normal, m.even, m.gloss * (0.5 * exponent + 1.0), m.reflected, m.reflected, exponent);
}

vec3 surfaceArea(Lit m, Area light) { return areaOfSide(light, surfaceAreaSide(m)); }
#endif
