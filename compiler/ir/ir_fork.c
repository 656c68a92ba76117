/* Forks an IR: a copy to which nodes can be added without a change of the original. A second
 * program that shares most of its nodes with the first is built in the fork.
 *
 *     original                           mix(black, white, mean)
 *     added to the fork                  select(point, white, black), which finds black and white
 *     left unused in the fork            mean */
#include "compiler/ir/ir.h"

#define COPY(list, count, room)                                                                    \
    copy->list = arena_copy(arena, ir->list, ir->count, ir->room, sizeof *ir->list)

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
    copy->held_room = 0;
    COPY(nodes, count, room);
    COPY(args, arg_count, arg_room);
    COPY(numbers, number_count, number_room);
    COPY(functions, function_count, function_room);
    COPY(textures, texture_count, texture_room);
    COPY(constants, constant_count, constant_room);
    COPY(maps, map_count, map_room);
    COPY(function_of, function_of_room, function_of_room);
    copy->table =
        arena_copy(arena, ir->table, ir->mask + (size_t)1, ir->mask + (size_t)1, sizeof *ir->table);
    copy->texture_index = hash_index_copy(arena, &ir->texture_index);
    copy->constant_index = hash_index_copy(arena, &ir->constant_index);
    copy->map_index = hash_index_copy(arena, &ir->map_index);
    return copy;
}
