// Silhouette shadows: tests whether a light reaches a point, by the depths at the four surrounding
// texel centers and the silhouette crossings between them.
//
// Each center is compared with the plane through the point with the point's normal: a depth nearer
// to the light there, by more than the bias, occludes the point. Adjacent centers without a
// crossing in between belong to one surface, which occludes everything below it or nothing: it is
// free if one of its centers is. So neither slopes nor surfaces that curve towards the light shade
// themselves. If some centers are covered, a line through the cell from crossing to crossing
// separates them from the others.
//
// The bias is a texel along the light, but 1/16 to 1/4 texel perpendicular to the plane: adjacent
// triangles may deviate that much towards the light before they shade the point. Added to it is the
// normal's tolerated error times the distance from the point to a center.
//
// The line through a cell between four centers is that of marching squares.
//
//  covered: (0, 0) alone; cuts at .3 of the lower segment, .6 of the left one: covered where x / .3
//  + y / .6 < 1
//
// Two diagonally opposite covered centers are one surface if more than half of the four segments is
// covered.

// Returns true if a point is in the corner (0, 0) of a cell, before the line from legs.x on one
// segment to legs.y on the other.
bool silhouetteCuts(vec2 legs, vec2 point)
{
    return point.x * legs.y + point.y * legs.x < legs.x * legs.y;
}

// Returns true if the point is covered. `low` and `high` are the covered centers at (0, 0) and (1,
// 0), and at (0, 1) and (1, 1); `cut` has the crossings of the lower and the upper segment along x,
// and of the left and the right one along y.
bool silhouetteCovers(bvec2 low, bvec2 high, vec4 cut, vec2 point)
{
    int count = int(low.x) + int(low.y) + int(high.x) + int(high.y);
    if (count == 2 && low.x == low.y) return (point.y < mix(cut.z, cut.w, point.x)) == low.x;
    if (count == 2 && low.x == high.x) return (point.x < mix(cut.x, cut.y, point.y)) == low.x;
    bool alone = count == 1; // state of the single center that differs
    bool right = count == 2 ? low.y : low.y == alone || high.y == alone;
    bool up = count != 2 && (high.x == alone || high.y == alone);
    // moves that center, or a covered one, to (0, 0)
    point = vec2(right ? 1.0 - point.x : point.x, up ? 1.0 - point.y : point.y);
    if (right) cut = vec4(1.0 - cut.xy, cut.wz);
    if (up) cut = vec4(cut.yx, 1.0 - cut.zw);
    if (count != 2) return silhouetteCuts(cut.xz, point) == alone;
    if (cut.x + cut.z > cut.y + cut.w) // equivalent to cut.x + cut.z + 1 - cut.y + 1 - cut.w > 2
        return !silhouetteCuts(vec2(1.0 - cut.x, cut.w), vec2(1.0 - point.x, point.y)) &&
               !silhouetteCuts(vec2(cut.y, 1.0 - cut.z), vec2(point.x, 1.0 - point.y));
    return silhouetteCuts(cut.xz, point) || silhouetteCuts(1.0 - cut.yw, 1.0 - point);
}

#ifdef SHADOW_SILHOUETTES // the code below follows shadow.glsl
// bias perpendicular to the plane, in texels
const float SILHOUETTE_MIN = 1.0 / 16.0, SILHOUETTE_MAX = 1.0 / 4.0;
const float SILHOUETTE_TILT = 0.005, SILHOUETTE_STEEPEST = 4096.0;

// A point in a view: its position there, and the change of depth per texel on its plane.
struct SilhouettePlace {
    vec2 at;     // position in the map, in texels
    float depth; // depth of the point; a greater depth is nearer to the light
    vec2 slope;
    float texel; // depth difference that is as long as a texel is wide
};

// Returns the position of a point in a view; `normal` is its plane's; both are in eye space. In the
// view's coordinates p = (x, y, z) the plane is n . p = k. For parallel light z is depth; else
// depth is near / z, which is near / k (n.x x / z + n.y y / z + n.z).
SilhouettePlace silhouettePlace(int view, vec3 point, vec3 normal)
{
    vec4 rows[3] = vec4[3](shadowRow(view, VIEW_ROWS), shadowRow(view, VIEW_ROWS + 1),
        shadowRow(view, VIEW_ROWS + 2)), how = shadowRow(view, VIEW_HOW);
    vec3 p, n;
    for (int i = 0; i < 3; i++) {
        p[i] = dot(rows[i], vec4(point, 1.0));
        n[i] = dot(rows[i].xyz, normal) / dot(rows[i].xyz, rows[i].xyz);
    }
    bool parallel = how.x <= 0.0;
    float depth = parallel ? p.z : how.x / p.z;
    float texel = parallel ? how.y * length(rows[2].xyz) : depth * how.y;
    vec2 slope = (parallel ? -n.xy / n.z : n.xy * (how.x / dot(n, p))) * (2.0 / float(SHADOW_SIZE));
    slope *= min(1.0, SILHOUETTE_STEEPEST * texel / length(slope));
    return SilhouettePlace(((parallel ? p.xy : p.xy / p.z) * 0.5 + 0.5) * float(SHADOW_SIZE) - 0.5,
        depth, slope, texel);
}

