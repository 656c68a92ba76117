// Nodes of the radiance cache (radiance.h), for passes with one invocation per node. A node has
// LISTS_STRIDE words and RADIANCE_TEXELS texels.
layout(local_size_x = 64) in;
layout(std430, binding = 2) readonly buffer RadianceFaces {
#include "radiance.layout.def"
};
layout(std430, binding = 4) readonly buffer RadianceNodes {
    uint radiance_nodes[];
};
layout(std430, binding = 5) buffer RadianceTexels {
    vec4 radiance_texels[];
};

// bit of a node's first word: its surface belongs to a closed mesh
const uint RADIANCE_BODY = 0x80000000u;
// bits of a node's first word: the voxel times 8, plus the side
const uint RADIANCE_PLACE = 0x3FFFFFFFu;

uint radianceNumber()
{
    return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u +
        gl_LocalInvocationIndex;
}

// Returns the position of a node in voxels, `size` along an edge: on the line along the node's axis
// through the voxel's center, at the stored depth.
vec3 radiancePlace(uint node, int size)
{
    int voxel = int((radiance_nodes[node] & RADIANCE_PLACE) >> 3),
        side = int(radiance_nodes[node] & 7u);
    float depth = uintBitsToFloat(0x3F800001u - radiance_nodes[node + 1u]);
    vec3 place = vec3(voxel % size, voxel / size % size, voxel / size / size) + 0.5;
    place[side >> 1] = ((side & 1) == 1 ? 1.0 - depth : depth) * float(size);
    return place;
}
