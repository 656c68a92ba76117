// Exact shadows: the share of a light that reaches a point, by ray-triangle intersection with the
// listed triangles. exact_lists.h describes the lists; corners and points are relative to the
// center of all triangles, along the world's axes.
//
// The test is watertight: two triangles that share an edge leave no gap. All corners are taken
// relative to the point and sheared so that the ray to the light is the axis z; the side of an edge
// on which the axis lies is the sign of x y' - y x' of its two ends. For the other triangle, which
// has the ends in reverse order, the value is the same with the opposite sign, bit for bit. A ray
// that hits the edge hits both.
//
//  the ray (0, 0, 1) from 0, corners (-1, -1), (1, -1), (0, 2): 2 x 1 + 1 x 0 = 2, 2 x -1 ...
//   all three are positive: a hit
//
// Except for rounding a point is on its own triangle, and on adjacent ones at an edge. To avoid
// self-shadowing a triangle counts only if the point's distance from its plane is more than
// EXACT_OFF times the greatest coordinate: 16 units in a float's last place. Closer occluders are
// treated as touching.
#include "exact_lists.layout.def"
const float EXACT_OFF = 9.5367e-7; // tolerance: 2^-20, relative to the greatest coordinate

layout(std430, binding = 6) readonly buffer ExactTriangles {
    // three texels per triangle; w: the triangle's transmittance of red, green, blue
    vec4 exact_corners[];
};
layout(std430, binding = 7) readonly buffer ExactLists {
    uint exact_words[];
};

// The eye, with the greatest coordinate of all corners as w; the camera's axes.
layout(std140) uniform Exact {
    vec4 exact_eye;
    vec4 exact_right;
    vec4 exact_up;
    vec4 exact_back;
};

struct ExactRay {
    vec3 from;
    int axis;   // axis of the direction's greatest component
    vec3 shear; // direction's x and y over its z, and 1 over z: in the permuted axes
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

// Returns a corner relative to the ray's start, sheared so that the ray is the axis z, with 1 at
// the ray's end.
vec3 exactSeen(ExactRay ray, vec3 corner)
{
    vec3 v = exactTurned(corner - ray.from, ray.axis);
    precise vec2 across = v.xy - ray.shear.xy * v.z;
    return vec3(across, ray.shear.z * v.z);
}

// Returns the signed areas of the ray with the three edges, each opposite to its corner; they add
// up to the triangle's.
vec3 exactAreas(vec3 a, vec3 b, vec3 c)
{
    precise vec3 areas = vec3(b.x * c.y - b.y * c.x, c.x * a.y - c.y * a.x, a.x * b.y - a.y * b.x);
    return areas;
}

// Returns true if a point is off a triangle's plane by more than the tolerance.
bool exactOff(vec3 point, vec3 a, vec3 b, vec3 c)
{
    vec3 normal = cross(b - a, c - a), size = abs(normal);
    normal /= max(max(max(size.x, size.y), size.z), 1e-37);
    vec3 way = abs(point);
    float off = dot(normal, a - point),
        least = EXACT_OFF * max(exact_eye.w, max(max(way.x, way.y), way.z));
    return off * off > least * least * dot(normal, normal);
}

bool exactMeets(ExactRay ray, uint triangle, bool endless)
{
    vec3 a = exactCorner(triangle, 0u), b = exactCorner(triangle, 1u),
        c = exactCorner(triangle, 2u);
    vec3 seen[3] = vec3[3](exactSeen(ray, a), exactSeen(ray, b), exactSeen(ray, c));
    vec3 areas = exactAreas(seen[0], seen[1], seen[2]);
    if (min(min(areas.x, areas.y), areas.z) < 0.0 && max(max(areas.x, areas.y), areas.z) > 0.0)
        return false;
    float area = areas.x + areas.y + areas.z;
    if (area == 0.0) return false; // the triangle is edge-on
    float along = dot(areas, vec3(seen[0].z, seen[1].z, seen[2].z)) / area;
    return along > 0.0 && (endless || along < 1.0) && exactOff(ray.from, a, b, c);
}

// Returns the cell of a light's view that contains a position; -1: outside of the view.
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

// Returns the share of a light that reaches a point; `light` is the number of its header.
vec3 exactShare(int light, vec3 point)
{
    uint head = uint(light) * EXACT_HEAD;
    vec4 row[4];
    for (int i = 0; i < 4; i++)
        for (int component = 0; component < 4; component++)
            row[i][component] = uintBitsToFloat(exact_words[head + uint(4 * i + component)]);
    bool placed = row[0].w > 0.0;
    vec4 from = vec4(placed ? point - row[0].xyz : point, 1.0);
    int cell = exactCell(vec3(dot(row[1], from), dot(row[2], from), dot(row[3], from)),
        int(exact_words[head + EXACT_VIEWS]),
                         int(exact_words[head + EXACT_SIZE]), placed);
    if (cell < 0) return vec3(1.0);
    uint list = exact_words[head + EXACT_CELLS] + 2u * uint(cell);
    ExactRay ray = exactRay(point, placed ? -from.xyz : row[0].xyz);
    vec3 share = vec3(1.0);
    for (uint i = exact_words[list], end = exact_words[list + 1u]; i < end && share != vec3(0.0);
        i++)
        if (exactMeets(ray, exact_words[i], !placed)) share *= exactThrough(exact_words[i]);
    return share;
}

// Transforms a direction from eye space to world space.
vec3 exactDirection(vec3 eye)
{
    return eye.x * exact_right.xyz + eye.y * exact_up.xyz + eye.z * exact_back.xyz;
}

#ifdef EXACT_SEEN
vec3 exactPoint(vec3 point, vec3 normal, float pixel); // defined in exact_seen.glsl
#else
// Returns a transparent surface's point, reconstructed from depth, and lifted to the light's side
// by the possible error.
vec3 exactPoint(vec3 point, vec3 normal, float pixel)
{
    return exact_eye.xyz + exactDirection(point + normal * (pixel / 64.0));
}
#endif

// Returns the share of a light that arrives (entry point, called by shadow_text.c's functions).
vec3 exactLight(int number, ivec2 views, vec3 point, vec3 side, float size, ivec2 pixel)
{
    return exactShare(number, exactPoint(point, side, size));
}
