// Infinite planes, which voxels do not hold: rays intersect them analytically. A plane sends light
// where it is on screen; elsewhere it is black.
layout(std140) uniform IndirectPlanes {
    vec4 indirect_planes[INDIRECT_PLANES]; // planes in eye space: dot(plane, vec4(point, 1)) = 0
};

// Returns the signed distance of a point from a plane, times the plane's scale; exactly 0 within
// rounding.
float indirectOffPlane(vec4 plane, vec3 point)
{
    const float rounding = 4e-6;
    float off = dot(plane, vec4(point, 1.0));
    return abs(off) > rounding * (length(point) + abs(plane.w)) ? off : 0.0;
}

// Returns the nearest plane that a ray hits before `far`, and its distance in `far`; -1: none. A
// ray that starts on a plane does not hit that plane.
int indirectPlane(vec3 point, vec3 way, inout float far)
{
    int met = -1;
    for (int i = 0; i < INDIRECT_PLANES; i++) {
        float t = -indirectOffPlane(indirect_planes[i], point) / dot(indirect_planes[i].xyz, way);
        if (!(t > 0.0 && t < far)) continue;
        met = i;
        far = t;
    }
    return met;
}

bool indirectShows(int plane, ivec2 pixel)
{
    if (any(lessThan(pixel, ivec2(0))) || any(greaterThanEqual(pixel, ivec2(indirect_picture.xy))))
        return false;
    float depth = texelFetch(indirect_depth, pixel, 0).x;
    return depth > 0.0 && indirectOffPlane(indirect_planes[plane], indirectPoint(pixel, depth)) ==
        0.0;
}

// Pixel that shows a plane's point, or the adjacent one if an object on the plane covers it; x -2:
// none.
ivec2 indirectShown(int plane, vec3 point)
{
    const ivec2 beside[5] = ivec2[5](ivec2(0), ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1),
        ivec2(0, 1));
    if (!indirectIsOrthographic() && -point.z <= indirect_view.x) return ivec2(-2);
    vec2 place = clamp(indirectPlace(point), vec2(-2.0), indirect_picture.xy + 2.0);
    for (int i = 0; i < 5; i++)
        if (indirectShows(plane, ivec2(floor(place)) + beside[i]))
            return ivec2(floor(place)) + beside[i];
    return ivec2(-2);
}
