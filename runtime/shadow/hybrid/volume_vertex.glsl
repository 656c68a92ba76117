// Vertex program of a depth map's shadow volume. A vertex is a texel, or for the perfect
// triangulation a corner of a quad, four each. CAP: a vertex of a fan that closes the volume at
// infinity, over the map's border. DEPTHS: its depth is an attribute. CORNERS: the same with four
// vertices per quad, and a negative depth marks a turned quad (volume_corners.glsl). CELLS: a
// corner of a cell's triangles (volume_cells.glsl), for all cells with VOLUME_MAX triangles each;
// with LISTED, for the cells in a list (volume_list.glsl). Missing triangles of a cell are
// degenerate.
#ifndef CELLS
uniform sampler2DArray volume_depths;
#endif
layout(std140) uniform Volume {
    vec4 volume_x, volume_y, volume_z, volume_w; // columns of the matrix from the map to clip space
    // x: layer; y: size; z 1: parallel light; w 1: stretched
    vec4 volume_map;
    // direction of a parallel light; for other lights x: min depth
    vec4 volume_far;
#ifdef CELLS
    // layer of crossings; index among hybrid views; 1: draws crossed cells, 0: the rest
    vec4 volume_cells;
#endif
};
#ifdef LISTED
layout(std430, binding = 0) readonly buffer Cells { uint listed_cells[]; };
#endif
#if defined DEPTHS || defined CORNERS
layout(location = 0) in float volume_depth;
#endif
invariant gl_Position; // caps and sheets must compute equal positions for shared vertices
#ifdef VIEWED
out float volume_away; // 1: the map has no depth at the vertex (volume_shown.glsl)
#endif

#ifndef CELLS
float volumeDepth(ivec2 texel)
{
    return texelFetch(volume_depths, ivec3(texel, int(volume_map.x)), 0).x;
}
#endif

// Returns a homogeneous point: perspective depth is near / z. A point without depth is as distant
// as pass_volume.c sets.
vec4 volumePoint(vec2 place, float depth)
{
#ifdef VIEWED
    volume_away = depth > 0.0 ? 0.0 : 1.0;
#endif
    if (volume_map.z == 0.0)
        return volume_x * place.x + volume_y * place.y + volume_z +
            volume_w * max(depth, volume_far.x);
    return depth > 0.0 ? volume_x * place.x + volume_y * place.y + volume_z * depth + volume_w
        : volume_far;
}

#ifdef CAP
// Returns texel k of the border, counterclockwise.
ivec2 volumeBorder(int k)
{
    int last = int(volume_map.y) - 1, along = k % last, side = k / last % 4;
    return side == 0 ? ivec2(along, 0) : side == 1 ? ivec2(last, along) : side == 2
        ? ivec2(last - along, last) : ivec2(0, last - along);
}
#endif

#ifdef CELLS
vec3 volumeVertex()
{
    int row = int(volume_map.y) - 1, most = 3 * VOLUME_MAX;
    bool cut = true; // the quad may have crossings
#ifdef LISTED
    cut = volume_cells.z > 0.0;
    most = cut ? most : 6;
    int all = row * row, first = int(volume_cells.y) * all, place = gl_VertexID / most;
    int number = int(listed_cells[cut ? first + all - 1 - place : first + place]);
#else
    int number = gl_VertexID / most;
#endif
    ivec2 cell = ivec2(number % row, number / row), layers = ivec2(volume_map.x, volume_cells.x);
    ivec2 triangulated = volumeTriangulated(layers, cell, cut ? volumeCrossed(layers, cell) : 0);
    int corner = gl_VertexID % most;
    return volumeCorner(layers, cell, triangulated, corner < 3 * VOLUME_TRIANGLES[triangulated.x]
        ? corner : 0);
}
#endif

void main()
{
    bool stretched = volume_map.w > 0.0;
#ifdef CAP
    int corner = gl_VertexID % 3;
    ivec2 texel = volumeBorder(gl_VertexID / 3 + 2 - corner);
    gl_Position = volumePoint(corner == 0 ? vec2(0.0) : volumePlace(texel, volume_map.y, stretched),
        0.0);
#elif defined CELLS
    vec3 vertex = volumeVertex();
    gl_Position = volumePoint(volumePlace(vertex.xy, volume_map.y, stretched), vertex.z);
#elif defined CORNERS
    const ivec2 corners[4] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 1));
    int edge = 2 * (int(volume_map.y) - 1);
    ivec2 texel = ivec2(gl_VertexID % edge, gl_VertexID / edge), within = texel % 2;
    int corner = (within.y == 0 ? within.x : 3 - within.x) + int(floatBitsToInt(volume_depth) < 0);
    gl_Position = volumePoint(volumePlace(texel / 2 + corners[corner % 4], volume_map.y, stretched),
        abs(volume_depth));
#elif defined QUADS
    const ivec2 corners[4] = ivec2[](ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 1));
    int quad = gl_VertexID / 4, row = int(volume_map.y) - 1;
    ivec2 first = ivec2(quad % row, quad / row);
    vec4 depths;
    for (int i = 0; i < 4; i++)
        depths[i] = volumeDepth(first + corners[i]);
    int corner = (gl_VertexID + int(volumeTurned(depths))) % 4;
    gl_Position = volumePoint(volumePlace(first + corners[corner], volume_map.y, stretched),
        depths[corner]);
#else
    int size = int(volume_map.y);
    ivec2 texel = ivec2(gl_VertexID % size, gl_VertexID / size);
#ifdef DEPTHS
    gl_Position = volumePoint(volumePlace(texel, volume_map.y, stretched), volume_depth);
#else
    gl_Position = volumePoint(volumePlace(texel, volume_map.y, stretched), volumeDepth(texel));
#endif
#endif
}
