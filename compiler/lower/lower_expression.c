/* Expression: lowers a formula's steps one after the other.
 *
 * A formula is filtered last, as a Blend is: its inputs are means already, noise fades its
 * octaves, cells fade to their mean, and all other terms are computed at the point. Where a term
 * jumps, or has an infinite slope, as a root at 0, the formula is computed at four points of the
 * pixel, its inputs extrapolated by their slopes, and the four results are averaged.
 *
 *     step(.5, u), u changes by .1 to the next pixel: at u = .47 the four points are at u -
 *     .0375, -.0125, .0125, .0375: a quarter of a 1
 *     sqrt(u) at u = 0, where the root of a negative number is 0: its mean is .236 sqrt(.1), at
 *     the point it is 0, by the four points .242 sqrt(.1) */
#include "compiler/formula/formula.h"
#include "compiler/lower/footprint.h"
#include "compiler/lower/lower_term.h"

/* Inputs of a formula as IR: at the point, or at one of the samples. */
typedef struct {
    Ref quantity[QUANTITY_COUNT];
    Ref *inputs;
    Ref attributes[LIMIT_ATTRIBUTES];
} Leaves;

/* Returns the view direction V = E.xyz - E.w P, of unit length: one formula for orthographic and
 * perspective cameras. It starts at the surface point, whatever coordinate `input` makes. Both
 * are relative to the same origin (Job.origin), which cancels here and must not be added. */
static Ref toward_viewer(Lower *l, const Env *env)
{
    Ir *ir = l->ir;
    Ref viewer = lower_query(l, NULL, GROUP_E, env), from = env->root[GROUP_P];
    Ref moved = build_mul(ir, from, build_swizzle(ir, viewer, "w"));
    return build_call(ir, FN_safeNormalize, build_sub(ir, build_swizzle(ir, viewer, "xyz"), moved));
}

static Ref quantity_at(Lower *l, const Node *input, Quantity quantity, const Env *env)
{
    const QuantityRow *row = &quantity_table[quantity];
    if (quantity == QUANTITY_V)
        return toward_viewer(l, env);
    if (quantity == QUANTITY_facing) {
        Ref n = quantity_at(l, input, QUANTITY_N, env);
        return build_min(l->ir, build_abs(l->ir, build_dot(l->ir, n, toward_viewer(l, env))),
                         build_float(l->ir, 1));
    }
    Ref group = lower_query(l, input, row->group, env);
    if (quantity == QUANTITY_N)
        group = build_call(l->ir, FN_safeNormalize, group);
    return build_swizzle(l->ir, group, row->components);
}

/* Returns a map's value in the declared number of components; one component is the color's
 * first. */
static Ref input_at(Lower *l, const Item *item, const Env *env)
{
    Ir *ir = l->ir;
    const int width = item->width ? item->width : item->input ? item->input->width : 3;
    Ref value = lower_query(l, item->input, GROUP_R, env);
    return width == 1 && ir_components(ir, value) > 1
               ? build_swizzle(ir, value, "x")
               : build_convert(ir, value, build_components_type(width));
}

static Ref list_of(Lower *l, const Formula *f, const FormulaStep *step, const Ref *refs)
{
    Ref parts[4];
    for (uint32_t i = 0; i < step->count; i++)
        parts[i] = refs[formula_argument(f, step, i)];
    if (step->count == 1 && f->steps[formula_argument(f, step, 0)].width == 1)
        return build_splat(l->ir, parts[0], build_components_type(step->width));
    return step->count == 1
               ? parts[0]
               : build_vec_of(l->ir, build_components_type(step->width), parts, (int)step->count);
}

static Ref term_of(Lower *l, const Formula *f, const FormulaStep *step, const Ref *refs)
{
    Ref args[TERM_MAX_ARGUMENTS] = {0};
    for (uint32_t i = 0; i < step->count; i++)
        args[i] = refs[formula_argument(f, step, i)];
    return lower_term(l, (Term)step->row, args);
}

static Ref step_of(Lower *l, const Formula *f, const FormulaStep *step, const Leaves *leaves,
                   const Ref *refs)
{
    Ir *ir = l->ir;
    switch (step->kind) {
    case FORMULA_number:
        return build_float(ir, step->number);
    case FORMULA_value:
        return leaves->quantity[step->row];
    case FORMULA_input:
        return leaves->inputs[step->row];
    case FORMULA_attribute:
        return leaves->attributes[step->row];
    case FORMULA_power:
        return lower_whole_power(l, refs[formula_argument(f, step, 0)], (int)step->number);
    case FORMULA_components:
        return build_components(ir, refs[formula_argument(f, step, 0)], step->row, step->width);
    case FORMULA_list:
        return list_of(l, f, step, refs);
    default:
        return term_of(l, f, step, refs);
    }
}

/* Marks the steps that the result depends on: an unused local is not computed. */
static void mark_read(const Formula *f, bool *read)
{
    read[f->result] = true;
    for (uint32_t i = f->result + 1; i-- > 0;)
        for (uint32_t k = 0; read[i] && k < f->steps[i].count; k++)
            read[formula_argument(f, &f->steps[i], k)] = true;
}

