/* translations.def as const arrays. */
#include "grammar/translation_tables.h"

const TranslationRow translation_table[] = {
#define TRANSLATION(material, param, formula)                                                      \
    {KIND_##material, P_Principled_##param, formula, 0, 0, 0},
#define TRANSLATED_WHERE(material, param, where, formula)                                          \
    {KIND_##material, P_Principled_##param, formula, 0, 0, where},
#define TRANSLATED_NORMAL(material, param, map, scale)                                             \
    {KIND_##material, P_Principled_##param, 0, P_##material##_##map, P_##material##_##scale, 0},
#include "grammar/translations.def"
};
const int translation_count = sizeof translation_table / sizeof *translation_table;

const LossRow loss_table[] = {
#define LOSS(material, param, formula, what) {P_##material##_##param, formula, what},
#include "grammar/translations.def"
};
const int loss_count = sizeof loss_table / sizeof *loss_table;
