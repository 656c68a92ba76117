// Share of a light that reaches a point, by its shadow maps and by infinite planes. shadow_views.h
// defines a view's rows; here they start from eye space. A map's edge has SHADOW_SIZE texels;
// SHADOW_FILTER is the width of the percentage-closer filter in texels.
//
// The bias against shadow acne. A map stores depth at texel centers. Each tap is compared with the
// depth of the receiver's point, which is up to (SHADOW_FILTER + 1) / 2 texels away from the tap's
// center along x and y, sqrt(2) times that in all. So
//  - the point is lifted along its normal by that distance, plus a quarter of a texel for the
//    rasterizer's 1/256: no tap is below its tangent plane, and convex surfaces never shade
//    themselves, even under grazing light;
//  - the map is drawn with a polygon offset of (SHADOW_FILTER + 1) times a triangle's slope: a
//    point in front of a triangle's plane is in front of the stored depth, so walls do not shade
//    the floor before them.
// A shadow is lost only if its caster is nearer than that to the receiver's plane, a texel and a
// half with the default filter.
#include "shadow_view.layout.def"

// A share of light; one per color if a caster is transparent.
#ifdef SHADOW_COLORED
#define SHARE vec3
#else
#define SHARE float
#endif

#ifdef SHADOW_GLASS
// transmittance lists, filled by glass_store.glsl
layout(std430, binding = 3) readonly buffer Glass {
#include "shadow_glass.layout.def"
    uint glass_words[];
};
#define glass_part uvec4(glass_column, glass_row, glass_columns, glass_rows)

// Tiled lists (shadow_tables.c): a point's share of light is a sum over texels, of which those of
// the current tile count. A share that needs no texel counts in the tile with the first texel of
// all.
#ifdef SHADOW_PARTS
bool shadowIsFirst()
{
    return glass_part.xy == uvec2(0u);
}

// Returns true if a light contributes in this tile, by its views.
bool shadowIsRead(ivec2 views)
{
    uint size = uint(SHADOW_SIZE), first = uint(views.x) * size,
        rows = uint(max(views.y, 0)) * size;
    return shadowIsFirst() || (first < glass_part.y + glass_part.w && glass_part.y < first + rows);
}
#endif
#endif

// Returns the full share, if no texel is needed.
SHARE shadowNone()
{
#ifdef SHADOW_PARTS
    return SHARE(shadowIsFirst());
#else
    return SHARE(1.0);
#endif
}

#ifdef SHADOW_SEEN
uniform usampler2D shadow_seen; // the target `seen`, which the programs of opaque surfaces wrote
#endif

#ifdef SHADOW_MAPS
uniform sampler2DArray shadow_maps;
uniform sampler2D shadow_views;

// offset along the normal (bias) in texels
const float SHADOW_LIFT = 0.70711 * float(SHADOW_FILTER + 1) + 0.25;

vec4 shadowRow(int view, int row)
{
    return texelFetch(shadow_views, ivec2(view % VIEW_ROW * VIEW_TEXELS + row, view / VIEW_ROW), 0);
}

vec3 shadowPlace(int view, vec4 point)
{
    return vec3(dot(shadowRow(view, VIEW_ROWS), point), dot(shadowRow(view, VIEW_ROWS + 1), point),
                dot(shadowRow(view, VIEW_ROWS + 2), point));
}

// Converts from the axes of a cube's first face, y, z, x, to those of the face that contains the
// position.
vec3 shadowOnFace(vec3 place, out int face)
{
    vec3 size = abs(place);
    int axis = size.z >= size.x && size.z >= size.y ? 0 : size.x >= size.y ? 1 : 2;
    vec3 turned = axis == 0 ? place : axis == 1 ? place.yzx : place.zxy;
    face = 2 * axis + int(turned.z < 0.0);
    return vec3(turned.xy, abs(turned.z));
}

// Converts a position on a face back: the inverse conversion.
vec3 shadowOffFace(vec3 place, int face)
{
    vec3 turned = vec3(place.xy, face % 2 == 0 ? place.z : -place.z);
    return face < 2 ? turned : face < 4 ? turned.zxy : turned.yzx;
}

#ifdef SHADOW_GLASS
// Return the first node of a texel's list, and the node after a node; 0: none. Further functions
// return a node's depth and transmittance.
uint shadowNode(uint number) { return number == 0u ? 0u : glass_heads + (number - 1u) * 4u; }

uint shadowList(uvec2 place) { return shadowNode(glass_words[place.y * glass_part.z + place.x]); }

uint shadowNext(uint node) { return shadowNode(glass_words[node]); }

float shadowListed(uint node) { return uintBitsToFloat(glass_words[node + 1u]); }

vec3 shadowLets(uint node)
{
    uint low = glass_words[node + 2u], high = glass_words[node + 3u];
    return vec3(low & 2097151u, low >> 21 | (high & 1023u) << 11, high >> 10) / 2097151.0;
}

