/* expression.def as const arrays. */
#include "grammar/expression_tables.h"
#include <string.h>

#define TERM_ROW(term, arguments, text, sample, called)                                                                \
    [TERM_##term].name = #term, [TERM_##term].signature = arguments, [TERM_##term].doc = text,                         \
    [TERM_##term].example = sample, [TERM_##term].count = sizeof arguments - sizeof ">g",                              \
    [TERM_##term].callable = called,
const TermRow term_table[TERM_COUNT] = {
#define OPERATOR(name, signature, doc, example) TERM_ROW(name, signature, doc, example, false)
#define FUNCTION(name, signature, doc, example) TERM_ROW(name, signature, doc, example, true)
#define JUMPS(name)                             [TERM_##name].jumps = true,
#define NOISY(name)                             [TERM_##name].noisy = true,
#define WHOLE(name, low, high)                  [TERM_##name].whole_low = low, [TERM_##name].whole_high = high,
#define LEAST(name, number, ...)                [TERM_##name].least = number, [TERM_##name].initial = {__VA_ARGS__},
#include "expression.def"
};

char term_result(const TermRow *row) { return strchr(row->signature, '>')[1]; }

static bool is_named(const char *row, const char *name, size_t size)
{
    return *row == *name && strlen(row) == size && !memcmp(row, name, size); /* the first letter rules most out */
}

Term term_named(const char *name, size_t size)
{
    for (int i = 0; i < TERM_COUNT; i++)
        if (term_table[i].callable && is_named(term_table[i].name, name, size))
            return (Term)i;
    return TERM_none;
}

const SymbolRow symbol_table[] = {
#define SYMBOL(text, term, level) {text, TERM_##term, level},
#define PREFIX(text, term)        {text, TERM_##term, level_prefix},
#include "expression.def"
};
const int symbol_count = sizeof symbol_table / sizeof *symbol_table;

const char *term_symbol(Term term)
{
    for (int i = 0; i < symbol_count; i++)
        if (symbol_table[i].term == term)
            return symbol_table[i].text;
    return term == TERM_choose ? "? :" : term_table[term].name;
}

const QuantityRow quantity_table[QUANTITY_COUNT] = {
#define CONSTANT(name, number, doc)            {#name, doc, GROUP_COUNT, NULL, number, NULL, TYPE_float},
#define QUANTITY(name, channels, letters, doc) {#name, doc, GROUP_##channels, letters, 0, NULL, TYPE_float},
#define ATTRIBUTE(name, attribute, type, initial, doc) {#name, doc, GROUP_COUNT, NULL, initial, attribute, TYPE_##type},
#include "expression.def"
};

Quantity quantity_named(const char *name, size_t size)
{
    for (int i = 0; i < QUANTITY_COUNT; i++)
        if (is_named(quantity_table[i].name, name, size))
            return (Quantity)i;
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
    for (int i = 0; i < vector_count; i++)
        if (is_named(vector_table[i].name, name, size))
            return vector_table[i].width;
    return 0;
}

const FormulaSpecialRow formula_special_table[SPECIAL_COUNT] = {
#define SPECIAL(name, form, doc) {#name, form, doc},
#include "expression.def"
};

FormulaSpecial formula_special_named(const char *name, size_t size)
{
    for (int i = 0; i < SPECIAL_COUNT; i++)
        if (is_named(formula_special_table[i].name, name, size))
            return (FormulaSpecial)i;
    return SPECIAL_none;
}

const char *expression_foreign(const char *name)
{
    static const char *const rows[][2] = {
#define FOREIGN(name, here) {#name, here},
#include "foreign.def"
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (!strcmp(rows[i][0], name))
            return rows[i][1];
    return NULL;
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
