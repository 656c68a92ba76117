// End of a transparent material's fragment program for lists: appends the fragment to its pixel's
// list. transparency.c has the preceding text.
uniform sampler2D lists_depth; // depth of opaque surfaces

// The heads of all pixels, 0 or 1 + the number of a node, are followed by the nodes: the next node,
// the depth, the packed surface.
layout(std430, binding = 2) buffer Lists {
#include "lists.layout.def"
    uint lists_words[];
};

void main()
{
    surfaceMain();
    bool hidden = depthHidden(FRAGMENT_DEPTH, texelFetch(lists_depth, ivec2(gl_FragCoord.xy), 0).x);
    // returns only now, since neighboring pixels need the derivatives
    if (surface_gone || hidden) return;
    uint number = atomicAdd(lists_count, 1u);
    if (number >= lists_capacity) return;
    uint at = lists_pixels + number * LISTS_STRIDE;
    uint packed_words[] = uint[](LISTS_PACK);
    lists_words[at] =
        atomicExchange(lists_words[uint(gl_FragCoord.y) * lists_width + uint(gl_FragCoord.x)],
        number + 1u);
    lists_words[at + 1u] = floatBitsToUint(FRAGMENT_DEPTH);
    for (int i = 0; i < packed_words.length(); i++)
        lists_words[at + 2u + uint(i)] = packed_words[i];
}
