// The surface of a shadow volume cut at silhouettes. A cell is the square between four
// texel centers, from the lower left one around: 0, 1, 2, 3. Where a silhouette crosses the segment
// between two centers (silhouette_find.glsl), the surface is discontinuous, and a wall along the
// light joins the side nearer to the light to the other one. So the volume ends at the silhouette,
// where an uncut surface would slope from center to center.
//
// A cell's boundary is a ring of up to twelve corners: for segment i, from center i to the next, 3
// i is the center, 3 i + 1 the crossing at the depth of that center's side, 3 i + 2 the same
// position at the depth of the other side. However a ring is triangulated, the volume is closed, as
// adjacent cells share the corners. The triangulation covers each side with triangles of its own,
// and the rest are walls, which are lines as seen from the light.
//
//  only center 0 is covered: its segments are crossed, at 1 and 2 (on segment 0), and at 10 and 11
//  (on segment 3)
//
//   9-----------6  0 1 11 is the covered corner; 6 9 10, 6 10 2 and 6 2 3 are the rest of the cell;
//   |           |  11 1 2 and 11 2 10 are the wall from the line 11-1 to the line 10-2,
//  10,11        |  at the same position
//   |  \        |
//   0--1,2------3
//
// VOLUME_DEPTHS and VOLUME_CROSSINGS are array textures: depths, and the bytes of
// silhouette_pack.glsl; `layers` are a map's layers in both.
const int VOLUME_MAX = 10; // max triangles of a cell
const int VOLUME_TRIANGLES[7] = int[7](2, 4, 4, 6, 6, 8, 10);
const int VOLUME_CORNERS[210] = int[210](
    // without crossings
    0, 3, 6, 0, 6, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    // one crossing, on segment 0, with center 0 nearer; or center 1 nearer: the wall is on the
    // deeper side
    0, 1, 9, 1, 2, 9, 2, 6, 9, 2, 3, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 1, 9, 1, 2, 6, 1, 6, 9, 2, 3, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    // two crossings, on the segments 3 and 0: center 0 is cut off
    0, 1, 11, 11, 1, 2, 11, 2, 10, 6, 9, 10, 6, 10, 2, 6, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    // two crossings, on the opposite segments 0 and 2
    0, 1, 8, 0, 8, 9, 1, 2, 7, 1, 7, 8, 2, 3, 6, 2, 6, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    // three crossings, none on segment 2: the centers 0 and 1 are cut off
    0, 1, 11, 2, 3, 4, 6, 9, 10, 6, 10, 5, 10, 11, 1, 10, 1, 2, 10, 2, 4, 10, 4, 5, 0, 0, 0, 0, 0,
        0,
    // four crossings: the centers 0 and 2 are cut off
    0, 1, 11, 5, 6, 7, 11, 1, 2, 11, 2, 10, 5, 7, 8, 5, 8, 4, 2, 3, 4, 2, 4, 8, 2, 8, 10, 8, 9, 10);

float volumeCellDepth(ivec2 layers, ivec2 texel)
{
    return texelFetch(VOLUME_DEPTHS, ivec3(texel, layers.x), 0).x;
}

ivec2 volumeCentre(int centre) { return ivec2(centre == 1 || centre == 2, centre >= 2); }

// A segment between two adjacent centers, from the left or lower one: along x (0) or y (1).
struct VolumeSegment {
    ivec2 first;
    int along;
};

ivec2 volumeStep(VolumeSegment s) { return ivec2(1 - s.along, s.along); }

// Returns the position of the crossing on the segment, 0 to 1; negative: no crossing.
float volumeCut(ivec2 layers, VolumeSegment s)
{
    vec2 bytes = texelFetch(VOLUME_CROSSINGS, ivec3(s.first, layers.y), 0).xy;
    float byte = s.along == 0 ? bytes.x : bytes.y;
    return byte > 0.0 ? (byte * 255.0 - 1.0) / 254.0 : -1.0;
}

// Returns segment i of a cell: those of its upper and left side begin at their second center.
VolumeSegment volumeSegment(ivec2 cell, int i)
{
    return VolumeSegment(cell + ivec2(i == 1, i == 2), i & 1);
}

// Returns the surface's depth at a crossing, on one side of it. The nearer side is extended
// horizontally. The farther side is extrapolated from the next center, unless a silhouette is
// between them.
float volumeSide(ivec2 layers, VolumeSegment s, float cut, bool second)
{
    ivec2 step = volumeStep(s), texel = second ? s.first + step : s.first;
    float here = volumeCellDepth(layers, texel),
        there = volumeCellDepth(layers, second ? s.first : s.first + step);
    if (here >= there || here <= 0.0) return here;
    // the next texel is inside the map, as depth is 0 at the border
    ivec2 next = second ? texel + step : texel - step;
    float beyond = volumeCellDepth(layers, next);
    if (beyond <= 0.0 || volumeCut(layers, VolumeSegment(second ? texel : next, s.along)) >= 0.0)
        return here;
    return clamp(here + (here - beyond) * (second ? 1.0 - cut : cut), 0.5 * here, there);
}

