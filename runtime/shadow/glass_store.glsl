// End of a fragment program that computes a surface's transmittance, for a shadow map: appends a
// node to its texel's list. The depth test has rejected fragments behind opaque casters; fully
// transparent ones are not stored. The buffer holds the heads of all texels, 0 or 1 + the number of
// a node, followed by the nodes: the next node, the depth, and the transmittance in three
// components of 21 bits, with an error of at most 2.4e-7.
layout(early_fragment_tests) in;
uniform int glass_map;

layout(std430, binding = 3) buffer Glass {
#include "shadow_glass.layout.def"
    uint glass_words[];
};
#define glass_part uvec4(glass_column, glass_row, glass_columns, glass_rows)

const uint GLASS_MAX = 0x80000000u; // counting stops here, so that the number cannot overflow

void main()
{
    if (glass_count >= GLASS_MAX) return;
    surfaceMain();
    uvec3 through = uvec3(clamp(fragment0.xyz, 0.0, 1.0) * 2097151.0 + 0.5);
    if (through == uvec3(2097151u)) return;
    uint number = atomicAdd(glass_count, 1u);
    if (number >= glass_capacity) return;
    uvec2 place = uvec2(gl_FragCoord.x, uint(glass_map) * glass_size + uint(gl_FragCoord.y)) -
        glass_part.xy;
    uint head = place.y * glass_part.z + place.x, at = glass_heads + number * 4u;
    glass_words[at] = atomicExchange(glass_words[head], number + 1u);
    glass_words[at + 1u] = floatBitsToUint(gl_FragCoord.z);
    glass_words[at + 2u] = through.x | through.y << 21;
    glass_words[at + 3u] = through.y >> 11 | through.z << 10;
}
