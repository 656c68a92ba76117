// Reflection of a Principled surface: of directional light, ambient light, the sky, hemispheres,
// area lights. Follows surface_principled.glsl, which makes a Lit of a Surface.
vec3 surfaceOwn(Lit m) { return m.emissive; }

// Returns the specular reflection of uniform light, including the coat's.
vec3 glossAround(Lit m)
{
#ifdef LIT_COAT
    return m.specular + m.coatSpecular;
#else
    return m.specular;
#endif
}

// Returns the diffuse transmission of uniform light from behind.
vec3 evenFromBehind(Lit m)
{
#ifdef LIT_BEHIND
    return m.evenBehind;
#else
    return vec3(0.0);
#endif
}

vec3 surfaceAmbient(Lit m, vec3 ambient)
{
    return (m.even + evenFromBehind(m) + glossAround(m)) * ambient;
}
vec3 surfaceEven(Lit m) { return m.even; }

// Returns the surface without specular reflection: the dielectric loses its tint, and the metal its
// share.
Lit surfaceMatt(Lit m)
{
    m.base *= 1.0 - m.metal;
#ifdef LIT_GRAIN
    m.grainAgain *= 1.0 - m.metal;
#endif
    m.metal = 0.0;
    m.tint = m.specular = vec3(0.0);
#ifdef LIGHT_HAS_SKY
    m.specularRescattered = vec3(0.0);
#endif
#ifdef LIT_LAYERS
    m.metalBounce = m.dielectricBounce = vec3(0.0);
#endif
#ifdef LIT_COAT
    m.coatShine = m.coatSpecular = 0.0;
#endif
    return m;
}

#ifdef LIT_BEHIND
// Returns the diffuse transmission: light that enters on the other side, with the same
// transmittance as on this side, and is scattered within.
vec3 fromBehind(Lit m, vec3 l, float cosine)
{
    vec2 own = baseAlbedo(m, l, cosine);
    vec3 sum = m.kept * cosine * (1.0 - baseReflected(m, own, cosine)) * m.baseRatio * m.behind;
#ifdef LIT_LAYERS
    sum *= below(m, cosine, coatCosineOf(m, -l, cosine), own.x).z;
#endif
#ifdef LIT_COAT
    sum *= m.coatTint;
#endif
    return sum;
}
#endif

