// Lists a view's cells: those without crossings from the beginning on, two triangles each; the
// others from the end backwards, VOLUME_MAX triangles each. For parallel light, cells without
// depth are omitted: their corners coincide at infinity.
layout(local_size_x = 8, local_size_y = 8) in;
struct Command { // draw command: vertices, instances, first vertex and instance
    uint count, instances, first, base;
};
layout(std430, binding = 0) writeonly buffer Cells { uint listed_cells[]; };
layout(std430, binding = 1) buffer Commands { Command commands[]; }; // two draw commands per view
// xyz: the map's two layers, its index among hybrid views; w 1: parallel light
uniform vec4 volume_listed;

void main()
{
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy), layers = ivec2(volume_listed.xy);
    int row = textureSize(volume_depths, 0).x - 1, all = row * row, number = int(volume_listed.z);
    if (any(greaterThanEqual(cell, ivec2(row)))) return;
    bool cut = volumeCrossed(layers, cell) != 0;
    if (!cut && volume_listed.w > 0.0 && volumeQuad(layers, cell) == vec4(0.0)) return;
    uint vertices = cut ? 3u * uint(VOLUME_MAX) : 6u;
    int place = int(atomicAdd(commands[2 * number + int(cut)].count, vertices) / vertices);
    listed_cells[cut ? (number + 1) * all - 1 - place : number * all + place] =
        uint(cell.y * row + cell.x);
}
