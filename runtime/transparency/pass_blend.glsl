// The pass blend: composites a pixel's transparent fragments from its list, nearest first. Follows
// lighting.glsl, LISTS_STRIDE, and LISTS_TEXELS; with VEIL no light is computed. The depth is
// reversed: nearer is greater.
layout(std430, binding = 2) buffer Lists {
#include "lists.layout.def"
    uint lists_words[];
};

#define LISTS_WORD(word) lists_words[node + uint(word)]

uint nodeAt(uint number)
{
    return lists_pixels + (number - 1u) * LISTS_STRIDE;
}

// Returns a fragment of a list: its depth, as bits, which are ordered like depths; its node; its
// number. 0: end of the list.
uvec3 fragmentAt(uint number)
{
    uint node = number == 0u ? 0u : nodeAt(number);
    return uvec3(number == 0u ? 0u : lists_words[node + 1u], node, number);
}

// Returns true if a is in front of b. At equal depth the contents decide, so that the result does
// not depend on the order of insertion, which a GPU is free to choose; if these are equal too, both
// orders give the same picture.
bool isBefore(uvec3 a, uvec3 b)
{
    for (uint word = 2u; a.x == b.x && word < LISTS_STRIDE; word++) {
        a.x = lists_words[a.y + word];
        b.x = lists_words[b.y + word];
    }
    return a.x != b.x ? a.x > b.x : a.y < b.y;
}

// Returns true if a list is sorted. Surfaces are drawn from the farthest on (gpu_scene_view.c), and
// the last inserted fragment is the first of its list: so most lists are sorted already.
bool isSorted(uint list)
{
    bool sorted = true;
    uvec3 before = fragmentAt(list);
    while (sorted && before.z != 0u) {
        uvec3 next = fragmentAt(lists_words[before.y]);
        sorted = next.z == 0u || isBefore(before, next);
        before = next;
    }
    return sorted;
}

// Links a fragment after `last`, a node; 0: the fragment is the first.
void link(uvec3 fragment, inout uint first, inout uint last)
{
    if (last == 0u)
        first = fragment.z;
    else
        lists_words[last] = fragment.z;
    last = fragment.y;
}

// Merges the first run of a list, fragments that are in order, with the second, the third with the
// fourth, and so on, by relinking. Returns the first fragment's number and the number of remaining
// runs.
uint mergedRuns(uint list, out uint runs)
{
    uint first = 0u, last = 0u, rest = list;
    for (runs = 0u; rest != 0u; runs++) {
        uvec3 a = fragmentAt(rest), b = fragmentAt(lists_words[a.y]), end = a;
        uint as = 1u;
        for (; b.z != 0u && isBefore(end, b); as++) {
            end = b;
            b = fragmentAt(lists_words[b.y]);
        }
        if (b.z == 0u) { // keeps the last run, which has no partner
            link(a, first, last);
            last = end.y;
            as = 0u;
        }
        bool hasB = b.z != 0u;
        while (as > 0u || hasB) {
            bool isA = as > 0u && (!hasB || isBefore(a, b));
            uvec3 taken = isA ? a : b, next = fragmentAt(lists_words[taken.y]);
            link(taken, first, last);
            hasB = hasB && (isA || (next.z != 0u && isBefore(b, next)));
            a = isA ? next : a;
            b = isA ? b : next;
            as -= uint(isA);
        }
        rest = b.z;
    }
    lists_words[last] = 0u;
    return first;
}

// Sorts a list by merge sort: each round halves the number of runs. In any order, n fragments take
// n log2 n steps and no memory. Terminates also in helper invocations, whose writes are discarded.
// Worked example: depths 9 5 7 8 2, runs 9 5, 7, 8 2; then 9 7 5, 8 2; then 9 8 7 5 2.
uint sortedList(uint list)
{
    uint runs = isSorted(list) ? 1u : 2u;
    for (int i = 0; runs > 1u && i < 32; i++) list = mergedRuns(list, runs);
    return list;
}

vec3 passOver(ivec2 pixel, out vec3 through)
{
    vec3 sum = vec3(0.0);
    uint head = uint(pixel.y) * lists_width + uint(pixel.x), number = lists_words[head];
    through = vec3(1.0);
    if (number == 0u) return sum;
    number = sortedList(number);
    lists_words[head] = number;
    while (number != 0u) {
        uint node = nodeAt(number);
        Surface surface = unpackTexels(LISTS_TEXELS);
#ifndef VEIL
        sum += through * lightOf(pixel, uintBitsToFloat(lists_words[node + 1u]), surface);
#endif
        through *= surfaceThrough(surface, lightToEye(pixel));
        number = lists_words[node];
    }
#ifndef VEIL
    through = lightOver(through);
#endif
    return sum;
}
