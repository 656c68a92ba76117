/* Forks an IR: a copy to which nodes can be added without a change of the original. A second
 * program that shares most of its nodes with the first is built in the fork.
 *
 *     original                           mix(black, white, mean)
 *     added to the fork                  select(point, white, black), which finds black and white
 *     left unused in the fork            mean */
#include "compiler/ir/ir.h"

#define COPY(list, count, capacity)                                                                \
    copy->list = arena_copy(arena, ir->list, ir->count, ir->capacity, sizeof *ir->list)

Ir *ir_fork(const Ir *ir, Session *session)
{
    Arena *arena = session->arena;
    Ir *copy = arena_copy(arena, ir, 1, 1, sizeof *ir);
    copy->session = session;
    copy->arena = arena;
    copy->scratch = copy->kept = (Arena){0};
    copy->ranges = NULL;
    copy->live = NULL;
    copy->output_count = 0;
    copy->held_capacity = 0;
    COPY(nodes, count, capacity);
    COPY(args, arg_count, arg_capacity);
    COPY(numbers, number_count, number_capacity);
    COPY(functions, function_count, function_capacity);
    COPY(textures, texture_count, texture_capacity);
    COPY(constants, constant_count, constant_capacity);
    COPY(maps, map_count, map_capacity);
    COPY(function_of, function_of_capacity, function_of_capacity);
    copy->table =
        arena_copy(arena, ir->table, ir->mask + (size_t)1, ir->mask + (size_t)1, sizeof *ir->table);
    copy->texture_index = hash_index_copy(arena, &ir->texture_index);
    copy->constant_index = hash_index_copy(arena, &ir->constant_index);
    copy->map_index = hash_index_copy(arena, &ir->map_index);
    return copy;
}
