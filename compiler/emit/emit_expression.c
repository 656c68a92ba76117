/* Expressions, by the shape of an operation and its lines in ops.def. An operand is put in
 * parentheses if it binds less tightly than its position requires:
 *
 *     sub(a, sub(b, c))    a - (b - c): the right operand of - must bind more tightly than -
 *     sub(sub(a, b), c)    a - b - c */
#include "compiler/emit/emit_scope.h"
#include "compiler/emit/attribute.h"
#include <math.h>
#include <string.h>

static void put_number(Text *out, Type type, double value)
{
    if (type == TYPE_bool)
        text_put(out, value != 0 ? "true" : "false");
    else if (type == TYPE_int)
        text_int(out, (long)value);
    else if (type == TYPE_uint || type == TYPE_uvec4)
        text_format(out, "%luu", (unsigned long)value);
    else
        text_float(out, value);
}

/* Writes a scalar or vector literal. */
static void emit_constant(Text *out, const Ir *ir, Ref ref)
{
    Type type = ir_type(ir, ref);
    const double *component = ir_numbers(ir, ref);
    int components = ir_components(ir, ref);
    if (components == 1) {
        put_number(out, type, component[0]);
        return;
    }
    bool equal = true;
    for (int i = 1; i < components; i++)
        equal &= component[i] == component[0];
    text_put(out, type_table[type].name);
    text_char(out, '(');
    for (int i = 0; i < (equal ? 1 : components); i++) {
        text_put(out, i ? ", " : "");
        put_number(out, type, component[i]);
    }
    text_char(out, ')');
}

const char *emit_function_name(Session *session, const Ir *ir, int function)
{
    Text name = text_new(session->arena);
    const Node *map = ir_origin_map(ir, ir->functions[function].origin);
    text_format(&name, "%sInput%d", map ? kind_table[map->kind].function : "function", function);
    return name.at;
}

/* Writers named by the WRITE lines of ops.def; those of leaves come first. */
static void put_const(Scope *e, Text *out, Ref ref) { emit_constant(out, e->ir, ref); }

/* Writes an input. A screen-space derivative also needs the input that is differentiated. */
static void put_input(Scope *e, Text *out, Ref ref)
{
    const Input input = (Input)ir_at(e->ir, ref)->payload;
    e->interface->inputs[input] = true;
    for (int i = 0; i < change_count; i++)
        if (change_table[i].input == input)
            e->interface->inputs[change_table[i].of] = true;
    text_put(out, input_table[input].glsl);
}

static void put_attribute(Scope *e, Text *out, Ref ref)
{
    const uint32_t payload = ir_at(e->ir, ref)->payload;
    e->interface->attributes[attribute_of(payload)] = true;
    if (attribute_part(payload) != ATTRIBUTE_value)
        e->interface->attribute_changes[attribute_of(payload)] = true;
    attribute_put_name(out, e->ir->graph->attributes[attribute_of(payload)],
                       attribute_part(payload));
}

static void put_uniform(Scope *e, Text *out, Ref ref)
{
    const uint32_t uniform = ir_at(e->ir, ref)->payload;
    e->interface->uniforms[uniform] = true;
    e->interface->counts[uniform] = ir_type(e->ir, ref) == TYPE_int;
    text_put(out, e->ir->graph->uniforms[uniform]->name);
}

static void put_member(Scope *e, Text *out, Ref ref)
{
    e->interface->members = true;
    text_put(out, e->job->instances ? "matc_numbers[matc_material]." : "");
    text_put(out, e->ir->constants[ir_at(e->ir, ref)->payload].name);
}

static void put_texture(Scope *e, Text *out, Ref ref)
{
    const uint32_t texture = ir_at(e->ir, ref)->payload;
    e->interface->textures[texture] = true;
    text_put(out, emit_texture_name(e->session, e->ir, (int)texture));
}

