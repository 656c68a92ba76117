// Soft shadows of area lights: the share of the light in the penumbra. SOFT_POINTS x SOFT_POINTS
// points are evenly distributed over the light, from edge to edge. Each has a map of the scene in
// front of it (soft_views.h), which tells, up to its texels, whether the point is visible from a
// surface. Four adjacent points are the corners of a cell:
//  - all four visible: the cell is unoccluded. If all cells are, the light stays unchanged, bit for
//    bit;
//  - none visible: the cell's light, the closed form of its parallelogram, is subtracted;
//  - otherwise the subtracted share is the share of sixteen rays from inside the cell that are
//    occluded. The occluded corners tell the occluder's position: at the fraction `along` of the
//    ray from the light. A ray passes there through a place that the map of the nearest corner
//    stores, and is occluded by what is nearer to the light than the midpoint between the occluder
//    and the surface.
// So the penumbra has the width given by light, occluder and receiver, and is smooth; it converges
// to the exact shadow as the number of points grows.
//
// Worked example: five points along an edge, sixteen cells. A straight edge hides the left 3/8 of
// the light: the first two columns of points are occluded. Four cells lose all, and of the four
// adjacent ones the rays from their left halves: in all 4/16 + 4 (1/2)/16 = 3/8.
//
// A texel's surface occludes a point only if it is above the point's tangent plane, by SOFT_OFF
// texels plus the error of a pixel of the picture. So planes and convex surfaces do not shade
// themselves, without a lift that would lose contact shadows.
const float SOFT_OFF = 0.25;
// distance of the outermost points from the light's edge, as a share
const float SOFT_INSET = 1.0 / 256.0;
const int SOFT_CELLS = SOFT_POINTS - 1, SOFT_WAYS = 16;
const int SOFT_WORDS = (SOFT_POINTS * SOFT_POINTS + 31) / 32;

// A light, and a surface point in its axes: x along u, z along the normal, to the point's side; the
// origin is the light's corner.
struct Soft {
    vec3 corner, u, v; // rectangle of the light in eye space: corner and edges
    vec3 eye;          // the surface point in eye space
    vec2 along_u, along_v;
    vec3 point, normal;
    float pixel;  // size of a pixel at the point
    bool through; // light from behind the surface counts, too (transmission)
    int layer;    // layer of the first point's map
    float near;   // near distance of all maps
};

Soft softOf(int light, Seen seen)
{
    vec4 corner = lightTexel(light, LIGHT_PLACE), u = lightTexel(light, LIGHT_AXIS),
        v = lightTexel(light, LIGHT_CONE);
    vec3 x = normalize(u.xyz), z = normalize(cross(u.xyz, v.xyz)), y = cross(z, x),
        way = seen.point - corner.xyz;
    float side = dot(z, way) < 0.0 ? -1.0 : 1.0, near = 0.0;
    int layer = int(u.w) - 1 + (side < 0.0 ? SOFT_POINTS * SOFT_POINTS : 0);
#ifdef SHADOW_MAPS
    near = shadowRow(layer, VIEW_HOW).x;
#endif
    return Soft(corner.xyz, u.xyz, v.xyz, seen.point, vec2(length(u.xyz), 0.0),
        vec2(dot(v.xyz, x), dot(v.xyz, y)),
                vec3(dot(x, way), dot(y, way), abs(dot(z, way))),
                vec3(dot(x, seen.m.normal), dot(y, seen.m.normal), side * dot(z, seen.m.normal)),
                    seen.pixelSize,
                any(greaterThan(surfaceLobe(seen.m, -seen.m.normal), vec3(0.0))), layer, near);
}

vec2 softPart(ivec2 point)
{
    return clamp(vec2(point) / float(SOFT_CELLS), SOFT_INSET, 1.0 - SOFT_INSET);
}

vec3 softPlace(Soft s, vec2 part) { return vec3(part.x * s.along_u + part.y * s.along_v, 0.0); }

// Returns the weight of a position on the light for a diffuse surface, up to a factor of the light
// and the point.
float softWeight(Soft s, vec3 place)
{
    vec3 way = place - s.point;
    float cosine = dot(s.normal, way), square = dot(way, way);
    return (s.through ? abs(cosine) : max(cosine, 0.0)) / (square * square);
}

#ifdef SHADOW_MAPS
const int SOFT_QUARTER = SHADOW_SIZE / 4;