// Returns the position of a map texel's list in the tile; it exceeds the tile's size for texels
// outside the tile.
uvec2 shadowAt(int map, ivec2 texel)
{
    return uvec2(texel.x, uint(map) * uint(SHADOW_SIZE) + uint(texel.y)) - glass_part.xy;
}

// Returns the transmittance of all transparent casters nearer to the light: a product, which needs
// no sorting.
vec3 shadowThrough(int map, ivec2 texel, float depth)
{
    vec3 through = vec3(1.0);
    uvec2 place = shadowAt(map, texel);
#ifdef SHADOW_PARTS
    if (any(greaterThanEqual(place, glass_part.zw))) return vec3(0.0);
#endif
    for (uint node = shadowList(place); node != 0u; node = shadowNext(node))
        if (shadowListed(node) > depth) through *= shadowLets(node);
    return through;
}
#endif

// Set by a technique that handles opaque casters itself: maps are then read for transparent ones
// only.
#ifdef SHADOW_APART
bool shadow_apart = false;
#else
const bool shadow_apart = false;
#endif

SHARE shadowTexel(int map, ivec2 texel, float depth)
{
    if (!shadow_apart && depth < texelFetch(shadow_maps, ivec3(texel, map), 0).x) return SHARE(0.0);
#ifdef SHADOW_GLASS
    return shadowThrough(map, texel, depth);
#else
    return SHARE(1.0);
#endif
}

// Returns half the edge of a cube face at distance 1: 1, or more if faces overlap by a border.
float shadowWide(vec4 how) { return 0.5 * how.y * float(SHADOW_SIZE); }

// Returns the share at a texel outside a face's edge: the texel is replaced by the neighboring
// face's texel that contains its center.
SHARE shadowBeyond(int first, int face, vec3 place, ivec2 texel, vec4 how)
{
    vec2 at = (vec2(2 * texel + 1) / float(SHADOW_SIZE) - 1.0) * shadowWide(how) * place.z;
    int other;
    vec3 there = shadowOnFace(shadowOffFace(vec3(at, place.z), face), other);
    ivec2 found = ivec2((there.xy / (there.z * shadowWide(how)) * 0.5 + 0.5) * float(SHADOW_SIZE));
    return shadowTexel(first + other, min(found, SHADOW_SIZE - 1), how.x / there.z);
}

// Returns the overlap, along an axis, of a texel with a square of SHADOW_FILTER texels that begins
// in texel 0 at `part`.
float shadowWeight(int texel, float part)
{
    return texel == 0 ? 1.0 - part : texel == SHADOW_FILTER ? part : 1.0;
}

// Applies percentage-closer filtering: returns the lit share of a square of SHADOW_FILTER texels
// around the point.
SHARE shadowFiltered(int first, bool cube, vec3 place, vec4 how)
{
    int face = 0;
    vec3 turned = cube ? shadowOnFace(vec3(place.xy * shadowWide(how), place.z), face) : place;
    float depth = how.x > 0.0 ? how.x / turned.z : max(turned.z, 0.0);
    float away = how.x <= 0.0 ? 1.0 : cube ? turned.z * shadowWide(how) : turned.z;
    vec2 at = (turned.xy / away * 0.5 + 0.5) * float(SHADOW_SIZE);
    if (how.x > 0.0 && turned.z <= 0.0) return shadowNone(); // the point is behind a spot light
    vec2 corner = clamp(at, -16.0, float(SHADOW_SIZE) + 16.0) - 0.5 * float(SHADOW_FILTER);
    ivec2 low = ivec2(floor(corner));
    vec2 part = SHADOW_FILTER > 0 ? corner - vec2(low) : vec2(0.0);
    SHARE sum = SHARE(0.0);
    for (int y = 0; y <= SHADOW_FILTER; y++)
        for (int x = 0; x <= SHADOW_FILTER; x++) {
            ivec2 texel = low + ivec2(x, y);
            float weight = shadowWeight(x, part.x) * shadowWeight(y, part.y);
            bool inside = all(greaterThanEqual(texel, ivec2(0))) &&
                all(lessThan(texel, ivec2(SHADOW_SIZE)));
            sum += weight * (inside ? shadowTexel(first + face, texel, depth)
                             : cube ? shadowBeyond(first, face, turned, texel, how)
                                    : shadowNone());
        }
    return sum / float(max(SHADOW_FILTER * SHADOW_FILTER, 1));
}

#ifdef SHADOW_CALL_VIEW // defined if a technique has `views`: shadow_method.h
SHARE shadowOfView(int method, int first, int count, vec3 point, vec3 normal, float pixel);
#endif

