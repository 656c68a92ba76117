// What the light of many lamps is kept in between two dispatches: for each block of 16 x 16 pixels FAR_GROUPS groups of them, each with its centre, 1 over its
// radius, its sums in four by four terms of red, green and blue, and which lights are near: a pixel sums these by itself. Before it stand FAR_LIGHTS, how
// many there are at most, a multiple of 32, and FAR_OTHERS, if not all are plain.
const int FAR_BLOCK = 16, FAR_GROUPS = 2, FAR_PIXELS = FAR_BLOCK * FAR_BLOCK;
const int FAR_TEXELS = 1 + 3 * FAR_TERMS / 4;
const int FAR_MAP = FAR_PIXELS / 32, FAR_NEAR = FAR_LIGHTS / 32;
const int FAR_WORDS = FAR_MAP + FAR_GROUPS * FAR_NEAR; // of a block: which pixels are of the second group; near lights of both, a bit for each

layout(std140) uniform FarBudget {
    float far_relative; // to a pixel's light, that its sum may be off
    float far_absolute; // the same, besides, in light
    int far_row;        // blocks
};

layout(std430, binding = 4) buffer FarWords {
    uint far_words[];
};

// It sends back light of lamps.
bool farReflects(Lit m)
{
    return any(greaterThan(surfaceEven(m) + surfaceGloss(m), vec3(0.0))) || surfaceLetsThrough(m);
}
