// Anisotropic reflection: GGX with two widths, a along a direction and b across it, as polynomials.
// As in OpenPBR 1.1, with strength s: b / a = 1 - s and a^2 + b^2 = 2 roughness^4. Follows
// surface_microfacets.glsl. tests/fits/anisotropy.c prints its polynomials;
// test_principled_anisotropy.c compares them with the integrals.
//
// The multiple-scattering loss for light from a direction v, and its share at grazing angles,
// depend almost only on v's cosine and on the widths along v: roughness^2 g, with g^2 = 1 + k
// (v.x^2 - v.y^2), k = (a^2 - b^2) / (a^2 + b^2), and x along the direction. Over all azimuths the
// mean of g^2 is 1, that is, the width roughness^2.
//   Worked example, strength 0.5 and roughness 0.5: a = 0.25 sqrt(2 / 1.25) = 0.316, b = 0.158, k =
//   0.6; viewed along the direction at 60 degrees g is 1.2, across it 0.74.
#if defined(SURFACE_HAS_anisotropy) && !defined(SURFACE_MISSING_anisotropy)
#define LIT_ANISOTROPY
#endif

#ifdef LIT_ANISOTROPY
struct Anisotropy {
    vec3 along, across; // axes, orthogonal to each other and to the normal
    vec2 widths;
    // alpha and roughness of isotropic microfacets with the same mean width; `ratio` is k
    float alpha, rough, ratio;
    // polynomials in a function of the angle, each coefficient a cubic in g
    vec4 loss[6], grazing[6];
};

// Sets polynomials in p, roughness^2, and 1 - k^2, for the energy loss.
void lossLines(float p, float rest, out vec4 lines[6])
{
    lines[0] = vec4(0.0317114, -0.173122, 0.236166, -0.0923749) +
                p * (vec4(-0.393538, 1.61709, -2.1262, 0.850697) +
                p * (vec4(1.1022, -3.58563, 4.70347, -2.06004) +
                p * (vec4(-1.36777, 3.58012, -5.10752, 2.75718) +
                p * (vec4(1.23829, -3.58164, 5.42244, -3.05713) +
                p * (vec4(-0.522143, 1.85011, -2.79776, 1.48491))))));
    lines[0] += rest * (vec4(0.312381, -0.736036, 0.57733, -0.152845) +
                p * (vec4(-1.41371, 2.1911, -0.528939, -0.233446) +
                p * (vec4(2.85918, -4.61502, 1.47097, 0.263245) +
                p * (vec4(-1.73102, 3.27129, -1.77244, 0.236538)))));
    lines[1] = vec4(0.104873, 0.783848, -1.29668, 0.555624) +
                p * (vec4(1.41309, -4.88945, 7.51568, -3.46407) +
                p * (vec4(7.18629, -13.6496, 9.06572, 0.749932) +
                p * (vec4(-12.1223, 27.8537, -23.3024, -1.98108) +
                p * (vec4(6.97806, -4.80717, -4.16137, 14.5258) +
                p * (vec4(-0.686105, -6.87173, 12.7204, -10.457))))));
    lines[1] += rest * (vec4(-3.67877, 8.99827, -7.44437, 2.09767) +
                p * (vec4(20.1885, -38.0673, 20.4481, -2.57217) +
                p * (vec4(-25.1613, 46.7359, -24.6675, 3.16174) +
                p * (vec4(13.8634, -34.2484, 29.2645, -8.89165)))));
    lines[2] = vec4(-0.205306, 1.31705, -0.326799, -0.276121) +
                p * (vec4(-7.11434, -5.51895, 4.58239, -0.108543) +
                p * (vec4(-3.05531, 32.029, -18.9132, 0.0306169) +
                p * (vec4(10.4887, 4.36557, -8.27922, 13.5192) +
                p * (vec4(-17.0838, -27.7839, 10.0471, -17.0348) +
                p * (vec4(5.64851, 16.6407, -6.63891, 10.0756))))));
    lines[2] += rest * (vec4(5.79625, -14.1053, 11.5698, -3.24217) +
                p * (vec4(-10.4497, 1.11199, 24.1076, -13.8341) +
                p * (vec4(3.04871, 2.77648, -10.613, 3.21871) +
                p * (vec4(-17.8752, 70.49, -87.5618, 35.4709)))));
    lines[3] = vec4(2.56073, -6.82547, 5.18377, -0.887726) +
                p * (vec4(21.6717, 4.54284, -2.05632, -1.76692) +
                p * (vec4(-25.8936, -44.957, -1.85068, 1.36644) +
                p * (vec4(20.5041, -26.0962, 52.3056, 12.878) +
                p * (vec4(28.5157, -3.56508, 61.7685, -64.7) +
                p * (vec4(-15.224, -1.12091, -39.408, 28.8208))))));
    lines[3] += rest * (vec4(-2.35322, 5.64724, -4.52738, 1.24404) +
                p * (vec4(-13.8257, 50.358, -59.1431, 21.5558) +
                p * (vec4(42.0513, -108.67, 94.7408, -26.3052) +
                p * (vec4(-7.23382, -3.94244, 26.7826, -16.2412)))));
    lines[4] = vec4(-5.28431, 7.23097, -4.94369, 0.608397) +
                p * (vec4(-30.4503, 31.9347, -37.8952, 17.2054) +
                p * (vec4(52.2735, 55.7594, -6.05781, 1.16412) +
                p * (vec4(-61.6285, -23.9121, -60.1626, -11.985) +
                p * (vec4(-8.32563, 16.8764, 46.976, 26.3331) +
                p * (vec4(8.25082, 30.3262, -51.9028, 2.66439))))));
    lines[5] = vec4(2.78911, -2.32767, 1.13844, 0.0979079) +
                p * (vec4(15.2846, -27.8636, 29.3138, -12.3443) +
                p * (vec4(-32.9848, -32.4923, 30.9286, -8.7974) +
                p * (vec4(45.5168, 58.2585, -30.5382, 13.3881) +
                p * (vec4(-3.92643, -60.1848, -3.31895, 1.66961) +
                p * (vec4(-3.03528, 0.484335, 33.8637, -13.2969))))));
}

