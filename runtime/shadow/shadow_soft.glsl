// Soft shadows of area lights: the share of the light in the penumbra. From SOFT_POINTS x SOFT_POINTS points of the light, evenly spread
// from edge to edge, a map each shows what is in front of it (soft_views.h); so each says exactly,
// but for its texels, whether its point reaches a surface. Four neighbours are the corners of a
// cell:
//  - all of them arrive: so does the cell's light. If that is so for all cells, the light is left
//    as it is, bit for bit;
//  - none does: the cell's light, the closed form of its own parallelogram, is taken away;
//  - else what is taken away is the share of sixteen ways from inside the cell that something
//    stops. The corners that do not arrive say where
//    that stands: at the share `along` of the way from the light. A way passes there through a
//        place that the map of the nearest corner
//    knows, and is stopped by what is there: by what is nearer to the light than the middle between
//        there and the surface.
// So the end of a shadow is as wide as the light, what casts it and the surface make it, and
// smooth; and for ever more points it is exact.
//
// Worked example: five points along an edge, sixteen cells. A straight edge hides the left 3/8 of
// the light: the first two columns of points do not arrive. Four cells lose all, and of the four
// beside them the ways from their left halves: in all 4/16 + 4 (1/2)/16 = 3/8.
//
// A texel's surface occludes a point only if it is above the point's tangent plane, by SOFT_OFF
// texels and the error of a pixel of the picture. So no plane and no
// convex body shades itself, without a lift that would lose what stands close.
const float SOFT_OFF = 0.25;
const float SOFT_INSET = 1.0 / 256.0; // of an edge, that the outermost points stand inside of it
const int SOFT_CELLS = SOFT_POINTS - 1, SOFT_WAYS = 16;
const int SOFT_WORDS = (SOFT_POINTS * SOFT_POINTS + 31) / 32;

// A light, and a surface's point in its axes: x along u, z along the normal, to the point's side;
// the origin is its corner.
struct Soft {
    vec3 corner, u, v; // in the eye's space
    vec3 eye;          // the point there
    vec2 along_u, along_v;
    vec3 point, normal;
    float pixel;  // the size of one of the picture, there
    bool through; // light from behind the surface counts, too
    int layer;    // of the first point's map
    float near;   // of all of them
};

Soft softOf(int light, Seen seen)
{
    vec4 corner = lightTexel(light, LIGHT_PLACE), u = lightTexel(light, LIGHT_AXIS), v = lightTexel(light, LIGHT_CONE);
    vec3 x = normalize(u.xyz), z = normalize(cross(u.xyz, v.xyz)), y = cross(z, x), way = seen.point - corner.xyz;
    float side = dot(z, way) < 0.0 ? -1.0 : 1.0, near = 0.0;
    int layer = int(u.w) - 1 + (side < 0.0 ? SOFT_POINTS * SOFT_POINTS : 0);
#ifdef SHADOW_MAPS
    near = shadowRow(layer, VIEW_HOW).x;
#endif
    return Soft(corner.xyz, u.xyz, v.xyz, seen.point, vec2(length(u.xyz), 0.0), vec2(dot(v.xyz, x), dot(v.xyz, y)),
                vec3(dot(x, way), dot(y, way), abs(dot(z, way))),
                vec3(dot(x, seen.m.normal), dot(y, seen.m.normal), side * dot(z, seen.m.normal)), seen.pixelSize,
                any(greaterThan(surfaceLobe(seen.m, -seen.m.normal), vec3(0.0))), layer, near);
}

vec2 softPart(ivec2 point) { return clamp(vec2(point) / float(SOFT_CELLS), SOFT_INSET, 1.0 - SOFT_INSET); }

vec3 softPlace(Soft s, vec2 part) { return vec3(part.x * s.along_u + part.y * s.along_v, 0.0); }

// Weight of a place of the light for a diffuse surface, up to a factor of the light and the point.
float softWeight(Soft s, vec3 place)
{
    vec3 way = place - s.point;
    float cosine = dot(s.normal, way), square = dot(way, way);
    return (s.through ? abs(cosine) : max(cosine, 0.0)) / (square * square);
}

#ifdef SHADOW_MAPS
const int SOFT_QUARTER = SHADOW_SIZE / 4;

