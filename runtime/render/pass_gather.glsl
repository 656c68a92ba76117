// Before the pass light where lights are many: for each group of a block's pixels, what far lights give together, and which are near. light_bound.c says
// how, and what it is off at most. Each group has invocations of its own: pass_groups.glsl has found it. Before it stands far_lobe.glsl.
layout(local_size_x = FAR_GATHERERS) in;
const int GROUP = FAR_GATHERERS; // invocations
const int PITCH = GROUP + 1, ROWS = FAR_TERMS + FAR_LOBES; // between rows of parts, so that neighbours in a column are in other banks; rows
const int PARTS = max(3 * ROWS * PITCH, FAR_LIGHTS);

shared float far_group[GROUP_NUMBERS];    // as pass_groups.glsl keeps it
shared float far_parts[PARTS]; // shares of lights; then parts of sums, a row for each
shared float far_sums[3 * ROWS];
shared uint far_near[FAR_NEAR]; // the lights that each pixel sums by itself, as far_blocks.glsl has them
shared uint far_shares[32];     // sums of lights' shares of the budget, by their size

// -- lights

// What a spot's cone lets through, at least and at most, from the group.
vec2 farCone(int light, vec3 way, float ratio)
{
    vec2 cone = lightTexel(light, 3).xy;
    float sine = min(ratio, 1.0);
    vec2 cosines = ratio < 1.0 ? farCosines(-dot(way, lightTexel(light, 2).xyz), sqrt(1.0 - sine * sine), sine)
                               : vec2(-1.0, 1.0);
    return clamp(cone.x * cosines + cone.y, 0.0, 1.0);
}

Far farLight(int light, Group group)
{
    Far far;
    vec4 place = lightTexel(light, 0);
    vec3 way = place.xyz - place.w * group.centre;
    float over = inversesqrt(max(dot(way, way), 1e-30)), finite = place.w > 0.0 ? over : 0.0;
    far.way = way * over;
    far.ratio = group.radius * finite;
    far.power = lightTexel(light, 1).xyz * (place.w > 0.0 ? over * over : 1.0);
    vec2 cosines = farCosines(dot(far.way, group.axis), group.cosine, group.sine);
    far.least = cosines.x - group.above * finite;
    far.most = cosines.y - group.below * finite;
    far.high = max(max(cosines.y, far.most), -cosines.x);
    far.lift = max(group.above, -group.below) * finite;
    far.whole = true;
#ifdef FAR_OTHERS
    if (light >= light_plain) {
        vec2 cone = farCone(light, far.way, far.ratio);
        far.whole = cone.x >= 1.0 && lightTexel(light, 3).w < 0.0;
        if (cone.y <= 0.0) far.power = vec3(0.0);
    }
#endif
    return far;
}

// No pixel of the group sees it.
bool farIsDark(Far far, Group group) { return far.power == vec3(0.0) || (far.most <= 0.0 && !group.behind); }

// What the light surely gives to each pixel of the group, but for what its surface sends back of that.
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
    if (farExpands(far)) return far.power * (q * q * q * q * (5.0 - 4.0 * q) * nearer * nearer);
    return far.power * (nearer * nearer * min(far.most * nearer, 1.0));
}

// The share of what may be off that it takes if it isn't summed at each pixel: `even` and `gloss` are 1 over that. Its last bit says that gloss is
// expanded: else it is left out.
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

// -- sums over the invocations

void farPart(int row, vec3 part)
{
    int at = row * 3 * PITCH + int(gl_LocalInvocationIndex);
    far_parts[at] = part.x;
    far_parts[at + PITCH] = part.y;
    far_parts[at + 2 * PITCH] = part.z;
}

void farSum(int rows)
{
    barrier();
    for (int row = int(gl_LocalInvocationIndex); row < 3 * rows; row += GROUP) {
        float sum = 0.0;
        for (int i = 0; i < GROUP; i++)
            sum += far_parts[row * PITCH + i];
        far_sums[row] = sum;
    }
    barrier();
}

vec3 farTotal(int row) { return vec3(far_sums[3 * row], far_sums[3 * row + 1], far_sums[3 * row + 2]); }

// -- which are near

int farCount() { return light_plain + light_points; }

vec3 farSureOfAll(Group group)
{
    vec3 sure = vec3(0.0);
    for (int i = int(gl_LocalInvocationIndex); i < farCount(); i += GROUP)
        sure += farSure(farLight(i, group));
    farPart(0, sure);
    farSum(1);
    return farTotal(0);
}

// The greatest share that a light may take, so that the sum of all shares up to it is 1 at most. Shares are summed in units of 2^-19, rounded up, by
// half octaves: those from 2^(-i/2 - 1/2) to 2^(-i/2), roughly, are the i-th; the last are all that are smaller. Each invocation leaves those of its
// lights in far_parts for itself, DARK where no pixel sees the light. For example 0.9, 0.3, 0.3, 0.01: the last three, 0.61, are far, and 0.5 is returned.
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