// Returns the share of light from direction l that reaches the eye, including the cosine. Values
// that do not depend on l are in m. A lobe of weight 0 is skipped, which a GPU does if all threads
// of a group agree.
vec3 surfaceLobe(Lit m, vec3 l)
{
    float cosine = dot(m.normal, l);
#ifdef LIT_BEHIND
    if (cosine < 0.0) return fromBehind(m, l, -cosine);
#endif
    if (cosine <= 0.0) return vec3(0.0);
    vec3 between = l + m.toEye;
    float square = max(dot(between, between), 1e-12), over = inversesqrt(square);
    vec3 h = between * over;
    // l.h is half of the length of l + v
    float facing = min(0.5 * square * over, 1.0), rest = 1.0 - facing, rest2 = rest * rest,
        rest5 = rest2 * rest2 * rest;
#ifdef LIT_ANISOTROPY
    float once = microfacetsAlong(m.anisotropy, m.normal, l, h, cosine, vec2(m.cosine, m.masked));
#else
    float once = microfacets(m.alpha, m.normal, h, cosine, vec2(m.cosine, m.masked));
#endif
    vec2 own = baseAlbedo(m, l, cosine);
    float again = cosine * own.x * m.lossRatio;
    TONE matt = cosine * (1.0 - baseReflected(m, own, cosine)) * m.baseRatio;
#ifdef LIT_LAYERS
    vec3 above = vec3(0.0);
    vec2 stray = vec2(0.0);
    if (m.layered) {
        float ofCoat = coatCosineOf(m, l, cosine), even = evenOf(m.microfacets.rough, cosine);
        vec4 layers = below(m, cosine, ofCoat, own.x);
        stray = cosine * strayed(m, layers.w, own) * m.multipleScatteringRatio;
        matt *= layers.z;
        again *= layers.z;
#ifdef LIT_COAT
        once *= (1.0 - m.stray) * veil(layers.x, m.coatVeil, m.coatMean, even);
        float shine = m.coatShine * microfacets(m.coatAlpha, m.coatNormal, h, ofCoat,
            vec2(m.coatCosine, m.coatMasked)) * mix(rest5, 1.0, m.coatReflectance);
#ifdef LIT_COAT_NORMAL
        shine = dot(m.coatNormal, l) > 0.0 ? shine : 0.0;
#endif
#ifdef LIT_FUZZ
        shine *= veil(layers.y, m.fuzzCoatVeil, m.fuzzMean,
            evenOf(m.coatMicrofacets.rough, ofCoat));
#endif
        above = vec3(shine);
#endif
#ifdef LIT_FUZZ
        once *= veil(layers.y, m.fuzzVeil, m.fuzzMean, even);
        above += m.fuzzColor * fibres(m.fuzzRough, dot(m.normal, h), cosine, m.cosine);
#endif
    }
#endif
    vec3 fresnel = max(m.base + rest5 * (1.0 - m.base) - m.dip * (facing * rest5 * rest), 0.0);
    TONE mirrored = TONE(mix(rest5, 1.0, m.reflectance));
#ifdef LIT_FILM
    if (m.film.weight > 0.0) {
        mirrored = mix(mirrored, filmReflected(m.film, facing, vec3(m.reflectance)), m.film.weight);
        fresnel = mix(fresnel, filmReflected(m.film, facing, m.base), m.film.weight);
    }
#endif
#ifdef LIT_GRAIN
    vec3 sent = (1.0 - m.metal) * grained(m.grain, m.base, m.grainAgain, dot(l, m.toEye),
        vec2(cosine, m.cosine), grainLost(m.grain, cosine));
#else
    vec3 sent = (1.0 - m.metal) * m.base;
#endif
    vec3 sum = matt * sent + again * mix(m.again * m.tint, m.metalAgain, m.metal) +
        once * (((1.0 - m.metal) * m.tint) * mirrored + m.metal * fresnel);
#ifdef LIT_LAYERS
    sum += stray.x * m.metalBounce + stray.y * m.dielectricBounce;
#ifdef LIT_COAT
    sum *= m.coatTint;
#endif
    sum += above;
#endif
    return m.kept * sum;
}

#ifdef LIGHT_HAS_SKY
// The microfacets' frame, and their widths along its first two axes.
struct SkyMicrofacets {
    mat3 frame;
    vec2 widths;
};

SkyMicrofacets skyMicrofacetsEven(vec3 normal, float alpha)
{
    vec3 aside = normalize(abs(normal.z) < 0.7 ? cross(normal, vec3(0.0, 0.0, 1.0))
        : cross(normal, vec3(1.0, 0.0, 0.0)));
    return SkyMicrofacets(mat3(aside, cross(normal, aside), normal), vec2(alpha));
}

// Returns the mean of the sky weighted by the microfacets' reflection, with reflectance `low` at
// normal incidence and `high` at grazing angles; 1 for a white sky. Importance sampling: microfacet
// normals are drawn by their visible area (Heitz 2018; by spherical caps: Dupuy and Benyoub 2023),
// in a spiral. Each sample is weighted by masking, and reads the mipmap level of the cube map whose
// texels are as large as the sample's solid angle.
//   Worked example, width 1 along the normal: microfacet normals are uniform over the sphere's
//   upper cap, and one at 60 degrees mirrors from below the horizon, so it counts nothing.
vec3 skySent(SkyMicrofacets f, vec3 toEye, vec3 low, vec3 high)
{
    vec3 v = toEye * f.frame;
    v.z = max(v.z, 1e-3);
    vec3 wide = vec3(f.widths * v.xy, v.z), sum = vec3(0.0), all = vec3(1e-9);
    float seen = length(wide), texels = float(textureSize(sky_map, 0).x);
    vec3 w = wide / seen;
    float share = 2.0 * SKY_PI * f.widths.x * f.widths.y * (v.z + seen) / float(SKY_SAMPLES);
    for (int i = 0; i < SKY_SAMPLES; i++) {
        float z = 1.0 - (float(i) + 0.5) / float(SKY_SAMPLES) * (1.0 + w.z),
            turn = 2.3999632 * float(i), flat_ = sqrt(max(1.0 - z * z, 0.0));
        vec3 cap = vec3(flat_ * cos(turn), flat_ * sin(turn), z) + w;
        vec3 h = normalize(vec3(f.widths * cap.xy, max(cap.z, 1e-6)));
        float facing = clamp(dot(v, h), 0.0, 1.0);
        vec3 l = 2.0 * facing * h - v;
        if (l.z <= 0.0) continue;
        vec2 steep = h.xy / f.widths;
        float width = h.z * h.z + dot(steep, steep), rest = 1.0 - facing;
        float left = l.z * (v.z + seen) / (l.z * seen + v.z * length(vec3(f.widths * l.xy, l.z)));
        vec3 weight = left * mix(low, high, rest * rest * rest * rest * rest);
        float level = 0.5 * log2(share * width * width * 6.0 * texels * texels / (4.0 * SKY_PI));
        sum += weight * textureLod(sky_map, skyWorld(f.frame * l), max(level, 0.0)).xyz;
        all += weight;
    }
    return sky_light.xyz * sum / all;
}

