// Lists of exact shadows: from the number of entries of each cell to where its list begins. Lists
// lie behind each other in an order of no meaning: a group of 256 cells takes room for all of its
// own at once.
//
//     cells with 2, 0, 3 entries, room from word 40 on: they begin at 40, 42, 42, and the next
//         group at 45
layout(local_size_x = 256) in;

#include "exact_lists.layout.def"

layout(std430, binding = 5) buffer ExactWork {
#include "exact_work.layout.def"
};
layout(std430, binding = 7) buffer ExactLists {
    uint exact_words[];
};

shared uint group_sums[256], group_begin;

// The sum of what threads up to this one give.
uint sumUpTo(uint thread, uint own)
{
    group_sums[thread] = own;
    for (uint step = 1u; step < 256u; step *= 2u) {
        barrier();
        uint before = thread >= step ? group_sums[thread - step] : 0u;
        barrier();
        group_sums[thread] += before;
    }
    barrier();
    return group_sums[thread];
}

void main()
{
    uint thread = gl_LocalInvocationIndex, first = exact_words[EXACT_CELLS];
    for (uint group = gl_WorkGroupID.x * 256u; group < exact_cells; group += gl_NumWorkGroups.x * 256u) {
        uint at = first + 2u * (group + thread), own = group + thread < exact_cells ? exact_words[at + 1u] : 0u;
        uint sum = sumUpTo(thread, own);
        if (thread == 255u) group_begin = atomicAdd(exact_next, sum);
        if (own > exact_longest) atomicMax(exact_longest, own);
        barrier();
        if (group + thread < exact_cells) exact_words[at] = exact_words[at + 1u] = group_begin + sum - own;
        barrier();
    }
}
