// A depth map as a height field over its texels' centres: what lies behind it is in the shadow.
// Four texels are a quad, from the lower left corner around: a, b, c, d. One diagonal makes it two
// triangles: a-c, or, of the perfect triangulation, b-d unless the quad is turned.

// A diagonal is turned if one of its corners lies farther from the plane of the other three than
// both corners beside it. All four are off by the same h = a - b + c - d along depth, so that a
// distance is |h| / sqrt(1 + g), with g the square of that plane's slope: the sum of the squares of
// two edges' steps, those that meet in the opposite corner. So b is farther than a where the left
// edge is less steep than the right one, and than c where the upper edge is less steep than the
// lower one; of d both are the other way round. Worked example: a b c d = 0 0 0 4. Steps: left 4,
// right 0, lower 0, upper 4; d is farther than a and c, and a-c it is.
bool volumeTurned(vec4 quad)
{
    vec4 steps = quad.xyxw - quad.wzyz; // left, right, lower, upper
    steps *= steps;
    return (steps.x < steps.y && steps.w < steps.z) || (steps.y < steps.x && steps.z < steps.w);
}

// Where texel centres lie, from -1 to 1; or, stretched, as the thesis has them: the outermost ones
// at the map's edge.
vec2 volumePlace(ivec2 texel, float size, bool stretched)
{
    return vec2(2 * texel + (stretched ? 0 : 1)) / (stretched ? size - 1.0 : size) - 1.0;
}

// And what lies between centres, in texels from the first one's.
vec2 volumePlace(vec2 texel, float size, bool stretched)
{
    return (2.0 * texel + (stretched ? 0.0 : 1.0)) / (stretched ? size - 1.0 : size) - 1.0;
}