// Sets polynomials in p, the roughness, and 1 - k^2, for grazing angles.
void grazingLines(float p, float rest, out vec4 lines[6])
{
    lines[0] = vec4(0.998919, 0.013488, -0.0124357, 0.00639183) +
                p * (vec4(0.0425421, -0.278259, 0.206028, -0.12764) +
                p * (vec4(-0.376939, -3.63536, -4.73485, 2.65791) +
                p * (vec4(0.941828, -3.6689, 8.83807, -3.94462) +
                p * (vec4(-0.841535, 19.8677, 15.744, 29.5314) +
                p * (vec4(0.193023, -7.77367, -30.522, -37.1847))))));
    lines[0] += rest * (vec4(0.0153988, -0.040124, 0.0361715, -0.0109758) +
                p * (vec4(-0.333724, 1.0723, -1.32764, 0.551059) +
                p * (vec4(1.92875, -7.6981, 11.3806, -5.19711) +
                p * (vec4(-6.42957, 31.7692, -47.7405, 21.8577)))));
    lines[1] = vec4(-0.00729832, -0.193689, 0.114043, -0.0535024) +
                p * (vec4(0.158944, 6.26465, 1.4217, -1.20052) +
                p * (vec4(3.50925, 30.1073, -12.519, 1.281) +
                p * (vec4(-10.9165, -79.9026, -11.0263, -46.8471) +
                p * (vec4(8.10649, -14.8355, -20.4534, -28.194) +
                p * (vec4(-1.00221, 25.5546, 114.76, 114.53))))));
    lines[1] += rest * (vec4(-0.186881, 0.578284, -0.513044, 0.138085) +
                p * (vec4(2.87642, -8.37141, 7.33765, -2.04711) +
                p * (vec4(-8.35661, -3.45729, 27.2534, -16.2725) +
                p * (vec4(14.7919, -34.5402, 40.0468, -18.0773)))));
    lines[2] = vec4(-0.947872, 1.16924, -1.50394, 0.809013) +
                p * (vec4(-5.48348, -37.4537, 7.17311, -1.06531) +
                p * (vec4(-0.332681, 44.5748, -7.871, 41.1236) +
                p * (vec4(46.3979, 130.337, 47.0301, 94.7136) +
                p * (vec4(-45.7884, 16.0697, -92.6331, -72.4741) +
                p * (vec4(7.81543, -63.9346, -151.533, -123.659))))));
    lines[2] += rest * (vec4(0.0498462, -1.30724, 2.10546, -0.89604) +
                p * (vec4(2.30753, 18.0612, -36.9575, 17.5853) +
                p * (vec4(-0.445393, 3.06731, -12.4872, 8.5755) +
                p * (vec4(-15.639, 15.5533, 1.8642, -3.39807)))));
    lines[3] = vec4(0.360581, -2.2285, 3.31244, -1.95954) +
                p * (vec4(22.8165, 35.7011, 28.5348, -15.0072) +
                p * (vec4(-58.7258, -134.476, -15.6141, -98.9286) +
                p * (vec4(-8.9087, -103.1, 25.3028, -4.88817) +
                p * (vec4(33.228, 27.8691, 132.81, 90.6035) +
                p * (vec4(4.3323, 56.0797, 93.4708, 65.7034))))));
    lines[3] += rest * (vec4(0.00168101, 0.986834, -1.71017, 0.740334) +
                p * (vec4(-9.05814, -2.21781, 26.1646, -15.5448) +
                p * (vec4(24.6089, -29.0006, -3.25631, 9.26533) +
                p * (vec4(-4.90834, 12.1847, -9.26976, 1.91913)))));
    lines[4] = vec4(-2.35258, 6.09493, -7.02369, 3.24761) +
                p * (vec4(-22.6786, -4.16035, -73.1442, 38.8101) +
                p * (vec4(85.9843, 128.453, 67.1296, 58.751) +
                p * (vec4(-25.481, -40.8939, -83.8891, -68.0178) +
                p * (vec4(-13.713, -8.87933, -25.3136, -15.8307) +
                p * (vec4(-12.5268, -5.034, -53.1242, -18.2898))))));
    lines[5] = vec4(2.37844, -6.32803, 6.83608, -2.71712) +
                p * (vec4(7.06973, -2.90322, 35.3765, -20.3521) +
                p * (vec4(-51.354, -28.0205, -36.9673, -6.53531) +
                p * (vec4(41.8766, 35.274, 17.3641, 37.0949) +
                p * (vec4(-13.7172, -8.2674, 8.33391, -16.3027) +
                p * (vec4(9.08247, -6.70663, 13.406, 4.9278))))));
}