static Ref value_at(Lower *l, const Formula *f, const bool *read, const Leaves *leaves, Ref *refs)
{
    for (uint32_t i = 0; i <= f->result; i++)
        if (read[i])
            refs[i] = step_of(l, f, &f->steps[i], leaves, refs);
    return refs[f->result];
}

/* Sets the leaf's values at the samples, from its slopes. Returns false, with all values equal,
 * if the leaf is constant. */
static bool spread(Lower *l, Ref leaf, Ref at[MAX_TAPS])
{
    const bool changes = footprint_points(l, leaf, at) > 0;
    for (int i = 0; !changes && i < MAX_TAPS; i++)
        at[i] = leaf;
    return changes;
}

/* A formula, the leaves that it reads, and storage for its steps' values. */
typedef struct {
    const Formula *formula;
    const bool *read;
    Leaves leaves;
    int inputs;
    Ref *refs;
} Reading;

/* Returns the mean of the samples; 0: all samples are equal. */
static Ref sampled(Lower *l, const Reading *r)
{
    Ir *ir = l->ir;
    Leaves leaves[MAX_TAPS] = {0};
    bool changes = false;
    Ref at[MAX_TAPS], sum = 0;
    for (int i = 0; i < MAX_TAPS; i++)
        leaves[i].inputs = ARENA_ARRAY(l->session->arena, Ref, r->inputs);
    for (int q = 0; q < QUANTITY_COUNT; q++) {
        changes |= r->leaves.quantity[q] && spread(l, r->leaves.quantity[q], at);
        for (int i = 0; r->leaves.quantity[q] && i < MAX_TAPS; i++)
            leaves[i].quantity[q] = at[i];
    }
    for (int k = 0; k < LIMIT_ATTRIBUTES; k++) {
        changes |= r->leaves.attributes[k] && spread(l, r->leaves.attributes[k], at);
        for (int i = 0; r->leaves.attributes[k] && i < MAX_TAPS; i++)
            leaves[i].attributes[k] = at[i];
    }
    for (int k = 0; k < r->inputs; k++) {
        changes |= spread(l, r->leaves.inputs[k], at);
        for (int i = 0; i < MAX_TAPS; i++)
            leaves[i].inputs[k] = at[i];
    }
    for (int i = 0; changes && i < MAX_TAPS; i++) {
        Ref value = value_at(l, r->formula, r->read, &leaves[i], r->refs);
        sum = sum ? build_add(ir, sum, value) : value;
    }
    return changes ? build_scale(ir, sum, 1.0 / MAX_TAPS) : 0;
}

/* Returns an attribute of the mesh, which belongs to the shaded point, whatever coordinate
 * `input` makes. */
static Ref attribute_at(Lower *l, int number, const Env *env)
{
    const MeshAttribute *attribute = l->graph->attributes[number];
    const bool mesh = !env->shape && l->job->pass != PASS_plane && l->job->pass != PASS_sky;
    return mesh ? build_attribute(l->ir, number, ATTRIBUTE_value)
                : ir_const(l->ir, attribute->type, attribute->initial);
}

static void read_leaves(Lower *l, const Node *node, Reading *r, const Env *env)
{
    const Value *with = node_param(node, P_Expression_with);
    const Formula *f = r->formula;
    r->inputs = with->kind == VALUE_items ? with->items->count : 0;
    r->leaves.inputs = ARENA_ARRAY(l->session->arena, Ref, r->inputs);
    for (uint32_t i = 0; i <= f->result; i++) {
        const FormulaStep *step = &f->steps[i];
        if (r->read[i] && step->kind == FORMULA_value && !r->leaves.quantity[step->row])
            r->leaves.quantity[step->row] = quantity_at(
                l, lower_param_node(node, P_Expression_input), (Quantity)step->row, env);
        if (r->read[i] && step->kind == FORMULA_attribute && !r->leaves.attributes[step->row])
            r->leaves.attributes[step->row] = attribute_at(l, step->row, env);
        if (r->read[i] && step->kind == FORMULA_input && !r->leaves.inputs[step->row])
            r->leaves.inputs[step->row] = input_at(l, &with->items->item[step->row], env);
    }
}

MapValue lower_Expression(Lower *l, const Node *node, Group group, const Env *env)
{
    const Value *is = node_param(node, P_Expression_is);
    if (is->kind != VALUE_formula)
        return map_value_as_group(l, map_value_of(build_float(l->ir, 0)), group);
    const Formula *f = is->formula;
    bool *read = ARENA_ARRAY(l->session->arena, bool, f->count);
    mark_read(f, read);
    Reading r = {.formula = f, .read = read, .refs = ARENA_ARRAY(l->session->arena, Ref, f->count)};
    read_leaves(l, node, &r, env);
    Ref mean = f->jumps && footprint_is_filtered(l) ? sampled(l, &r) : 0;
    Ref value = mean ? mean : value_at(l, f, read, &r.leaves, r.refs);
    return map_value_as_group(l, map_value_of(value), group);
}
