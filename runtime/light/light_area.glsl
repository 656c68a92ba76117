// Light of radiance 1 from a polygon, on a point at the origin. Its edges, as the point sees them, are arcs of great circles, and integrals
// over the polygon are sums over these arcs: Stokes' theorem on the sphere.
//
// The cosine's integral is Lambert's formula, half of the sum of angle * dot(m, n), m the unit normal of an arc's plane, turned inward. A power
// of a cosine times a cosine is Arvo's double axis moment (SIGGRAPH 1995). He sums over whole exponents; here any exponent k has
//   (k + 2) integral of (w.u)^k (n.u) du = sum over arcs of the integral of (n.w) (m.w) h(c) + (n.m) c^k, with c = w.u, h = (1 - c^k) / (1 - c^2)
// over the arc's length s, which is smooth: h is k / 2 where c is 1, and 1 + c^2 + c^4 + ... + c^(k-2) for even k. With s from the arc's point
// nearest to w, both are as wide as r, r^2 = (m.w)^2 + 4 / (k + 1); tan s = r tan t spreads that evenly over t, where eight Gauss points
// are within 3e-4 of the lobe's whole, 2 pi / (k + 2), for all k to 65504.
//
// Worked example: a square that fills the half space. Four arcs of 90 degrees lie in the horizon, m = n, so the cosine's integral is
// half of 2 pi. With w = n: c is 0 and h 1 all along them, and the moment is 2 pi / (k + 2).
#define LIGHT_HAS_AREAS
const int AREA_CORNERS = 9; // of a parallelogram that two planes cut, and rounding
const float AREA_PI = 3.14159265358979;

struct Area {
    vec3 corners[AREA_CORNERS]; // clockwise, as the point sees them: cross products of neighbours point inward
    int count;
    float width; // of the whole parallelogram, over its least distance
};

// The parallelogram's corners from a point; nothing where it turns its back, or the point is in its plane.
Area areaSeen(vec3 corner, vec3 u, vec3 v, bool bothSides)
{
    Area area;
    float size = max(length(u), length(v));
    float scale = 1.0 / max(length(corner), size); // of any size, and squares are numbers
    corner *= scale;
    u *= scale;
    v *= scale;
    vec3 face = cross(u, v);
    float height = dot(face, corner); // above 0: the point is behind it
    bool turned = bothSides && height > 0.0;
    vec3 second = turned ? u : v, last = turned ? v : u;
    area.corners[0] = corner;
    area.corners[1] = corner + second;
    area.corners[2] = corner + u + v;
    area.corners[3] = corner + last;
    float nearest = min(min(length(corner), length(area.corners[1])), min(length(area.corners[2]), length(area.corners[3])));
    area.width = 2.0 * size * scale / max(nearest, 1e-30);
    area.count = (bothSides ? abs(height) : -height) > 1e-6 * length(face) ? 4 : 0;
    return area;
}

// What of it is in the half space of a normal.
Area areaClip(Area area, vec3 normal)
{
    Area left = Area(area.corners, 0, area.width);
    for (int i = 0; i < area.count; i++) {
        vec3 a = area.corners[i], b = area.corners[i + 1 < area.count ? i + 1 : 0];
        float high = dot(a, normal), next = dot(b, normal);
        if (high >= 0.0 && left.count < AREA_CORNERS) left.corners[left.count++] = a;
        if ((high >= 0.0) != (next >= 0.0) && left.count < AREA_CORNERS)
            left.corners[left.count++] = a + (b - a) * (high / (high - next));
    }
    return left;
}

// -ln(1 - q) / q
float areaLogarithm(float q)
{
    return q < 0.015625 ? 1.0 + q * (0.5 + q * (1.0 / 3.0 + q * 0.25)) : -log(max(1.0 - q, 1e-30)) / q;
}

// Seven points of each triangle (Radon's rule, exact for powers to the fifth): the middle, and two on each line from there to a corner, in
// shares of that line. Arcs would lose a small polygon's area, which is what is left of their sum, to rounding.
float areaPoints(Area area, vec3 normal, vec3 w, float exponent)
{
    const float PLACE[3] = float[3](0.0, -0.4104261923, 0.6961404780);
    const float WEIGHT[3] = float[3](0.225, 0.1323941528, 0.1259391805);
    float sum = 0.0;
    for (int i = 1; i + 1 < area.count; i++) {
        vec3 a = area.corners[0], b = area.corners[i], c = area.corners[i + 1];
        vec3 face = cross(b - a, c - a), middle = (a + b + c) / 3.0;
        for (int k = 0; k < 7; k++) {
            vec3 p = mix(middle, k % 3 == 0 ? a : k % 3 == 1 ? b : c, PLACE[(k + 2) / 3]);
            float square = dot(p, p);
            vec3 d = p * inversesqrt(square), across = cross(w, d);
            float q = min(dot(across, across), 1.0);
            float power = exponent > 0.0 ? dot(w, d) > 0.0 ? exp(-0.5 * exponent * q * areaLogarithm(q)) : 0.0 : 1.0;
            sum += WEIGHT[(k + 2) / 3] * max(dot(normal, d) * dot(face, d), 0.0) / square * power;
        }
    }
    return sum / (2.0 * AREA_PI);
}

// Of a sine, not below 0, and a cosine, of any length; from 0 to pi, within 2e-7 of itself, where a driver's arctangent may have less. A
// quarter of it is an arctangent of at most 0.42, whose powers fall fast.
float areaAngle(float sine, float cosine)
{
    float t = sine / max(length(vec2(sine, cosine)) + abs(cosine), 1e-37);
    t /= 1.0 + sqrt(1.0 + t * t);
    float z = -t * t, sum = 0.0;
    for (int i = 17; i > 0; i -= 2) sum = sum * z + 1.0 / float(i);
    return cosine < 0.0 ? AREA_PI - 4.0 * t * sum : 4.0 * t * sum;
}

