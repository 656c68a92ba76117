// The pass edge: a thread walks along a line, pixel column by pixel column (row by row where the
// line is steep), and leaves in each pixel that it crosses where it does so. Of several lines of a
// pixel that next to its centre stays: it says most of what the centre does not show. A line that
// ends before the middle of a column stays only where no other goes on: at corners.
//
// A line from (10.2, 5.0) to (12.8, 5.6) crosses the columns 10, 11 and 12 at their centres 10.5,
// 11.5, 12.5 at the heights 5.07, 5.30, 5.53; so pixel (11, 5), whose centre is at 5.5, has it 0.20
// below its centre, with a slope of 0.23.
layout(local_size_x = 64) in;
layout(r32ui) uniform uimage2D edge_target;
uniform sampler2D edge_depth;
uniform sampler2D edge_lines;
layout(std140) uniform Edge {
    vec4 edge_corner; // xy: the pixel of the picture with which the target begins; zw: the picture's size
    int edge_count;
};

const int LINES = 1024; // in a row of their texture

// Depth grows towards the eye: what is nearer than the line on both sides hides it. Beside a crease
// that is turned away both sides may be a little nearer; less, where they would be as far on.
const float NEARER = 1.01, AS_NEAR = 1.001, FURTHER = 0.9;

// So near to a centre, in pixels, a line is on either side of it: some times the 1/256 of
// rasterisers.
const float CENTRE = 0.02;

float depthAt(ivec2 pixel)
{
    return texelFetch(edge_depth, pixel, 0).x;
}

// Which of the neighbours lies beyond the line: 1 the upper, -1 the lower one. Where it runs
// through the centre, a rounding decides on which side that is; then it is the neighbour whose
// depth is further from the pixel's.
int sideOf(ivec2 pixel, float above, ivec2 up)
{
    int side = above > 0.0 ? 1 : -1;
    if (abs(above) > CENTRE) return side;
    float here = depthAt(pixel), there = depthAt(pixel + side * up), other = depthAt(pixel - side * up);
    return abs(there - here) >= abs(other - here) ? side : -side;
}

bool isSeen(ivec2 pixel)
{
    ivec2 first = max(ivec2(0), -ivec2(edge_corner.xy));
    ivec2 last = min(imageSize(edge_target), ivec2(edge_corner.zw - edge_corner.xy)) - 1;
    return all(greaterThanEqual(pixel, first)) && all(lessThanEqual(pixel, last));
}

// Depth of a pixel's surface extrapolated to the line, `way` pixels on: by the plane through this
// pixel and the one behind it, along which depths are linear. If that rises towards the line, the
// pixel's own depth.
float depthToward(ivec2 pixel, ivec2 behind, float way)
{
    float here = depthAt(pixel);
    return isSeen(behind) ? min(here, here + (here - depthAt(behind)) * way) : here;
}

// Whether of two pixels one shows what the line is an edge of, or both do, of a crease, and nothing
// before it hides it on both sides: the surfaces that both show would be nearer where it is. Of
// pixels aside neither may be, since what is beyond them may have an edge of its own. `line`: as in
// mark().
bool isEdge(ivec2 pixel, ivec2 beyond, ivec2 toward, vec4 line)
{
    float here = depthAt(pixel), there = depthAt(beyond), away = abs(line.x);
    float a = depthToward(pixel, pixel - toward, away), b = depthToward(beyond, beyond + toward, 1.0 - away);
    return isSeen(beyond) && min(here, there) <= line.z * NEARER && min(a, b) <= line.z * AS_NEAR &&
           (beyond == pixel + toward || max(a, b) <= line.z * NEARER) &&
           (line.w > 0.0 ? min(here, there) : max(here, there)) >= line.z * FURTHER;
}

// `line`: how far it is above the centre, its slope, its depth there, whether it is a crease. At a
// corner only a pixel that is next to the neighbour may be beyond it.
void mark(ivec2 pixel, vec4 line, bool steep, bool within)
{
    ivec2 up = steep ? ivec2(1, 0) : ivec2(0, 1);
    int side = sideOf(pixel, line.x, up);
    uint aside = 1u;
    for (uint i = 0u; i < 3u && !isEdge(pixel, pixel + side * up + (int(aside) - 1) * up.yx, side * up, line); i++)
        aside = i == 0u ? 0u : i == 1u ? 2u : 3u;
    if (!isSeen(pixel) || aside > 2u) return;
    uint near = uint(1023.0 * (1.0 - min(abs(line.x), 1.0)) + 0.5);
    uint inclined = uint(1023.0 * (line.y + 1.0) * 0.5 + 0.5);
    uint word = uint(within) << 31 | near << 21 | uint(side > 0) << 20 | uint(steep) << 19 | inclined << 8 | aside << 1 | 1u;
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
            mark(steep ? ivec2(row, column) : ivec2(column, row), vec4(at.y - (float(row) + 0.5), step.y, at.z, crease), steep,
                 middle >= from.x && middle < to.x);
    }
}
