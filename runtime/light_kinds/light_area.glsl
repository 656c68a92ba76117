// Light of radiance 1 from a polygon at a point at the origin. Seen from the point, its edges are
// arcs of great circles, and integrals over the polygon are sums over these arcs: Stokes' theorem
// on the sphere.
//
// The cosine's integral is Lambert's formula, half of the sum of angle * dot(m, n), with m the unit
// normal of an arc's plane, facing inward. A power of a cosine times a cosine is Arvo's double axis
// moment (SIGGRAPH 1995). Arvo sums over integer exponents; here any exponent k has
//   (k + 2) integral of (w.u)^k (n.u) du = sum over arcs of the integral of (n.w) (m.w) h(c) +
//   (n.m) c^k, with c = w.u, h = (1 - c^k) / (1 - c^2)
// over the arc's length s. The integrand is smooth: h is k / 2 where c is 1, and 1 + c^2 + c^4 +
// ... + c^(k-2) for even k. With s measured from the arc's point nearest to w, both terms are as
// wide as r, r^2 = (m.w)^2 + 4 / (k + 1); tan s = r tan t spreads them evenly over t, where eight
// Gauss points are within 3e-4 of the lobe's total, 2 pi / (k + 2), for all k to 65504.
//
// Worked example: a square that fills the half space. Four arcs of 90 degrees lie in the horizon, m
// = n, so the cosine's integral is half of 2 pi. With w = n: c is 0 and h 1 all along them, and the
// moment is 2 pi / (k + 2).
#ifndef LIGHT_SENDS
#define LIGHT_HAS_AREAS
const float AREA_PI = 3.14159265358979;

// A parallelogram seen from a point at the origin: corner + s u + t v, s and t from 0 to 1; its
// corners in the order (0, 0), (1, 0), (1, 1), (0, 1) are clockwise, so that cross products of
// successive corners point inward.
struct Area {
    vec3 corner, u, v;
    float width; // twice the light's longer edge over the distance of its nearest corner
    bool seen;   // false: the point sees the back side, or is in the light's plane
};

Area areaMeasured(vec3 corner, vec3 u, vec3 v, bool seen)
{
    float nearest = min(min(length(corner), length(corner + u)),
        min(length(corner + u + v), length(corner + v)));
    return Area(corner, u, v, 2.0 * max(length(u), length(v)) / max(nearest, 1e-30), seen);
}

Area areaSeen(vec3 corner, vec3 u, vec3 v, bool bothSides)
{
    // normalizes the size, so that squares do not overflow
    float scale = 1.0 / max(length(corner), max(length(u), length(v)));
    corner *= scale;
    u *= scale;
    v *= scale;
    vec3 face = cross(u, v);
    float height = dot(face, corner); // height above 0: the point is behind the light
    bool turned = bothSides && height > 0.0;
    return areaMeasured(corner, turned ? u : v, turned ? v : u,
        (bothSides ? abs(height) : -height) > 1e-6 * length(face));
}

// Returns the parallelogram transformed by a matrix.
Area areaInto(Area area, mat3 into)
{
    return areaMeasured(into * area.corner, into * area.u, into * area.v, area.seen);
}

// Half spaces, as functions on a parallelogram: they contain (s, t) where h.x + h.y s + h.z t >= 0.
const vec3 AREA_ALL = vec3(1.0, 0.0, 0.0);
vec3 areaHalf(Area area, vec3 normal)
{
    return vec3(dot(area.corner, normal), dot(area.u, normal), dot(area.v, normal));
}
float areaLowest(vec3 h) { return h.x + min(h.y, 0.0) + min(h.z, 0.0); }
float areaHighest(vec3 h) { return h.x + max(h.y, 0.0) + max(h.z, 0.0); }
vec2 areaHeights(vec4 line, vec3 h) { return h.x + vec2(dot(h.yz, line.xy), dot(h.yz, line.zw)); }

// Return lines from (s, t) to (s, t): an edge; the point where a line crosses the border of a half
// space; the part of a line inside, or a line of length 0.
vec4 areaEdge(int i)
{
    return i < 2 ? i < 1 ? vec4(0.0, 0.0, 1.0, 0.0) : vec4(1.0, 0.0, 1.0, 1.0) : i < 3
        ? vec4(1.0, 1.0, 0.0, 1.0) : vec4(0.0, 1.0, 0.0, 0.0);
}
vec2 areaCrossing(vec4 line, vec2 heights)
{
    return mix(line.xy, line.zw, heights.x / (heights.x - heights.y));
}
vec4 areaWithin(vec4 line, vec3 h)
{
    vec2 heights = areaHeights(line, h);
    if (max(heights.x, heights.y) < 0.0) return line.xyxy;
    if (min(heights.x, heights.y) >= 0.0) return line;
    vec2 crossing = areaCrossing(line, heights);
    return heights.x < 0.0 ? vec4(crossing, line.zw) : vec4(line.xy, crossing);
}

