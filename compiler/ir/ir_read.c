/* Parses the output of ir_print, so that tests can run single passes. */
#include "compiler/ir/ir.h"
#include <stdlib.h>
#include <string.h>

typedef struct {
    Ir *ir;
    const char *at;
    Ref *named; /* nodes indexed by their number in the text */
    size_t named_capacity;
    const char *fault;
} Scanner;

enum { LARGEST_NUMBER = 1 << 20, MAX_OPERANDS = 16, MAX_FUNCTIONS = 1 << 12 };

static void skip_spaces(Scanner *s)
{
    while (*s->at == ' ' || *s->at == ',' || *s->at == '(' || *s->at == ')')
        s->at++;
}

/* Reads the next word; false at the end of the line. */
static bool word(Scanner *s, char *into, size_t capacity)
{
    size_t size = 0;
    skip_spaces(s);
    while (*s->at && !strchr(" ,()\n", *s->at)) {
        if (size + 1 < capacity)
            into[size++] = *s->at;
        s->at++;
    }
    into[size] = 0;
    return size > 0;
}

static bool fail(Scanner *s, const char *fault)
{
    if (!s->fault)
        s->fault = fault;
    return false;
}

static Ref operand(Scanner *s, const char *text)
{
    char *end;
    unsigned long number = text[0] == '%' ? strtoul(text + 1, &end, 10) : LARGEST_NUMBER;
    if (number >= s->named_capacity || !s->named[number]) {
        fail(s, "an operand is not defined before its use");
        return 0;
    }
    return s->named[number];
}

static int find(const char *name, const char *(*names)(int), int count)
{
    for (int i = 0; i < count; i++)
        if (names(i) && !strcmp(names(i), name))
            return i;
    return -1;
}

static const char *op_name(int i) { return op_text((Op)i); }
static const char *type_name(int i) { return type_table[i].name; }
static const char *input_name(int i) { return input_table[i].name; }
static const char *call_name(int i) { return function_row(i)->name; }

static bool read_components(const char *text, Type type, uint32_t *payload)
{
    if (text[0] != '.' || (int)strlen(text + 1) != type_table[type].components)
        return false;
    for (int i = 0; text[i + 1]; i++) {
        const char *letter = strchr("xyzw", text[i + 1]);
        if (!letter)
            return false;
        *payload |= (uint32_t)(letter - "xyzw") << 2 * i;
    }
    return true;
}

/* Returns the payload of an argument with its set and its number in the set; -1 if out of
 * bounds. */
static int argument_payload(int set, int number)
{
    return set >= 0 && set < LARGEST_NUMBER && number >= 0 && number < 256 ? set << 8 | number : -1;
}

/* Returns the number, or -1 if the function has not been defined yet. */
static int defined_function(const Scanner *s, int number)
{
    bool known =
        number >= 0 && (size_t)number < s->ir->function_count && s->ir->functions[number].result;
    return known ? number : -1;
}

/* Parses an attribute of the graph, "wetness" or "wetness.byX"; -1 if unknown. */
static int attribute_payload(const Graph *graph, const char *text)
{
    char name[LIMIT_NAME + 8];
    const size_t size = strcspn(text, ".");
    memcpy(name, text, size);
    name[size] = 0;
    const int found = names_find(&graph->attribute_names, name);
    const AttributePart part = !text[size]                   ? ATTRIBUTE_value
                               : strcmp(text + size, ".byX") ? ATTRIBUTE_by_y
                                                             : ATTRIBUTE_by_x;
    return found < 0 ? -1 : found * ATTRIBUTE_PARTS + (int)part;
}

/* Returns the payload that a word names; -1 if the word is unknown. */
static int named_payload(const Scanner *s, Payload kind, Type type, const char *text)
{
    uint32_t components = 0;
    switch (kind) {
    case PAYLOAD_input:
        return find(text, input_name, INPUT_COUNT);
    case PAYLOAD_attribute:
        return attribute_payload(s->ir->graph, text);
    case PAYLOAD_uniform:
        return names_find(&s->ir->graph->uniform_names, text);
    case PAYLOAD_argument:
        return strchr(text, '.') ? argument_payload(atoi(text), atoi(strchr(text, '.') + 1)) : -1;
    case PAYLOAD_texture:
        return atoi(text);
    case PAYLOAD_components:
        return read_components(text, type, &components) ? (int)components : -1;
    case PAYLOAD_library:
        return find(text, call_name, FUNCTION_COUNT);
    case PAYLOAD_function:
        return text[0] == 'f' ? defined_function(s, atoi(text + 1)) : -1;
    default:
        return -1;
    }
}

static bool read_payload(Scanner *s, Op op, Type type, uint32_t *payload)
{
    char text[LIMIT_NAME + 8];
    if (op_payload[op] == PAYLOAD_none)
        return true;
    if (!word(s, text, sizeof text))
        return fail(s, "a node ends too early");
    int found = named_payload(s, (Payload)op_payload[op], type, text);
    *payload = (uint32_t)found;
    return found >= 0 || fail(s, "a node names what does not exist");
}

