// Surfaces whose triangles are small against voxels, one triangle per invocation: finds the lines
// through voxel centers, along each axis, that hit the triangle, like voxel_touch.glsl with a
// rasterizer. Most such triangles are hit by one line or none.
//
// Vertices are snapped to 1/256 of a voxel, and areas are integers: a line over an edge is on the
// same side of the edge for both triangles that share it, or exactly on it, so no line passes
// between them. A line on an edge hits both triangles, which is harmless. FINE_STRIDE: floats per
// vertex, whose position comes first.
//
//     Corners (0, 0), (1, 0), (0, 1), in voxels: the line at (1/2, 1/2) is on the long edge, where
//         its area is 0, and hits the triangle.
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer FinePlaces {
    vec4 fine_places[]; // per instance: rows of the matrix from local space to voxels
};
layout(std430, binding = 1) readonly buffer FineVertices {
    float fine_vertices[];
};
layout(std430, binding = 2) readonly buffer FineIndices {
    uint fine_indices[];
};
layout(r32ui) uniform uimage2DArray voxel_surface;

const int fine_parts = 256; // fixed-point steps per voxel

vec3 finePlace(uint vertex, int place)
{
    uint at = vertex * uint(FINE_STRIDE);
    vec4 local = vec4(fine_vertices[at], fine_vertices[at + 1u], fine_vertices[at + 2u], 1.0);
    precise vec3 made = vec3(dot(fine_places[place], local), dot(fine_places[place + 1], local),
        dot(fine_places[place + 2], local));
    return made;
}

int fineArea(ivec2 a, ivec2 b) { return a.x * b.y - a.y * b.x; }

// Fills a voxel, given by x, y and depth of the view along an axis.
void fineSet(ivec3 seen, int axis)
{
    ivec3 at = axis == 0 ? seen.zxy : axis == 1 ? seen.yzx : seen;
    imageAtomicOr(voxel_surface, ivec3(at.xy, at.z >> 5), 1u << uint(at.z & 31));
}

void fineTouch(ivec2 a, ivec2 b, ivec2 c, vec3 depths, int axis)
{
    int whole = fineArea(b - a, c - a), turn = sign(whole), last = imageSize(voxel_surface).x - 1;
    ivec2 low = max((min(a, min(b, c)) + (fine_parts / 2 - 1)) >> 8, 0),
        high = min((max(a, max(b, c)) - fine_parts / 2) >> 8, last);
    vec3 slopes = depths / float(whole);
    for (ivec2 at = low; whole != 0 && at.y <= high.y && low.x <= high.x;) {
        ivec2 middle = fine_parts * at + fine_parts / 2;
        ivec3 areas = ivec3(fineArea(c - b, middle - b), fineArea(a - c, middle - c),
            fineArea(b - a, middle - a));
        if (all(greaterThanEqual(turn * areas, ivec3(0))))
            fineSet(ivec3(at, clamp(int(dot(vec3(areas), slopes)), 0, last)), axis);
        at = at.x < high.x ? ivec2(at.x + 1, at.y) : ivec2(low.x, at.y + 1);
    }
}

void main()
{
    int place = 3 * int(gl_WorkGroupID.y);
    uint count = uint(fine_indices.length()) / 3u;
    for (uint i = gl_GlobalInvocationID.x; i < count;
        i += gl_NumWorkGroups.x * gl_WorkGroupSize.x) {
        vec3 a = finePlace(fine_indices[3u * i], place),
            b = finePlace(fine_indices[3u * i + 1u], place),
            c = finePlace(fine_indices[3u * i + 2u], place);
        ivec3 p = ivec3(floor(float(fine_parts) * a + 0.5)),
            q = ivec3(floor(float(fine_parts) * b + 0.5)),
            r = ivec3(floor(float(fine_parts) * c + 0.5));
        fineTouch(p.yz, q.yz, r.yz, vec3(a.x, b.x, c.x), 0);
        fineTouch(p.zx, q.zx, r.zx, vec3(a.y, b.y, c.y), 1);
        fineTouch(p.xy, q.xy, r.xy, vec3(a.z, b.z, c.z), 2);
    }
}