// Returns 1 for each surrounding center that does not occlude the point, else 0, in textureGather's
// order: (0, 1), (1, 1), (1, 0), (0, 0) of the cell.
vec4 silhouetteFree(SilhouettePlace place, vec2 part, vec4 depths, float pixel)
{
    vec4 x = vec4(0.0, 1.0, 1.0, 0.0) - part.x, y = vec4(1.0, 1.0, 0.0, 0.0) - part.y;
    float steep = length(place.slope) / place.texel, square = 1.0 + steep * steep;
    // bias that is 1 along the light, clamped to both bounds
    float lift = clamp(inversesqrt(square), SILHOUETTE_MIN, SILHOUETTE_MAX) + pixel / 64.0;
    vec4 bias = lift * sqrt(square) + min(SILHOUETTE_TILT * square, max(steep, 0.25)) *
        sqrt(x * x + y * y);
    vec4 off = depths - place.depth - place.slope.x * x - place.slope.y * y;
    // depth 0 marks an empty texel
    return max(vec4(lessThanEqual(off, bias * place.texel)), vec4(equal(depths, vec4(0.0))));
}

// Returns true if a view's light reaches a point. `pixel` is a pixel's size there, in texels.
bool silhouetteReaches(int view, vec3 point, vec3 normal, float pixel)
{
    SilhouettePlace place = silhouettePlace(view, point, normal);
    vec2 low = clamp(floor(place.at), vec2(0.0), vec2(SHADOW_SIZE - 2)), part = place.at - low;
    // the point is outside the map
    if (any(lessThan(part, vec2(0.0))) || any(greaterThan(part, vec2(1.0)))) return true;
    vec3 middle = vec3((low + 1.0) / float(SHADOW_SIZE), view);
    vec4 depths = textureGather(shadow_maps, middle),
        free = silhouetteFree(place, part, depths, pixel);
    if (free == vec4(0.0) || free == vec4(1.0)) return free.x > 0.0;
    middle.z = shadowRow(view, VIEW_HOW).w - 1.0;
    vec4 rows = textureGather(silhouette_crossings, middle, 0),
        columns = textureGather(silhouette_crossings, middle, 1);
    // true without a crossing from a center to the next around the cell
    vec4 joined = vec4(equal(vec4(rows.x, columns.z, rows.w, columns.w), vec4(0.0)));
    for (int i = 0; i < 3; i++)
        free = max(free, max(joined * free.yzwx, joined.wxyz * free.wxyz));
    if (free == vec4(1.0)) return true;
    vec4 cut = (vec4(rows.w, rows.x, columns.w, columns.z) * 255.0 - 1.0) / 254.0;
    bvec4 covered = equal(free, vec4(0.0));
    return !silhouetteCovers(covered.wz, covered.xy, cut, part);
}

#ifdef MICROFACETS // triangle.glsl sets both variables for each light
vec3 triangle_side = vec3(0.0); // triangle normal of the pixel, towards the light; 0: unknown
// the triangle faces away from the light, while the shading normal does not
bool triangle_away = false;
#endif

#ifdef SHADOW_GLASS
// Returns the transmittance of all transparent casters, filtered over texels that no opaque caster
// covers; edges are as in a plain map.
SHARE silhouetteThrough(int view, vec3 point)
{
    vec4 how = shadowRow(view, VIEW_HOW);
    vec3 place = shadowPlace(view, vec4(point, 1.0));
    float depth = how.x > 0.0 ? how.x / place.z : place.z;
    vec2 corner = ((how.x > 0.0 ? place.xy / place.z : place.xy) * 0.5 + 0.5) * float(SHADOW_SIZE) -
        0.5 * float(SHADOW_FILTER);
    ivec2 low = ivec2(floor(corner));
    vec2 part = SHADOW_FILTER > 0 ? corner - vec2(low) : vec2(0.0);
    vec4 sum = vec4(0.0);
    for (int y = 0; y <= SHADOW_FILTER; y++)
        for (int x = 0; x <= SHADOW_FILTER; x++) {
            ivec2 texel = low + ivec2(x, y);
            if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(SHADOW_SIZE))))
                continue;
            if (depth < texelFetch(shadow_maps, ivec3(texel, view), 0).x) continue;
            float weight = shadowWeight(x, part.x) * shadowWeight(y, part.y);
            sum += weight * vec4(shadowThrough(view, texel, depth), 1.0);
        }
    return sum.w > 0.0 ? sum.xyz / sum.w : shadowNone();
}
#endif

// Returns the share by one view, or by those of a cube, which overlap by two texels on each side.
SHARE silhouetteShare(int first, int count, vec3 point, vec3 normal, float pixel)
{
    vec4 how = shadowRow(first, VIEW_HOW);
    vec3 place = shadowPlace(first, vec4(point, 1.0));
    int face = 0;
    if (how.x > 0.0 && count > 1)
        place = shadowOnFace(vec3(place.xy * (0.5 * how.y * float(SHADOW_SIZE)), place.z), face);
    if (how.x > 0.0 && place.z <= 0.0) return shadowNone(); // the point is behind a spot light
    float texel = how.y * (how.x > 0.0 ? place.z : 1.0);
#ifdef MICROFACETS
    if (triangle_away) return SHARE(0.0);
    if (!silhouetteReaches(first + face, point, triangle_side == vec3(0.0) ? normal : triangle_side,
        pixel / texel))
        return SHARE(0.0);
#else
    if (!silhouetteReaches(first + face, point, normal, pixel / texel)) return SHARE(0.0);
#endif
#ifdef SHADOW_GLASS
    return silhouetteThrough(first + face, point + normal * (SHADOW_LIFT * texel + pixel / 64.0));
#else
    return shadowNone();
#endif
}
#endif
