// A group of pixels of a block: those that lie near each other and are alike, as pass_groups.glsl
// leaves them where pass_gather.glsl puts sums. Before it stand lighting.glsl, far_terms.glsl and
// far_blocks.glsl, and FAR_INVOCATIONS, the invocations that a pass has for a group: some software
// renderers go through what invocations share for one after the other, so that few are faster
// there.
layout(std430, binding = FAR_WORDS_BINDING) buffer FarWords {
    uint far_words[];
};

layout(std430, binding = FAR_NUMBERS_BINDING) buffer FarNumbers {
    float far_numbers[];
};

const float NEVER = 1e30;

// The centre of its points' box, and the distance of its corners, less than 0: there is none; the
// seed's normal, and the cone of all around it, n.(p - c) at most and at least; the seed's mirrored
// view, and the cone of all around it; of its surfaces the most and the least that is even, the
// most that is not, and the least exponent of that. What far_lobe.glsl asks: how far mirrored views
// turn and normals lean from the seed's, and the most by which exponents change a power of a
// cosine.
struct Group {
    vec3 centre, axis, view;
    float radius, cosine, sine, above, below, mirror, exponent;
    float turn, lean, spread;
    vec3 even, dim, gloss;
    bool behind;
};

int farBlock() { return int(gl_WorkGroupID.y) * far_row + int(gl_WorkGroupID.x); }

// Where the numbers of a group begin, and its bits.
int farPlace(int number) { return (farBlock() * FAR_GROUPS + number) * FAR_TEXELS * 4; }
int farBits(int number) { return farBlock() * FAR_WORDS + FAR_MAP + number * FAR_MARKS; }

// The cosines that a direction can have with one that is within an angle of an axis: x the least, y
// the most.
vec2 farCosines(float along, float cosine, float sine)
{
    float aside = sqrt(max(1.0 - along * along, 0.0)) * sine;
    return vec2(along > -cosine ? along * cosine - aside : -1.0, along < cosine ? along * cosine + aside : 1.0);
}
