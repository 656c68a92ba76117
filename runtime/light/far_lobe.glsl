// Gloss of a light that is taken together, for pass_near.glsl and pass_gather.glsl. Before it stand
// far_terms.glsl and far_group.glsl.

// A light as the group sees it: the way to the centre, of length 1; the group's radius over its
// distance, 0 if that is infinite, and the most that a point is above or below the centre, along
// its normal, over the distance; what arrives at the centre; of n.(l - p) over the distance the
// least and the most at the group's points, and the most on ways from the centre to them; whether
// it shines on all of the group alike and without shadows.
struct Far {
    vec3 way, power;
    float ratio, lift, least, most, high;
    bool whole;
};

const float NEAREST = 0.6; // times a light's distance, the group's radius is less where the light is far

bool farExpands(Far far) { return far.whole && far.ratio <= NEAREST && far.least >= 0.0; }

// Gloss 1 sends back F = A B^k of a light's power, where A = n.L d^2 / |l - p|^2, B = max(r.L, 0),
// L is the direction from p to l, and r the mirrored view. From the centre and the seed's r to a
// point and its r F is a function of one number from 0 to 1: F(0) + F'(0) is linear in both, so
// that lights add up in seven numbers for each lane, and what is left out is half of the greatest
// F'' at most. With q = |p - c| / d at most, s = 1 / (1 - q), e = q s:
//   A  <= H = s^2 times the greatest n.L
//   A' <= s^3 lift + 3 e H, and A'' <= 6 q s^4 lift + 12 e^2 H: slopes of n.w / |w|^3, where n.w
//   itself changes by `lift` at most
//   B  <= the greatest cosine; B' <= (t + e) sin, t = |r - r0|: only what is across L turns it; B''
//      <= 2 t e + 2 / sqrt(3) e^2, as L'' is at most
//   F'' = B^k (A'' + 2 A' k B'/B + A (k (k - 1) (B'/B)^2 + k B''/B)), for k from 2 on
// Normals that lean by |n - a| from the seed's a change what is linear by as much of it, and
// exponents from k to k + x change F by x / (2.718 k) of H. For example a lamp straight above, r =
// n = L, k = 2, and a point at q = 0.1 across: F is 1.01^(-5/2) = 0.975, what is linear 1, and the
// bound of 0.025 is 0.119, as it knows no direction of p - c.
struct Lobe {
    float most, rest; // to gloss 1, of a light's power: the most, and how much what is linear is off
};

Lobe farLobe(Far far, Group group)
{
    float q = far.ratio, nearer = 1.0 / (1.0 - q), k = group.exponent;
    float mirror = farCosines(group.mirror, sqrt(1.0 - q * q), q).x; // of the angles' sum
    vec2 cosines = farCosines(dot(far.way, group.view), mirror, sqrt(max(1.0 - mirror * mirror, 0.0)));
    if (cosines.y <= 0.0) return Lobe(0.0, 0.0);
    float along = max(cosines.y, 1e-6), power = pow(along, k), square = nearer * nearer;
    float most = square * min(far.most * nearer, 1.0) * power;
    if (!farExpands(far) || k < 2.0) return Lobe(most, NEVER);
    float e = q * nearer, a = square * min(far.high * nearer, 1.0), over = k / along;
    float a1 = nearer * square * far.lift + 3.0 * e * a, a2 = 6.0 * q * square * square * far.lift + 12.0 * e * e * a;
    float b1 = (group.turn + e) * (cosines.x > 0.0 ? sqrt(1.0 - cosines.x * cosines.x) : 1.0);
    float b2 = 2.0 * group.turn * e + 1.1548 * e * e;
    float curved = 0.5 * (a2 + 2.0 * a1 * over * b1 + a * (over * over * b1 * b1 + over * b2));
    float leaning = group.lean * (1.0 + 2.0 * q + over * b1);
    return Lobe(most, power * (curved + leaning) + a * group.spread);
}

// F(0), its slope along u = (p - c) / radius, and along r - r0.
void farAddLobe(Far far, Group group, inout vec3 sums[FAR_LOBES])
{
    float height = dot(group.axis, far.way), along = max(dot(group.view, far.way), 1e-30);
    float sharp = pow(along, group.exponent - 1.0), slope = height * group.exponent * sharp;
    vec3 u = far.ratio * ((3.0 * height * far.way - group.axis) * (sharp * along) + slope * (along * far.way - group.view));
    sums[0] += far.power * (height * sharp * along);
    sums[1] += far.power * u.x;
    sums[2] += far.power * u.y;
    sums[3] += far.power * u.z;
    sums[4] += far.power * (slope * far.way.x);
    sums[5] += far.power * (slope * far.way.y);
    sums[6] += far.power * (slope * far.way.z);
}