// Sums the series of what is far, and marks what is near.
void farGather(Group group, float threshold)
{
    vec3 sums[FAR_TERMS], lobes[FAR_LOBES];
#define FAR_CLEAR(k) sums[k] = vec3(0.0);
#define FAR_CLEAR_LOBE(k) lobes[k] = vec3(0.0);
    FAR_EACH(FAR_CLEAR)
    FAR_EACH_LOBE(FAR_CLEAR_LOBE)
    for (int i = int(gl_LocalInvocationIndex); i < farCount(); i += GROUP) {
        float share = far_parts[i];
        if (share == DARK) continue;
        if (!(share < threshold)) {
            atomicOr(far_near[i >> 10], 1u << (i >> 5 & 31));
            atomicOr(far_near[FAR_TOPS + (i >> 5)], 1u << (i & 31));
            continue;
        }
        Far far = farLight(i, group);
        if (farExpands(far)) farAdd(far.way, far.ratio, far.power, sums);
#ifdef SURFACE_HAS_specular
        if ((floatBitsToUint(share) & 1u) != 0u) farAddLobe(far, group, lobes);
#endif
    }
    barrier(); // shares are read
#define FAR_PART(k) farPart(k, sums[k]);
#define FAR_PART_LOBE(k) farPart(FAR_TERMS + k, lobes[k]);
    FAR_EACH(FAR_PART)
    FAR_EACH_LOBE(FAR_PART_LOBE)
    farSum(ROWS);
}

// -- what is kept

// Of the texels of gloss: for each lane its slopes and itself, then its slopes by the view, and a lane of that.
float farGlossNumber(Group group, int i)
{
    int lane = i / 4 % 3, kind = i / 12, k = i % 4;
    if (kind == 1 && k == 3) return group.view[lane];
    return far_sums[3 * (FAR_TERMS + (k == 3 ? 0 : 1 + 3 * kind + k)) + lane];
}

// The sums lie four terms of a lane in a texel: texels 1 to 6 of red, 7 to 12 of green, 13 to 18 of blue.
void farKeep(Group group, int number)
{
    int at = farPlace(number), self = int(gl_LocalInvocationIndex);
    if (self == 0) {
        for (int i = 0; i < 3; i++)
            far_numbers[at + i] = group.centre[i];
        far_numbers[at + 3] = 1.0 / max(group.radius, 1e-30);
    }
    for (int i = self; i < 3 * FAR_TERMS; i += GROUP)
        far_numbers[at + 4 + i] = far_sums[i % FAR_TERMS * 3 + i / FAR_TERMS];
    for (int i = self; i < 24; i += GROUP)
        far_numbers[at + 4 * FAR_GLOSS + i] = farGlossNumber(group, i);
    for (int i = self; i < FAR_NEAR; i += GROUP)
        far_words[farBlock() * FAR_WORDS + FAR_MAP + number * FAR_NEAR + i] = far_near[i];
}

// A pixel's even light is off by e R, its gloss by g G at most, of sums R and G over all lights that are taken together, and may be by r e E + a. The
// one over the other is R / (r E + a / e) + G g / (r e E + a) at most, with the greatest e in the one and the least in the other.
void farLights(Group group)
{
    vec3 least = far_relative * farSureOfAll(group);
    vec3 even = 1.0 / max(least + far_absolute / max(group.even, 1e-20), 1e-30);
    vec3 gloss = group.gloss / max(least * group.dim + far_absolute, 1e-30);
    farGather(group, farThreshold(group, even, gloss));
}

vec3 farTake(int i) { return vec3(far_group[i], far_group[i + 1], far_group[i + 2]); }

// The group's numbers, which give way to its sums.
Group farLoad(int number)
{
    int self = int(gl_LocalInvocationIndex);
    for (int i = self; i < GROUP_NUMBERS; i += GROUP)
        far_group[i] = far_numbers[farPlace(number) + i];
    for (int i = self; i < 32; i += GROUP)
        far_shares[i] = 0u;
    for (int i = self; i < FAR_NEAR; i += GROUP)
        far_near[i] = 0u;
    barrier();
    return Group(farTake(0), farTake(3), farTake(6), far_group[9], far_group[10], far_group[11], far_group[12], far_group[13],
                 far_group[14], far_group[24], far_group[25], far_group[26], far_group[27], farTake(15), farTake(18),
                 farTake(21), far_group[28] > 0.0);
}

void main()
{
    int number = int(gl_WorkGroupID.z);
    Group group = farLoad(number);
    if (group.radius >= 0.0) {
        farLights(group);
        farKeep(group, number);
    }
}
