// Lists of exact shadows: converts the number of entries of each cell to the offset of its list, by
// prefix sums. Lists are stored in an arbitrary order: a workgroup of 256 cells allocates space for
// all of its lists at once.
//
//  cells with 2, 0, 3 entries, space from word 40 on: they begin at 40, 42, 42, and the next group
//  at 45
layout(local_size_x = 256) in;

#include "exact_lists.layout.def"

layout(std430, binding = 5) buffer ExactWork {
#include "exact_work.layout.def"
};
layout(std430, binding = 7) buffer ExactLists {
    uint exact_words[];
};

shared uint group_sums[256], group_begin;

// Returns the inclusive prefix sum over the workgroup's threads.
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
    for (uint group = gl_WorkGroupID.x * 256u; group < exact_cells;
        group += gl_NumWorkGroups.x * 256u) {
        uint at = first + 2u * (group + thread), own = group + thread < exact_cells
            ? exact_words[at + 1u] : 0u;
        uint sum = sumUpTo(thread, own);
        if (thread == 255u) group_begin = atomicAdd(exact_next, sum);
        if (own > exact_longest) atomicMax(exact_longest, own);
        barrier();
        if (group + thread < exact_cells)
            exact_words[at] = exact_words[at + 1u] = group_begin + sum - own;
        barrier();
    }
}
