// What facets, coats and fuzz send of light, by plain numbers: lobes, and polynomials that stand for their integrals. tests/fits/principled.c prints the
// polynomials; test_principled.c and test_principled_lobes.c hold them against the integrals.
#if defined(SURFACE_HAS_coat) && !defined(SURFACE_LACKS_coat)
#define LIT_COAT
#endif
#if defined(SURFACE_HAS_fuzz) && !defined(SURFACE_LACKS_fuzz)
#define LIT_FUZZ
#endif
#if defined(LIT_COAT) || defined(LIT_FUZZ)
#define LIT_LAYERS
#endif

// A polynomial of degree 5.
struct Row {
    vec4 low;
    vec2 high;
};

float rowAt(Row a, float x) { return a.low.x + x * (a.low.y + x * (a.low.z + x * (a.low.w + x * (a.high.x + x * a.high.y)))); }

// What of GGX's albedos depends on the roughness alone: polynomials in what an angle gives, by albedo().
struct Gloss {
    float alpha, rough;
    Row loss, grazing;
};

Row lossOf(float alpha)
{
    vec4 p = vec4(1.0, alpha, alpha * alpha, alpha * alpha * alpha);
    vec2 q = p.zw * p.z; // alpha^4, alpha^5
    return Row(vec4(dot(p, vec4(0.00541417324, -0.0802598988, 0.331120234, -0.549823251)) + dot(q, vec2(0.412405132, -0.114975581)),
                    dot(p, vec4(0.0490225499, 2.36567246, -6.3156039, 14.0076693)) + dot(q, vec2(-11.1162599, 3.0406926)),
                    dot(p, vec4(1.03763889, -19.3840807, 76.0973214, -142.107111)) + dot(q, vec2(108.540868, -29.8151354)),
                    dot(p, vec4(-1.21144156, 50.948669, -236.742035, 456.215017)) + dot(q, vec2(-360.753228, 102.821782))),
               vec2(dot(p, vec4(-1.10015173, -50.1714478, 280.583884, -571.944723)) + dot(q, vec2(470.757091, -139.104376)),
                    dot(p, vec4(1.2209995, 16.2630829, -112.33339, 244.772749)) + dot(q, vec2(-210.325806, 64.3963559))));
}

Row grazingOf(float rough)
{
    vec4 p = vec4(1.0, rough, rough * rough, rough * rough * rough);
    vec2 q = p.zw * p.z;
    return Row(vec4(dot(p, vec4(1.00224032, -0.0662290637, -7.94384868, 12.296826)) + dot(q, vec2(87.1399725, -147.642713)),
                    dot(p, vec4(-0.0744141474, 6.807808, 34.2218858, -329.730659)) + dot(q, vec2(139.481849, 483.915005)),
                    dot(p, vec4(-0.927768838, -46.9780731, 164.191096, 708.135015)) + dot(q, vec2(-1141.46066, -473.420831)),
                    dot(p, vec4(1.54931621, 98.8533863, -718.783035, 65.237189)) + dot(q, vec2(1357.76862, 115.638134))),
               vec2(dot(p, vec4(-4.1182924, -73.4273809, 847.482319, -1057.4753)) + dot(q, vec2(-194.466002, -46.7178094)),
                    dot(p, vec4(2.82127544, 11.1127891, -302.8796, 575.312636)) + dot(q, vec2(-229.887532, 63.4033289))));
}

Gloss glossOf(float rough) { return Gloss(rough * rough, rough, lossOf(rough * rough), grazingOf(rough)); }

// Albedos of the lobe with Fresnel's term 1: x is 1 - E, what is lost to facets behind others, y the part of E that Schlick's (1 - cosine)^5 has.
// Fitted to integrals of the lobe: within 0.0055 and 0.0035 for all roughnesses and angles (tests/test_principled.c).
vec2 albedo(float cosine, Gloss g)
{
    float loss = clamp(rowAt(g.loss, cosine * (1.0 + g.alpha) / (cosine + g.alpha)), 0.0, 1.0);
    float q = clamp(rowAt(g.grazing, sqrt(cosine + 0.5 * g.alpha)), 0.0, 1.0);
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

#ifdef LIT_COAT
// What a white mirror of a roughness lacks below a coat: `share` is what such a coat has against a smooth one.
Row coatSpread(float rough, float share)
{
    vec4 p = share * vec4(1.0, rough, rough * rough, rough * rough * rough);
    vec2 q = p.zw * rough * rough;
    return Row(vec4(dot(p, vec4(-0.00131019374, -0.417850086, 4.05985137, -11.3097669)) + dot(q, vec2(12.3165997, -4.62772364)),
                    dot(p, vec4(0.0231361444, 2.69628641, -39.5246106, 130.809179)) + dot(q, vec2(-157.970545, 63.9086731)),
                    dot(p, vec4(-0.454077749, 9.82565964, 32.1286548, -272.806508)) + dot(q, vec2(431.530642, -200.272582)),
                    dot(p, vec4(0.982518578, -45.3147833, 165.039668, -29.7389878)) + dot(q, vec2(-294.584078, 204.266698))),
               vec2(dot(p, vec4(-0.42677792, 48.1933106, -273.419571, 389.066021)) + dot(q, vec2(-120.234328, -44.1919578)),
                    dot(p, vec4(-0.136481722, -14.6603853, 109.882595, -201.799877)) + dot(q, vec2(124.772386, -17.5993762))));
}
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

// Fibres that stand up, by the sine of the half angle (Estevez and Kulla 2017), masked as Neubelt and Pettineo have it.
float fibres(float rough, float high, float cosine, float eye)
{
    float power = 0.5 / rough;
    return 0.5 * cosine * (1.0 + power) * pow(max(1.0 - high * high, 1e-6), power) / (2.0 * (cosine + eye - cosine * eye));
}

// As coatSpread(), below fuzz.
Row fuzzSpread(float rough, float share)
{
    vec4 p = share * vec4(1.0, rough, rough * rough, rough * rough * rough);
    vec2 q = p.zw * rough * rough;
    return Row(vec4(dot(p, vec4(-0.00116753484, -0.669510384, 5.6480139, -14.9195274)) + dot(q, vec2(15.9246078, -5.96829246)),
                    dot(p, vec4(0.12343559, 3.77617984, -43.3263677, 131.639497)) + dot(q, vec2(-153.826232, 61.7059045)),
                    dot(p, vec4(-1.15076841, 8.81013093, 44.2862562, -267.583535)) + dot(q, vec2(394.602461, -179.476676)),
                    dot(p, vec4(2.81994723, -49.2486912, 133.70156, -7.44530449)) + dot(q, vec2(-241.921602, 163.174069))),
               vec2(dot(p, vec4(-2.46870407, 56.438446, -236.087556, 329.347657)) + dot(q, vec2(-133.889061, -14.3506012)),
                    dot(p, vec4(0.666573359, -18.7508442, 93.3375412, -164.595544)) + dot(q, vec2(112.207302, -22.5091751))));
}
#endif