// Makes the anisotropy from its slot; the angle is relative to the frame of anisotropyStored().
Anisotropy anisotropyOf(vec2 slot, vec3 normal, float rough)
{
    Anisotropy m;
    float strength = min(length(slot), 1.0), other = 1.0 - strength;
    vec2 twice = strength > 1e-6 ? slot / length(slot) : vec2(1.0, 0.0);
    vec2 once = sqrt(max(0.5 + vec2(0.5, -0.5) * twice.x, 0.0));
    once.y = twice.y < 0.0 ? -once.y : once.y;
    float across = dot(normal.xy, normal.xy), below = normal.z < 0.0 ? across / (1.0 - normal.z)
        : 1.0 + normal.z;
    vec2 k = normal.xy / max(below, 1e-12);
    vec3 x = vec3(1.0 - k.x * normal.x, -k.x * normal.y, -normal.x),
        y = vec3(-k.y * normal.x, 1.0 - k.y * normal.y, -normal.y);
    m.along = once.x * x + once.y * y;
    m.across = once.x * y - once.y * x;
    float wide = rough * rough * sqrt(2.0 / (1.0 + other * other));
    m.widths = max(vec2(wide, wide * other), vec2(0.001));
    vec2 squares = m.widths * m.widths;
    m.alpha = sqrt(0.5 * (squares.x + squares.y));
    m.rough = sqrt(m.alpha);
    m.ratio = (squares.x - squares.y) / (squares.x + squares.y);
    lossLines(m.alpha, 1.0 - m.ratio * m.ratio, m.loss);
    grazingLines(m.rough, 1.0 - m.ratio * m.ratio, m.grazing);
    return m;
}

// Returns the anisotropic masking's g toward direction v.
float anisotropyToward(Anisotropy m, vec3 v)
{
    vec2 flat_ = vec2(dot(v, m.along), dot(v, m.across));
    return sqrt(max(1.0 + m.ratio * (flat_.x * flat_.x - flat_.y * flat_.y), 0.0));
}

Row rowOf(vec4 lines[6], vec4 g)
{
    return Row(vec4(dot(lines[0], g), dot(lines[1], g), dot(lines[2], g), dot(lines[3], g)),
        vec2(dot(lines[4], g), dot(lines[5], g)));
}

// Returns what albedo() does, along a direction: within 0.011 and 0.006 of the integrals for
// cosines from 0.03 on.
vec2 albedoAlong(float cosine, float g, Anisotropy m)
{
    vec4 powers = vec4(1.0, g, g * g, g * g * g);
    float along = m.alpha * g;
    float loss = clamp(rowAt(rowOf(m.loss, powers), cosine * (1.0 + along) / (cosine + along)), 0.0,
        1.0);
    float q = clamp(rowAt(rowOf(m.grazing, powers), sqrt(cosine + 0.5 * along)), 0.0, 1.0);
    return vec2(loss, (1.0 - loss) * q * q * q * q * q);
}

// Returns the mean albedo over azimuths: at two azimuths whose values v.x^2 - v.y^2 are Gauss
// points of the distribution.
vec2 albedoAround(float cosine, Anisotropy m)
{
    float off = 0.70710678 * m.ratio * (1.0 - cosine * cosine);
    return 0.5 * (albedoAlong(cosine, sqrt(1.0 + off), m) +
        albedoAlong(cosine, sqrt(1.0 - off), m));
}

// Returns cosine (1 + 2 Lambda) of Smith's masking for a direction with that cosine.
float maskedAlong(Anisotropy m, vec3 v, float cosine)
{
    vec2 wide = m.widths * vec2(dot(v, m.along), dot(v, m.across));
    return sqrt(cosine * cosine + dot(wide, wide));
}

// Evaluates the microfacet lobe like microfacets(): the light's direction l, the half vector, and
// the light's cosine; `eye`: the eye's cosine and its maskedAlong().
float microfacetsAlong(Anisotropy m, vec3 normal, vec3 l, vec3 h, float cosine, vec2 eye)
{
    vec2 across = vec2(dot(h, m.along), dot(h, m.across)) / m.widths;
    float high = dot(normal, h), width = high * high + dot(across, across);
    float masked = cosine * eye.y + eye.x * maskedAlong(m, l, cosine);
    return 0.5 * cosine / (m.widths.x * m.widths.y * width * width * masked);
}
#endif