static void put_argument(Scope *e, Text *out, Ref ref)
{
    for (int i = 0; i < e->function->count; i++)
        if (e->function->arguments[i] == ref)
            text_put(out, ir_type(e->ir, ref) == TYPE_vec3 ? "p" : "st");
}

static void put_list(Scope *e, Text *out, Ref ref)
{
    text_char(out, '(');
    for (int i = 0; i < ir_at(e->ir, ref)->count; i++) {
        text_put(out, i ? ", " : "");
        emit_expression(e, out, ir_arg(e->ir, ref, i), PRECEDENCE_any);
    }
    text_char(out, ')');
}

/* GLSL accepts a float in place of a vector in some operands of some functions; elsewhere the
 * float is converted explicitly. */
static bool may_be_float(const IrNode *node, int i, bool both_bounds)
{
    switch (node->op) {
#define NARROW(name, condition)                                                                    \
    case OP_##name:                                                                                \
        return condition;
#include "grammar/ops.def"
    default:
        return false;
    }
}

static void put_call(Scope *e, Text *out, Ref ref)
{
    const IrNode *node = ir_at(e->ir, ref);
    bool by_component = op_table[node->op].rule == RULE_widest;
    bool bounds = node->count == 3 && ir_components(e->ir, ir_arg(e->ir, ref, 1)) == 1 &&
                  ir_components(e->ir, ir_arg(e->ir, ref, 2)) == 1;
    text_put(out, op_table[node->op].glsl);
    text_char(out, '(');
    for (int i = 0; i < node->count; i++) {
        Ref arg = ir_arg(e->ir, ref, i);
        bool widen = by_component && ir_components(e->ir, arg) < ir_components(e->ir, ref) &&
                     !may_be_float(node, i, bounds);
        text_put(out, i ? ", " : "");
        if (widen) {
            text_put(out, type_table[node->type].name);
            text_char(out, '(');
        }
        emit_expression(e, out, arg, PRECEDENCE_any);
        if (widen)
            text_char(out, ')');
    }
    text_char(out, ')');
}

/* Writes vec3(a) for three equal parts; vec4(vec3(a), b) if only the first three are equal. */
static void put_vec(Scope *e, Text *out, Ref ref)
{
    const IrNode *node = ir_at(e->ir, ref);
    int components = type_table[node->type].components, equal = 1;
    while (equal < node->count && ir_arg(e->ir, ref, equal) == ir_arg(e->ir, ref, 0))
        equal++;
    bool all = equal == node->count && node->count == components,
         three = equal == 3 && components == 4 && node->count == 4;
    text_put(out, type_table[node->type].name);
    text_char(out, '(');
    for (int i = all || three ? equal - 1 : 0; i < node->count; i++) {
        text_put(out, i > (all || three ? equal - 1 : 0) ? ", " : "");
        text_put(out, three && i == 2 ? "vec3(" : "");
        emit_expression(e, out, ir_arg(e->ir, ref, i), PRECEDENCE_any);
        text_put(out, three && i == 2 ? ")" : "");
    }
    text_char(out, ')');
}

/* Writes mat3(column, column, column) * vector. */
static void put_linear(Scope *e, Text *out, Ref ref)
{
    text_format(out, "mat%d(", ir_components(e->ir, ref));
    for (int i = 1; i < ir_at(e->ir, ref)->count; i++) {
        text_put(out, i > 1 ? ", " : "");
        emit_expression(e, out, ir_arg(e->ir, ref, i), PRECEDENCE_any);
    }
    text_put(out, ") * ");
    emit_expression(e, out, ir_arg(e->ir, ref, 0), PRECEDENCE_prefix);
}

static void put_select(Scope *e, Text *out, Ref ref)
{
    emit_expression(e, out, ir_arg(e->ir, ref, 0), PRECEDENCE_or);
    text_put(out, " ? ");
    emit_expression(e, out, ir_arg(e->ir, ref, 1), PRECEDENCE_or);
    text_put(out, " : ");
    emit_expression(e, out, ir_arg(e->ir, ref, 2), PRECEDENCE_select);
}

