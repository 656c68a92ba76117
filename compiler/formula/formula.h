/* Formulas: text -> steps. A formula is read (formula_read.c) into steps of which operands come
 * before their users, then its names and widths are found (formula_check.c). Whoever evaluates it
 * goes through the steps once, in their order, without recursion: lowering makes IR of each,
 * formula_value numbers in double.
 *
 *     2 * u + sin(v)    0 number 2   1 value u   2 multiply 0 1   3 value v   4 sin 3   5 add 2 4
 *     c = u * u; c + c  0 value u    1 multiply 0 0   2 add 1 1: a local is its step */
#ifndef MATC_FORMULA_H
#define MATC_FORMULA_H
#include "compiler/base/names.h"
#include "compiler/base/session.h"
#include "grammar/expression_tables.h"

typedef enum {
    FORMULA_number,    /* number */
    FORMULA_value,     /* row: a Quantity */
    FORMULA_input,     /* row: which of the inputs */
    FORMULA_attribute, /* row: which of the document's attributes */
    FORMULA_name,      /* until it is checked: a value or an input */
    FORMULA_term,      /* row: a Term, of its arguments */
    FORMULA_power,     /* of its argument, with a whole number that stands there itself: number */
    FORMULA_lanes,     /* of its argument, two bits each: row; width of them */
    /* a vector of its arguments' lanes; row: so many, 0 as there are; a single number is in all of
     * them */
    FORMULA_list,
    FORMULA_fault, /* what could not be read, and was said */
} FormulaKind;

/* Widths of values: lanes 1 to 4, or one of these. */
enum { WIDTH_condition = 0, WIDTH_unknown = -1 };

typedef struct {
    uint8_t kind; /* FormulaKind */
    int8_t width;
    int row;
    uint32_t first, count; /* arguments: in Formula.arguments, numbers of steps */
    uint32_t start, end;   /* bytes of the text: the name, the symbol, the number */
    double number;
} FormulaStep;

typedef struct Formula {
    FormulaStep *steps;
    size_t count, room;
    uint32_t *arguments;
    size_t argument_count, argument_room;
    uint32_t result;
    int width;       /* of the result, 1 to 4 */
    int inputs;      /* so many are used: 0 .. inputs - 1 */
    bool jumps;      /* something in it jumps, or is steep without end, and is no constant */
    bool varies;     /* it reads a point or an input */
    bool meshed;     /* it reads attributes of the mesh */
    unsigned groups; /* 1 << Group of what it reads of a point */
} Formula;

/* attribute("wetness", float, 0), as it stands there. */
typedef struct {
    const char *name;
    Type type;
    double initial[4];
    uint32_t start, end; /* bytes of the text: the name, with its quotes */
} FormulaAttribute;

/* Meaning of a name that is not built in: the number of an input, or one of these. */
enum { FORMULA_UNKNOWN = -1, FORMULA_SAID = -2 };
typedef struct {
    Session *session;
    const char *text; /* zero-terminated */
    uint32_t size;
    bool srgb; /* colours of it are */
    void *user;
    /* Called for each hex color with its components before `srgb` decodes them; or NULL. */
    void (*color)(void *user, uint32_t start, uint32_t end, const double *lanes);
    /* Where bytes of the text stand in the source. */
    Span (*span)(void *user, uint32_t start, uint32_t end);
    /* An input by its name, and its width; FORMULA_UNKNOWN; FORMULA_SAID: it is one, and has a
     * fault that was reported. */
    int (*input)(void *user, const char *name, const FormulaStep *step, int *width);
    /* The number of an attribute of the mesh; FORMULA_SAID: it cannot be one, which was
     * reported. */
    int (*attribute)(void *user, const FormulaAttribute *given);
    /* Names of inputs, for suggestions. */
    NameChoice names;
} FormulaSource;

/* NULL: see the diagnostics. */
Formula *formula_read(const FormulaSource *source);
/* Names and widths; false and diagnostics, which propose locals, too. formula_check.c */
bool formula_check(const FormulaSource *source, Formula *formula, const Names *locals);

/* Inputs of a formula, and room for its values: so many doubles for each step. formula_value.c */
typedef struct {
    double quantity[QUANTITY_COUNT][4]; /* constants are not looked at */
    const double (*inputs)[4];
    const double (*attributes)[4]; /* the document's; a number in all lanes */
    const void *noise;             /* ReferenceContext */
    double (*values)[4];           /* room for formula->count */
} FormulaPoint;
/* The value in double precision, of formula->width lanes: the references' half of
 * expression.def. */
void formula_value(const Formula *formula, const FormulaPoint *point, double result[4]);

/* A step's argument. */
static inline uint32_t formula_argument(const Formula *formula, const FormulaStep *step, uint32_t i)
{
    return formula->arguments[step->first + i];
}
/* A new step of these arguments; its number. formula_stack.c */
uint32_t formula_add(Session *session, Formula *formula, FormulaStep step,
                     const uint32_t *arguments, uint32_t count);
#endif
