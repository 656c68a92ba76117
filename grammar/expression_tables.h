/* expression.def as enums and const arrays: the terms, symbols and values of formulas. */
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

enum { TERM_MOST_ARGUMENTS = 5, TERM_MOST_DEFAULTS = 2 };

typedef struct {
    const char *name;
    const char *signature; /* "gg>g", as the head of expression.def says */
    const char *doc;
    const char *example;                /* "formula = value" */
    int count, least;                   /* arguments: so many, and at least */
    double initial[TERM_MOST_DEFAULTS]; /* of those that may be left out */
    int whole_low, whole_high;          /* what a whole number may be */
    bool callable;                      /* by its name; else by its symbol alone */
    bool jumps;
    bool noisy; /* it goes by --noise */
} TermRow;
extern const TermRow term_table[TERM_COUNT];
/* The letter of a term's result. */
char term_result(const TermRow *row);
/* The function of that name, or TERM_none. */
Term term_named(const char *name, size_t size);

/* How tightly an operator binds. level_choose is that of a ? b : c, level_prefix of one in
 * front. */
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
    OperatorLevel level; /* level_prefix: of one operand, in front of it */
} SymbolRow;
/* Longer ones before those that they begin with. */
extern const SymbolRow symbol_table[];
extern const int symbol_count;
/* The first of symbol_table that the text, of one byte and a zero byte at least, begins with;
 * symbol_count: none. */
int symbol_begun(const char *text);
/* The symbol of a term, or its name. */
const char *term_symbol(Term term);

typedef struct {
    const char *name, *doc;
    Group group;           /* of channels */
    const char *lanes;     /* of it, letters of xyz; NULL: a constant */
    double number;         /* of a constant; of an attribute all lanes where a mesh has none */
    const char *attribute; /* of the mesh; NULL: it is none */
    Type type;             /* of that */
} QuantityRow;
typedef enum {
#define CONSTANT(name, number, doc)       QUANTITY_##name,
#define QUANTITY(name, group, lanes, doc) QUANTITY_##name,
#define ATTRIBUTE(name, ...)              QUANTITY_##name,
#include "expression.def"
    QUANTITY_COUNT,
    QUANTITY_none = QUANTITY_COUNT
} Quantity;
extern const QuantityRow quantity_table[QUANTITY_COUNT];
Quantity quantity_named(const char *name, size_t size);
/* Its lanes, 1 to 4. */
int quantity_width(Quantity quantity);

/* Functions that make a vector of so many lanes. */
typedef struct {
    const char *name, *doc;
    int width;
} VectorRow;
extern const VectorRow vector_table[];
extern const int vector_count;
/* The lanes of what the function makes; 0: none of that name. */
int vector_named(const char *name, size_t size);

/* Terms that are called like functions, but take words. */
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
