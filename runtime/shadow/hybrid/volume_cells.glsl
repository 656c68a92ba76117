// The surface of a shadow volume that silhouettes cut. A cell lies between the centres of four
// texels, from the lower left one around: 0, 1, 2, 3. Where a silhouette crosses the segment from
// one to the next (silhouette_find.glsl) the surface breaks off, and a wall along the light leads
// from the side that is nearer to the light to the other one: so the volume ends at the silhouette,
// where without it a slope would lead from centre to centre.
//
// A cell is surrounded by a ring of up to twelve corners: of segment i, from centre i to the next,
// 3 i is the centre, 3 i + 1 the crossing at the depth of that centre's side, 3 i + 2 the same
// place at the depth of the other side. However a ring is parted into triangles, the volume is
// closed, as the cells beside it have the same corners. It is parted so that each side has its own,
// and what is left is walls, which the light sees as lines.
//
//     one centre is covered, the 0: its segments are crossed, at 1 and 2 (of segment 0), at 10 and
//         11 (of segment 3)
//
//       9-----------6     0 1 11 is the covered corner, 6 9 10, 6 10 2 and 6 2 3 are the rest of
//                         the cell,
//       |           | 11 1 2 and 11 2 10 are the wall from the line 11-1 to the line 10-2, at the
//                   same places
//     10,11         |
//       |  \        |
//       0--1,2------3
//
// VOLUME_DEPTHS and VOLUME_CROSSINGS are arrays of maps: depths, and silhouette_pack.glsl's bytes;
// `layers` has the number of a map in both.
const int VOLUME_MOST = 10; // triangles of a cell
const int VOLUME_TRIANGLES[7] = int[7](2, 4, 4, 6, 6, 8, 10);
const int VOLUME_CORNERS[210] = int[210](
    // no crossing
    0, 3, 6, 0, 6, 9, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    // one, on segment 0, from which centre 0 is nearer; or centre 1 is: what lies behind the wall
    // is deep
    0, 1, 9, 1, 2, 9, 2, 6, 9, 2, 3, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 1, 9, 1, 2, 6, 1, 6, 9, 2, 3, 6, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    // two, on the segments 3 and 0: centre 0 is alone
    0, 1, 11, 11, 1, 2, 11, 2, 10, 6, 9, 10, 6, 10, 2, 6, 2, 3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    // two, on the segments 0 and 2
    0, 1, 8, 0, 8, 9, 1, 2, 7, 1, 7, 8, 2, 3, 6, 2, 6, 7, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    // three, not on segment 2: the centres 0 and 1 are alone
    0, 1, 11, 2, 3, 4, 6, 9, 10, 6, 10, 5, 10, 11, 1, 10, 1, 2, 10, 2, 4, 10, 4, 5, 0, 0, 0, 0, 0, 0,
    // four: the centres 0 and 2 are cut off
    0, 1, 11, 5, 6, 7, 11, 1, 2, 11, 2, 10, 5, 7, 8, 5, 8, 4, 2, 3, 4, 2, 4, 8, 2, 8, 10, 8, 9, 10);

float volumeCellDepth(ivec2 layers, ivec2 texel) { return texelFetch(VOLUME_DEPTHS, ivec3(texel, layers.x), 0).x; }

ivec2 volumeCentre(int centre) { return ivec2(centre == 1 || centre == 2, centre >= 2); }

// A segment between two centres beside each other, from the left or lower one on: along x (0) or y
// (1).
struct VolumeSegment {
    ivec2 first;
    int along;
};

ivec2 volumeStep(VolumeSegment s) { return ivec2(1 - s.along, s.along); }

// Which part of it is before its crossing; below 0: it has none.
float volumeCut(ivec2 layers, VolumeSegment s)
{
    vec2 bytes = texelFetch(VOLUME_CROSSINGS, ivec3(s.first, layers.y), 0).xy;
    float byte = s.along == 0 ? bytes.x : bytes.y;
    return byte > 0.0 ? (byte * 255.0 - 1.0) / 254.0 : -1.0;
}

// Segment i of a cell: those of its upper and left side begin at their second centre.
VolumeSegment volumeSegment(ivec2 cell, int i) { return VolumeSegment(cell + ivec2(i == 1, i == 2), i & 1); }

