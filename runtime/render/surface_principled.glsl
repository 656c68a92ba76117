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
#if defined(LIT_COAT) || defined(LIT_FUZZ)
#define LIT_LAYERS
#endif
// What of GGX's albedos depends on the roughness alone: polynomials in what an angle gives, by albedo().
struct Gloss {
    float alpha, rough;
    vec4 loss, grazing;
    vec2 lossMore, grazingMore;
};

struct Lit {
    vec3 normal, toEye, reflected, base, tint, dip, emissive;
    vec3 metalAgain;  // the share of what was reflected twice and more, of metal
    vec3 even, gloss; // what it sends of light from all around: diffusely, by reflection
    Gloss facets;
    float metal, alpha, cosine, reflectance, again, kept;
    float lossOfEye, baseOfEye, meanLoss, meanBase; // as it leaves, and in the mean, with what layers let through of both
#ifdef LIT_COAT
    vec3 coatTint;
    Gloss coatFacets;
    float coat, coatShine, coatAlpha, coatReflectance, coatGloss;
    float coatOfEye, coatMean; // what is let through: of the eye's light, in the mean
    vec4 spread; // what a white rough mirror below lacks, by the angle
    vec2 spreadMore;
    float stray;
#endif
#ifdef LIT_FUZZ
    vec3 fuzzColor; // its weight in it
    float fuzz, fuzzRough, fuzzOfEye, fuzzMean; // the same
    vec4 fuzzSpread;
    vec2 fuzzSpreadMore;
#endif
#ifdef LIT_LAYERS
    vec3 metalBounce, dielectricBounce; // what the base reflects of light that layers send back to it
    vec2 strayOfEye, meanStray;         // below(), of metal and of the dielectric
#endif
};

Gloss glossOf(float rough)
{
    Gloss g;
    float alpha = rough * rough;
    vec4 a = vec4(1.0, alpha, alpha * alpha, alpha * alpha * alpha), r = vec4(1.0, rough, alpha, alpha * rough);
    vec2 more = a.zw * a.z, moreRough = r.zw * r.z;
    g.alpha = alpha;
    g.rough = rough;
    g.loss = vec4(dot(a, vec4(0.00563398208, -0.0843984781, 0.356630063, -0.616003578)) + dot(more, vec2(0.486410182, -0.144437895)),
                    dot(a, vec4(0.041883195, 2.51902204, -7.23108312, 16.4288191)) + dot(more, vec2(-13.9349608, 4.21058823)),
                    dot(a, vec4(1.08441251, -20.5015295, 82.6345043, -159.170619)) + dot(more, vec2(128.404945, -38.1080236)),
                    dot(a, vec4(-1.32628322, 53.9185548, -253.968034, 500.640058)) + dot(more, vec2(-412.211923, 124.299324)));
    g.lossMore = vec2(dot(a, vec4(-0.981185825, -53.4389793, 299.486867, -620.27736)) + dot(more, vec2(526.469036, -162.321269)),
                    dot(a, vec4(1.17702241, 17.5301485, -119.667408, 263.41627)) + dot(more, vec2(-231.729768, 73.3007772)));
    g.grazing = vec4(dot(r, vec4(1.00229858, -0.0693790402, -7.90042211, 12.1028064)) + dot(moreRough, vec2(87.3390786, -147.509621)),
                    dot(r, vec4(-0.0748609383, 6.8437939, 33.6529518, -326.852167)) + dot(moreRough, vec2(135.047532, 484.87721)),
                    dot(r, vec4(-0.928605093, -47.0745144, 166.337778, 695.952749)) + dot(moreRough, vec2(-1120.34262, -481.625648)),
                    dot(r, vec4(1.56063199, 98.8272047, -721.720845, 86.4021829)) + dot(moreRough, vec2(1317.50747, 134.337864)));
    g.grazingMore = vec2(dot(r, vec4(-4.14312206, -73.0814366, 848.262777, -1072.40906)) + dot(moreRough, vec2(-161.647723, -63.7352037)),
                    dot(r, vec4(2.83756091, 10.8233579, -302.155228, 578.156651)) + dot(moreRough, vec2(-238.912745, 68.6817093)));
    return g;
}

