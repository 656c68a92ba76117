// Specular light of distant lights that are summed together, for pass_near.glsl and
// pass_light_cluster.glsl. Preceded by far_terms.glsl and far_group.glsl.

// Bounds of a light for a group of pixels. way: unit direction from the center; power: irradiance
// at the center; ratio: the group's radius over the light's distance, 0 if directional; lift: max
// distance of a point from the center along its normal, over the light's distance; least, most:
// range of n.(l - p) over the distance at the group's points; high: max of the cosine along the
// segments from the center to the points; whole: it lights the whole group equally and without
// shadows.
struct Far {
    vec3 way, power;
    float ratio, lift, least, most, high;
    bool whole;
};

const float NEAREST = 0.6; // max ratio of the group's radius to the distance of a far light

bool farExpands(Far far) { return far.whole && far.ratio <= NEAREST && far.least >= 0.0; }

// A specular lobe of reflectance 1 reflects F = A B^k of a light's power, where
// A = n.L d^2 / |l - p|^2, B = max(r.L, 0), L is the direction from p to l, r the mirrored view. On
// the path from the center and the seed's r to a point and its r, F is a function of one
// parameter from 0 to 1. F(0) + F'(0) is linear in both, so that lights add up in seven numbers per
// color component; the remainder is at most half of the max F''. With q = |p - c| / d at most,
// s = 1 / (1 - q), e = q s:
//   A  <= H = s^2 times the max n.L
//   A' <= s^3 lift + 3 e H, and A'' <= 6 q s^4 lift + 12 e^2 H: derivatives of n.w / |w|^3, where
//         n.w itself changes by at most `lift`
//   B  <= the max cosine; B' <= (t + e) sin, t = |r - r0|: only the part across L turns B;
//         B'' <= 2 t e + 2 / sqrt(3) e^2, a bound of L''
//   F'' = B^k (A'' + 2 A' k B'/B + A (k (k - 1) (B'/B)^2 + k B''/B)), for k >= 2
// Normals that deviate by |n - a| from the seed's a change the linear part by as much of it, and
// exponents from k to k + x change F by x / (2.718 k) of H. For example a lamp straight above,
// r = n = L, k = 2, and a point at q = 0.1 to the side: F is 1.01^(-5/2) = 0.975, the linear part
// 1; the error of 0.025 is within its bound of 0.119, which ignores the direction of p - c.
struct Lobe {
    // given specular reflectance 1 and power 1: max of F, and max error of its linear part
    float most, rest;
};

Lobe farLobe(Far far, Group group)
{
    float q = far.ratio, nearer = 1.0 / (1.0 - q), k = group.exponent;
    // cosine of the sum of both angles
    float mirror = farCosines(group.mirror, sqrt(1.0 - q * q), q).x;
    vec2 cosines = farCosines(dot(far.way, group.view), mirror,
        sqrt(max(1.0 - mirror * mirror, 0.0)));
    if (cosines.y <= 0.0) return Lobe(0.0, 0.0);
    float along = max(cosines.y, 1e-6), power = pow(along, k), square = nearer * nearer;
    float most = square * min(far.most * nearer, 1.0) * power;
    if (!farExpands(far) || k < 2.0) return Lobe(most, NEVER);
    float e = q * nearer, a = square * min(far.high * nearer, 1.0), over = k / along;
    float a1 = nearer * square * far.lift + 3.0 * e * a, a2 = 6.0 * q * square * square * far.lift +
        12.0 * e * e * a;
    float b1 = (group.turn + e) * (cosines.x > 0.0 ? sqrt(1.0 - cosines.x * cosines.x) : 1.0);
    float b2 = 2.0 * group.turn * e + 1.1548 * e * e;
    float curved = 0.5 * (a2 + 2.0 * a1 * over * b1 + a * (over * over * b1 * b1 + over * b2));
    float leaning = group.lean * (1.0 + 2.0 * q + over * b1);
    return Lobe(most, power * (curved + leaning) + a * group.spread);
}

// Adds F(0), its gradient along u = (p - c) / radius, and along r - r0.
void farAddLobe(Far far, Group group, inout vec3 sums[FAR_LOBES])
{
    float height = dot(group.axis, far.way), along = max(dot(group.view, far.way), 1e-30);
    float sharp = pow(along, group.exponent - 1.0), slope = height * group.exponent * sharp;
    vec3 u = far.ratio * ((3.0 * height * far.way - group.axis) * (sharp * along) +
        slope * (along * far.way - group.view));
    sums[0] += far.power * (height * sharp * along);
    sums[1] += far.power * u.x;
    sums[2] += far.power * u.y;
    sums[3] += far.power * u.z;
    sums[4] += far.power * (slope * far.way.x);
    sums[5] += far.power * (slope * far.way.y);
    sums[6] += far.power * (slope * far.way.z);
}
