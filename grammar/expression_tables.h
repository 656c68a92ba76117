/* expression.def as enums and const arrays: the terms, symbols and quantities of formulas. */
#ifndef MATC_EXPRESSION_TABLES_H
#define MATC_EXPRESSION_TABLES_H
#include "tables.h"
#include <stddef.h>

/* A term of formulas: an operator or a function. */
typedef enum {
#define OPERATOR(name, ...) TERM_##name,
#define FUNCTION(name, ...) TERM_##name,
#include "expression.def"
    TERM_COUNT,
    TERM_none = TERM_COUNT
} Term;

enum { TERM_MAX_ARGUMENTS = 5, TERM_MAX_DEFAULTS = 2 };

typedef struct {
    const char *name;
    const char *signature; /* letters of the arguments and the result, "gg>g": see expression.def */
    const char *doc;
    const char *example; /* example formula and its value: "formula = value" */
    /* max and min number of arguments; they differ if some are optional */
    int count, least;
    double initial[TERM_MAX_DEFAULTS]; /* defaults of the optional arguments */
    int whole_low, whole_high;         /* range of a literal integer argument */
    /* the term is called by its name; false: only its symbol denotes it */
    bool callable;
    bool jumps;
    bool noisy; /* the result depends on --noise */
} TermRow;
extern const TermRow term_table[TERM_COUNT];
/* Returns the letter of a term's result. */
char term_result(const TermRow *row);
/* Returns the function with that name, or TERM_none. */
Term term_named(const char *name, size_t size);

/* Binding strength of an operator. level_choose belongs to a ? b : c, level_prefix to prefix
 * operators. */
typedef enum {
    level_none,
    level_choose,
    level_or,
    level_and,
    level_compare,
    level_sum,
    level_product,
    level_prefix,
    level_power
} OperatorLevel;

typedef struct {
    const char *text;
    Term term;
    OperatorLevel level; /* level_prefix: a prefix operator of one operand */
} SymbolRow;
/* Longer symbols precede their prefixes. */
extern const SymbolRow symbol_table[];
extern const int symbol_count;
/* Returns the first row of symbol_table with which the text begins; symbol_count: none. The text
 * has at least one byte and a zero byte. */
int symbol_begun(const char *text);
/* Returns the symbol of a term, or its name. */
const char *term_symbol(Term term);

typedef struct {
    const char *name, *doc;
    Group group;            /* group of channels */
    const char *components; /* components of the group, letters of xyz; NULL: a constant */
    double number;          /* value of a constant; default components of an attribute */
    const char *attribute;  /* mesh attribute; NULL: none */
    Type type;              /* type of the attribute */
} QuantityRow;
typedef enum {
#define CONSTANT(name, number, doc)            QUANTITY_##name,
#define QUANTITY(name, group, components, doc) QUANTITY_##name,
#define ATTRIBUTE(name, ...)                   QUANTITY_##name,
#include "expression.def"
    QUANTITY_COUNT,
    QUANTITY_none = QUANTITY_COUNT
} Quantity;
extern const QuantityRow quantity_table[QUANTITY_COUNT];
Quantity quantity_named(const char *name, size_t size);
/* Returns the number of components, 1 to 4. */
int quantity_width(Quantity quantity);

/* Functions that construct a vector of a given width. */
typedef struct {
    const char *name, *doc;
    int width;
} VectorRow;
extern const VectorRow vector_table[];
extern const int vector_count;
/* Returns the width of the function's vector; 0: unknown name. */
int vector_named(const char *name, size_t size);

/* Terms with the syntax of a call whose arguments are not values. */
typedef enum {
#define SPECIAL(name, form, doc) SPECIAL_##name,
#include "expression.def"
    SPECIAL_COUNT,
    SPECIAL_none = SPECIAL_COUNT
} FormulaSpecial;
typedef struct {
    const char *name, *form, *doc;
} FormulaSpecialRow;
extern const FormulaSpecialRow formula_special_table[SPECIAL_COUNT];
FormulaSpecial formula_special_named(const char *name, size_t size);

#endif
