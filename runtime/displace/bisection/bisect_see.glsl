// Visibility of a triangle. A query's value is a signed number: positive means yes, and its
// magnitude is a lower bound of the distance that the camera has to move before the sign changes.
// So `and` of two queries is the minimum of their values, `or` the maximum, and `not` the negative.
//
//  inside the view frustum by 2 from the nearest side, and too coarse unless 0.5 farther away: the
//  `and` is 0.5, and the triangle is not evaluated again before the camera has moved by 0.5
//
// The camera's movement is the distance of its positions plus the rotation of its frustum planes
// times the distance of the farthest point.

// Minimum and maximum displacement of points along the world's axes, in bytes: 0 is -bisect_reach,
// 255 is bisect_reach. Stored for triangles of each depth up to bisect_ranged; a deeper triangle
// uses its ancestor at that depth.
layout(std430, binding = 5) buffer BisectRanges {
    uvec2 bisect_ranges[];
};
uniform int bisect_ranged;
uniform int bisect_deepest; // triangles of this depth are bisected only for a neighbor's sake
uniform vec3 bisect_reach;  // maximum displacement along the world's axes
uniform vec4 bisect_eye;    // (position, 1); or for parallel rays (direction toward the eye, 0)
// frustum planes, by columns, with unit normals: negative products are outside
uniform mat4 bisect_sides;
uniform vec4 bisect_front;   // the near plane, in the form of the planes above
uniform float bisect_near;   // lower bound of distances
uniform float bisect_scale;  // pixels per unit length at distance 1
uniform float bisect_pixels; // tolerated deviation in pixels
uniform int bisect_closed;   // 3 (corners) for a closed mesh whose back faces are invisible; else 0
uniform float bisect_gone;   // distance that the camera has moved
uniform float bisect_slack;  // rounding error of bisect_gone

const float BISECT_SURE = 1e30;

// Corners of a base and their normals, in world space.
struct BisectBase {
    mat3 places, normals;
};

mat3 bisectPart(uint base, uint part)
{
    uint at = BISECT_BASE * base + 4u + 9u * part;
    mat3 found;
    for (uint k = 0u; k < 3u; k++)
        found[k] = vec3(uintBitsToFloat(bisect_bases[at + 3u * k]),
            uintBitsToFloat(bisect_bases[at + 3u * k + 1u]),
            uintBitsToFloat(bisect_bases[at + 3u * k + 2u]));
    return found;
}

BisectBase bisectBase(uint base)
{
    BisectBase found = BisectBase(bisectPart(base, 0u), mat3(0.0));
    // without closed bases the loop has 0 iterations, and drivers that execute both sides of a
    // branch skip it
    for (int i = 0; i < bisect_closed; i += 3)
        found.normals = bisectPart(base, 1u);
    return found;
}

vec3 bisectMixed(mat3 of, ivec3 weights)
{
    return of * (vec3(weights) / float(BISECT_WHOLE));
}

uint bisectRangeOf(uint base, uint number)
{
    return (base << (bisect_ranged + 1)) + (number >> max(findMSB(number) - bisect_ranged, 0));
}

vec3 bisectOffset(uint bytes)
{
    return (vec3(uvec3(bytes, bytes >> 8, bytes >> 16) & 255u) / 127.5 - 1.0) * bisect_reach;
}

// Returns a positive number if the whole box is outside the plane.
float bisectBeyond(vec4 side, vec3 middle, vec3 extent)
{
    return -(dot(side.xyz, middle) + side.w + dot(abs(side.xyz), extent));
}

// The normals of all three corners point away from the eye or a light, from every point in the box,
// by an angle so large that displaced points are not visible over the horizon.
// sine of the angle: a height of a quarter of a ball's radius is visible from no farther behind
const float BISECT_BEHIND = 0.6;
float bisectAway(BisectBase at, Corners t, vec4 eye, vec3 middle, vec3 extent)
{
    float away = bisect_closed != 0 ? BISECT_SURE : -BISECT_SURE;
    vec3 to = middle * eye.w - eye.xyz;
    float far = length(abs(to) + extent * eye.w);
    for (int k = 0; k < bisect_closed; k++) {
        vec3 normal = bisectMixed(at.normals, k == 0 ? t.a : k == 1 ? t.b : t.c);
        float longest = max(max(length(at.normals[0]), length(at.normals[1])),
            max(length(at.normals[2]), 1e-30));
        away = min(away, (dot(normal, to) - dot(abs(normal), extent) * eye.w) / longest -
            BISECT_BEHIND * far);
    }
    return away / (1.0 + BISECT_BEHIND);
}

#ifdef BISECT_LIGHTS
// -- visibility of a triangle's shadow

vec4 bisectStateFloats(uint at)
{
    return uintBitsToFloat(uvec4(bisect_work[at], bisect_work[at + 1u], bisect_work[at + 2u],
        bisect_work[at + 3u]));
}

// (position, 1), or (direction toward the light, 0); `extent` is the half size of the light's
// bounding box.
struct BisectLight {
    vec4 at;
    vec3 extent;
};

