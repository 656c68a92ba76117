// What a Principled surface sends of light: of a direction, of ambient light, the sky, hemispheres, areas. Before it stands surface_principled.glsl, which
// makes a Lit of a Surface.
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

// What it sends of light from all around behind it.
vec3 evenFromBehind(Lit m)
{
#ifdef LIT_BEHIND
    return m.evenBehind;
#else
    return vec3(0.0);
#endif
}

vec3 surfaceAmbient(Lit m, vec3 ambient) { return (m.even + evenFromBehind(m) + glossAround(m)) * ambient; }
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

#ifdef LIT_BEHIND
// Light that comes in on the other side, as through this one, and was scattered within.
vec3 fromBehind(Lit m, vec3 l, float cosine)
{
    vec2 own = baseAlbedo(m, l, cosine);
    vec3 sum = m.kept * cosine * (1.0 - baseReflected(m, own)) * m.baseOfEye / m.meanBase * m.behind;
#ifdef LIT_LAYERS
    sum *= below(m, cosine, own.x).z;
#endif
#ifdef LIT_COAT
    sum *= m.coatTint;
#endif
    return sum;
}
#endif

vec3 surfaceLobe(Lit m, vec3 l)
{
    float cosine = dot(m.normal, l);
#ifdef LIT_BEHIND
    if (cosine < 0.0) return fromBehind(m, l, -cosine);
#endif
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
    TONE matt = cosine * (1.0 - baseReflected(m, own)) * m.baseOfEye / m.meanBase;
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
    vec3 fresnel = max(mix(vec3(rest5), vec3(1.0), m.base) - m.dip * (facing * rest5 * rest), 0.0);
    TONE mirrored = TONE(mix(rest5, 1.0, m.reflectance));
#ifdef LIT_FILM
    if (m.film.weight > 0.0) {
        mirrored = mix(mirrored, filmReflected(m.film, facing, vec3(m.reflectance)), m.film.weight);
        fresnel = mix(fresnel, filmReflected(m.film, facing, m.base), m.film.weight);
    }
#endif
    vec3 dielectric = matt * m.base + m.tint * (once * mirrored + again * m.again);
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
#ifdef LIT_BEHIND
    if (any(greaterThan(m.evenBehind, vec3(0.0)))) sum += m.evenBehind * skyIrradiance(-m.normal);
#endif
#ifdef LIT_COAT
    if (m.coatGloss > 0.0) sum += skyMirrored(m, vec3(m.coatGloss), m.coatAlpha);
#endif
    return sum;
}
#endif

#ifdef LIGHT_HAS_HEMISPHERE
vec3 surfaceHemisphere(Lit m)
{
    return m.even * hemisphereMatt(m.normal) + evenFromBehind(m) * hemisphereMatt(-m.normal) + glossAround(m) * hemisphereMirrored(m.reflected);
}
#endif

#ifdef LIGHT_HAS_AREAS
int surfaceAreaSides(Lit m)
{
    int sides = 2;
#ifdef LIT_COAT
    if (m.coatGloss > 0.0) sides++;
#endif
#ifdef LIT_BEHIND
    if (any(greaterThan(m.evenBehind, vec3(0.0)))) sides++;
#endif
    return sides;
}

// What it sends evenly, what the base reflects, what the coat reflects, what comes from behind.
AreaSide surfaceAreaSide(Lit m, int i)
{
#ifdef LIT_BEHIND
    if (i > 1 && i + 1 == surfaceAreaSides(m) && any(greaterThan(m.evenBehind, vec3(0.0)))) return areaPowers(-m.normal, m.evenBehind, vec3(0.0), -m.normal, -m.normal, 0.0);
#endif
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
