// The third dispatch of the pass light_cluster: for each group of a block's pixels, sums the
// distant lights that pass_near.glsl selected. Preceded by far_light.glsl.
const int ROWS = FAR_TERMS + FAR_LOBES;

shared float far_parts[ROWS * PITCH]; // partial sums of a color component, a row for each term
shared float far_sums[3 * ROWS];

// Sums a color component over the invocations.
void farSum(int component)
{
    barrier();
    for (int row = int(gl_LocalInvocationIndex); row < ROWS; row += GROUP) {
        float sum = 0.0;
        for (int i = 0; i < GROUP; i++)
            sum += far_parts[row * PITCH + i];
        far_sums[3 * row + component] = sum;
    }
    barrier();
}

// Sums the series of distant lights, and their specular light.
void farGather(Group group, int number)
{
    vec3 sums[FAR_TERMS], lobes[FAR_LOBES];
#define FAR_CLEAR(k) sums[k] = vec3(0.0);
#define FAR_CLEAR_LOBE(k) lobes[k] = vec3(0.0);
    FAR_EACH(FAR_CLEAR)
    FAR_EACH_LOBE(FAR_CLEAR_LOBE)
    int at = farBits(number), self = int(gl_LocalInvocationIndex);
    for (int i = self; i < farCount(); i += GROUP) {
        uint bit = 1u << (i & 31);
        if ((far_words[at + FAR_TOPS + (i >> 5)] & bit) != 0u) continue;
        Far far = farLight(i, group);
        if (farIsDark(far, group)) continue;
        if (farExpands(far)) farAdd(far.way, far.ratio, far.power, sums);
#ifdef SURFACE_HAS_specular
        if ((far_words[at + FAR_NEAR + (i >> 5)] & bit) != 0u) farAddLobe(far, group, lobes);
#endif
    }
#define FAR_PART(k) far_parts[(k) * PITCH + self] = sums[k][component];
#define FAR_PART_LOBE(k) far_parts[(FAR_TERMS + k) * PITCH + self] = lobes[k][component];
    for (int component = 0; component < 3; component++) {
        FAR_EACH(FAR_PART)
        FAR_EACH_LOBE(FAR_PART_LOBE)
        farSum(component);
    }
}

// -- results

// Returns number i from FAR_SPECULAR on.
float farSpecularNumber(Group group, int i)
{
    int component = i / 4 % 3, kind = i / 12, k = i % 4;
    if (kind == 1 && k == 3) return group.view[component];
    return far_sums[3 * (FAR_TERMS + (k == 3 ? 0 : 1 + 3 * kind + k)) + component];
}

void farKeep(Group group, int number)
{
    int at = farPlace(number), self = int(gl_LocalInvocationIndex);
    if (self == 0) {
        for (int i = 0; i < 3; i++)
            far_numbers[at + 4 * FAR_CENTER + i] = group.centre[i];
        far_numbers[at + 4 * FAR_CENTER + 3] = 1.0 / max(group.radius, 1e-30);
    }
    for (int i = self; i < 3 * FAR_TERMS; i += GROUP)
        far_numbers[at + 4 * FAR_SUMS + i] = far_sums[i % FAR_TERMS * 3 + i / FAR_TERMS];
    for (int i = self; i < 4 * (FAR_TEXELS - FAR_SPECULAR); i += GROUP)
        far_numbers[at + 4 * FAR_SPECULAR + i] = farSpecularNumber(group, i);
}

void main()
{
    int number = int(gl_WorkGroupID.z);
    Group group = farLoad(number);
    if (group.radius < 0.0) return;
    farGather(group, number);
    farKeep(group, number);
}
