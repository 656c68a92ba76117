// Finds where silhouettes cross the segments between the centers of a shadow map's texels: one
// thread per edge of a mesh and object. An edge belongs to the silhouette if both its faces are on
// the same side of it, as seen from the light; an edge with one face stores that face twice. The
// thread walks along all rows and columns of texels that the edge crosses.
//
// A crossing counts on a segment with one center nearer to the light than the other, if its edge is
// no deeper than the surface at the farther center, and its faces are on the nearer center's side.
// The crossing that is farthest from the nearer center is kept: everything up to it is
// covered. It is stored as its distance from that center.
//
//     depths .9 and .5 at the columns 3 and 4 of a row, an edge at column 3.25 of depth .8: .25;
//         another one at 3.75 of depth .7: .75
//
// A rasterizer rounds corners to 1/256 of a texel, so a center nearer than that to an edge may be
// on its other side: the crossing is also stored for the adjacent segment.
layout(local_size_x = 64) in;

struct Instance {
    mat4 worldFromLocal;
    mat3 worldNormalFromLocal;
    uint material;
};
layout(std140, binding = 0) readonly buffer Instances {
    Instance instances[];
};
layout(std430, binding = 1) readonly buffer Places {
    uint places[];
};
// edges of all meshes: two ends, then the third corners of both faces
layout(std430, binding = 2) readonly buffer Edges {
    float edge_components[];
};
// extents per texel: of the segment to the right, and of that upwards
layout(std430, binding = 3) buffer Extents {
    uint extents[];
};
uniform sampler2DArray silhouette_maps;
// three rows from world space; row 3: near, edge of the map in texels, number of the map
uniform mat4 silhouette_view;
// range of a mesh: its first edge, number of edges; offset of its objects' numbers
uniform vec3 silhouette_run;

const float NEAR_CENTRE = 1.0 / 128.0; // distance to a texel's center, in texels
const float FLAT = 2e-6; // tolerance for faces seen edge-on

float near, size;

// Returns the position in the view: x, y, depth and 1, times w.
vec4 placeOf(uint edge, uint corner, mat4 worldFromLocal)
{
    uint at = edge * 12u + corner * 3u;
    vec4 world = worldFromLocal * vec4(edge_components[at], edge_components[at + 1u],
        edge_components[at + 2u], 1.0);
    vec3 place = vec3(dot(silhouette_view[0], world), dot(silhouette_view[1], world),
        dot(silhouette_view[2], world));
    return near > 0.0 ? vec4(place.xy, near, place.z) : vec4(place, 1.0);
}

// Returns the side of an edge on which a point is, as seen from the light: 1, -1; 0: on the edge.
float sideOf(vec3 from, vec3 edge, vec3 there)
{
    vec3 way = there - from, across = cross(edge, way);
    float side = dot(from, across);
    return abs(side) <= FLAT * length(from) * length(edge) * length(way) ? 0.0 : sign(side);
}

// Converts to texels and depth.
vec3 texelOf(vec4 place)
{
    return vec3((place.xy / place.w * 0.5 + 0.5) * size - 0.5, place.z / place.w);
}

float depthAt(ivec2 texel)
{
    return texelFetch(silhouette_maps,
        ivec3(clamp(texel, ivec2(0), ivec2(size) - 1), int(silhouette_view[3].z)), 0).x;
}

// An edge in the map's coordinates.
struct Edge {
    vec3 ends[2];
    vec2 faces; // x: 1 if a face is on the side 1; y: 1 if a face is on the side -1
};

// Stores a crossing. `along` is 0 on a row of texels, 1 on a column; the segment begins at `texel`,
// and the crossing is at `part` of the segment.
void record(Edge edge, int along, ivec2 texel, float part, float depth)
{
    ivec2 next = ivec2(along == 0, along == 1);
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel + next, ivec2(size)))) return;
    float first = depthAt(texel), second = depthAt(texel + next);
    if (first == second) return;
    bool nearer = first > second; // the first center is nearer
    float deepest = min(first, second), beyond = depthAt(nearer ? texel + 2 * next : texel - next);
    float left = nearer ? 1.0 - part : part;
    if (depth < min(deepest, deepest + (deepest - beyond) * left) * (1.0 - 2e-6)) return;
    vec2 way = edge.ends[1].xy - edge.ends[0].xy, to = vec2(nearer ? texel : texel + next) -
        edge.ends[0].xy;
    float side = way.x * to.y - way.y * to.x;
    bool covers = abs(side) <= NEAR_CENTRE * length(way) ||
        (side > 0.0 ? edge.faces.x : edge.faces.y) > 0.0;
    if (covers)
        atomicMax(extents[(texel.y * int(size) + texel.x) * 2 + along],
            uint((1.0 - left) * 65534.0 + 0.5) + 1u);
}

// Visits all rows, or all columns, that an edge crosses.
void walk(Edge edge, int along)
{
    int across = 1 - along;
    float from = edge.ends[0][across], to = edge.ends[1][across], far = to - from;
    int last = int(floor(min(max(from, to) + NEAR_CENTRE, size - 1.0)));
    for (int line = int(ceil(max(min(from, to) - NEAR_CENTRE, 0.0))); line <= last; line++) {
        float share = abs(far) > 1e-6 ? clamp((float(line) - from) / far, 0.0, 1.0) : 0.0;
        float at = mix(edge.ends[0][along], edge.ends[1][along], share),
            depth = mix(edge.ends[0].z, edge.ends[1].z, share);
        if (at < -1.0 || at > size) continue;
        float column = floor(at), part = at - column;
        ivec2 texel = along == 0 ? ivec2(column, line) : ivec2(line, column),
            step = ivec2(along == 0, along == 1);
        record(edge, along, texel, part, depth);
        if (part < NEAR_CENTRE) record(edge, along, texel - step, 1.0, depth);
        if (part > 1.0 - NEAR_CENTRE) record(edge, along, texel + step, 0.0, depth);
    }
}

void main()
{
    uint number = gl_GlobalInvocationID.x;
    near = silhouette_view[3].x;
    size = silhouette_view[3].y;
    if (number >= uint(silhouette_run.y)) return;
    number += uint(silhouette_run.x);
    mat4 world = instances[places[uint(silhouette_run.z) + gl_GlobalInvocationID.y]].worldFromLocal;
    vec4 a = placeOf(number, 0u, world), b = placeOf(number, 1u, world);
    vec3 way = b.xyw - a.xyw;
    vec2 sides = vec2(sideOf(a.xyw, way, placeOf(number, 2u, world).xyw),
        sideOf(a.xyw, way, placeOf(number, 3u, world).xyw));
    if (sides.x * sides.y < 0.0) return;
    vec2 faces = vec2(max(sides.x, sides.y) >= 0.0, min(sides.x, sides.y) <= 0.0);
    float least = near > 0.0 ? near * 0.99 : 0.0; // nearer points are in no map
    if (max(a.w, b.w) <= least) return;
    vec4 first = a.w < least ? mix(a, b, (least - a.w) / (b.w - a.w)) : a;
    vec4 second = b.w < least ? mix(b, a, (least - b.w) / (a.w - b.w)) : b;
    Edge edge = Edge(vec3[2](texelOf(first), texelOf(second)), faces);
    if (any(lessThan(max(edge.ends[0].xy, edge.ends[1].xy), vec2(-1.0)))) return;
    if (any(greaterThan(min(edge.ends[0].xy, edge.ends[1].xy), vec2(size)))) return;
    walk(edge, 0);
    walk(edge, 1);
}
