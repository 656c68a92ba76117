// The pass blend: a pixel's transparent fragments, out of its list, from the nearest on. Before it stand lighting.glsl, LISTS_STRIDE, and
// LISTS_TEXELS; with VEIL no light is asked for. The depth is reversed: what is nearer is greater.
layout(std430, binding = 2) readonly buffer Lists {
    uint lists_width;
    uint lists_pixels;
    uint lists_room;
    uint lists_count;
    uint lists_words[];
};

#define LISTS_WORD(word) lists_words[node + uint(word)]

uint nodeAt(uint number)
{
    return lists_pixels + (number - 1u) * LISTS_STRIDE;
}

// Whether the fragment a is in front of b. At one depth their contents decide, so that the order in which they were appended, which a GPU is
// free to choose, does not; where these are equal too, either order gives the same picture.
bool isBefore(uint a, uint b)
{
    for (uint word = 1u; word < LISTS_STRIDE; word++)
        if (lists_words[a + word] != lists_words[b + word]) return lists_words[a + word] > lists_words[b + word];
    return a < b;
}

// The first fragment behind `last`, a node, of all of a list: 0, there is none. Looks at each of them, so a pixel of n fragments takes n^2 / 2 steps
// and no memory.
uint nextFragment(uint list, uint last)
{
    uint nearest = 0u;
    for (uint number = list; number != 0u; number = lists_words[nodeAt(number)]) {
        uint node = nodeAt(number);
        if ((last == 0u || isBefore(last, node)) && (nearest == 0u || isBefore(node, nearest))) nearest = node;
    }
    return nearest;
}

vec3 passOver(ivec2 pixel, out vec3 through)
{
    vec3 sum = vec3(0.0);
    uint list = lists_words[uint(pixel.y) * lists_width + uint(pixel.x)];
    through = vec3(1.0);
    for (uint node = nextFragment(list, 0u); node != 0u; node = nextFragment(list, node)) {
        Surface surface = unpackTexels(LISTS_TEXELS);
#ifndef VEIL
        sum += through * lightOf(pixel, uintBitsToFloat(lists_words[node + 1u]), surface);
#endif
        through *= surfaceThrough(surface);
    }
    return sum;
}