static void put_swizzle(Scope *e, Text *out, Ref ref)
{
    const IrNode *node = ir_at(e->ir, ref);
    emit_expression(e, out, ir_arg(e->ir, ref, 0), PRECEDENCE_postfix);
    text_char(out, '.');
    for (int i = 0; i < type_table[node->type].components; i++)
        text_char(out, "xyzw"[node->payload >> 2 * i & 3]);
}

static void put_library_call(Scope *e, Text *out, Ref ref)
{
    const char *name = function_row((int)ir_at(e->ir, ref)->payload)->name;
    chunks_add(e->session, &e->interface->chunks, name, e->job);
    text_put(out, name);
    put_list(e, out, ref);
}

static void put_apply(Scope *e, Text *out, Ref ref)
{
    text_put(out, emit_function_name(e->session, e->ir, (int)ir_at(e->ir, ref)->payload));
    put_list(e, out, ref);
}

static void put_kernel_sum(Scope *e, Text *out, Ref ref)
{
    text_put(out, emit_function_name(e->session, e->ir, (int)ir_at(e->ir, ref)->payload));
    text_put(out, "Sum");
    put_list(e, out, ref);
}

static void put_special(Scope *e, Text *out, Ref ref)
{
    switch (ir_at(e->ir, ref)->op) {
#define WRITE(name, function)                                                                      \
    case OP_##name:                                                                                \
        function(e, out, ref);                                                                     \
        break;
#include "grammar/ops.def"
    default:
        break;
    }
}

static int precedence_of(const IrNode *node)
{
    switch (node->op) {
#define PRECEDENCE(name, level)                                                                    \
    case OP_##name:                                                                                \
        return PRECEDENCE_##level;
#include "grammar/ops.def"
    default:
        return PRECEDENCE_postfix;
    }
}

static void put_infix(Scope *e, Text *out, Ref ref, int own)
{
    bool mixed = own == PRECEDENCE_equal; /* a < b != c < d is legal, but unreadable */
    emit_expression(e, out, ir_arg(e->ir, ref, 0), mixed ? PRECEDENCE_add : own);
    text_char(out, ' ');
    text_put(out, op_table[ir_at(e->ir, ref)->op].glsl);
    text_char(out, ' ');
    /* left-associative: the right operand must bind more tightly */
    emit_expression(e, out, ir_arg(e->ir, ref, 1), mixed ? PRECEDENCE_add : own + 1);
}

/* Returns true for a literal written with a minus sign, including -0.0. */
static bool is_negative(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_const) && ir_components(ir, ref) == 1 &&
           signbit(ir_numbers(ir, ref)[0]);
}

static void put_operation(Scope *e, Text *out, Ref ref, int own)
{
    const IrNode *node = ir_at(e->ir, ref);
    switch (op_table[node->op].shape) {
    case SHAPE_infix:
        put_infix(e, out, ref, own);
        break;
    case SHAPE_prefix:
        text_put(out, op_table[node->op].glsl);
        /* writes `-(-x)`, never `--x`, which would be a decrement */
        emit_expression(e, out, ir_arg(e->ir, ref, 0), PRECEDENCE_postfix);
        break;
    case SHAPE_call:
        put_call(e, out, ref);
        break;
    default:
        put_special(e, out, ref);
        break;
    }
}

void emit_expression(Scope *e, Text *out, Ref ref, int precedence)
{
    if (e->names[ref]) {
        text_put(out, e->names[ref]);
        return;
    }
    int own = is_negative(e->ir, ref) ? PRECEDENCE_prefix : precedence_of(ir_at(e->ir, ref));
    bool parentheses = own < precedence;
    if (parentheses)
        text_char(out, '(');
    put_operation(e, out, ref, own);
    if (parentheses)
        text_char(out, ')');
}
