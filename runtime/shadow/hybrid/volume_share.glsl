// Hybrid shadows: tests whether a shadow volume contains a surface point. Follows shadow.glsl and
// shadow_volume.glsl.
#ifdef SHADOW_MASK
uniform sampler2D shadow_mask;

// Returns the share of light at opaque surfaces: the volumes' faces were counted at the pixel, a
// bit for each light.
float volumeShare(int bit, ivec2 views, vec3 point, ivec2 at)
{
    return float((uint(texelFetch(shadow_mask, at, 0)[bit / 8] * 255.0 +
        0.5) >> (bit % 8) & 1u) ^ 1u);
}
#else
// Interpolates a triangle's depth between three texels: b is adjacent to a, c adjacent to b. For
// parallel light the triangle reaches infinity if one texel has no depth.
float volumeHeight(vec3 abc, vec2 part, bool parallel)
{
    return parallel && min(abc.x, min(abc.y, abc.z)) <= 0.0 ? 0.0 : abc.x +
        (abc.y - abc.x) * part.x + (abc.z - abc.y) * part.y;
}

#ifdef SHADOW_CUT
// defined in volume_cells.glsl
bool volumeCellHas(ivec2 layers, vec2 at, float depth, bool parallel);
#endif

// Returns true if the volume of a view contains the point; uses the same triangles as the drawn
// volume.
bool volumeHas(int view, vec3 point)
{
    vec4 how = shadowRow(view, VIEW_HOW);
    vec3 place = shadowPlace(view, vec4(point, 1.0));
    bool parallel = how.x <= 0.0;
    if (!parallel && place.z <= 0.0) return false;
    float depth = parallel ? place.z : how.x / place.z, size = float(SHADOW_SIZE);
    vec2 at = (parallel ? place.xy : place.xy / place.z) * 0.5 + 0.5;
    at = SHADOW_STRETCHED ? at * (size - 1.0) : at * size - 0.5;
    if (!all(greaterThanEqual(at, vec2(0.0))) || !all(lessThan(at, vec2(size - 1.0)))) return false;
#ifdef SHADOW_CUT
    return volumeCellHas(ivec2(view, int(how.w) - 1), at, depth, parallel);
#else
    ivec2 texel = ivec2(at);
    vec2 part = at - vec2(texel);
    vec4 quad = vec4(texelFetch(shadow_maps, ivec3(texel, view), 0).x,
                     texelFetch(shadow_maps, ivec3(texel + ivec2(1, 0), view), 0).x,
                     texelFetch(shadow_maps, ivec3(texel + ivec2(1, 1), view), 0).x,
                     texelFetch(shadow_maps, ivec3(texel + ivec2(0, 1), view), 0).x);
    if (SHADOW_QUADS && !volumeTurned(quad)) // diagonal b-d: mirroring turns the diagonal into a-c
        quad = quad.yxwz, part.x = 1.0 - part.x;
    return depth < (part.x >= part.y ? volumeHeight(quad.xyz, part, parallel)
        : volumeHeight(quad.xwz, part.yx, parallel));
#endif
}

// Returns the share of light at transparent surfaces, which have no counts in the stencil.
float volumeShare(int number, ivec2 views, vec3 point, ivec2 at)
{
    for (int view = views.x; view < views.x + views.y; view++)
        if (volumeHas(view, point)) return 0.0;
    return 1.0;
}
#endif

// Returns the share of a light that arrives (entry point, called by shadow_text.c's functions).
vec3 volumeLight(int number, ivec2 views, vec3 point, vec3 side, float size, ivec2 pixel)
{
    shadow_apart = true;
    return vec3(volumeShare(number, views, point, pixel));
}
