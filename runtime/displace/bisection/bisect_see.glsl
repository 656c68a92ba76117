// Visibility of a triangle. A question's answer is a number: more than 0 is yes, and the camera has
// to move that far at least, either way, before the answer is another one. So both of two questions
// is the lesser of their numbers, one of them the greater, and not the negative.
//
//     in view by 2 from the nearest side, too coarse as it is unless it were 0.5 farther: both is
//         0.5, and nobody has to look again before the camera has gone by 0.5
//
// How far it moves: its place, plus what its sides turn by times how far away anything is.

// How far points move, along the world's axes, at least and at most, in bytes of which 0 is
// -bisect_reach and 255 bisect_reach: of triangles of each depth up to bisect_ranged, of a deeper
// one as of the one there that it is in.
layout(std430, binding = 5) buffer BisectRanges {
    uvec2 bisect_ranges[];
};
uniform int bisect_ranged;
uniform int bisect_deepest;     // no triangle is bisected for its own sake from there on
uniform vec3 bisect_reach;      // along the world's axes, no point moves farther
uniform vec4 bisect_eye;        // and 1; or where rays come from, and 0
uniform mat4 bisect_sides;      // of what is seen, by columns, of normals of length 1: a point is beyond one where the product is negative
uniform vec4 bisect_front;      // the same
uniform float bisect_near;      // what is nearer counts as so far
uniform float bisect_scale;     // pixels of a unit, at a distance of 1
uniform float bisect_pixels;    // that a deviation may have
uniform int bisect_closed;      // 3: nobody sees its triangles from behind, for their three corners; 0: or else
uniform float bisect_gone;      // how far the camera has moved
uniform float bisect_slack;     // of that, for what is rounded

const float BISECT_SURE = 1e30;

// Corners of a base and their normals, in the world.
struct BisectBase {
    mat3 places, normals;
};

mat3 bisectPart(uint base, uint part)
{
    uint at = BISECT_BASE * base + 4u + 9u * part;
    mat3 found;
    for (uint k = 0u; k < 3u; k++)
        found[k] = vec3(uintBitsToFloat(bisect_bases[at + 3u * k]), uintBitsToFloat(bisect_bases[at + 3u * k + 1u]), uintBitsToFloat(bisect_bases[at + 3u * k + 2u]));
    return found;
}