// Returns the texel in the direction `way` from a map's point, and the distance along the cube
// face's axis.
ivec2 softTexel(vec3 way, out float away)
{
    vec2 size = abs(way.xy);
    float side = max(size.x, size.y);
    away = max(max(side, way.z), 1e-30);
    vec2 at = way.xy / away;
    ivec2 low = ivec2(SOFT_QUARTER), high = ivec2(3 * SOFT_QUARTER - 1);
    if (side > way.z) {
        // selects components without a variable index, since some drivers keep indexed vectors in
        // memory
        bool x = size.x >= size.y;
        float beyond = 2.0 - max(way.z, 0.0) / side;
        int first = (x ? at.x : at.y) < 0.0 ? 0 : 3 * SOFT_QUARTER, last = first + SOFT_QUARTER - 1;
        at = x ? vec2(at.x * beyond, at.y) : vec2(at.x, at.y * beyond);
        low = x ? ivec2(first, low.y) : ivec2(low.x, first);
        high = x ? ivec2(last, high.y) : ivec2(high.x, last);
    }
    return clamp(ivec2(floor((at + 2.0) * float(SOFT_QUARTER))), low, high);
}

// Returns the direction to a texel's center, scaled to 1 along its face's axis.
vec3 softWay(ivec2 texel)
{
    vec2 at = (vec2(texel) + 0.5) / float(SOFT_QUARTER) - 2.0, size = abs(at);
    if (max(size.x, size.y) <= 1.0) return vec3(at, 1.0);
    return size.x > size.y ? vec3(sign(at.x), at.y, 2.0 - size.x)
        : vec3(at.x, sign(at.y), 2.0 - size.y);
}

// Returns true if an occluder at the distance `away` in a map is in front of the surface.
bool softStands(Soft s, vec3 from, vec3 ray, float away, float limit)
{
    vec3 normal = dot(s.normal, from - s.point) < 0.0 ? -s.normal : s.normal;
    float over = SOFT_OFF / float(SOFT_QUARTER) * away + s.pixel / 64.0;
    return away < limit && dot(normal, from + ray * away - s.point) > over;
}

// Returns the share of light that arrives along a ray from a point, considering occluders nearer
// than `limit` of the ray. `along` is the fraction of the ray at which an occluder is; 0: none.
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

// Returns the transmittance of infinite planes, from a position on the light.
SHARE softPlanes(Soft s, vec2 part)
{
#ifdef SHADOW_PLANES
    return shadowPlanes(vec4(s.corner + part.x * s.u + part.y * s.v, 1.0), s.eye);
#else
    return SHARE(1.0);
#endif
}

// A bit for each point. Words are looped over rather than indexed by a variable, for the same
// reason.
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

// Visibility of a light's points from a surface.
struct SoftPoints {
    SoftBits dim, dark;     // bits of points that are partly occluded, and fully occluded
    // numbers of points that are not behind the surface: all, partly and fully occluded ones
    int asked, dims, darks;
};

// Returns the share of a point's light that arrives; `along`: fraction of the ray at which the
// occluder is, or 0 if unknown.
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

// Returns the number of a cell's corners that are partly, and that are fully occluded.
ivec2 softCorners(SoftPoints points, ivec2 cell)
{
    ivec2 count = ivec2(0);
    for (int i = 0; i < 4; i++) {
        int point = (cell.y + (i >> 1)) * SOFT_POINTS + cell.x + (i & 1);
        count += ivec2(softBit(points.dim, point), softBit(points.dark, point));
    }
    return count;
}

// Returns the mean position of the occluders of a cell's corners; 1: unknown. The maps are read
// once more, as few cells need it.
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

// Returns the share of a cell's light that arrives. The rays' start points form a low-discrepancy
// set: no two in a row or a column of cells have the same offset.
SHARE softCell(Soft s, ivec2 cell)
{
    vec2 shift = (vec2(cell.yx) + 0.5) / float(SOFT_CELLS);
    SHARE sum = SHARE(0.0);
    float along = softAlong(s, cell), all = 0.0;
    for (int i = 0; i < SOFT_WAYS; i++) {
        int reversed = (i & 1) << 3 | (i & 2) << 1 | (i & 4) >> 1 | (i & 8) >> 3;
        vec2 inside = (vec2(i, reversed) + shift) / float(SOFT_WAYS),
            part = (vec2(cell) + inside) / float(SOFT_CELLS);
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

// Returns the reflected light of an area light, per component for radiance 1: first without
// occlusion, then minus the occluded part of each cell.
vec3 softLight(int light, Seen seen)
{
    vec4 corner = lightTexel(light, LIGHT_PLACE), u = lightTexel(light, LIGHT_AXIS),
        v = lightTexel(light, LIGHT_CONE);
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
        sum += lost * surfaceArea(seen.m,
            areaSeen(corner.xyz + part.x * u.xyz + part.y * v.xyz - seen.point, u.xyz / cells,
                                                   v.xyz / cells, both));
    }
    if (count == 0) return sum;
    return max(sum, 0.0);
}
