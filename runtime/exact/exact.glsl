// Exact shadows: which share of a light reaches a point, by the triangles that stand between.
// exact_lists.h has what the lists hold; corners and points are counted from the middle of all
// triangles, along the world's axes.
//
// Two triangles that share an edge leave no gap. All corners are taken relative to the point and
// sheared so that the way to the light is the axis z; which side of an edge the axis is on is the
// sign of x y' - y x' of its two ends. Of the other triangle, which has them in the other order,
// that number is the same with the other sign, bit for bit. A ray that meets an edge meets both.
//
//     the way (0, 0, 1) from 0, corners (-1, -1), (1, -1), (0, 2): 2 x 1 + 1 x 0 = 2, 2 x -1 ...
//         all three are positive: it is met
//
// A point is on its own triangle, and on those beside it, but for rounding. So a triangle counts
// only if the point is off its plane by more than EXACT_OFF times the greatest coordinate: 16 steps
// of a float's last place. What stands closer is not told from what touches.
#include "exact_lists.layout.def"
const float EXACT_OFF = 9.5367e-7; // 2^-20

layout(std430, binding = 6) readonly buffer ExactTriangles {
    vec4 exact_corners[]; // three each; w: what the triangle lets through of red, green, blue
};
layout(std430, binding = 7) readonly buffer ExactLists {
    uint exact_words[];
};

// The eye, and of all corners the greatest coordinate; the camera's axes.
layout(std140) uniform Exact {
    vec4 exact_eye;
    vec4 exact_right;
    vec4 exact_up;
    vec4 exact_back;
};

struct ExactRay {
    vec3 from;
    int axis;   // the way's longest
    vec3 shear; // the way's x and y over its z, and 1 over z: by these axes
};

vec3 exactTurned(vec3 v, int axis) { return axis == 0 ? v.yzx : axis == 1 ? v.zxy : v; }

ExactRay exactRay(vec3 from, vec3 way)
{
    vec3 size = abs(way);
    int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    vec3 turned = exactTurned(way, axis);
    return ExactRay(from, axis, vec3(turned.xy / turned.z, 1.0 / turned.z));
}

vec3 exactCorner(uint triangle, uint corner) { return exact_corners[triangle * 3u + corner].xyz; }

// From the ray's start, the ray as the axis z, where 1 is the end of its way.
vec3 exactSeen(ExactRay ray, vec3 corner)
{
    vec3 v = exactTurned(corner - ray.from, ray.axis);
    precise vec2 across = v.xy - ray.shear.xy * v.z;
    return vec3(across, ray.shear.z * v.z);
}

// Signed areas of the ray with the three edges, each opposite to its corner; they sum to the
// triangle's.
vec3 exactAreas(vec3 a, vec3 b, vec3 c)
{
    precise vec3 areas = vec3(b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x);
    return areas;
}

// Whether a point is off a triangle's plane.
bool exactOff(vec3 point, vec3 a, vec3 b, vec3 c)
{
    vec3 normal = cross(b - a, c - a), size = abs(normal);
    normal /= max(max(max(size.x, size.y), size.z), 1e-37);
    vec3 way = abs(point);
    float off = dot(normal, a - point), least = EXACT_OFF * max(exact_eye.w, max(max(way.x, way.y), way.z));
    return off * off > least * least * dot(normal, normal);
}

bool exactMeets(ExactRay ray, uint triangle, bool endless)
{
    vec3 a = exactCorner(triangle, 0u), b = exactCorner(triangle, 1u), c = exactCorner(triangle, 2u);
    vec3 seen[3] = vec3[3](exactSeen(ray, a), exactSeen(ray, b), exactSeen(ray, c));
    vec3 areas = exactAreas(seen[0], seen[1], seen[2]);
    if (min(min(areas.x, areas.y), areas.z) < 0.0 && max(max(areas.x, areas.y), areas.z) > 0.0) return false;
    float area = areas.x + areas.y + areas.z;
    if (area == 0.0) return false; // it is seen from its side
    float along = dot(areas, vec3(seen[0].z, seen[1].z, seen[2].z)) / area;
    return along > 0.0 && (endless || along < 1.0) && exactOff(ray.from, a, b, c);
}

// The cell of a light's view in which a place is; -1: the light does not see it.
int exactCell(vec3 place, int views, int size, bool placed)
{
    int face = 0;
    if (views > 1) {
        vec3 away = abs(place);
        int axis = away.z >= away.x && away.z >= away.y ? 2 : away.x >= away.y ? 0 : 1;
        place = axis == 0 ? place.yzx : axis == 1 ? place.zxy : place;
        face = 2 * axis + int(place.z < 0.0);
        place.z = abs(place.z);
    }
    if (placed && place.z <= 0.0) return -1;
    vec2 at = placed ? place.xy / place.z : place.xy;
    if (max(abs(at.x), abs(at.y)) > 1.0) return -1;
    ivec2 cell = min(ivec2((at * 0.5 + 0.5) * float(size)), size - 1);
    return (face * size + cell.y) * size + cell.x;
}

vec3 exactThrough(uint triangle)
{
    uint at = triangle * 3u;
    return vec3(exact_corners[at].w, exact_corners[at + 1u].w, exact_corners[at + 2u].w);
}

// The share of a light that reaches a point; `light` is the number of its head.
vec3 exactShare(int light, vec3 point)
{
    uint head = uint(light) * EXACT_HEAD;
    vec4 row[4];
    for (int i = 0; i < 4; i++)
        for (int lane = 0; lane < 4; lane++)
            row[i][lane] = uintBitsToFloat(exact_words[head + uint(4 * i + lane)]);
    bool placed = row[0].w > 0.0;
    vec4 from = vec4(placed ? point - row[0].xyz : point, 1.0);
    int cell = exactCell(vec3(dot(row[1], from), dot(row[2], from), dot(row[3], from)), int(exact_words[head + EXACT_VIEWS]),
                         int(exact_words[head + EXACT_SIZE]), placed);
    if (cell < 0) return vec3(1.0);
    uint list = exact_words[head + EXACT_CELLS] + 2u * uint(cell);
    ExactRay ray = exactRay(point, placed ? -from.xyz : row[0].xyz);
    vec3 share = vec3(1.0);
    for (uint i = exact_words[list], end = exact_words[list + 1u]; i < end && share != vec3(0.0); i++)
        if (exactMeets(ray, exact_words[i], !placed)) share *= exactThrough(exact_words[i]);
    return share;
}

// A direction from the eye's space.
vec3 exactDirection(vec3 eye) { return eye.x * exact_right.xyz + eye.y * exact_up.xyz + eye.z * exact_back.xyz; }

#ifdef EXACT_SEEN
vec3 exactPoint(vec3 point, vec3 normal, float pixel); // exact_seen.glsl
#else
// The point of something transparent is known from its depth. It is lifted to the light's side by
// what that may be off.
vec3 exactPoint(vec3 point, vec3 normal, float pixel) { return exact_eye.xyz + exactDirection(point + normal * (pixel / 64.0)); }
#endif

// For shadow_text.c.
vec3 exactLight(int number, ivec2 views, vec3 point, vec3 side, float size, ivec2 pixel)
{
    return exactShare(number, exactPoint(point, side, size));
}
