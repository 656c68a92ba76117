// Blocks of pixels, and their data between dispatches, laid out by far.layout.def: the groups of
// their pixels, sums of distant lights as terms of a series and of specular lobes (far_lobe.glsl),
// and the set of near lights, which each pixel sums itself. Preceded by FAR_LIGHTS, the capacity in
// lights, 32 times a power of two; the numbers of words that follow from it (LightFarWords); and
// FAR_OTHERS, if some lights are not plain.
layout(std140) uniform FarBudget {
    float far_relative; // max error relative to a pixel's light
    float far_absolute; // max absolute error, added to the relative error
    int far_row;        // number of blocks in a row
};

// Reports whether the surface reflects or transmits light of lamps.
bool farReflects(Lit m)
{
    return any(greaterThan(surfaceEven(m) + surfaceSpecular(m), vec3(0.0))) ||
        surfaceLetsThrough(m);
}