BisectLight bisectLight(uint i)
{
    uint words = EXTENT + 3u * i;
    return BisectLight(bisectStateFloats(LIGHT + 4u * i),
        uintBitsToFloat(uvec3(bisect_work[words], bisect_work[words + 1u],
        bisect_work[words + 2u])));
}

// Returns the distance that rays through the box travel until they have left the bounds of shadow
// receivers: a length for parallel rays, else a multiple of the distance from the light. The
// light's near side gives the maximum.
float bisectLightReach(BisectLight from, vec3 middle, vec3 extent)
{
    vec4 light = from.at;
    vec3 low = bisectStateFloats(BOX).xyz, high = bisectStateFloats(BOX + 3u).xyz;
    float reach = 1e30;
    for (int k = 0; k < 3; k++) {
        float below = light[k] * light.w + from.extent[k], above = light[k] * light.w -
            from.extent[k];
        float least = middle[k] - extent[k] - below, most = middle[k] + extent[k] - above;
        if (light.w == 0.0 ? light[k] < 0.0 : least > 0.0)
            reach = min(reach, light.w == 0.0 ? (least - high[k]) / light[k]
                : (high[k] - below) / least);
        if (light.w == 0.0 ? light[k] > 0.0 : most < 0.0)
            reach = min(reach, light.w == 0.0 ? (most - low[k]) / light[k]
                : (low[k] - above) / most);
    }
    return max(reach, light.w);
}

// Returns a positive number if the box and all receivers of its shadow are outside the plane. The
// point of the light that is farthest outside casts the shadow farthest inside.
float bisectCastsBeyond(vec4 side, BisectLight light, float reach, vec3 middle, vec3 extent)
{
    float most = dot(side.xyz, middle) + side.w + dot(abs(side.xyz), extent),
        from = dot(side, light.at) - dot(abs(side.xyz), light.extent);
    return min(-most, -(light.at.w != 0.0 ? from + reach * (most - from) : most - reach * from) /
        (2.0 * reach + 1.0));
}

// The light as a point on the line from the eye to it: at the eye its extent is 0, and grows
// linearly along the line. Returns the vector from that point to the nearest point of the box
// around 0.
vec3 bisectGap(vec3 at, vec3 extent)
{
    return at - clamp(at, -extent, extent);
}

// Returns half the derivative of the squared gap along the line.
float bisectGapSlope(vec3 from, vec3 way, vec3 extent, vec3 grows, float at)
{
    vec3 gap = bisectGap(from + at * way, extent + at * grows);
    return dot(gap, way) - dot(abs(gap), grows);
}

// Returns the distance of the box from the segment between the eye and the light, up to parameter
// `last`. The squared distance along the line is piecewise quadratic, with breaks where the line
// passes a side of the box, so its derivative is piecewise linear. The sides move with the light's
// extent.
float bisectLightFar(BisectLight light, float last, vec3 middle, vec3 extent)
{
    vec3 from = bisect_eye.xyz - middle, way = light.at.xyz - bisect_eye.xyz * light.at.w,
        grows = light.extent;
    float low = 0.0, high = last, low_slope = bisectGapSlope(from, way, extent, grows, 0.0),
        high_slope = bisectGapSlope(from, way, extent, grows, last);
    if (low_slope >= 0.0)
        return length(bisectGap(from, extent));
    if (high_slope <= 0.0)
        return length(bisectGap(from + last * way, extent + last * grows));
    for (int i = 0; i < 6; i++) {
        int component = i >> 1;
        float side = (i & 1) != 0 ? -1.0 : 1.0, passes = way[component] - side * grows[component];
        float at = (side * extent[component] - from[component]) / passes;
        if (passes == 0.0 || at <= low || at >= high)
            continue;
        float slope = bisectGapSlope(from, way, extent, grows, at);
        low_slope = slope < 0.0 ? slope : low_slope;
        high_slope = slope < 0.0 ? high_slope : slope;
        low = slope < 0.0 ? at : low;
        high = slope < 0.0 ? high : at;
    }
    float nearest = low + (high - low) * low_slope / (low_slope - high_slope);
    return length(bisectGap(from + nearest * way, extent + nearest * grows));
}