// Returns the reflected sky. Multiple scattering between microfacets, and specular light
// that layers spread, count as diffuse.
vec3 surfaceSky(Lit m)
{
    vec3 sum = (m.even + m.specularRescattered) * skyIrradiance(m.normal),
        once = m.specular - m.specularRescattered;
    if (any(greaterThan(once, vec3(0.0)))) {
#ifdef LIT_ANISOTROPY
        SkyMicrofacets microfacets = SkyMicrofacets(mat3(m.anisotropy.along, m.anisotropy.across,
            m.normal), m.anisotropy.widths);
#else
        SkyMicrofacets microfacets = skyMicrofacetsEven(m.normal, m.alpha);
#endif
        sum += once * skySent(microfacets, m.toEye, mix(m.tint * m.reflectance, m.base, m.metal),
            mix(m.tint, vec3(1.0), m.metal));
    }
#ifdef LIT_BEHIND
    if (any(greaterThan(m.evenBehind, vec3(0.0)))) sum += m.evenBehind * skyIrradiance(-m.normal);
#endif
#ifdef LIT_COAT
    if (m.coatSpecular > 0.0)
        sum += m.coatSpecular * skySent(skyMicrofacetsEven(m.coatNormal, m.coatAlpha), m.toEye,
            vec3(m.coatReflectance), vec3(1.0));
#endif
    return sum;
}
#endif

#ifdef LIGHT_HAS_HEMISPHERE
vec3 surfaceHemisphere(Lit m)
{
    vec3 sum = m.even * hemisphereMatt(m.normal) + evenFromBehind(m) * hemisphereMatt(-m.normal) +
        m.specular * hemisphereMirrored(m.reflected);
#ifdef LIT_COAT
    sum += m.coatSpecular * hemisphereMirrored(reflect(-m.toEye, m.coatNormal));
#endif
    return sum;
}
#endif

#ifdef LIGHT_HAS_AREAS
int surfaceAreaSides(Lit m)
{
    int sides = 2;
#ifdef LIT_COAT
    if (m.coatSpecular > 0.0) sides++;
#endif
#ifdef LIT_BEHIND
    if (any(greaterThan(m.evenBehind, vec3(0.0)))) sides++;
#endif
    return sides;
}

// Returns side i for area lights: diffuse, the base's specular, the coat's, transmission from
// behind.
AreaSide surfaceAreaSide(Lit m, int i)
{
#ifdef LIT_BEHIND
    if (i > 1 && i + 1 == surfaceAreaSides(m) && any(greaterThan(m.evenBehind, vec3(0.0))))
        return areaPowers(-m.normal, m.evenBehind, vec3(0.0), -m.normal, -m.normal, 0.0);
#endif
    AreaSide side = areaPowers(m.normal, i == 0 ? m.even : m.specular, vec3(0.0), m.normal,
        m.normal, i == 0 ? 0.0 : -1.0);
    side.into = m.roughnessInto;
#ifdef LIT_COAT
    if (i == 2) {
        side = areaPowers(m.coatNormal, vec3(m.coatSpecular), vec3(0.0), m.coatNormal, m.coatNormal,
            -1.0);
        side.into = m.coatInto;
    }
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
