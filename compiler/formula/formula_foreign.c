/* Hints for names of other languages in formulas: rows of foreign.def, and colors. */
#include "compiler/base/diag.h"
#include "compiler/base/text.h"
#include "compiler/formula/formula_lex.h"
#include "grammar/foreign_table.h"
#include <string.h>

const char *formula_foreign(Session *session, const char *name)
{
    const char *here = diag_full(session) ? NULL : foreign_name(FOREIGN_FORMULA, KIND_COUNT, name);
    Text text = text_new(session->arena);
    if (here)
        text_format(&text, "; here it is %s", here);
    for (int i = 0; !here && !diag_full(session) && i < color_count; i++)
        if (!strcmp(color_table[i].name, name))
            text_format(&text, "; in a formula the color is written #%02x%02x%02x",
                        color_table[i].rgb[0], color_table[i].rgb[1], color_table[i].rgb[2]);
    return text.size ? text.at : NULL;
}