// Returns a positive number if the triangle is too coarse for its shadow by one of the lights;
// `far`: distance up to which the triangle itself is too coarse. A deviation e at p, perpendicular
// to the light's ray, becomes t e in the shadow, where the ray has traveled from l to l + t (p -
// l), and appears with the size t e / |l + t (p - l) - eye|. That is e / |p - (l + (eye - l) / t)|,
// the distance to a point between light and eye, wherever the shadow falls. The greatest t of a
// shadow bounds how near that point is to the light.
float bisectShadowWants(BisectBase at, Corners t, float far, vec3 middle, vec3 extent)
{
    float wants = -BISECT_SURE;
    for (uint i = 0u; i < bisect_work[LIGHTS]; i++) {
        BisectLight light = bisectLight(i);
        float reach = bisectLightReach(light, middle, extent);
        float hidden = bisectCastsBeyond(bisect_front, light, reach, middle, extent);
        for (int side = 0; side < 4; side++)
            hidden = max(hidden, bisectCastsBeyond(bisect_sides[side], light, reach, middle,
                extent));
        // facing away from a light is independent of the camera's position
        hidden = max(hidden, bisectAway(at, t, light.at, middle, extent + light.extent) > 0.0
            ? BISECT_SURE : -BISECT_SURE);
        float last = light.at.w != 0.0 ? 1.0 - 1.0 / reach : reach;
        float coarse = bisect_eye.w == 0.0 ? (far > 1.0 ? BISECT_SURE : -BISECT_SURE) : far -
            max(bisectLightFar(light, last, middle, extent), bisect_near);
        wants = max(wants, min(-hidden, coarse));
    }
    return wants;
}
#endif

// Returns a positive number if the triangle's deviation is too large, as seen from the nearest
// point of a box around its points. A child's box is inside its parent's, and its deviation is at
// most the parent's, so a triangle that need not be bisected has no descendants that need to be.
// Outside the frustum, and from behind, its distance counts eightfold, since mirrors may show it; a
// visible shadow counts fully.
float bisectWants(BisectBase at, uint base, uint number, Corners t, uint code)
{
    int depth = findMSB(number);
    vec3 a = bisectMixed(at.places, t.a), b = bisectMixed(at.places, t.b),
        c = bisectMixed(at.places, t.c);
    uvec2 range = bisect_ranges[bisectRangeOf(base, number)];
    vec3 low = min(min(a, b), c) + bisectOffset(range.x), high = max(max(a, b), c) +
        bisectOffset(range.y),
         middle = (low + high) / 2.0, extent = (high - low) / 2.0;
    float hidden = bisectBeyond(bisect_front, middle, extent);
    for (int i = 0; i < 4; i++)
        hidden = max(hidden, bisectBeyond(bisect_sides[i], middle, extent));
    hidden = max(hidden, bisectAway(at, t, bisect_eye, middle, extent));
    // distance up to which the leaf is too coarse
    float far = bisectDeviation(code) * bisect_scale / bisect_pixels;
    float away = max(length(max(abs(bisect_eye.xyz - middle) - extent, 0.0)), bisect_near);
    float coarse = far - away, coarser = far / 8.0 - away;
    // a parallel projection: the deviation is independent of the distance
    if (bisect_eye.w == 0.0) {
        coarse = far > 1.0 ? BISECT_SURE : -BISECT_SURE;
        coarser = far > 8.0 ? BISECT_SURE : -BISECT_SURE;
    }
    float wants = max(coarser, min(coarse, -hidden));
#ifdef BISECT_LIGHTS
    wants = max(wants, bisectShadowWants(at, t, far, middle, extent));
#endif
    return depth < bisect_coarse ? BISECT_SURE : depth >= bisect_deepest ? -BISECT_SURE : wants;
}

// A leaf to be evaluated: its slot, the leaf that was there, and the new leaf with corners t;
// `even`: it is a child 0.
struct Asked {
    uint slot;
    Leaf had, leaf;
    Corners t;
    bool even;
};

// Values of the queries: the leaf is to be bisected; and, for a child 0, its parent would be
// (BISECT_SURE for others).
struct Answers {
    float own, parent;
};

Answers bisectAnswers(Asked a)
{
    BisectBase base = bisectBase(a.leaf.base);
    Answers answers = Answers(BISECT_SURE, BISECT_SURE);
#ifdef BISECT_WIDE
    // recomputes the corners, which is faster than keeping them in registers
    Corners t = bisectCorners(a.leaf.base, a.leaf.number);
    // the loop bound is dynamic, so that the compiler does not duplicate the body
    for (uint up = 0u; up <= uint(a.even); up++) {
        float wants = bisectWants(base, a.leaf.base, a.leaf.number >> up, t, up == 0u ? a.leaf.own
            : a.leaf.behind);
        if (up == 0u)
            answers.own = wants;
        else
            answers.parent = wants;
        t = bisectParent(a.leaf.number, t);
    }
#else
    answers.own = bisectWants(base, a.leaf.base, a.leaf.number, a.t, a.leaf.own);
    if (a.even)
        answers.parent = bisectWants(base, a.leaf.base, a.leaf.number >> 1,
            bisectParent(a.leaf.number, a.t), a.leaf.behind);
#endif
    return answers;
}

// Schedules the next evaluation of the leaf in the slot, after the camera has moved far enough to
// change a value.
void bisectDue(uint slot, Answers answers)
{
    float move = min(abs(answers.own), abs(answers.parent)),
        due = max(bisect_gone + 0.99 * min(move, BISECT_SURE) - bisect_slack, 0.0);
    atomicMin(bisect_work[bisectWord(LIST_DUE, slot / BISECT_TILE)], floatBitsToUint(due));
}
