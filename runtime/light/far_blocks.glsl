// What the light of many lamps is kept in between dispatches: for each block of 32 x 32 pixels
// FAR_GROUPS groups of them, each with its centre, 1 over its radius, its sums in four by four
// terms of red, green and blue, those of gloss (far_lobe.glsl) and the mirrored view that they are
// around, and which lights are near: a pixel sums these by itself. Before it stand FAR_LIGHTS, how
// many there are at most, 32 times a power of two, and FAR_OTHERS, if not all are plain.
const int FAR_SPAN = 4, FAR_BLOCK = 8 * FAR_SPAN, FAR_GROUPS = 4; // pixels of an invocation of 8 x 8, and of all, along x and y
const int FAR_LOBES = 7;                         // terms of gloss: itself, its slopes along three axes, and by the mirrored view
const int FAR_GLOSS = 1 + 3 * FAR_TERMS / 4;     // where they begin: slopes and the term itself, a texel for each lane; slopes by the view, and that
const int FAR_TEXELS = FAR_GLOSS + 6;
const int FAR_MAP = 64;                                               // words of a block: of an invocation's pixels two bits each, their groups
const int FAR_BITS = FAR_LIGHTS / 32, FAR_TOPS = (FAR_BITS + 31) / 32; // of a group: a bit for each light; before that a bit for each of these words, if it isn't 0
const int FAR_NEAR = FAR_TOPS + FAR_BITS, FAR_MARKS = FAR_NEAR + FAR_BITS; // what is near; behind that a bit for each far light whose gloss is expanded
const int FAR_WORDS = FAR_MAP + FAR_GROUPS * FAR_MARKS;

layout(std140) uniform FarBudget {
    float far_relative; // to a pixel's light, that its sum may be off
    float far_absolute; // the same, besides, in light
    int far_row;        // blocks
};

// It sends back light of lamps.
bool farReflects(Lit m)
{
    return any(greaterThan(surfaceEven(m) + surfaceGloss(m), vec3(0.0))) || surfaceLetsThrough(m);
}