// The border of the intersection with two half spaces, clipped by one after the other, so that it
// is closed even if both are equal: the parts of the edges, and the closing lines along the first
// and then along the second border, from where lines leave a half space to where they reenter.
//   Worked example, h = (-0.25, 1, 0): s is 0.25 or more. Edge 0 is from (0.25, 0) to (1, 0), edge
//   2 from (1, 1) to (0.25, 1), edge 3 has no length, and the closing line is from (0.25, 1) to
//   (0.25, 0).
const int AREA_LINES = 6;
struct AreaBorder {
    vec3 first, second;
    vec4 closing, last;
};

void areaClose(vec4 line, vec3 h, inout vec4 closing)
{
    vec2 heights = areaHeights(line, h);
    if ((heights.x < 0.0) == (heights.y < 0.0)) return;
    vec2 crossing = areaCrossing(line, heights);
    if (heights.x < 0.0) closing.zw = crossing;
    else closing.xy = crossing;
}

vec4 areaFirst(AreaBorder border, int i)
{
    if (i == 4) return border.closing;
    return areaWithin(areaEdge(i), border.first);
}

AreaBorder areaBorder(vec3 first, vec3 second)
{
    AreaBorder border = AreaBorder(first, second, vec4(0.0), vec4(0.0));
    if (areaLowest(first) < 0.0)
        for (int i = 0; i < 4; i++) areaClose(areaEdge(i), first, border.closing);
    if (areaLowest(second) < 0.0)
        for (int i = 0; i < 5; i++) areaClose(areaFirst(border, i), second, border.last);
    return border;
}

vec4 areaLine(AreaBorder border, int i)
{
    if (i == 5) return border.last;
    return areaWithin(areaFirst(border, i), border.second);
}

// Returns -ln(1 - q) / q.
float areaLogarithm(float q)
{
    return q < 0.015625 ? 1.0 + q * (0.5 + q * (1.0 / 3.0 + q * 0.25))
        : -log(max(1.0 - q, 1e-30)) / q;
}

// Integrates by Gaussian quadrature with 3 x 3 points over the whole parallelogram. For a small
// polygon a sum over arcs would lose the area to cancellation.
float areaPoints(Area area, vec3 normal, vec3 w, float exponent)
{
    const float PLACE[3] = float[3](0.1127016654, 0.5, 0.8872983346);
    const float WEIGHT[3] = float[3](5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0);
    vec3 face = cross(area.u, area.v);
    float sum = 0.0;
    for (int k = 0; k < 9; k++) {
        vec3 p = area.corner + PLACE[k % 3] * area.u + PLACE[k / 3] * area.v;
        float square = dot(p, p);
        vec3 d = p * inversesqrt(square), across = cross(w, d);
        float q = min(dot(across, across), 1.0);
        float power = exponent > 0.0 ? dot(w, d) > 0.0
            ? exp(-0.5 * exponent * q * areaLogarithm(q)) : 0.0 : 1.0;
        sum += WEIGHT[k % 3] * WEIGHT[k / 3] * max(dot(normal, d) * dot(face, d), 0.0) / square *
            power;
    }
    return sum / AREA_PI;
}

// Returns the angle from 0 to pi of a sine, not below 0, and a cosine, with any common factor;
// relative error 2e-7, where a driver's arctangent may be less exact. A quarter of the angle is an
// arctangent of at most 0.42, whose series converges fast.
float areaAngle(float sine, float cosine)
{
    float t = sine / max(length(vec2(sine, cosine)) + abs(cosine), 1e-37);
    t /= 1.0 + sqrt(1.0 + t * t);
    float z = -t * t, sum = 0.0;
    for (int i = 17; i > 0; i -= 2) sum = sum * z + 1.0 / float(i);
    return cosine < 0.0 ? AREA_PI - 4.0 * t * sum : 4.0 * t * sum;
}

// Returns the integral of the cosine over pi, above the normal's horizon and in another half space:
// the share of uniform light from all directions.
float areaCosine(Area area, vec3 normal, vec3 other)
{
    vec3 above = areaHalf(area, normal);
    bool whole = min(areaLowest(above), areaLowest(other)) >= 0.0;
    if (min(areaHighest(above), areaHighest(other)) <= 0.0 || !area.seen) return 0.0;
    if (whole && area.width < 0.3) return areaPoints(area, normal, normal, 0.0);
    AreaBorder border = areaBorder(above, other);
    float sum = 0.0;
    for (int i = 0; i < (whole ? 4 : AREA_LINES); i++) {
        vec4 line = areaLine(border, i);
        vec2 way = line.zw - line.xy;
        vec3 a = area.corner + line.x * area.u + line.y * area.v, step_ = way.x * area.u +
            way.y * area.v;
        vec3 m = cross(a, step_);
        float sine = length(m);
        if (sine > 0.0) sum += areaAngle(sine, dot(a, a + step_)) * (dot(m, normal) / sine);
    }
    return max(sum, 0.0) / (2.0 * AREA_PI);
}

