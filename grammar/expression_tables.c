/* expression.def as const arrays. */
#include "grammar/expression_tables.h"
#include <string.h>

#define TERM_ROW(term, arguments, text, sample, called)                                            \
    [TERM_##term].name = #term, [TERM_##term].signature = arguments, [TERM_##term].doc = text,     \
    [TERM_##term].example = sample, [TERM_##term].count = sizeof arguments - sizeof ">g",          \
    [TERM_##term].callable = called,
const TermRow term_table[TERM_COUNT] = {
#define OPERATOR(name, signature, doc, example) TERM_ROW(name, signature, doc, example, false)
#define FUNCTION(name, signature, doc, example) TERM_ROW(name, signature, doc, example, true)
#define JUMPS(name)                             [TERM_##name].jumps = true,
#define NOISY(name)                             [TERM_##name].noisy = true,

#define WHOLE(name, low, high) [TERM_##name].whole_low = low, [TERM_##name].whole_high = high,

#define LEAST(name, number, ...)                                                                   \
    [TERM_##name].least = number, [TERM_##name].initial = {__VA_ARGS__},
#include "expression.def"
};

/* behind the arguments and '>' */
char term_result(const TermRow *row) { return row->signature[row->count + 1]; }

/* Whether `name`, of `size` letters, is a row's: written out row by row, so that the compiler
 * compares with numbers that it knows. */
#define IS(row) (size == sizeof #row - 1 && !memcmp(name, #row, sizeof #row - 1))

Term term_named(const char *name, size_t size)
{
#define FUNCTION(name, ...)                                                                        \
    if (IS(name))                                                                                  \
        return TERM_##name;
#include "expression.def"
    return TERM_none;
}

const SymbolRow symbol_table[] = {
#define SYMBOL(text, term, level) {text, TERM_##term, level},
#define PREFIX(text, term)        {text, TERM_##term, level_prefix},
#include "expression.def"
};
const int symbol_count = sizeof symbol_table / sizeof *symbol_table;

int symbol_begun(const char *text)
{
    int row = 0;
#define SYMBOL(symbol, ...)                                                                        \
    if (text[0] == symbol[0] && (!symbol[1] || text[1] == symbol[1]))                              \
        return row;                                                                                \
    row++;
#define PREFIX SYMBOL
#include "expression.def"
    return row;
}

const char *term_symbol(Term term)
{
    for (int i = 0; i < symbol_count; i++)
        if (symbol_table[i].term == term)
            return symbol_table[i].text;
    return term == TERM_choose ? "? :" : term_table[term].name;
}

const QuantityRow quantity_table[QUANTITY_COUNT] = {
#define CONSTANT(name, number, doc) {#name, doc, GROUP_COUNT, NULL, number, NULL, TYPE_float},
#define QUANTITY(name, channels, letters, doc)                                                     \
    {#name, doc, GROUP_##channels, letters, 0, NULL, TYPE_float},
#define ATTRIBUTE(name, attribute, type, initial, doc)                                             \
    {#name, doc, GROUP_COUNT, NULL, initial, attribute, TYPE_##type},
#include "expression.def"
};

Quantity quantity_named(const char *name, size_t size)
{
#define QUANTITY(name, ...)                                                                        \
    if (IS(name))                                                                                  \
        return QUANTITY_##name;
#define CONSTANT  QUANTITY
#define ATTRIBUTE QUANTITY
#include "expression.def"
    return QUANTITY_none;
}

int quantity_width(Quantity quantity)
{
    const QuantityRow *row = &quantity_table[quantity];
    return row->lanes ? (int)strlen(row->lanes) : type_table[row->type].lanes;
}

const VectorRow vector_table[] = {
#define VECTOR(name, lanes, doc) {#name, doc, lanes},
#include "expression.def"
};
const int vector_count = sizeof vector_table / sizeof *vector_table;

int vector_named(const char *name, size_t size)
{
#define VECTOR(name, lanes, doc)                                                                   \
    if (IS(name))                                                                                  \
        return lanes;
#include "expression.def"
    return 0;
}

const FormulaSpecialRow formula_special_table[SPECIAL_COUNT] = {
#define SPECIAL(name, form, doc) {#name, form, doc},
#include "expression.def"
};

FormulaSpecial formula_special_named(const char *name, size_t size)
{
#define SPECIAL(name, ...)                                                                         \
    if (IS(name))                                                                                  \
        return SPECIAL_##name;
#include "expression.def"
    return SPECIAL_none;
}

const char *expression_word(int i)
{
    if (i < QUANTITY_COUNT)
        return quantity_table[i].name;
    i -= QUANTITY_COUNT;
    if (i < vector_count)
        return vector_table[i].name;
    i -= vector_count;
    if (i < SPECIAL_COUNT)
        return formula_special_table[i].name;
    i -= SPECIAL_COUNT;
    for (int term = 0; term < TERM_COUNT; term++)
        if (term_table[term].callable && i-- == 0)
            return term_table[term].name;
    return NULL;
}
