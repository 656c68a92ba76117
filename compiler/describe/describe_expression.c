/* Formats formulas for --list=functions, --explain and the schema, from expression.def. */
#include "compiler/describe/describe.h"
#include "compiler/base/json_write.h"
#include "grammar/expression_tables.h"
#include <string.h>

enum { NAME_WIDTH = 24 };

/* Writes "mix(a, b, c)", "a + b", "-a", "a ? b : c"; optional arguments are in brackets. */
static void put_form(Text *out, Term term)
{
    const TermRow *row = &term_table[term];
    if (row->callable) {
        text_format(out, "%s(", row->name);
        for (int i = 0; i < row->count; i++)
            text_format(out, "%s%s%c", row->least && i == row->least ? "[" : "", i ? ", " : "",
                        'a' + i);
        text_put(out, row->least ? "])" : ")");
    } else if (term == TERM_choose) {
        text_put(out, "a ? b : c");
    } else {
        text_format(out, row->count == 1 ? "%sa" : "a %s b", term_symbol(term));
    }
}

static const char *width_word(char letter)
{
    switch (letter) {
    case '1':
        return "a number";
    case '2':
        return "two components";
    case '3':
        return "three components";
    case '4':
        return "four components";
    case 'b':
        return "a condition";
    case 'i':
        return "a literal integer";
    default:
        return "numbers or vectors of equal width";
    }
}

static void put_lines_of(Text *out, bool callable)
{
    for (int i = 0; i < TERM_COUNT; i++) {
        Text form = text_new(out->arena);
        if (term_table[i].callable != callable)
            continue;
        put_form(&form, (Term)i);
        text_format(out, "  %-*s  %s\n", NAME_WIDTH, form.at, term_table[i].doc);
    }
}

void describe_functions(Text *out)
{
    text_put(out, out->size ? "\nFunctions of formulas\n" : "Functions of formulas\n");
    put_lines_of(out, true);
    for (int i = 0; i < vector_count; i++)
        text_format(out, "  %-*s  %s\n", NAME_WIDTH, vector_table[i].name, vector_table[i].doc);
    for (int i = 0; i < SPECIAL_COUNT; i++)
        text_format(out, "  %-*s  %s\n", NAME_WIDTH, formula_special_table[i].form,
                    formula_special_table[i].doc);
    text_put(out, "\nOperators of formulas\n");
    put_lines_of(out, false);
    text_put(out, "\nValues of formulas\n");
    for (int i = 0; i < QUANTITY_COUNT; i++)
        text_format(out, "  %-*s  %s\n", NAME_WIDTH, quantity_table[i].name, quantity_table[i].doc);
}

void describe_function(Text *out, int term)
{
    const TermRow *row = &term_table[term];
    text_format(out, "%s (function of formulas)\n", row->name);
    put_form(out, (Term)term);
    text_format(out, "\n%s\n\nArguments\n", row->doc);
    for (int i = 0; i < row->count; i++) {
        text_format(out, "  %c  %s", 'a' + i, width_word(row->signature[i]));
        if (row->least && i >= row->least) {
            text_put(out, "; without it ");
            text_plain(out, row->initial[i - row->least]);
        }
        if (row->signature[i] == 'i')
            text_format(out, ", %d to %d", row->whole_low, row->whole_high);
        text_char(out, '\n');
    }
    text_format(out, "\nGives\n  %s\n\nExample\n  %s\n", width_word(term_result(row)),
                row->example);
}

/* Writes the part of an example before " = ". */
static void put_example(Text *out, const char *example)
{
    const char *end = example, *next = strstr(example, " = ");
    for (; next; next = strstr(next + 1, " = "))
        end = next;
    json_bytes(out, example, (size_t)(end - example));
}

void describe_formula_schema(Text *out)
{
    text_put(out, "    \"formula\": {\n      \"description\": \"A formula; --list=functions has "
                  "its words.\",\n"
                  "      \"type\": [\"string\", \"number\", \"null\"],\n      \"examples\": [");
    for (int i = 0; i < TERM_COUNT; i++) {
        text_put(out, i ? ", " : "");
        put_example(out, term_table[i].example);
    }
    for (int i = 0; i < QUANTITY_COUNT; i++) {
        text_put(out, ", ");
        json_string(out, quantity_table[i].name);
    }
    text_put(out, "]\n    },\n"
                  "    \"shorthand\": {\"description\": \"A formula as a map.\", \"type\": "
                  "\"string\", \"pattern\": \"^=\"},\n"
                  "    \"maps\": {\n      \"type\": [\"object\", \"null\"],\n"
                  "      \"propertyNames\": {\"pattern\": \"^[A-Za-z_][A-Za-z0-9_]*$\"},\n"
                  "      \"additionalProperties\": {\"$ref\": \"#/$defs/map\"}\n    },\n");
}