// Albedos of the lobe with Fresnel's term 1: x is 1 - E, what is lost to facets behind others, y the part of E that Schlick's (1 - cosine)^5 has.
// Fitted to integrals of the lobe: within 0.0055 and 0.0035 for all roughnesses and angles (tests/test_principled.c).
vec2 albedo(float cosine, Gloss g)
{
    float s = cosine * (1.0 + g.alpha) / (cosine + g.alpha), x = sqrt(cosine + 0.5 * g.alpha);
    float loss = g.loss.x + s * (g.loss.y + s * (g.loss.z + s * (g.loss.w + s * (g.lossMore.x + s * g.lossMore.y))));
    float q = g.grazing.x + x * (g.grazing.y + x * (g.grazing.z + x * (g.grazing.w + x * (g.grazingMore.x + x * g.grazingMore.y))));
    loss = clamp(loss, 0.0, 1.0);
    q = clamp(q, 0.0, 1.0);
    return vec2(loss, (1.0 - loss) * q * q * q * q * q);
}

// What the dielectric reflects of all that arrives from a direction.
float reflectedOf(vec2 albedo, float reflectance, float again)
{
    return mix(albedo.y, 1.0 - albedo.x, reflectance) + albedo.x * again;
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

#ifdef LIT_LAYERS
// What a layer leaves of light that is reflected below it, by what it lets through of each direction, and of all in the mean: the same when both
// change places. A mirror has the same share both ways, which counts once; what is sent evenly counts the one over the mean, times the other. A
// rough mirror is between, by `even`; what that lacks is spread, see below().
float veil(float through, float eye, float mean, vec2 even)
{
    return through * eye * inversesqrt(max(mix(through, mean, even.x) * mix(eye, mean, even.y), 1e-8));
}

// Of the light's angle and the eye's: what grazes is spread most.
vec2 evenOf(float rough, vec2 cosines) { return 0.86 * smoothstep(vec2(0.05), 0.35 + 0.9 * sqrt(cosines), vec2(rough)); }
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

float fuzzThrough(Lit m, float cosine) { return 1.0 - m.fuzz * fuzzAlbedo(cosine, m.fuzzRough); }

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

float coatThrough(Lit m, float cosine) { return 1.0 - m.coat * coatAlbedo(albedo(cosine, m.coatFacets), m.coatReflectance); }

void spreadOfCoat(inout Lit m)
{
    float r = m.facets.rough, smoother = 1.0 - m.coatFacets.rough * m.coatFacets.rough, smoother2 = smoother * smoother;
    float share = m.coat * (1.0 - m.coatReflectance) * smoother2 * smoother2 * smoother * 1.0563; // 1 of a smooth coat of index 1.6
    vec4 p = vec4(1.0, r, r * r, r * r * r);
    vec2 q = p.zw * p.z; // r^4, r^5
    m.spread = share * vec4(dot(p, vec4(-0.00130984306, -0.417861106, 4.05993299, -11.3099923)) + dot(q, vec2(12.3168581, -4.62782787)),
                            dot(p, vec4(0.0231338713, 2.69639512, -39.5255634, 130.812048)) + dot(q, vec2(-157.97401, 63.9101199)),
                            dot(p, vec4(-0.454080765, 9.82544167, 32.1314982, -272.816322)) + dot(q, vec2(431.543338, -200.278106)),
                            dot(p, vec4(0.982550907, -45.3149242, 165.03727, -29.7268852)) + dot(q, vec2(-294.60197, 204.275033)));
    m.spreadMore = share * vec2(dot(p, vec4(-0.426830036, 48.1939502, -273.420365, 389.061947)) + dot(q, vec2(-120.22507, -44.1969678)),
                                dot(p, vec4(-0.136456841, -14.6607673, 109.883837, -201.800783)) + dot(q, vec2(124.77158, -17.5985384)));
    m.stray = 0.022 * share * smoothstep(0.1, 0.35, r);
}

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
    m.coatOfEye = coatThrough(m, m.cosine);
    m.coatMean = 0.0;
    m.coatGloss = m.kept * (1.0 - m.coatOfEye);
    spreadOfCoat(m);
}
#endif