// Returns the share by one view, or by those of a cube.
SHARE shadowViewed(int first, int count, vec3 point, vec3 normal, float pixel)
{
    vec4 how = shadowRow(first, VIEW_HOW);
#ifdef SHADOW_CALL_VIEW
    if (how.z > 0.0) return shadowOfView(int(how.z), first, count, point, normal, pixel);
#endif
    vec3 place = shadowPlace(first, vec4(point, 1.0));
    vec3 size = abs(place);
    bool cube = how.x > 0.0 && count > 1;
    float away = how.x > 0.0 ? cube ? max(max(size.x, size.y), size.z) : size.z : 1.0;
    vec3 lifted = point + normal * (SHADOW_LIFT * how.y * away + pixel / 64.0);
    return shadowFiltered(first, cube, shadowPlace(first, vec4(lifted, 1.0)), how);
}

const float SHADOW_BAND = 0.0625; // blend width at the edge of a cascade, in half widths

// Returns 0 if a cascade lacks texels around a point; the value grows to 1 across the band.
float shadowInside(int view, vec3 point, vec3 normal, float pixel)
{
    float lift = SHADOW_LIFT * shadowRow(view, VIEW_HOW).y + pixel / 64.0;
    vec2 place = abs(shadowPlace(view, vec4(point + lift * normal, 1.0)).xy);
    float edge = 1.0 - float(SHADOW_FILTER + 2) / float(SHADOW_SIZE);
    return clamp((edge - max(place.x, place.y)) / SHADOW_BAND, 0.0, 1.0);
}

// Returns the share by cascaded shadow maps: by the finest cascade that contains the point, blended
// into the next one along its edge to hide the seam. The last one contains all casters.
SHARE shadowCascaded(int first, int count, vec3 point, vec3 normal, float pixel)
{
    SHARE sum = SHARE(0.0);
    float left = 1.0;
    for (int view = first; view < first + count && left > 0.0; view++) {
        float part = view < first + count - 1 ? left * shadowInside(view, point, normal, pixel)
            : left;
        if (part > 0.0) sum += part * shadowViewed(view, 1, point, normal, pixel);
        left -= part;
    }
    return sum;
}

// Returns the share of a light by its maps. `normal` faces the light; `pixel` is a pixel's size at
// the point. The light has `count` views from `first` on.
SHARE shadowMapped(int first, int count, vec3 point, vec3 normal, float pixel)
{
    return shadowRow(first, VIEW_HOW).x <= 0.0 ? shadowCascaded(first, count, point, normal, pixel)
                                        : shadowViewed(first, count, point, normal, pixel);
}
#endif

#ifdef SHADOW_PLANES
uniform sampler2D shadow_planes;

vec4 shadowPlane(int texel)
{
    return texelFetch(shadow_planes, ivec2(texel % VIEW_ROW, texel / VIEW_ROW), 0);
}

// Returns true if the plane separates the point from the light. A point on the plane is not
// separated.
bool shadowBetween(vec4 plane, vec4 light, vec3 point)
{
    float here = dot(plane, vec4(point, 1.0));
    return here * dot(plane, light) < 0.0 && abs(here) > 4e-6 * (length(point) + abs(plane.w));
}

// Returns the transmittance of all planes: first the opaque ones, then, two texels each, those of
// constant transmittance.
SHARE shadowPlanes(vec4 light, vec3 point)
{
    SHARE share = SHARE(1.0);
    for (int i = 0; i < SHADOW_PLANES; i++)
        if (shadowBetween(shadowPlane(i), light, point)) return SHARE(0.0);
#ifdef SHADOW_GLASS_PLANES
    for (int i = 0; i < SHADOW_GLASS_PLANES; i++)
        if (shadowBetween(shadowPlane(SHADOW_PLANES + 2 * i), light, point))
            share *= shadowPlane(SHADOW_PLANES + 2 * i + 1).xyz;
#endif
    return share;
}
#endif

#ifdef SHADOW_SHEETS
uniform usampler2DArray plane_transmittances;

// Returns the transmittance of planes with varying transparency between a light and a pixel's
// point: plane_transmittance.c. `layer` is 1 + the layer of the light; 0: no layer.
vec3 shadowSheets(int layer, ivec2 pixel)
{
    if (layer == 0) return vec3(1.0);
    uvec2 words = texelFetch(plane_transmittances, ivec3(pixel, layer - 1), 0).xy;
    return vec3(words.x & 2097151u, words.x >> 21 | (words.y & 1023u) << 11, words.y >> 10) /
        2097151.0;
}
#endif

// Returns the share of a light that reaches a point, by planes and maps. `views` is the light's
// first view and their number; negative: it casts no shadow.
SHARE shadowShare(vec4 light, ivec2 views, vec3 point, vec3 normal, float pixel)
{
    SHARE share = SHARE(1.0);
    if (views.y < 0) return shadowNone();
#ifdef SHADOW_PLANES
    share = shadowPlanes(light, point);
    if (share == SHARE(0.0)) return share;
#endif
#ifdef SHADOW_MAPS
#ifndef SHADOW_GLASS
    if (shadow_apart) return share * shadowNone();
#endif
    if (views.y > 0) return share * shadowMapped(views.x, views.y, point, normal, pixel);
#endif
    return share * shadowNone();
}
