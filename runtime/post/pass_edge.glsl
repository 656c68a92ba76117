// The edge pass: each thread rasterizes one line, column by column (row by row for steep lines),
// and records the crossing in each pixel. If several lines cross a pixel, the line nearest to its
// center is kept, since the center's color misses most of that line's far side. A line that ends
// before the middle of a column is kept only if no other line continues there: at corners.
//
// A line from (10.2, 5.0) to (12.8, 5.6) crosses the columns 10, 11 and 12 at their centers 10.5,
// 11.5, 12.5 at the heights 5.07, 5.30, 5.53. Pixel (11, 5), whose center is at 5.5, therefore has
// the line 0.20 below its center, with a slope of 0.23.
layout(local_size_x = 64) in;
layout(r32ui) uniform uimage2D edge_target;
uniform sampler2D edge_depth;
uniform sampler2D edge_lines;
layout(std140) uniform Edge {
    vec4 edge_corner; // xy: the picture's pixel at the target's origin; zw: the picture's size
    int edge_count;
};

const int LINES = 1024; // lines per row of the texture

// Depth increases toward the camera. A line is hidden if the surfaces on both sides are nearer than
// the line by these factors. Beside a crease seen at a grazing angle both sides may be slightly
// nearer (NEARER); extrapolated depths get a tighter bound (AS_NEAR). A surface below FURTHER times
// the depth of the line does not have the line as its edge.
const float NEARER = 1.01, AS_NEAR = 1.001, FURTHER = 0.9;

// Distance in pixels up to which a line through a pixel center is on both sides of the center:
// several times the rasterizer's precision of 1/256.
const float CENTRE = 0.02;

float depthAt(ivec2 pixel)
{
    return texelFetch(edge_depth, pixel, 0).x;
}

// Returns which neighbor is on the far side of the line: 1 the upper, -1 the lower one. For a line
// through the center rounding would decide; the neighbor with the larger depth difference is used
// instead.
int sideOf(ivec2 pixel, float above, ivec2 up)
{
    int side = above > 0.0 ? 1 : -1;
    if (abs(above) > CENTRE) return side;
    float here = depthAt(pixel), there = depthAt(pixel + side * up),
        other = depthAt(pixel - side * up);
    return abs(there - here) >= abs(other - here) ? side : -side;
}

bool isSeen(ivec2 pixel)
{
    ivec2 first = max(ivec2(0), -ivec2(edge_corner.xy));
    ivec2 last = min(imageSize(edge_target), ivec2(edge_corner.zw - edge_corner.xy)) - 1;
    return all(greaterThanEqual(pixel, first)) && all(lessThanEqual(pixel, last));
}

// Returns the depth of a pixel's surface extrapolated by `way` pixels to the line: along the plane
// through this pixel and the pixel behind, since depth is linear in screen space. Returns the
// pixel's own depth if the plane comes nearer toward the line.
float depthToward(ivec2 pixel, ivec2 behind, float way)
{
    float here = depthAt(pixel);
    return isSeen(behind) ? min(here, here + (here - depthAt(behind)) * way) : here;
}

// Returns whether the line is a visible edge between two pixels. One pixel (both pixels for a
// crease) must show the surface that has the edge, and no nearer surface may hide the line on both
// sides; extrapolated to the line, such surfaces would be nearer. For a diagonal neighbor neither
// pixel may be nearer, since the surface there may have an edge of its own. `line`: see mark().
bool isEdge(ivec2 pixel, ivec2 beyond, ivec2 toward, vec4 line)
{
    float here = depthAt(pixel), there = depthAt(beyond), away = abs(line.x);
    float a = depthToward(pixel, pixel - toward, away),
        b = depthToward(beyond, beyond + toward, 1.0 - away);
    return isSeen(beyond) && min(here, there) <= line.z * NEARER && min(a, b) <= line.z * AS_NEAR &&
           (beyond == pixel + toward || max(a, b) <= line.z * NEARER) &&
           (line.w > 0.0 ? min(here, there) : max(here, there)) >= line.z * FURTHER;
}

// Records a line in a pixel. `line`: offset above the center, slope, depth at that point, crease
// flag. Tries the direct neighbor, then both diagonal neighbors, which matter at corners.
void mark(ivec2 pixel, vec4 line, bool steep, bool within)
{
    ivec2 up = steep ? ivec2(1, 0) : ivec2(0, 1);
    int side = sideOf(pixel, line.x, up);
    uint aside = 1u;
    for (uint i = 0u; i < 3u && !isEdge(pixel, pixel + side * up + (int(aside) - 1) * up.yx,
        side * up, line); i++)
        aside = i == 0u ? 0u : i == 1u ? 2u : 3u;
    if (!isSeen(pixel) || aside > 2u) return;
    uint near = uint(1023.0 * (1.0 - min(abs(line.x), 1.0)) + 0.5);
    uint inclined = uint(1023.0 * (line.y + 1.0) * 0.5 + 0.5);
    uint word = uint(within) << 31 | near << 21 | uint(side >
        0) << 20 | uint(steep) << 19 | inclined << 8 | aside << 1 | 1u;
    imageAtomicMax(edge_target, pixel, word);
}

void main()
{
    int line = int(gl_GlobalInvocationID.x);
    if (line >= edge_count) return;
    ivec2 texel = ivec2(line % LINES * 2, line / LINES);
    vec3 from = texelFetch(edge_lines, texel, 0).xyz - vec3(edge_corner.xy, 0.0);
    float crease = texelFetch(edge_lines, texel, 0).w;
    vec3 to = texelFetch(edge_lines, texel + ivec2(1, 0), 0).xyz - vec3(edge_corner.xy, 0.0);
    bool steep = abs(to.y - from.y) > abs(to.x - from.x);
    if (steep) {
        from = from.yxz;
        to = to.yxz;
    }
    if (from.x > to.x) {
        vec3 end = from;
        from = to;
        to = end;
    }
    vec3 step = (to - from) / max(to.x - from.x, 1e-6);
    float reach = 0.5 + 0.5 * abs(step.y);
    int last = int(ceil(to.x));
    for (int column = int(floor(from.x)); column < last; column++) {
        float middle = float(column) + 0.5;
        vec3 at = from + step * (middle - from.x);
        for (int row = int(ceil(at.y - reach - 0.5)); float(row) + 0.5 < at.y + reach; row++)
            mark(steep ? ivec2(row, column) : ivec2(column, row),
                vec4(at.y - (float(row) + 0.5), step.y, at.z, crease), steep,
                 middle >= from.x && middle < to.x);
    }
}