// The texel in which something lies that way from a map's point, and how far along its face.
ivec2 softTexel(vec3 way, out float away)
{
    vec2 size = abs(way.xy);
    float side = max(size.x, size.y);
    away = max(max(side, way.z), 1e-30);
    vec2 at = way.xy / away;
    ivec2 low = ivec2(SOFT_QUARTER), high = ivec2(3 * SOFT_QUARTER - 1);
    if (side > way.z) {
        bool x = size.x >= size.y; // no lane is indexed by a variable: some drivers keep what is so in memory
        float beyond = 2.0 - max(way.z, 0.0) / side;
        int first = (x ? at.x : at.y) < 0.0 ? 0 : 3 * SOFT_QUARTER, last = first + SOFT_QUARTER - 1;
        at = x ? vec2(at.x * beyond, at.y) : vec2(at.x, at.y * beyond);
        low = x ? ivec2(first, low.y) : ivec2(low.x, first);
        high = x ? ivec2(last, high.y) : ivec2(high.x, last);
    }
    return clamp(ivec2(floor((at + 2.0) * float(SOFT_QUARTER))), low, high);
}

// The way to a texel's middle, as far as 1 along its face.
vec3 softWay(ivec2 texel)
{
    vec2 at = (vec2(texel) + 0.5) / float(SOFT_QUARTER) - 2.0, size = abs(at);
    if (max(size.x, size.y) <= 1.0) return vec3(at, 1.0);
    return size.x > size.y ? vec3(sign(at.x), at.y, 2.0 - size.x) : vec3(at.x, sign(at.y), 2.0 - size.y);
}

// Whether what a map has so far away stands before the surface.
bool softStands(Soft s, vec3 from, vec3 ray, float away, float limit)
{
    vec3 normal = dot(s.normal, from - s.point) < 0.0 ? -s.normal : s.normal;
    float over = SOFT_OFF / float(SOFT_QUARTER) * away + s.pixel / 64.0;
    return away < limit && dot(normal, from + ray * away - s.point) > over;
}

// The share of light that goes this way from a point, by what stands at less than `limit` of it;
// `along`: at which share of it something is, or 0.
SHARE softWayShare(Soft s, ivec2 point, vec3 way, float limit, out float along)
{
    float away;
    vec3 from = softPlace(s, softPart(point));
    ivec2 texel = softTexel(way, away);
    vec3 ray = softWay(texel);
    int layer = s.layer + point.y * SOFT_POINTS + point.x;
    float depth = texelFetch(shadow_maps, ivec3(texel, layer), 0).x;
    SHARE share = SHARE(1.0);
    along = 0.0;
    if (depth > 0.0 && softStands(s, from, ray, s.near / depth, limit * away)) {
        along = s.near / depth / away;
        return SHARE(0.0);
    }
#if defined SHADOW_GLASS && !defined SHADOW_PARTS
    for (uint node = shadowList(shadowAt(layer, texel)); node != 0u; node = shadowNext(node)) {
        float there = s.near / shadowListed(node);
        if (!softStands(s, from, ray, there, limit * away)) continue;
        share *= shadowLets(node);
        along = max(along, there / away);
    }
#endif
    return share;
}
#endif

// Transmittance of infinite planes, from a place of the light.
SHARE softPlanes(Soft s, vec2 part)
{
#ifdef SHADOW_PLANES
    return shadowPlanes(vec4(s.corner + part.x * s.u + part.y * s.v, 1.0), s.eye);
#else
    return SHARE(1.0);
#endif
}

// A bit for each point. Words are gone through, not indexed by a variable, for the same reason.
struct SoftBits {
    uint words[SOFT_WORDS];
};

SoftBits softNoBits()
{
    SoftBits bits;
    for (int i = 0; i < SOFT_WORDS; i++)
        bits.words[i] = 0u;
    return bits;
}

void softSet(inout SoftBits bits, int point, bool set)
{
    for (int i = 0; i < SOFT_WORDS; i++)
        bits.words[i] |= set && i == point / 32 ? 1u << uint(point % 32) : 0u;
}

int softBit(SoftBits bits, int point)
{
    uint word = 0u;
    for (int i = 0; i < SOFT_WORDS; i++)
        word |= i == point / 32 ? bits.words[i] : 0u;
    return int(word >> uint(point % 32) & 1u);
}

// Visibility of a surface from a light's points.
struct SoftPoints {
    SoftBits dim, dark;     // less than all arrives, or nothing
    int asked, dims, darks; // numbers of points: of those that are not behind the surface
};

// The share of a point's light that arrives; `along`: where what is on the way stands, or 0: no map
// knows.
SHARE softPointShare(Soft s, ivec2 point, out float along)
{
    vec2 part = softPart(point);
    SHARE share = softPlanes(s, part);
    along = 0.0;
#ifdef SHADOW_MAPS
    share *= softWayShare(s, point, s.point - softPlace(s, part), 1.0, along);
#endif
    return share;
}

bool softIsAsked(Soft s, ivec2 point) { return softWeight(s, softPlace(s, softPart(point))) > 0.0; }

