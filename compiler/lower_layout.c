/* The G-buffer: every slot of a layout, encoded, in its place of a render target. */
#include "layout.h"
#include "lower.h"
#include <string.h>

static const double greatest_half = 65504;

/* The slot as the G-buffer wants it: its normal is in eye space. */
static Ref stored_slot(Lower *l, const Node *material, Slot slot, const Env *env)
{
    return slot == SLOT_normal ? lower_eye_normal(l, material, env) : lower_slot(l, material, slot, env);
}

static Ref one_lane(Lower *l, const Node *material, SlotLane source, const Env *env)
{
    return ir_swizzle_lanes(l->ir, stored_slot(l, material, source.slot, env), (uint32_t)source.lane, 1);
}

/* Lanes of one slot side by side are a swizzle of it, others are put together. */
static Ref source_value(Lower *l, const Piece *piece, const Node *material, const Env *env)
{
    static const Type types[] = {TYPE_float, TYPE_float, TYPE_vec2, TYPE_vec3, TYPE_vec4};
    const SlotLane *source = &piece->field->source[piece->first];
    Ref lanes[FIELD_LANES];
    if (piece_is_slot(piece))
        return stored_slot(l, material, source[0].slot, env);
    for (int i = 0; i < piece->count; i++)
        lanes[i] = one_lane(l, material, source[i], env);
    return piece->count == 1 ? lanes[0] : ir_vec(l->ir, types[piece->count], lanes, piece->count);
}

static Ref piece_value(Lower *l, const Piece *piece, const Node *material, const Env *env)
{
    int pack = encoding_table[piece->field->encoding].pack;
    bool bits = piece_takes_bits(piece);
    Ref args[] = {source_value(l, piece, material, env), bits ? ir_int(l->ir, piece->field->bits) : 0};
    if (pack == FN_none)
        return ir_ternary(l->ir, OP_clamp, args[0], number(l, -greatest_half), number(l, greatest_half));
    return ir_call(l->ir, pack, args, bits ? 2 : 1);
}

/* The pieces of a lane, each at its shift. */
static Ref word_value(Lower *l, const Placement *placement, int target, int lane, const Node *material, const Env *env)
{
    Ref word = 0;
    for (int i = 0; i < placement->count; i++) {
        const Piece *piece = &placement->pieces[i];
        if (piece->target != target || piece->lane != lane)
            continue;
        Ref code = piece_value(l, piece, material, env);
        if (piece->shift)
            code = ir_binary(l->ir, OP_shift, code, ir_int(l->ir, piece->shift));
        word = word ? ir_binary(l->ir, OP_join, word, code) : code;
    }
    return word ? word : ir_const(l->ir, TYPE_uint, (double[]){0});
}

static Ref words_value(Lower *l, const Placement *placement, int target, const Node *material, const Env *env)
{
    Ref words[FIELD_LANES];
    for (int lane = 0; lane < FIELD_LANES; lane++)
        words[lane] = word_value(l, placement, target, lane, material, env);
    return ir_vec(l->ir, TYPE_uvec4, words, FIELD_LANES);
}

static const Piece *piece_at(const Placement *placement, int target, int lane)
{
    for (int i = 0; i < placement->count; i++)
        if (placement->pieces[i].target == target && placement->pieces[i].lane == lane)
            return &placement->pieces[i];
    return NULL;
}

/* The pieces of a float target side by side. */
static Ref floats_value(Lower *l, const Placement *placement, int target, const Node *material, const Env *env)
{
    Ref parts[FIELD_LANES];
    int count = 0;
    for (int lane = 0; lane < FIELD_LANES;) {
        const Piece *piece = piece_at(placement, target, lane);
        parts[count++] = piece ? piece_value(l, piece, material, env) : number(l, 0);
        lane += piece ? piece->size : 1;
    }
    return count == 1 ? parts[0] : ir_vec(l->ir, TYPE_vec4, parts, count);
}

/* A layout that the target's GLSL cannot write, or whose fields do not fit in, is refused. */
static bool place(Lower *l, Placement *placement)
{
    const LayoutRow *row = l->job->layout;
    const FieldRow *fault = layout_place(row, placement);
    if (fault)
        diag_add(l->c, NO_SPAN, DIAG_layout_full, row->name, encoding_table[fault->encoding].name,
                 slot_table[fault->source[0].slot].name);
    if (!fault && l->job->target == TARGET_glsl110 && layout_has_words(row))
        diag_add(l->c, NO_SPAN, DIAG_layout_words, row->name, target_table[l->job->target].name);
    return !l->c->diags.errors;
}

void lower_layout(Lower *l, const Node *material, const Env *env)
{
    Placement placement;
    if (!place(l, &placement)) {
        l->failed = true;
        return;
    }
    for (int target = 0; target < placement.targets; target++) {
        bool words = format_table[l->job->layout->formats[target]].words;
        ir_output(l->ir, OUT_color, target,
                  words ? words_value(l, &placement, target, material, env)
                        : floats_value(l, &placement, target, material, env));
    }
}
