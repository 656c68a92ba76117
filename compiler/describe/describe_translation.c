/* Formats rows of translations.def, one per line. */
#include "compiler/describe/describe.h"
#include "grammar/translation_tables.h"

void describe_translations(Text *out, Kind kind, const char *indent)
{
    for (int i = 0; i < translation_count; i++) {
        const TranslationRow *row = &translation_table[i];
        if (row->from != kind)
            continue;
        text_format(out, "%s%s = ", indent, param_table[row->to].name);
        if (row->formula)
            text_format(out, "%s\n", row->formula);
        else
            text_format(out, "a NormalMap of %s, scaled by %s, if given\n",
                        param_table[row->map].name, param_table[row->scale].name);
    }
    for (int i = 0; i < loss_count; i++)
        if (param_table[loss_table[i].param].kind == kind)
            text_format(out, "%s%s is only approximated if it is not 0: %s; %s\n", indent,
                        param_table[loss_table[i].param].name, loss_table[i].formula,
                        loss_table[i].what);
}
