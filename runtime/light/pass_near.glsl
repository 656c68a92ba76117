// The second dispatch of the pass light_cluster: for each group of a block's pixels, selects the
// lights that each pixel sums itself (light_bound.c). Preceded by far_light.glsl.
const int PARTS = max(3 * PITCH, FAR_LIGHTS);

shared float far_parts[PARTS];  // partial sums; later the lights' shares of the budget
shared uint far_near[FAR_NEAR], far_linear[FAR_BITS]; // `far_near` has the layout of LightFarWords
shared uint far_shares[32];     // histogram of the lights' shares of the budget

// Lower bound of irradiance at each pixel of the group.
vec3 farSure(Far far)
{
    if (!far.whole || far.least <= 0.0) return vec3(0.0);
    float further = 1.0 / (1.0 + far.ratio);
    return far.power * (far.least * further * further * further);
}

// Returns the max error if the light is summed together: the series' remainder, or all of its
// light.
vec3 farRest(Far far)
{
    float q = far.ratio, nearer = 1.0 / (1.0 - q);
    if (farExpands(far)) return far.power * farLeftOut(q);
    return far.power * (nearer * nearer * min(far.most * nearer, 1.0));
}

// Returns the share of the error budget that a light takes if pixels do not sum it themselves;
// `even` and `specular` are reflectances over the budget. The lowest bit reports that specular
// light is expanded; else specular light is omitted.
float farShare(Far far, Group group, vec3 even, vec3 specular)
{
    if (far.ratio > 0.9 || (group.behind && far.least < 0.0)) return NEVER;
    vec3 share = farRest(far) * even;
    bool expanded = false;
#ifdef SURFACE_HAS_specular
    Lobe lobe = farLobe(far, group);
    expanded = lobe.rest < lobe.most;
    share += far.power * min(lobe.most, lobe.rest) * specular;
#endif
    return uintBitsToFloat((floatBitsToUint(max(max(share.x, share.y),
        share.z)) & ~1u) | uint(expanded));
}

// -- near lights

// Sums over the invocations.
vec3 farSum(vec3 part)
{
    int self = int(gl_LocalInvocationIndex);
    far_parts[self] = part.x;
    far_parts[PITCH + self] = part.y;
    far_parts[2 * PITCH + self] = part.z;
    barrier();
    vec3 sum = vec3(0.0);
    for (int i = 0; i < GROUP; i++)
        sum += vec3(far_parts[i], far_parts[PITCH + i], far_parts[2 * PITCH + i]);
    barrier();
    return sum;
}

vec3 farSureOfAll(Group group)
{
    vec3 sure = vec3(0.0);
    for (int i = int(gl_LocalInvocationIndex); i < farCount(); i += GROUP)
        sure += farSure(farLight(i, group));
    return farSum(sure);
}

// Returns the max share of a far light, such that all shares up to it sum up to at most 1. Shares
// are summed in units of 2^-19, rounded up, in a histogram by half octaves: bin i has those from
// 2^(-i/2 - 1/2) to about 2^(-i/2); the last bin has all smaller ones. Each invocation stores the
// shares of its lights in far_parts, DARK for lights that reach no pixel. For example 0.9, 0.3,
// 0.3, 0.01: the last three, 0.61, are far, and 0.5 is returned.
const float DARK = -1.0, UNITS = 524288.0;
// shift that keeps a float's exponent and first mantissa bit; 1.0 after that shift
const uint HALF_OCTAVE = 22u, ONE = 0x3f800000u >> HALF_OCTAVE;

float farThreshold(Group group, vec3 even, vec3 specular)
{
    for (int i = int(gl_LocalInvocationIndex); i < farCount(); i += GROUP) {
        Far far = farLight(i, group);
        float share = farIsDark(far, group) ? DARK : farShare(far, group, even, specular);
        far_parts[i] = share;
        if (share < 1.0 && share != DARK)
            atomicAdd(far_shares[min(ONE - 1u - (floatBitsToUint(share) >> HALF_OCTAVE), 31u)],
                uint(share * UNITS) + 1u);
    }
    barrier();
    uint sum = 0u;
    float threshold = 0.0;
    for (int i = 31; i >= 0; i--) {
        sum += far_shares[i];
        if (sum > uint(UNITS)) break;
        threshold = uintBitsToFloat(ONE - uint(i) << HALF_OCTAVE);
    }
    return threshold;
}

// Marks near lights, and far lights whose specular light is expanded.
void farMark(float threshold)
{
    for (int i = int(gl_LocalInvocationIndex); i < farCount(); i += GROUP) {
        float share = far_parts[i];
        uint bit = 1u << (i & 31);
        if (share == DARK) continue;
        if (!(share < threshold)) {
            atomicOr(far_near[i >> 10], 1u << (i >> 5 & 31));
            atomicOr(far_near[FAR_TOPS + (i >> 5)], bit);
        } else if ((floatBitsToUint(share) & 1u) != 0u) {
            atomicOr(far_linear[i >> 5], bit);
        }
    }
    barrier();
}

void farClear()
{
    int self = int(gl_LocalInvocationIndex);
    for (int i = self; i < 32; i += GROUP)
        far_shares[i] = 0u;
    for (int i = self; i < FAR_NEAR; i += GROUP)
        far_near[i] = 0u;
    for (int i = self; i < FAR_BITS; i += GROUP)
        far_linear[i] = 0u;
}

void farKeep(int number)
{
    int at = farBits(number), self = int(gl_LocalInvocationIndex);
    for (int i = self; i < FAR_NEAR; i += GROUP)
        far_words[at + i] = far_near[i];
    for (int i = self; i < FAR_BITS; i += GROUP)
        far_words[at + FAR_NEAR + i] = far_linear[i];
}

// A pixel's diffuse light has an error of at most e R, its specular light g G, with sums R and G
// over all far lights; the budget is r e E + a. The ratio is at most R / (r E + a / e) + G g / (r e
// E + a), with the max e in the first and the min e in the second term.
void farLights(Group group)
{
    vec3 least = far_relative * farSureOfAll(group);
    vec3 even = 1.0 / max(least + far_absolute / max(group.even, 1e-20), 1e-30);
    vec3 specular = group.specular / max(least * group.dim + far_absolute, 1e-30);
    farMark(farThreshold(group, even, specular));
}

void main()
{
    int number = int(gl_WorkGroupID.z);
    Group group = farLoad(number);
    if (group.radius < 0.0) return;
    farClear();
    farLights(group);
    farKeep(number);
}