/* Reads a literal, or a constant of the uniform block; each of the latter is separate. */
static Ref read_const(Scanner *s, Op op, Type type)
{
    double components[4] = {0};
    char text[LIMIT_NAME];
    for (int i = 0; i < type_table[type].components; i++)
        if (!word(s, text, sizeof text) || !text_number(text, strlen(text), &components[i]) ||
            components[i] - components[i] != 0) {
            fail(s, "a constant lacks a number");
            return 0;
        }
    return op_payload[op] == PAYLOAD_numbers ? ir_const(s->ir, type, components)
                                             : ir_constant(s->ir, type, components, NULL);
}

static Ref read_node(Scanner *s)
{
    char text[LIMIT_NAME];
    Ref args[MAX_OPERANDS];
    int op = word(s, text, sizeof text) ? find(text, op_name, OP_COUNT) : -1, count = 0;
    int type = word(s, text, sizeof text) ? find(text, type_name, TYPE_COUNT) : -1;
    uint32_t payload = 0;
    if (op < 0 || type < 0) {
        fail(s, "no such operation or type");
        return 0;
    }
    if (op_payload[op] == PAYLOAD_numbers || op_payload[op] == PAYLOAD_member)
        return read_const(s, (Op)op, (Type)type);
    if (!read_payload(s, (Op)op, (Type)type, &payload))
        return 0;
    while (count < MAX_OPERANDS && word(s, text, sizeof text))
        if (!(args[count++] = operand(s, text)))
            return 0;
    if (op_table[op].arity >= 0 && op_table[op].arity != count) {
        fail(s, "the wrong number of operands");
        return 0;
    }
    return ir_make(s->ir, (IrNode){.op = op, .type = type, .count = count, .payload = payload},
                   args);
}

static bool read_output(Scanner *s)
{
    char kind[16], index[16], equals[8], value[16];
    if (!word(s, kind, sizeof kind) || !word(s, index, sizeof index) ||
        !word(s, equals, sizeof equals) || !word(s, value, sizeof value) ||
        s->ir->output_count == MAX_OUTPUTS)
        return fail(s, "an output is not `out kind index = %node`");
    Ref ref = operand(s, value);
    ir_output(s->ir,
              !strcmp(kind, "color")          ? OUT_color
              : !strcmp(kind, "depth")        ? OUT_depth
              : !strcmp(kind, "displacement") ? OUT_displacement
              : !strcmp(kind, "normal")       ? OUT_normal
                                              : OUT_discard,
              atoi(index), ref);
    return ref != 0;
}

/* Allocates function fN. A function is defined after its last node, so the definitions need not
 * be in numeric order. */
static bool number_function(Scanner *s, const char *text, size_t *number)
{
    const IrFunction none = {0};
    char *end;
    *number = strtoul(text + 1, &end, 10);
    if (text[0] != 'f' || end == text + 1 || *end || *number >= MAX_FUNCTIONS)
        return false;
    while (s->ir->function_count <= *number)
        ARENA_PUSH(s->ir->arena, s->ir->functions, s->ir->function_count, s->ir->function_capacity,
                   none);
    return !s->ir->functions[*number].result;
}

/* function fN = result arguments... */
static bool read_function(Scanner *s)
{
    char text[LIMIT_NAME];
    size_t number;
    IrFunction function = {.arguments = ARENA_ARRAY(s->ir->arena, Ref, MAX_OPERANDS)};
    if (!word(s, text, sizeof text) || !number_function(s, text, &number) ||
        !word(s, text, sizeof text) || !word(s, text, sizeof text) ||
        !(function.result = operand(s, text)))
        return fail(s, "a function is not `function fN = %result %argument...`");
    while (function.count < MAX_OPERANDS && word(s, text, sizeof text))
        if (!(function.arguments[function.count++] = operand(s, text)))
            return false;
    s->ir->functions[number] = function;
    return true;
}

static bool read_line(Scanner *s)
{
    char text[LIMIT_NAME];
    if (!word(s, text, sizeof text))
        return true; /* an empty line is allowed */
    if (!strcmp(text, "out"))
        return read_output(s);
    if (!strcmp(text, "function"))
        return read_function(s);
    if (text[0] != '%')
        return fail(s, "a line is neither a node nor an output");
    unsigned long number = strtoul(text + 1, NULL, 10);
    if (number >= s->named_capacity || !word(s, text, sizeof text) || strcmp(text, "=") != 0)
        return fail(s, "a node is not `%number = operation`");
    return (s->named[number] = read_node(s)) != 0;
}

Ir *ir_read(Session *session, const char *text, const Graph *graph, const char **fault)
{
    /* upper bound of the number of nodes: each takes more than a byte */
    size_t size = strlen(text) + 1;
    Scanner s = {.ir = ir_new(session, graph),
                 .at = text,
                 .named_capacity = size < LARGEST_NUMBER ? size : LARGEST_NUMBER};
    s.named = ARENA_ARRAY(session->arena, Ref, s.named_capacity);
    while (*s.at && !s.fault) {
        if (!read_line(&s))
            break;
        while (*s.at && *s.at != '\n')
            s.at++;
        s.at += *s.at == '\n';
    }
    for (size_t i = 0; i < s.ir->function_count; i++)
        if (!s.ir->functions[i].result)
            fail(&s, "a function's number is left out");
    *fault = s.fault;
    return s.fault ? NULL : s.ir;
}
