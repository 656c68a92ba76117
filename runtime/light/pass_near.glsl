// Before the pass gather: for each group of a block's pixels, which lights each pixel is to sum by
// itself. light_bound.c says how. Before it stands far_light.glsl.
const int PARTS = max(3 * PITCH, FAR_LIGHTS);

shared float far_parts[PARTS];  // parts of a sum; then shares of lights
shared uint far_near[FAR_NEAR], far_linear[FAR_BITS]; // as far_blocks.glsl has them
shared uint far_shares[32];     // sums of lights' shares of the budget, by their size

// Lower bound of the light at each pixel of the group, without the surface's reflectance.
vec3 farSure(Far far)
{
    if (!far.whole || far.least <= 0.0) return vec3(0.0);
    float further = 1.0 / (1.0 + far.ratio);
    return far.power * (far.least * further * further * further);
}

// How much it gives more or less than what it is taken for: the rest of its series, or all.
vec3 farRest(Far far)
{
    float q = far.ratio, nearer = 1.0 / (1.0 - q);
    if (farExpands(far)) return far.power * farLeftOut(q);
    return far.power * (nearer * nearer * min(far.most * nearer, 1.0));
}

// The share of what may be off that it takes if it isn't summed at each pixel: `even` and `gloss`
// are 1 over that. Its last bit says that gloss is expanded: else it is left out.
float farShare(Far far, Group group, vec3 even, vec3 gloss)
{
    if (far.ratio > 0.9 || (group.behind && far.least < 0.0)) return NEVER;
    vec3 share = farRest(far) * even;
    bool expanded = false;
#ifdef SURFACE_HAS_specular
    Lobe lobe = farLobe(far, group);
    expanded = lobe.rest < lobe.most;
    share += far.power * min(lobe.most, lobe.rest) * gloss;
#endif
    return uintBitsToFloat((floatBitsToUint(max(max(share.x, share.y), share.z)) & ~1u) | uint(expanded));
}

// -- which are near

// Over the invocations.
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

// The greatest share that a light may take, so that the sum of all shares up to it is 1 at most.
// Shares are summed in units of 2^-19, rounded up, by half octaves: those from 2^(-i/2 - 1/2) to
// 2^(-i/2), roughly, are the i-th; the last are all that are smaller. Each invocation leaves those
// of its lights in far_parts for itself, DARK where no pixel sees the light. For example 0.9, 0.3,
// 0.3, 0.01: the last three, 0.61, are far, and 0.5 is returned.
const float DARK = -1.0, UNITS = 524288.0;
const uint HALF_OCTAVE = 22u, ONE = 0x3f800000u >> HALF_OCTAVE; // bits of a float below its exponent and the first of the rest; 1.0 without them

float farThreshold(Group group, vec3 even, vec3 gloss)
{
    for (int i = int(gl_LocalInvocationIndex); i < farCount(); i += GROUP) {
        Far far = farLight(i, group);
        float share = farIsDark(far, group) ? DARK : farShare(far, group, even, gloss);
        far_parts[i] = share;
        if (share < 1.0 && share != DARK)
            atomicAdd(far_shares[min(ONE - 1u - (floatBitsToUint(share) >> HALF_OCTAVE), 31u)], uint(share * UNITS) + 1u);
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

// Marks what is near, and of what is not, whose gloss is expanded.
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

// A pixel's even light is off by e R, its gloss by g G at most, of sums R and G over all lights
// that are taken together, and may be by r e E + a. The one over the other is R / (r E + a / e) + G
// g / (r e E + a) at most, with the greatest e in the one and the least in the other.
void farLights(Group group)
{
    vec3 least = far_relative * farSureOfAll(group);
    vec3 even = 1.0 / max(least + far_absolute / max(group.even, 1e-20), 1e-30);
    vec3 gloss = group.gloss / max(least * group.dim + far_absolute, 1e-30);
    farMark(farThreshold(group, even, gloss));
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
