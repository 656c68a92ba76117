// Lists a view's cells: those that no silhouette crosses from the first place on, two triangles
// each; the others from the last one back, VOLUME_MOST each. Of parallel light cells without depth
// are none: all their corners are the one point where it goes.
layout(local_size_x = 8, local_size_y = 8) in;
struct Command { // of a draw: vertices, instances, first vertex and instance
    uint count, instances, first, base;
};
layout(std430, binding = 0) writeonly buffer Cells { uint listed_cells[]; };
layout(std430, binding = 1) buffer Commands { Command commands[]; }; // two for each view
uniform vec4 volume_listed; // the maps' layers, the view among those that are volumes, 1: of parallel light

void main()
{
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy), layers = ivec2(volume_listed.xy);
    int row = textureSize(volume_depths, 0).x - 1, all = row * row, number = int(volume_listed.z);
    if (any(greaterThanEqual(cell, ivec2(row)))) return;
    bool cut = volumeCrossed(layers, cell) != 0;
    if (!cut && volume_listed.w > 0.0 && volumeQuad(layers, cell) == vec4(0.0)) return;
    uint vertices = cut ? 3u * uint(VOLUME_MOST) : 6u;
    int place = int(atomicAdd(commands[2 * number + int(cut)].count, vertices) / vertices);
    listed_cells[cut ? (number + 1) * all - 1 - place : number * all + place] = uint(cell.y * row + cell.x);
}
