// Nodes of cached radiance (radiance.h), for passes that have an invocation for each. LISTS_STRIDE
// words each, RADIANCE_TEXELS texels.
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

const uint RADIANCE_BODY = 0x80000000u;  // of a node's first word: it is of a body's surface
const uint RADIANCE_PLACE = 0x3FFFFFFFu; // the voxel times 8 and the side

uint radianceNumber()
{
    return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * 64u + gl_LocalInvocationIndex;
}

// In voxels, `size` along an edge: seen along an axis, through the middle of its column.
vec3 radiancePlace(uint node, int size)
{
    int voxel = int((radiance_nodes[node] & RADIANCE_PLACE) >> 3), side = int(radiance_nodes[node] & 7u);
    float depth = uintBitsToFloat(0x3F800001u - radiance_nodes[node + 1u]);
    vec3 place = vec3(voxel % size, voxel / size % size, voxel / size / size) + 0.5;
    place[side >> 1] = ((side & 1) == 1 ? 1.0 - depth : depth) * float(size);
    return place;
}