#ifdef LIT_FUZZ
void spreadOfFuzz(inout Lit m)
{
    float r = m.facets.rough, share = m.fuzz / (0.8 + 1.05 * m.fuzzRough);
    vec4 p = vec4(1.0, r, r * r, r * r * r);
    vec2 q = p.zw * p.z;
    m.fuzzSpread = share * vec4(dot(p, vec4(-0.00116799324, -0.669502096, 5.6479709, -14.9194331)) + dot(q, vec2(15.924515, -5.96825871)),
                                dot(p, vec4(0.123444748, 3.77602053, -43.325565, 131.637771)) + dot(q, vec2(-153.824555, 61.7052987)),
                                dot(p, vec4(-1.15081001, 8.81079809, 44.2831309, -267.577196)) + dot(q, vec2(394.596546, -179.474594)),
                                dot(p, vec4(2.82002081, -49.2497064, 133.705566, -7.45212523)) + dot(q, vec2(-241.916148, 163.172358)));
    m.fuzzSpreadMore = share * vec2(dot(p, vec4(-2.46875836, 56.4389929, -236.088648, 329.347312)) + dot(q, vec2(-133.886948, -14.3517625)),
                                    dot(p, vec4(0.666586785, -18.7508871, 93.3369607, -164.593005)) + dot(q, vec2(112.203977, -22.5077815)));
}

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
    spreadOfFuzz(m);
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
    found.w = m.spread.x + x * (m.spread.y + x * (m.spread.z + x * (m.spread.w + x * (m.spreadMore.x + x * m.spreadMore.y))));
    found.w = (1.0 - m.stray) * found.w + m.stray * (1.0 - loss) * found.x;
#endif
#ifdef LIT_FUZZ
    found.y = fuzzThrough(m, cosine);
    found.w = found.w * found.y + found.x * (m.fuzzSpread.x + x * (m.fuzzSpread.y + x * (m.fuzzSpread.z + x * (m.fuzzSpread.w + x * (m.fuzzSpreadMore.x + x * m.fuzzSpreadMore.y)))));
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
    const vec4 PLACE = vec4(0.0694318442, 0.3300094782, 0.6699905218, 0.9305681558);
    const vec4 WEIGHT = vec4(0.1739274226, 0.3260725774, 0.3260725774, 0.1739274226);
    mean = left = vec3(0.0);
#ifdef LIT_LAYERS
    m.meanStray = vec2(0.0);
#endif
    for (int i = 0; i < 8; i++) {
        float t = 0.5 * PLACE[i & 3] + (i < 4 ? 0.0 : 0.5), share = 2.0 * WEIGHT[i & 3] * t * t * t;
        vec3 own = share * vec3(1.0, albedo(t * t, m.facets));
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
    m.alpha = m.facets.alpha;
    m.cosine = clamp(dot(m.normal, toEye), 1e-3, 1.0);
#ifdef LIT_COAT
    litCoat(s, m);
#endif
#ifdef LIT_FUZZ
    litFuzz(s, m);
#endif
    vec3 mean, left;
    litMeans(m, mean, left);

    vec2 eye = albedo(m.cosine, m.facets);
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
    float once = facets(m.alpha, m.normal, h, cosine, m.cosine);
    vec2 own = albedo(cosine, m.facets);
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
