// The end of a transparent material's fragment program, where there are lists: appends the fragment
// to its pixel's. transparency.c has what stands before it.
uniform sampler2D lists_depth; // of what is opaque

// Behind the heads of all pixels, 0 or 1 + the number of a node, lie the nodes: the next of the
// list, the depth, what is packed.
layout(std430, binding = 2) buffer Lists {
#include "lists.layout.def"
    uint lists_words[];
};

void main()
{
    surfaceMain();
    bool hidden = depthHidden(FRAGMENT_DEPTH, texelFetch(lists_depth, ivec2(gl_FragCoord.xy), 0).x);
    if (surface_gone || hidden) return; // not sooner: neighbors want its slopes
    uint number = atomicAdd(lists_count, 1u);
    if (number >= lists_room) return;
    uint at = lists_pixels + number * LISTS_STRIDE;
    uint packed_words[] = uint[](LISTS_PACK);
    lists_words[at] = atomicExchange(lists_words[uint(gl_FragCoord.y) * lists_width + uint(gl_FragCoord.x)], number + 1u);
    lists_words[at + 1u] = floatBitsToUint(FRAGMENT_DEPTH);
    for (int i = 0; i < packed_words.length(); i++) lists_words[at + 2u + uint(i)] = packed_words[i];
}
