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

// The first fragment behind `last`, a node, of all of a list: 0, there is none. For pixels with fragments at one depth: n of them take n^2 steps.
uint nextFragment(uint list, uint last)
{
    uint nearest = 0u;
    for (uint number = list; number != 0u; number = lists_words[nodeAt(number)]) {
        uint node = nodeAt(number);
        if ((last == 0u || isBefore(last, node)) && (nearest == 0u || isBefore(node, nearest))) nearest = node;
    }
    return nearest;
}

// The nearest fragments of a list that are behind some depth, sorted: depth, as bits, which are ordered as depths are, and node. A place that is
// not taken is 0. No index but constants, so that they stay in registers: NEAREST steps for each fragment of a list, and a walk along it for
// each NEAREST of them.
// Worked example, NEAREST 3, depths 5 9 7 8 inserted: 5 - -, 9 5 -, 9 7 5, 9 8 7; the next walk, behind 7, has 5 - -.
const int NEAREST = 16;
struct Nearest {
    uvec2 at[NEAREST];
    bool tied; // two of one depth: their order is another's to find
};

Nearest nearestBehind(uint list, uint behind)
{
    Nearest found;
    found.tied = false;
    for (int i = 0; i < NEAREST; i++) found.at[i] = uvec2(0u);
    for (uint number = list; number != 0u;) {
        uint node = nodeAt(number);
        uvec2 moved = uvec2(lists_words[node + 1u], node);
        number = lists_words[node];
        if (moved.x >= behind) continue;
        for (int i = 0; i < NEAREST; i++) {
            uvec2 held = found.at[i];
            bool nearer = moved.x > held.x;
            found.tied = found.tied || (moved.x == held.x && moved.x != 0u);
            found.at[i] = nearer ? moved : held;
            moved = nearer ? held : moved;
        }
    }
    return found;
}

vec3 passOver(ivec2 pixel, out vec3 through)
{
    vec3 sum = vec3(0.0);
    uint list = lists_words[uint(pixel.y) * lists_width + uint(pixel.x)];
    through = vec3(1.0);
    if (list == 0u) return sum;
    Nearest near = nearestBehind(list, 0xFFFFFFFFu);
    int left = NEAREST;
    uint node = near.tied ? nextFragment(list, 0u) : near.at[0].y;
    while (node != 0u) {
        uint depth = lists_words[node + 1u];
        Surface surface = unpackTexels(LISTS_TEXELS);
#ifndef VEIL
        sum += through * lightOf(pixel, uintBitsToFloat(depth), surface);
#endif
        through *= surfaceThrough(surface);
        if (near.tied) {
            node = nextFragment(list, node);
            continue;
        }
        for (int i = 1; i < NEAREST; i++) near.at[i - 1] = near.at[i];
        near.at[NEAREST - 1] = uvec2(0u);
        if (--left == 0) {
            near = nearestBehind(list, depth);
            left = NEAREST;
        }
        node = near.tied ? nextFragment(list, node) : near.at[0].y;
    }
#ifndef VEIL
    through = lightOver(through);
#endif
    return sum;
}
