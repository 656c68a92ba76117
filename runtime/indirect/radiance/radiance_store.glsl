// End of an opaque material's program that is drawn along an axis: a fragment becomes a node of the
// radiance cache (radiance.h). Three runs: mark the sides of each voxel that have a fragment; find
// the nearest fragment of each node; store its surface.
layout(std430, binding = 2) buffer RadianceFaces {
#include "radiance.layout.def"
    uint radiance_faces[];
};
layout(std430, binding = 4) buffer RadianceNodes {
    uint radiance_nodes[];
};
uniform int radiance_step; // number of the run, 0 to 2
uniform int radiance_side; // twice the axis; plus 1 if viewed from the axis' upper end
uniform int radiance_size; // voxels along an edge
uniform bool radiance_body; // the mesh is closed and fills voxels

// minuend for the bits of a depth in [0, 1]: the difference is > 0, and larger is nearer
const uint RADIANCE_NEAREST = 0x3F800001u;
const uint RADIANCE_KEPT = 0x40000000u; // bit of a node's first word: its surface is stored

void main()
{
    float depth = clamp(gl_FragCoord.z, 0.0, 1.0), along = (radiance_side & 1) == 1 ? 1.0 - depth
        : depth;
    ivec3 seen = clamp(ivec3(gl_FragCoord.xy, along * float(radiance_size)), 0, radiance_size - 1);
    ivec3 at = radiance_side < 2 ? seen.zxy : radiance_side < 4 ? seen.yzx : seen;
    uint voxel = uint((at.z * radiance_size + at.y) * radiance_size + at.x),
        side = 1u << uint(radiance_side);
    if (radiance_step == 0) {
        atomicOr(radiance_faces[voxel], side);
        return;
    }
    // every fragment calls surfaceMain(), since it takes derivatives
    if (radiance_step == 2) surfaceMain();
    uint word = radiance_faces[voxel], nearness = RADIANCE_NEAREST - floatBitsToUint(depth);
    uint node = ((word >> 6) + uint(bitCount(word & 63u & (side - 1u)))) * LISTS_STRIDE;
    if (radiance_step == 1) {
        atomicMax(radiance_nodes[node + 1u], nearness);
        return;
    }
    if (radiance_nodes[node + 1u] != nearness) return;
    // If several fragments have the same depth, only the first is stored: a mix of words from two
    // would be no valid surface.
    uint place = voxel << 3 | uint(radiance_side);
    if (atomicCompSwap(radiance_nodes[node], place,
        place | RADIANCE_KEPT | uint(radiance_body) << 31) != place)
        return;
    uint packed_words[] = uint[](LISTS_PACK);
    for (int i = 0; i < packed_words.length(); i++)
        radiance_nodes[node + 2u + uint(i)] = packed_words[i];
}
