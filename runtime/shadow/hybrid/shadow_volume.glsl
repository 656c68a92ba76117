// A depth map as a height field over its texels' centers, with the shadow below. Four texels are a
// quad, from the lower left corner around: a, b, c, d. A diagonal divides it into two triangles:
// a-c, or for the perfect triangulation b-d unless the quad is turned.

// Returns true if the quad is turned: one end of the diagonal is farther from the plane of the
// other three corners than both adjacent corners are from theirs. All four differ from their planes
// by the same h = a - b + c - d along depth, so a distance is |h| / sqrt(1 + g), with g the squared
// slope of that plane: the sum of the squared steps of the two edges that meet in the opposite
// corner. So b is farther than a if the left edge is less steep than the right one, and farther
// than c if the upper edge is less steep than the lower one; for d both are reversed. Worked
// example: a b c d = 0 0 0 4. Steps: left 4, right 0, lower 0, upper 4; d is farther than a and c,
// and the diagonal is a-c.
bool volumeTurned(vec4 quad)
{
    vec4 steps = quad.xyxw - quad.wzyz; // depth steps along the left, right, lower and upper edge
    steps *= steps;
    return (steps.x < steps.y && steps.w < steps.z) || (steps.y < steps.x && steps.z < steps.w);
}

// Returns the position of a texel's center, from -1 to 1; stretched, as in the thesis, the
// outermost centers are at the map's edge.
vec2 volumePlace(ivec2 texel, float size, bool stretched)
{
    return vec2(2 * texel + (stretched ? 0 : 1)) / (stretched ? size - 1.0 : size) - 1.0;
}

// Returns the position, from -1 to 1, of a point between centers, in texels from the first center.
vec2 volumePlace(vec2 texel, float size, bool stretched)
{
    return (2.0 * texel + (stretched ? 0.0 : 1.0)) / (stretched ? size - 1.0 : size) - 1.0;
}