// The surface's depth at a crossing, on one side of it. What is nearer to the light goes on as it
// is. What lies behind goes on as from the centre beyond, unless a silhouette stands between them.
float volumeSide(ivec2 layers, VolumeSegment s, float cut, bool second)
{
    ivec2 step = volumeStep(s), texel = second ? s.first + step : s.first;
    float here = volumeCellDepth(layers, texel), there = volumeCellDepth(layers, second ? s.first : s.first + step);
    if (here >= there || here <= 0.0) return here;
    ivec2 next = second ? texel + step : texel - step; // it is in the map, as at the border depth is 0
    float beyond = volumeCellDepth(layers, next);
    if (beyond <= 0.0 || volumeCut(layers, VolumeSegment(second ? texel : next, s.along)) >= 0.0) return here;
    return clamp(here + (here - beyond) * (second ? 1.0 - cut : cut), 0.5 * here, there);
}

// Which segments are crossed: bits.
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

// With four crossings, the first of the two centers that are cut off, 0 or 1: the nearer pair,
// unless it is one surface, that is, if more than half of the segments is its own.
int volumeCutOff(ivec2 layers, ivec2 cell, vec4 quad)
{
    int nearer = quad.x + quad.z >= quad.y + quad.w ? 0 : 1;
    float even = 0.0; // what of the segments is on the side of the centres 0 and 2
    for (int i = 0; i < 4; i++) {
        float cut = volumeCut(layers, volumeSegment(cell, i)); // from centre 0, 1, 3 and 0
        even += (i == 0 || i == 3) ? cut : 1.0 - cut;
    }
    float own = nearer == 0 ? even : 4.0 - even;
    return own > 2.0 ? 1 - nearer : nearer;
}

// How a cell is parted, by the segments that are crossed: a row of VOLUME_TRIANGLES, and by how
// many centres it is turned.
ivec2 volumeParted(ivec2 layers, ivec2 cell, int crossed)
{
    vec4 quad = volumeQuad(layers, cell);
    if (crossed == 0) return ivec2(0, volumeTurned(quad) ? 0 : 1);
    if (crossed == 15) return ivec2(6, volumeCutOff(layers, cell, quad));
    if (crossed == 5 || crossed == 10) return ivec2(4, crossed == 5 ? 0 : 1);
    for (int turn = 0; turn < 4; turn++) {
        int turned = (crossed >> turn | crossed << (4 - turn)) & 15; // as if centre `turn` were 0
        if (turned == 1) return ivec2(quad[turn] > quad[(turn + 1) % 4] ? 1 : 2, turn);
        if (turned == 9) return ivec2(3, turn);
        if (turned == 11) return ivec2(5, turn);
    }
    return ivec2(0);
}

// A corner of a cell's triangles: where it is, in texels from the first one's centre, and its
// depth.
vec3 volumeCorner(ivec2 layers, ivec2 cell, ivec2 parted, int number)
{
    int label = (VOLUME_CORNERS[parted.x * 3 * VOLUME_MOST + number] + 3 * parted.y) % 12, i = label / 3;
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
// Whether the volume has a point in it that a view sees at this place and depth. Of parallel light
// what reaches to infinity goes along it.
bool volumeCellHas(ivec2 layers, vec2 at, float depth, bool parallel)
{
    ivec2 cell = ivec2(at), parted = volumeParted(layers, cell, volumeCrossed(layers, cell));
    for (int triangle = 0; triangle < VOLUME_TRIANGLES[parted.x]; triangle++) {
        vec3 a = volumeCorner(layers, cell, parted, 3 * triangle), b = volumeCorner(layers, cell, parted, 3 * triangle + 1),
             c = volumeCorner(layers, cell, parted, 3 * triangle + 2);
        vec2 ab = b.xy - a.xy, ac = c.xy - a.xy, way = at - a.xy;
        float area = ab.x * ac.y - ab.y * ac.x;
        vec2 part = vec2(way.x * ac.y - way.y * ac.x, ab.x * way.y - ab.y * way.x) / max(area, 1e-9);
        if (area <= 1e-9 || part.x < 0.0 || part.y < 0.0 || part.x + part.y > 1.0) continue; // a wall, or beside it
        if (parallel && min(a.z, min(b.z, c.z)) <= 0.0) return false;
        return depth < a.z + (b.z - a.z) * part.x + (c.z - a.z) * part.y;
    }
    return false;
}
#endif
