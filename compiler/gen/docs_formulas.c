/* Reference of the functions and values of formulas, and of the library's definitions. A
 * function's picture shows a sphere: a goes from -4 at the seam to 4 around it, b from -2 at the
 * bottom to 2 at the top; other arguments are constants. */
#include "docs_formulas.h"
#include "compiler/describe/describe.h"
#include "compiler/matc.h"
#include "grammar/expression_tables.h"
#include "grammar/library_table.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST = 512 };

/* Returns an expression for the i-th argument by its letter of the signature. */
static const char *argument(char letter, int i)
{
    static const char *const numbers[TERM_MAX_ARGUMENTS] = {"(8 * u - 4)", "(4 * v - 2)", ".5",
                                                            ".25", ".75"};
    switch (letter) {
    case 'b':
        return i ? "(v < .5)" : "(u < .5)";
    case 'i':
        return "3";
    case '2':
        return "[8 * u - 4, 4 * v - 2]";
    case '3':
        return "[8 * u - 4, 4 * v - 2, .5]";
    case '4':
        return "[8 * u - 4, 4 * v - 2, .5, 1]";
    default:
        return numbers[i];
    }
}

/* Writes the function as a color: 0 is gray, 2 is white. */
static void put_shown(Text *out, const TermRow *row)
{
    const char result = term_result(row);
    text_put(out, result == 'b' ? "= " : "= .5 + .25 * (");
    text_format(out, "%s(", row->name);
    for (int i = 0; i < row->count; i++)
        text_format(out, "%s%s", i ? ", " : "", argument(row->signature[i], i));
    text_put(out, result == 'b'   ? ") ? 1 : 0"
                  : result == '2' ? ")).xyy"
                  : result == '4' ? ")).xyz"
                                  : "))");
}

void docs_function_document(Text *out)
{
    text_put(out,
             "# A picture of each function of formulas, for the reference pages.\nmaterials:\n");
    for (int i = 0; i < TERM_COUNT; i++) {
        if (!term_table[i].callable)
            continue;
        text_format(out, "  %s: { material: Phong, diffuse: \"", term_table[i].name);
        put_shown(out, &term_table[i]);
        text_put(out, "\" }\n");
    }
}

void docs_functions(Text *out)
{
    text_put(out,
             "\n## Functions of formulas\n\nPictures show a sphere: `a` goes from -2 at the left "
             "to 2 at the "
             "right, `b` from -2 at the bottom to 2 at the top, other arguments "
             "are numbers; black is -2, gray 0, white 2; components of vectors are colors.\n");
    for (int i = 0; i < TERM_COUNT; i++) {
        if (!term_table[i].callable)
            continue;
        text_format(out, "\n### %s()\n\n```text\n", term_table[i].name);
        describe_function(out, i);
        text_format(out, "```\n\n![%s](pictures/functions.%s.png)\n", term_table[i].name,
                    term_table[i].name);
    }
    text_put(out, "\n## Values of formulas\n\n| value | |\n| --- | --- |\n");
    for (int i = 0; i < QUANTITY_COUNT; i++)
        text_format(out, "| `%s` | %s |\n", quantity_table[i].name, quantity_table[i].doc);
}

/* Writes a definition's page, the --explain text of a document that includes its file. */
static void put_definition(Text *out, const char *name)
{
    char text[2 * LONGEST];
    MatcOptions options;
    matc_options_init(&options);
    snprintf(text, sizeof text, "include: %s.yaml\n", name);
    MatcDocument *document = matc_read("reference.yaml", text, strlen(text), &options);
    char *page = matc_explain_definition(document, name);
    if (!page) {
        fprintf(stderr, "docs: %s has no page\n", name);
        exit(1);
    }
    text_format(out, "\n### %s\n\n```text\n%s```\n\n![%s](pictures/library.%s.png)\n", name, page,
                name, name);
    free(page);
    matc_document_free(document);
}

void docs_library(Text *out)
{
    text_put(out, "\n## Definitions that come with matc\n");
    for (int i = 0; i < library_count; i++) {
        char name[LONGEST];
        snprintf(name, sizeof name, "%.*s", (int)(strlen(library_table[i].name) - strlen(".yaml")),
                 library_table[i].name);
        put_definition(out, name);
    }
}
