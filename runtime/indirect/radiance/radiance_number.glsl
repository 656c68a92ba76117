// Numbers the nodes of each voxel consecutively. Voxels whose nodes do not fit are still counted.
layout(local_size_x = 64) in;
layout(std430, binding = 2) buffer RadianceFaces {
#include "radiance.layout.def"
    uint radiance_faces[];
};
layout(std430, binding = 4) buffer RadianceNodes {
    uint radiance_nodes[];
};
uniform int radiance_size, radiance_stride;

void main()
{
    uint voxel = (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u +
        gl_LocalInvocationIndex;
    if (voxel >= uint(radiance_size * radiance_size * radiance_size)) return;
    uint sides = radiance_faces[voxel] & 63u, count = uint(bitCount(sides));
    if (sides == 0u) return;
    uint node = atomicAdd(radiance_count, count);
    radiance_faces[voxel] = sides;
    if (node + count > radiance_capacity) return;
    radiance_faces[voxel] = node << 6 | sides;
    for (; sides != 0u; sides &= sides - 1u, node++) {
        radiance_nodes[node * uint(radiance_stride)] = voxel << 3 | uint(findLSB(sides));
        radiance_nodes[node * uint(radiance_stride) + 1u] = 0u;
    }
}