// The integral of the cosine over pi, of a polygon above the horizon of the normal: the share of the light that would fill the half space.
float areaCosine(Area area, vec3 normal)
{
    if (area.width < 0.3) return areaPoints(area, normal, normal, 0.0);
    float sum = 0.0;
    for (int i = 0; i < area.count; i++) {
        vec3 a = area.corners[i], b = area.corners[i + 1 < area.count ? i + 1 : 0];
        vec3 m = cross(a, b - a);
        float sine = length(m);
        if (sine > 0.0) sum += areaAngle(sine, dot(a, b)) * (dot(m, normal) / sine);
    }
    return max(sum, 0.0) / (2.0 * AREA_PI);
}

// An arc's share of the moment; see above.
float areaArc(vec3 a, vec3 b, vec3 normal, vec3 w, float exponent)
{
    const float PLACE[4] = float[4](0.1834346425, 0.5255324099, 0.7966664774, 0.9602898565);
    const float WEIGHT[4] = float[4](0.3626837834, 0.3137066459, 0.2223810345, 0.1012285363);
    vec3 m = cross(a, b - a);
    float sine = length(m);
    if (sine <= 0.0) return 0.0;
    m /= sine;
    float off = dot(w, m), square = off * off;
    vec3 near = w - off * m;
    float along = dot(near, near);
    if (along < 1e-10) near = a; // all of the arc is at right angles to w
    vec3 beside = cross(m, near);
    float r = min(sqrt(square + 4.0 / (exponent + 1.0)), 1.0);
    float first = atan(dot(beside, a), r * dot(near, a)), last = atan(dot(beside, b), r * dot(near, b));
    if (last < first - 1.0) last += 2.0 * AREA_PI; // it crosses where angles begin
    float middle = 0.5 * (first + last), half_ = 0.5 * (last - first), sum = 0.0;
    for (int i = 0; i < 8; i++) {
        float t = middle + (i < 4 ? half_ : -half_) * PLACE[i & 3];
        float c = cos(t), s = r * sin(t), rate = 1.0 / (c * c + s * s);
        float q = min(square + along * s * s * rate, 1.0); // 1 - (w.u)^2
        float logarithm = areaLogarithm(q), x = 0.5 * exponent * q * logarithm;
        float h = x < 0.05 ? 0.5 * exponent * logarithm * (1.0 - x * (0.5 - x * (1.0 / 6.0 - x / 24.0)))
                           : (1.0 - exp(-x)) / q;
        sum += WEIGHT[i & 3] * rate * (dot(normal, w) * off * h + dot(normal, m) * exp(-x));
    }
    return sum * half_ * r;
}

// The integral of (w.u)^exponent (normal.u) over pi, of what of a polygon above the horizon of the normal is in the half space of w, too.
float areaLobe(Area area, vec3 normal, vec3 w, float exponent)
{
    bool even = exponent <= 0.0; // what is left is areaCosine, which needs no text of its own here: compilers take seconds for each
    if (area.width * area.width * (exponent + 1.0) < (even ? 0.09 : 0.3)) return areaPoints(area, normal, w, exponent);
    Area seen = areaClip(area, even ? normal : w);
    float sum = 0.0;
    for (int i = 0; i < seen.count; i++)
        sum += areaArc(seen.corners[i], seen.corners[i + 1 < seen.count ? i + 1 : 0], normal, w, exponent);
    return max(sum, 0.0) / ((exponent + 2.0) * AREA_PI);
}

// The polygon in other directions: each times a matrix. What of it is above their horizon.
Area areaInto(Area area, mat3 into)
{
    float longest = 0.0, nearest = 1e30;
    for (int i = 0; i < area.count; i++) area.corners[i] = into * area.corners[i];
    for (int i = 0; i < area.count; i++) {
        longest = max(longest, distance(area.corners[i], area.corners[i + 1 < area.count ? i + 1 : 0]));
        nearest = min(nearest, length(area.corners[i]));
    }
    area.width = 2.0 * longest / max(nearest, 1e-30);
    return areaClip(area, vec3(0.0, 0.0, 1.0));
}

// What a surface sends of light that arrives on one side of it: evenly, and around an axis, the cosine's power counted in; or, where the exponent is below 0, evenly of
// directions times a matrix. A model gives it (surface_model.h), so that the code of the integrals above stands in a program once.
struct AreaSide {
    vec3 normal, even;        // the side, and the share that it sends evenly
    vec3 gloss, axis, across; // the lobe: gloss max(axis.l, 0)^exponent across.l
    float exponent;
    mat3 into; // read where that is below 0: turned so that the side's normal is z, or a lobe's directions
};

AreaSide areaPowers(vec3 normal, vec3 even, vec3 gloss, vec3 axis, vec3 across, float exponent)
{
    return AreaSide(normal, even, gloss, axis, across, exponent, mat3(1.0));
}

vec3 areaOfSide(Area light, AreaSide side)
{
    bool into = side.exponent < 0.0;
    Area part = areaClip(light, side.normal), seen = part;
    if (into) seen = areaInto(part, side.into);
    vec3 sum = vec3(0.0);
    if (any(greaterThan(side.even, vec3(0.0)))) sum = side.even * areaCosine(seen, into ? vec3(0.0, 0.0, 1.0) : side.normal);
    if (!into && any(greaterThan(side.gloss, vec3(0.0)))) sum += side.gloss * areaLobe(part, side.across, side.axis, side.exponent);
    return sum;
}