BisectBase bisectBase(uint base)
{
    BisectBase found = BisectBase(bisectPart(base, 0u), mat3(0.0));
    for (int i = 0; i < bisect_closed; i += 3) // a driver that runs both sides of a branch leaves out what a loop does no times
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

// All of the box is.
float bisectBeyond(vec4 side, vec3 middle, vec3 extent)
{
    return -(dot(side.xyz, middle) + side.w + dot(abs(side.xyz), extent));
}

// Normals of all three corners look away from the eye, or a light, from wherever in the box, by so
// much that what rises there is not seen over the horizon.
const float BISECT_BEHIND = 0.6; // the sine of the angle: what rises by a quarter of a ball's radius is seen from no farther behind
float bisectAway(BisectBase at, Corners t, vec4 eye, vec3 middle, vec3 extent)
{
    float away = bisect_closed != 0 ? BISECT_SURE : -BISECT_SURE;
    vec3 to = middle * eye.w - eye.xyz;
    float far = length(abs(to) + extent * eye.w);
    for (int k = 0; k < bisect_closed; k++) {
        vec3 normal = bisectMixed(at.normals, k == 0 ? t.a : k == 1 ? t.b : t.c);
        float longest = max(max(length(at.normals[0]), length(at.normals[1])), max(length(at.normals[2]), 1e-30));
        away = min(away, (dot(normal, to) - dot(abs(normal), extent) * eye.w) / longest - BISECT_BEHIND * far);
    }
    return away / (1.0 + BISECT_BEHIND);
}

#ifdef BISECT_LIGHTS
// -- what is seen of its shadow

vec4 bisectHeadFloats(uint at)
{
    return uintBitsToFloat(uvec4(bisect_work[at], bisect_work[at + 1u], bisect_work[at + 2u], bisect_work[at + 3u]));
}

// A point and 1, or where its rays come from, and 0; what shines is in a box around the point.
struct BisectLight {
    vec4 at;
    vec3 extent;
};

BisectLight bisectLight(uint i)
{
    uint words = EXTENT + 3u * i;
    return BisectLight(bisectHeadFloats(LIGHT + 4u * i), uintBitsToFloat(uvec3(bisect_work[words], bisect_work[words + 1u], bisect_work[words + 2u])));
}

// How far rays by the box go on until no point of them is where shadows may fall: as a length, or
// as times what they have gone. It is farthest from the light's near side.
float bisectLightReach(BisectLight from, vec3 middle, vec3 extent)
{
    vec4 light = from.at;
    vec3 low = bisectHeadFloats(BOX).xyz, high = bisectHeadFloats(BOX + 3u).xyz;
    float reach = 1e30;
    for (int k = 0; k < 3; k++) {
        float below = light[k] * light.w + from.extent[k], above = light[k] * light.w - from.extent[k];
        float least = middle[k] - extent[k] - below, most = middle[k] + extent[k] - above;
        if (light.w == 0.0 ? light[k] < 0.0 : least > 0.0)
            reach = min(reach, light.w == 0.0 ? (least - high[k]) / light[k] : (high[k] - below) / least);
        if (light.w == 0.0 ? light[k] > 0.0 : most < 0.0)
            reach = min(reach, light.w == 0.0 ? (most - low[k]) / light[k] : (low[k] - above) / most);
    }
    return max(reach, light.w);
}

// The box, and all that its shadow may fall on, are beyond the side: from where the light is the
// farthest beyond it, a shadow comes the farthest in.
float bisectCastsBeyond(vec4 side, BisectLight light, float reach, vec3 middle, vec3 extent)
{
    float most = dot(side.xyz, middle) + side.w + dot(abs(side.xyz), extent), from = dot(side, light.at) - dot(abs(side.xyz), light.extent);
    return min(-most, -(light.at.w != 0.0 ? from + reach * (most - from) : most - reach * from) / (2.0 * reach + 1.0));
}

// A light as a point of the line to it: at the eye it is the eye, from there it grows as what
// shines is seen. From it, to the nearest of the box around 0.
vec3 bisectGap(vec3 at, vec3 extent)
{
    return at - clamp(at, -extent, extent);
}

// Half of how its square changes along the line.
float bisectGapSlope(vec3 from, vec3 way, vec3 extent, vec3 grows, float at)
{
    vec3 gap = bisectGap(from + at * way, extent + at * grows);
    return dot(gap, way) - dot(abs(gap), grows);
}

// How far the box is from what lies between the eye and the light, as long as `last` says: the
// square grows along that line as a parabola between places where it passes a side of the box, so
// that its slope is a line there. As the light has an extent, the sides move.
float bisectLightFar(BisectLight light, float last, vec3 middle, vec3 extent)
{
    vec3 from = bisect_eye.xyz - middle, way = light.at.xyz - bisect_eye.xyz * light.at.w, grows = light.extent;
    float low = 0.0, high = last, low_slope = bisectGapSlope(from, way, extent, grows, 0.0), high_slope = bisectGapSlope(from, way, extent, grows, last);
    if (low_slope >= 0.0)
        return length(bisectGap(from, extent));
    if (high_slope <= 0.0)
        return length(bisectGap(from + last * way, extent + last * grows));
    for (int i = 0; i < 6; i++) {
        int lane = i >> 1;
        float side = (i & 1) != 0 ? -1.0 : 1.0, passes = way[lane] - side * grows[lane];
        float at = (side * extent[lane] - from[lane]) / passes;
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

// It is too coarse for its shadow by one of the lights, as it would be up to `far`. A deviation e
// of p, at right angles to the light's ray, is t e in the shadow, where the ray has gone from l to
// l + t (p - l), and is seen t e / |l + t (p - l) - eye| large: that is e / |p - (l + (eye - l) /
// t)|, and the latter between light and eye, wherever the shadow falls; no nearer to the light than
// where t is the most that a shadow can have.
float bisectShadowWants(BisectBase at, Corners t, float far, vec3 middle, vec3 extent)
{
    float wants = -BISECT_SURE;
    for (uint i = 0u; i < bisect_work[LIGHTS]; i++) {
        BisectLight light = bisectLight(i);
        float reach = bisectLightReach(light, middle, extent);
        float hidden = bisectCastsBeyond(bisect_front, light, reach, middle, extent);
        for (int side = 0; side < 4; side++)
            hidden = max(hidden, bisectCastsBeyond(bisect_sides[side], light, reach, middle, extent));
        hidden = max(hidden, bisectAway(at, t, light.at, middle, extent + light.extent) > 0.0 ? BISECT_SURE : -BISECT_SURE); // wherever the camera is
        float last = light.at.w != 0.0 ? 1.0 - 1.0 / reach : reach;
        float coarse = bisect_eye.w == 0.0 ? (far > 1.0 ? BISECT_SURE : -BISECT_SURE) : far - max(bisectLightFar(light, last, middle, extent), bisect_near);
        wants = max(wants, min(-hidden, coarse));
    }
    return wants;
}
#endif

// Its deviation is too large, as large as it can be seen from anywhere in a box around its points.
// A child's box is within that of its parent, and its deviation is at most its parent's: so who is
// not to be bisected has no children that are. Out of view, or from behind, it counts as eight
// times as far, since it is seen in mirrors; but where its shadow may be in view, as that needs it.
float bisectWants(BisectBase at, uint base, uint number, Corners t, uint code)
{
    int depth = findMSB(number);
    vec3 a = bisectMixed(at.places, t.a), b = bisectMixed(at.places, t.b), c = bisectMixed(at.places, t.c);
    uvec2 range = bisect_ranges[bisectRangeOf(base, number)];
    vec3 low = min(min(a, b), c) + bisectOffset(range.x), high = max(max(a, b), c) + bisectOffset(range.y),
         middle = (low + high) / 2.0, extent = (high - low) / 2.0;
    float hidden = bisectBeyond(bisect_front, middle, extent);
    for (int i = 0; i < 4; i++)
        hidden = max(hidden, bisectBeyond(bisect_sides[i], middle, extent));
    hidden = max(hidden, bisectAway(at, t, bisect_eye, middle, extent));
    float far = bisectDeviation(code) * bisect_scale / bisect_pixels; // up to where it is too coarse
    float away = max(length(max(abs(bisect_eye.xyz - middle) - extent, 0.0)), bisect_near);
    float coarse = far - away, coarser = far / 8.0 - away;
    if (bisect_eye.w == 0.0) { // from wherever
        coarse = far > 1.0 ? BISECT_SURE : -BISECT_SURE;
        coarser = far > 8.0 ? BISECT_SURE : -BISECT_SURE;
    }
    float wants = max(coarser, min(coarse, -hidden));
#ifdef BISECT_LIGHTS
    wants = max(wants, bisectShadowWants(at, t, far, middle, extent));
#endif
    return depth < bisect_coarse ? BISECT_SURE : depth >= bisect_deepest ? -BISECT_SURE : wants;
}

// A leaf that is asked: its place, what was there, and what is there from now on, whose corners are
// t; whether it is a child 0.
struct Asked {
    uint slot;
    Leaf had, leaf;
    Corners t;
    bool even;
};

// Whether it is to be bisected; and, of a child 0, whether its parent would be: of others
// BISECT_SURE.
struct Answers {
    float own, parent;
};

Answers bisectAnswers(Asked a)
{
    BisectBase base = bisectBase(a.leaf.base);
    Answers answers = Answers(BISECT_SURE, BISECT_SURE);
#ifdef BISECT_WIDE
    Corners t = bisectCorners(a.leaf.base, a.leaf.number); // found anew sooner than kept, by a device
    for (uint up = 0u; up <= uint(a.even); up++) { // as often as a device's compiler does not know, which would take its time for both
        float wants = bisectWants(base, a.leaf.base, a.leaf.number >> up, t, up == 0u ? a.leaf.own : a.leaf.behind);
        if (up == 0u)
            answers.own = wants;
        else
            answers.parent = wants;
        t = bisectParent(a.leaf.number, t);
    }
#else
    answers.own = bisectWants(base, a.leaf.base, a.leaf.number, a.t, a.leaf.own);
    if (a.even)
        answers.parent = bisectWants(base, a.leaf.base, a.leaf.number >> 1, bisectParent(a.leaf.number, a.t), a.leaf.behind);
#endif
    return answers;
}

// The leaf there has to be looked at again when the camera has moved by so much.
void bisectDue(uint slot, Answers answers)
{
    float move = min(abs(answers.own), abs(answers.parent)), due = max(bisect_gone + 0.99 * min(move, BISECT_SURE) - bisect_slack, 0.0);
    atomicMin(bisect_work[bisectWord(LIST_DUE, slot / BISECT_TILE)], floatBitsToUint(due));
}
