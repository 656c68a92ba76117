// A group of pixels of a block, which are close to each other and have similar surfaces: written by
// pass_groups.glsl, later replaced by the sums of pass_light_cluster.glsl. Preceded by
// lighting.glsl, far_terms.glsl and far_blocks.glsl, and FAR_INVOCATIONS, the invocations per
// group: some software renderers serialize accesses to shared memory, so that few invocations are
// faster there.
layout(std430, binding = FAR_WORDS_BINDING) buffer FarWords {
    uint far_words[];
};

layout(std430, binding = FAR_NUMBERS_BINDING) buffer FarNumbers {
    float far_numbers[];
};

const float NEVER = 1e30;

// Bounds of a group's pixels. centre, radius: bounding box of the points, and distance of its
// corners; radius < 0: no group. axis, cosine, sine: cone of normals around the seed's. above,
// below: max and min of n.(p - c). view, mirror: cone of mirrored views around the seed's. even,
// dim: max and min diffuse reflectance; gloss: max specular reflectance; exponent: min specular
// exponent. behind: some surface transmits light. For far_lobe.glsl: turn and lean are the max
// deviations of mirrored views and normals from the seed's, and spread is the max change of a power
// of a cosine by the range of exponents.
struct Group {
    vec3 centre, axis, view;
    float radius, cosine, sine, above, below, mirror, exponent;
    float turn, lean, spread;
    vec3 even, dim, specular;
    bool behind;
};

int farBlock() { return int(gl_WorkGroupID.y) * far_row + int(gl_WorkGroupID.x); }

// Returns the first float of a group's numbers, and first word of its bits.
int farPlace(int number) { return (farBlock() * FAR_GROUPS + number) * FAR_TEXELS * 4; }
int farBits(int number) { return farBlock() * FAR_WORDS + FAR_MAP + number * FAR_MARKS; }

// Range of cosines between a direction and all directions in a cone: x the min, y the max. `along`
// is the cosine to the cone's axis.
vec2 farCosines(float along, float cosine, float sine)
{
    float aside = sqrt(max(1.0 - along * along, 0.0)) * sine;
    return vec2(along > -cosine ? along * cosine - aside : -1.0, along < cosine ? along * cosine +
        aside : 1.0);
}