// Returns an arc's contribution to the moment; see the top of the file.
float areaArc(vec3 a, vec3 step_, vec3 normal, vec3 w, float exponent)
{
    const float PLACE[4] = float[4](0.1834346425, 0.5255324099, 0.7966664774, 0.9602898565);
    const float WEIGHT[4] = float[4](0.3626837834, 0.3137066459, 0.2223810345, 0.1012285363);
    vec3 m = cross(a, step_), b = a + step_;
    float sine = length(m);
    if (sine <= 0.0) return 0.0;
    m /= sine;
    float off = dot(w, m), square = off * off;
    vec3 near = w - off * m;
    float along = dot(near, near);
    if (along < 1e-10) near = a; // the whole arc is perpendicular to w
    vec3 beside = cross(m, near);
    float r = min(sqrt(square + 4.0 / (exponent + 1.0)), 1.0);
    float first = atan(dot(beside, a), r * dot(near, a)),
        last = atan(dot(beside, b), r * dot(near, b));
    if (last < first - 1.0) last += 2.0 * AREA_PI; // the arc crosses the branch cut of the angle
    float middle = 0.5 * (first + last), half_ = 0.5 * (last - first), sum = 0.0;
    for (int i = 0; i < 8; i++) {
        float t = middle + (i < 4 ? half_ : -half_) * PLACE[i & 3];
        float c = cos(t), s = r * sin(t), rate = 1.0 / (c * c + s * s);
        // squared sine of the angle between w and u: q = 1 - (w.u)^2
        float q = min(square + along * s * s * rate, 1.0);
        float logarithm = areaLogarithm(q), x = 0.5 * exponent * q * logarithm;
        float h = x < 0.05 ? 0.5 * exponent * logarithm *
            (1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0)))
                           : (1.0 - exp(-x)) / q;
        sum += WEIGHT[i & 3] * rate * (dot(normal, w) * off * h + dot(normal, m) * exp(-x));
    }
    return sum * half_ * r;
}

// Returns the integral of (w.u)^exponent (normal.u) over pi, in the half space `above` and in that
// of w.
float areaLobe(Area area, vec3 above, vec3 normal, vec3 w, float exponent)
{
    // equals areaCosine() without its code, which compilers take seconds for
    bool even = exponent <= 0.0;
    if (areaHighest(above) <= 0.0 || !area.seen) return 0.0;
    if (areaLowest(above) >= 0.0 && area.width * area.width * (exponent + 1.0) <
        (even ? 0.09 : 0.3))
        return areaPoints(area, normal, w, exponent);
    AreaBorder border = areaBorder(above, areaHalf(area, even ? normal : w));
    float sum = 0.0;
    for (int i = 0; i < AREA_LINES && areaHighest(border.second) > 0.0; i++) {
        vec4 line = areaLine(border, i);
        vec2 way = line.zw - line.xy;
        sum += areaArc(area.corner + line.x * area.u + line.y * area.v,
            way.x * area.u + way.y * area.v, normal, w, exponent);
    }
    return max(sum, 0.0) / ((exponent + 2.0) * AREA_PI);
}

// Reflection of light that arrives on one side of a surface: diffuse, plus a lobe around an axis,
// the cosine's power included; or, if the exponent is negative, diffuse over directions transformed
// by a matrix (LTC). Surface models return it (surface_model.h), so that the code of the integrals
// above is in a program only once.
struct AreaSide {
    vec3 normal, even;        // the side's normal, and its diffuse share
    vec3 specular, axis, across; // specular lobe: gloss max(axis.l, 0)^exponent across.l
    float exponent;
    // valid if the exponent is negative: maps the side's normal to z, or a lobe's directions
    mat3 into;
};

AreaSide areaPowers(vec3 normal, vec3 even, vec3 specular, vec3 axis, vec3 across, float exponent)
{
    return AreaSide(normal, even, specular, axis, across, exponent, mat3(1.0));
}

vec3 areaOfSide(Area light, AreaSide side)
{
    bool into = side.exponent < 0.0;
    vec3 above = areaHalf(light, side.normal), sum = vec3(0.0);
    if (any(greaterThan(side.even, vec3(0.0)))) {
        Area seen = light;
        if (into) seen = areaInto(light, side.into);
        sum = side.even * areaCosine(seen, into ? vec3(0.0, 0.0, 1.0) : side.normal,
            into ? above : AREA_ALL);
    }
    if (!into && any(greaterThan(side.specular, vec3(0.0))))
        sum += side.specular * areaLobe(light, above, side.across, side.axis, side.exponent);
    return sum;
}
#else
// Returns a parallelogram light as seen from a point.
Area areaAt(int light, vec3 point)
{
    return areaSeen(lightTexel(light, LIGHT_PLACE).xyz - point, lightTexel(light, LIGHT_AXIS).xyz,
        lightTexel(light, LIGHT_CONE).xyz,
                    lightTexel(light, LIGHT_POWER).w > 0.0);
}

#ifdef SHADOW_SOFT
vec3 softLight(int light, Seen seen); // defined in shadow_soft.glsl
#endif

vec3 lightFromArea(int light, Seen seen)
{
#ifdef SHADOW_SOFT
    return lightTexel(light, LIGHT_POWER).xyz * softLight(light, seen);
#else
    return lightTexel(light, LIGHT_POWER).xyz * surfaceArea(seen.m, areaAt(light, seen.point));
#endif
}
#endif