// Returns the bits of the segments that are crossed.
int volumeCrossed(ivec2 layers, ivec2 cell)
{
    int crossed = 0;
    for (int i = 0; i < 4; i++)
        if (volumeCut(layers, volumeSegment(cell, i)) >= 0.0) crossed |= 1 << i;
    return crossed;
}

vec4 volumeQuad(ivec2 layers, ivec2 cell)
{
    vec4 quad;
    for (int i = 0; i < 4; i++)
        quad[i] = volumeCellDepth(layers, cell + volumeCentre(i));
    return quad;
}

// Returns the first of the two centers that are cut off by four crossings, 0 or 1: the nearer pair,
// unless the pair is one surface, that is, unless more than half of the segments is on its side.
int volumeCutOff(ivec2 layers, ivec2 cell, vec4 quad)
{
    int nearer = quad.x + quad.z >= quad.y + quad.w ? 0 : 1;
    float even = 0.0; // length of the segments on the side of centers 0 and 2
    for (int i = 0; i < 4; i++) {
        // position of the crossing, from centers 0, 1, 3 and 0
        float cut = volumeCut(layers, volumeSegment(cell, i));
        even += (i == 0 || i == 3) ? cut : 1.0 - cut;
    }
    float own = nearer == 0 ? even : 4.0 - even;
    return own > 2.0 ? 1 - nearer : nearer;
}

// Returns the triangulation of a cell, by its crossed segments: a row of VOLUME_TRIANGLES, and the
// number of centers by which it is rotated.
ivec2 volumeTriangulated(ivec2 layers, ivec2 cell, int crossed)
{
    vec4 quad = volumeQuad(layers, cell);
    if (crossed == 0) return ivec2(0, volumeTurned(quad) ? 0 : 1);
    if (crossed == 15) return ivec2(6, volumeCutOff(layers, cell, quad));
    if (crossed == 5 || crossed == 10) return ivec2(4, crossed == 5 ? 0 : 1);
    for (int turn = 0; turn < 4; turn++) {
        // rotates the bits as if center `turn` were 0
        int turned = (crossed >> turn | crossed << (4 - turn)) & 15;
        if (turned == 1) return ivec2(quad[turn] > quad[(turn + 1) % 4] ? 1 : 2, turn);
        if (turned == 9) return ivec2(3, turn);
        if (turned == 11) return ivec2(5, turn);
    }
    return ivec2(0);
}

// Returns a corner of a cell's triangles: its position, in texels from the first center, and its
// depth.
vec3 volumeCorner(ivec2 layers, ivec2 cell, ivec2 triangulated, int number)
{
    int label = (VOLUME_CORNERS[triangulated.x * 3 * VOLUME_MAX + number] +
        3 * triangulated.y) % 12, i = label / 3;
    if (label % 3 == 0) {
        ivec2 texel = cell + volumeCentre(i);
        return vec3(texel, volumeCellDepth(layers, texel));
    }
    VolumeSegment s = volumeSegment(cell, i);
    float cut = volumeCut(layers, s);
    bool second = (label % 3 == 2) == (i < 2);
    return vec3(vec2(s.first) + vec2(volumeStep(s)) * cut, volumeSide(layers, s, cut, second));
}

#ifdef VOLUME_HAS
// Returns true if the volume contains the point at this position and depth of a view. For parallel
// light a surface that reaches infinity runs along the light.
bool volumeCellHas(ivec2 layers, vec2 at, float depth, bool parallel)
{
    ivec2 cell = ivec2(at), triangulated =
        volumeTriangulated(layers, cell, volumeCrossed(layers, cell));
    for (int triangle = 0; triangle < VOLUME_TRIANGLES[triangulated.x]; triangle++) {
        vec3 a = volumeCorner(layers, cell, triangulated, 3 * triangle),
            b = volumeCorner(layers, cell, triangulated, 3 * triangle + 1),
             c = volumeCorner(layers, cell, triangulated, 3 * triangle + 2);
        vec2 ab = b.xy - a.xy, ac = c.xy - a.xy, way = at - a.xy;
        float area = ab.x * ac.y - ab.y * ac.x;
        vec2 part = vec2(way.x * ac.y - way.y * ac.x, ab.x * way.y - ab.y * way.x) /
            max(area, 1e-9);
        // the triangle is a wall, or the point is outside the triangle
        if (area <= 1e-9 || part.x < 0.0 || part.y < 0.0 || part.x + part.y > 1.0) continue;
        if (parallel && min(a.z, min(b.z, c.z)) <= 0.0) return false;
        return depth < a.z + (b.z - a.z) * part.x + (c.z - a.z) * part.y;
    }
    return false;
}
#endif
