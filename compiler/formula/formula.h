/* Formulas: text -> steps. The parser (formula_read.c) creates steps, operands before their
 * users. The check (formula_check.c) then resolves names and widths. Evaluation is one pass over
 * the steps, without recursion: lowering creates IR, formula_value computes in double.
 *
 *     2 * u + sin(v)    0 number 2   1 value u   2 multiply 0 1   3 value v   4 sin 3
 *                       5 add 2 4
 *     c = u * u; c + c  0 value u    1 multiply 0 0   2 add 1 1: a local is its step */
#ifndef MATC_FORMULA_H
#define MATC_FORMULA_H
#include "compiler/base/names.h"
#include "compiler/base/session.h"
#include "grammar/expression_tables.h"

typedef enum {
    FORMULA_number,     /* literal, which `number` holds */
    FORMULA_value,      /* built-in quantity; `row` is a Quantity */
    FORMULA_input,      /* input; `row` is its index */
    FORMULA_attribute,  /* mesh attribute; `row` is its index in the document */
    FORMULA_name,       /* name of a value or an input, until the check resolves it */
    FORMULA_term,       /* term applied to its arguments; `row` is a Term */
    FORMULA_power,      /* power with a literal integer exponent, which `number` holds */
    FORMULA_components, /* swizzle of `width` components; `row` has two bits per component */
    /* Vector of its arguments' components. row: the width, 0 for that of the arguments; a single
     * number is copied to all components. */
    FORMULA_list,
    FORMULA_fault, /* part with a reported syntax error */
} FormulaKind;

/* Widths of values: 1 to 4 components, or one of these. */
enum { WIDTH_condition = 0, WIDTH_unknown = -1 };

typedef struct {
    uint8_t kind; /* kind of the step, a FormulaKind */
    int8_t width;
    int row;
    uint32_t first, count; /* arguments: range of Formula.arguments, which holds step numbers */
    uint32_t start, end;   /* byte range of the name, symbol or number in the text */
    double number;
} FormulaStep;

typedef struct Formula {
    FormulaStep *steps;
    size_t count, capacity;
    uint32_t *arguments;
    size_t argument_count, argument_capacity;
    uint32_t result;
    int width;   /* width of the result, 1 to 4 */
    int inputs;  /* number of inputs in use */
    bool jumps;  /* a varying part is discontinuous or infinitely steep */
    bool varies; /* the formula reads a point or an input */
    bool meshed; /* the formula reads attributes of the mesh */
    /* set of the groups of the point's quantities that the formula reads: 1 << Group */
    unsigned groups;
} Formula;

/* A parsed attribute("wetness", float, 0). */
typedef struct {
    const char *name;
    Type type;
    double initial[4];
    uint32_t start, end; /* byte range of the name with its quotes */
} FormulaAttribute;

/* Result of a look-up of a name: the index of an input, or one of these. */
enum { FORMULA_UNKNOWN = -1, FORMULA_REPORTED = -2 };
typedef struct {
    Session *session;
    const char *text; /* the formula, zero-terminated */
    uint32_t size;
    bool srgb; /* hex colors are sRGB */
    void *user;
    /* Called for each hex color with its components before `srgb` decodes them; NULL: no calls. */
    void (*color)(void *user, uint32_t start, uint32_t end, const double *components);
    /* Returns the source span of a byte range of the text. */
    Span (*span)(void *user, uint32_t start, uint32_t end);
    /* Returns the index of an input by name, and its width; FORMULA_UNKNOWN; FORMULA_REPORTED: an
     * input with a fault that was reported. */
    int (*input)(void *user, const char *name, const FormulaStep *step, int *width);
    /* Returns the index of a mesh attribute; FORMULA_REPORTED: invalid, which was reported. */
    int (*attribute)(void *user, const FormulaAttribute *given);
    /* Names of inputs, for suggestions. */
    NameChoice names;
} FormulaSource;

/* Returns NULL after reporting faults. */
Formula *formula_read(const FormulaSource *source);
/* Resolves names and widths. Returns false after reporting faults, whose suggestions include
 * locals. formula_check.c */
bool formula_check(const FormulaSource *source, Formula *formula, const Names *locals);

/* Inputs of an evaluation, and buffers for the steps' values. formula_value.c */
typedef struct {
    /* values of the quantities, of which constants are ignored */
    double quantity[QUANTITY_COUNT][4];
    const double (*inputs)[4];
    /* values of the document's attributes; a scalar is in all components */
    const double (*attributes)[4];
    const void *noise;   /* state of the noise functions, a ReferenceContext */
    double (*values)[4]; /* buffer for formula->count values */
} FormulaPoint;
/* Evaluates a formula in double precision to formula->width components, by the VALUE lines of
 * expression.def. */
void formula_value(const Formula *formula, const FormulaPoint *point, double result[4]);

/* Returns the step number of an argument. */
static inline uint32_t formula_argument(const Formula *formula, const FormulaStep *step, uint32_t i)
{
    return formula->arguments[step->first + i];
}
/* Appends a step with these arguments. Returns its number. formula_stack.c */
uint32_t formula_add(Session *session, Formula *formula, FormulaStep step,
                     const uint32_t *arguments, uint32_t count);
#endif