SoftPoints softAsk(Soft s)
{
    SoftPoints points = SoftPoints(softNoBits(), softNoBits(), 0, 0, 0);
    for (int i = 0; i < SOFT_POINTS * SOFT_POINTS; i++) {
        ivec2 point = ivec2(i % SOFT_POINTS, i / SOFT_POINTS);
        if (!softIsAsked(s, point)) continue;
        float along;
        SHARE share = softPointShare(s, point, along);
        bool less = share != SHARE(1.0), none = share == SHARE(0.0);
        softSet(points.dim, i, less);
        softSet(points.dark, i, none);
        points.asked++;
        points.dims += int(less);
        points.darks += int(none);
    }
    return points;
}

// How many of a cell's corners are dim, and dark.
ivec2 softCorners(SoftPoints points, ivec2 cell)
{
    ivec2 count = ivec2(0);
    for (int i = 0; i < 4; i++) {
        int point = (cell.y + (i >> 1)) * SOFT_POINTS + cell.x + (i & 1);
        count += ivec2(softBit(points.dim, point), softBit(points.dark, point));
    }
    return count;
}

// Where what stands before a cell's corners is, as the mean; 1: no map knows. They are asked once
// more, as few cells are so.
float softAlong(Soft s, ivec2 cell)
{
    float sum = 0.0, known = 0.0;
    for (int i = 0; i < 4; i++) {
        ivec2 point = cell + ivec2(i & 1, i >> 1);
        float along = 0.0;
        if (softIsAsked(s, point)) softPointShare(s, point, along);
        sum += along;
        known += along > 0.0 ? 1.0 : 0.0;
    }
    return known > 0.0 ? clamp(sum / known, 0.01, 1.0) : 1.0;
}

// The share of a cell's light that arrives. No two ways from any cells of a row, or of a column,
// start at one height.
SHARE softCell(Soft s, ivec2 cell)
{
    vec2 shift = (vec2(cell.yx) + 0.5) / float(SOFT_CELLS);
    SHARE sum = SHARE(0.0);
    float along = softAlong(s, cell), all = 0.0;
    for (int i = 0; i < SOFT_WAYS; i++) {
        int reversed = (i & 1) << 3 | (i & 2) << 1 | (i & 4) >> 1 | (i & 8) >> 3;
        vec2 inside = (vec2(i, reversed) + shift) / float(SOFT_WAYS), part = (vec2(cell) + inside) / float(SOFT_CELLS);
        float weight = softWeight(s, softPlace(s, part));
        if (weight <= 0.0) continue;
        SHARE share = softPlanes(s, part);
#ifdef SHADOW_MAPS
        float other;
        ivec2 point = cell + ivec2(greaterThanEqual(inside, vec2(0.5)));
        vec3 way = mix(softPlace(s, part), s.point, along) - softPlace(s, softPart(point));
        share *= softWayShare(s, point, way, 0.5 * (1.0 + along) / along, other);
#endif
        sum += weight * share;
        all += weight;
    }
    return all > 0.0 ? sum / all : SHARE(1.0);
}

// Light of an area light that a surface reflects, each component for radiance 1: first without
// occlusion, then less the occluded part of each cell.
vec3 softLight(int light, Seen seen)
{
    vec4 corner = lightTexel(light, LIGHT_PLACE), u = lightTexel(light, LIGHT_AXIS), v = lightTexel(light, LIGHT_CONE);
    bool both = lightTexel(light, LIGHT_POWER).w > 0.0;
    vec3 sum = vec3(0.0);
    SHARE lost = SHARE(1.0);
    Soft s = softOf(light, seen);
    SoftPoints points = SoftPoints(softNoBits(), softNoBits(), 0, 0, 0);
    if (u.w > 0.0) points = softAsk(s);
    if (points.asked > 0 && points.darks == points.asked) return vec3(0.0);
    int count = points.dims == 0 ? 0 : SOFT_CELLS * SOFT_CELLS;
    for (int i = -1; i < count; i++) {
        ivec2 cell = ivec2(max(i, 0) % SOFT_CELLS, max(i, 0) / SOFT_CELLS);
        float cells = i < 0 ? 1.0 : float(SOFT_CELLS);
        if (i >= 0) {
            ivec2 corners = softCorners(points, cell);
            if (corners.x == 0) continue;
            lost = corners.y == 4 ? SHARE(-1.0) : softCell(s, cell) - 1.0;
        }
        vec2 part = vec2(cell) / cells;
        sum += lost * surfaceArea(seen.m, areaSeen(corner.xyz + part.x * u.xyz + part.y * v.xyz - seen.point, u.xyz / cells,
                                                   v.xyz / cells, both));
    }
    if (count == 0) return sum;
    return max(sum, 0.0);
}
