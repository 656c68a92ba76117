// Blocks of pixels, and what is kept of them between dispatches, as far.layout.def says: the groups
// of their pixels, sums of far lights in terms of the series and of gloss (far_lobe.glsl), and
// which lights are near: a pixel sums these by itself. Before it stand FAR_LIGHTS, how many lights
// there are at most, 32 times a power of two, the numbers of words that follow from it
// (LightFarWords), and FAR_OTHERS, if not all are plain.
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
