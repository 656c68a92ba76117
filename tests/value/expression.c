/* Recursive descent parser of expressions, and their printer. */
#include "expression.h"
#include "compiler/ir/build.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MAX_ARGUMENTS = 16, LONGEST_WORD = 32 };

typedef struct {
    const char *name;
    Input input;
    int component; /* -1: all */
} Leaf;

static const Leaf leaves[] = {{"x", INPUT_X, 0},         {"y", INPUT_X, 1},  {"z", INPUT_X, 2},
                              {"v", INPUT_X, -1},        {"w", INPUT_P, -1}, {"u", INPUT_U, -1},
                              {"front", INPUT_front, -1}};
enum { LEAF_COUNT = sizeof leaves / sizeof *leaves };

static const Type type_of_components[] = {TYPE_float, TYPE_float, TYPE_vec2, TYPE_vec3, TYPE_vec4};

static Ref read(Ir *ir, const char **at);

static void skip(const char **at) { *at += strspn(*at, " "); }

static bool accept(const char **at, char letter)
{
    skip(at);
    bool found = **at == letter;
    *at += found;
    return found;
}

/* Reads "[1, 0, 0]" after its bracket. */
static Ref read_vector(Ir *ir, const char **at)
{
    double numbers[4];
    int count = 0;
    do {
        char *end;
        numbers[count++] = strtod(*at, &end);
        *at = end;
    } while (count < 4 && accept(at, ','));
    return accept(at, ']') ? ir_const(ir, type_of_components[count], numbers) : 0;
}

static Ref read_number(Ir *ir, const char **at)
{
    char *end;
    double number = strtod(*at, &end);
    *at = end;
    if (accept(at, 'i'))
        return build_int(ir, number);
    return ir_const(ir, accept(at, 'u') ? TYPE_uint : TYPE_float, &number);
}

static Ref read_leaf(Ir *ir, const char *word)
{
    for (int i = 0; i < LEAF_COUNT; i++)
        if (!strcmp(leaves[i].name, word)) {
            Ref input = build_input(ir, leaves[i].input);
            return leaves[i].component < 0 ? input
                                           : build_component(ir, input, leaves[i].component);
        }
    if (!strcmp(word, "true") || !strcmp(word, "false"))
        return build_truth(ir, !strcmp(word, "true"));
    return 0;
}

static Ref make(Ir *ir, const char *word, const Ref *args, int count)
{
    if (!strncmp(word, "vec", 3))
        return build_vec_of(ir, type_of_components[word[3] - '0'], args, count);
    for (int op = 0; op < OP_COUNT; op++)
        if (!strcmp(op_text((Op)op), word))
            return ir_make(
                ir, (IrNode){.op = op, .type = ir_type(ir, args[op == OP_select]), .count = count},
                args);
    for (int function = 0; function < FUNCTION_COUNT; function++)
        if (function_row(function)->name && !strcmp(function_row(function)->name, word))
            return build_call_of(ir, function, args, count);
    return 0;
}

static Ref read_word(Ir *ir, const char **at)
{
    char word[LONGEST_WORD];
    Ref args[MAX_ARGUMENTS];
    int size = 0, count = 0;
    while (isalnum((unsigned char)**at) && size + 1 < LONGEST_WORD)
        word[size++] = *(*at)++;
    word[size] = 0;
    if (!accept(at, '('))
        return read_leaf(ir, word);
    do {
        if (!(args[count++] = read(ir, at)))
            return 0;
    } while (count < MAX_ARGUMENTS && accept(at, ','));
    return accept(at, ')') ? make(ir, word, args, count) : 0;
}

static Ref read(Ir *ir, const char **at)
{
    skip(at);
    Ref ref = accept(at, '[')                ? read_vector(ir, at)
              : isalpha((unsigned char)**at) ? read_word(ir, at)
                                             : read_number(ir, at);
    while (ref && **at == '.') {
        char components[5] = "";
        for (int i = 0; i < 4 && strchr("xyzw", (*at)[1]) && (*at)[1]; i++)
            components[i] = *++*at;
        ++*at;
        ref = build_swizzle(ir, ref, components);
    }
    return ref;
}

Ref expression_read(Ir *ir, const char *text)
{
    Ref ref = read(ir, &text);
    return *text ? 0 : ref;
}

static void print_const(Text *out, const Ir *ir, Ref ref)
{
    int components = ir_components(ir, ref);
    const double *numbers = ir_numbers(ir, ref);
    if (ir_type(ir, ref) == TYPE_bool) {
        text_put(out, numbers[0] != 0 ? "true" : "false");
        return;
    }
    text_put(out, components > 1 ? "[" : "");
    for (int i = 0; i < components; i++)
        text_format(out, "%s%.10g", i ? ", " : "", numbers[i]);
    text_put(out, components > 1                  ? "]"
                  : ir_type(ir, ref) == TYPE_int  ? "i"
                  : ir_type(ir, ref) == TYPE_uint ? "u"
                                                  : "");
}

/* Prints an input, or a component that has a name. */
static bool print_leaf(Text *out, const Ir *ir, Ref ref)
{
    const IrNode *node = ir_at(ir, ref);
    int component = node->op == OP_swizzle && ir_components(ir, ref) == 1 ? (int)node->payload : -1;
    Ref input = component < 0 ? ref : ir_arg(ir, ref, 0);
    for (int i = 0; i < LEAF_COUNT; i++)
        if (ir_is(ir, input, OP_input) && ir_at(ir, input)->payload == leaves[i].input &&
            leaves[i].component == component) {
            text_put(out, leaves[i].name);
            return true;
        }
    return false;
}

void expression_print(Text *out, const Ir *ir, Ref ref)
{
    const IrNode *node = ir_at(ir, ref);
    if (print_leaf(out, ir, ref))
        return;
    if (node->op == OP_const) {
        print_const(out, ir, ref);
        return;
    }
    if (node->op == OP_swizzle) {
        expression_print(out, ir, ir_arg(ir, ref, 0));
        text_char(out, '.');
        for (int i = 0; i < ir_components(ir, ref); i++)
            text_char(out, "xyzw"[node->payload >> 2 * i & 3]);
        return;
    }
    text_put(out, node->op == OP_call  ? function_row((int)node->payload)->name
                  : node->op == OP_vec ? type_table[node->type].name
                                       : op_text((Op)node->op));
    for (int i = 0; i < node->count; i++) {
        text_put(out, i ? ", " : "(");
        expression_print(out, ir, ir_arg(ir, ref, i));
    }
    text_char(out, ')');
}
