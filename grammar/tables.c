/* The rows of grammar/ as const arrays. */
#include "layout_tables.h"
#include "lobe_table.h"
#include "key_table.h"
#include "unit_table.h"
#include "grammar/translation_tables.h"
#include "foreign_table.h"
#include "grammar/expression_tables.h"
#include <math.h>
#include <stddef.h>
#include <string.h>

const TypeRow type_table[TYPE_COUNT] = {
#define TYPE(name, glsl, components, doc) {glsl, components, doc},
#include "types.def"
};

const ChannelRow channel_table[CHANNEL_COUNT] = {
#define CHANNEL(name, group, component, doc) {#name, GROUP_##group, component, doc},
#include "channels.def"
};

const SlotRow slot_table[SLOT_COUNT] = {
#define SLOT(name, type, low, high, absent, doc) {#name, TYPE_##type, low, high, absent, doc},
#include "slots.def"
};

Mixing slot_mixing(Slot slot)
{
    switch (slot) {
#define MIXED(slot, how)                                                                           \
    case SLOT_##slot:                                                                              \
        return MIXING_##how;
#include "slots.def"
    default:
        return MIXING_LINEAR;
    }
}

Slot slot_weight(Slot slot)
{
    switch (slot) {
#define WEIGHED(slot, by)                                                                          \
    case SLOT_##slot:                                                                              \
        return SLOT_##by;
#include "slots.def"
    default:
        return SLOT_COUNT;
    }
}

#define NONE                                                                                       \
    0, { 0 }
#define D(x)                                                                                       \
    1, { x }
#define D3(x, y, z)                                                                                \
    3, { x, y, z }
#define ANY              -INFINITY, INFINITY
#define RANGE(low, high) low, high

const ParamRow param_table[PARAM_COUNT] = {
#define PARAM(kind, name, type, init, range, doc)                                                  \
    {KIND_##kind, #name, PARAM_##type, init, range, doc},
#include "materials.def"
#include "maps.def"
};

const WordRow keyword_table[WORD_COUNT] = {
#define WORD(list, name, doc) {PARAM_##list, #name, doc},
#include "words.def"
};

int word_of_truth(ParamKind list, bool yes)
{
    switch (list) {
#define TRUTH(list, no_word, yes_word)                                                             \
    case PARAM_##list:                                                                             \
        return yes ? KEYWORD_##list##_##yes_word : KEYWORD_##list##_##no_word;
#include "words.def"
    default:
        return -1;
    }
}

bool param_is_colored(int param)
{
    switch (param) {
#define COLORED(kind, name) case P_##kind##_##name:
#include "materials.def"
#include "maps.def"
        return true;
    default:
        return false;
    }
}

static bool says_number(int param)
{
    switch (param) {
#define RED_ALONE(kind, name) case P_##kind##_##name:
#include "materials.def"
#include "maps.def"
        return true;
    default:
        return false;
    }
}

bool param_is_number(int param)
{
    const ParamRow *row = &param_table[param];
    return row->type == PARAM_Map &&
           ((row->components == 1 && !param_is_colored(param)) || says_number(param));
}

bool param_is_unstored(int param)
{
    switch (param) {
#define UNSTORED(kind, name) case P_##kind##_##name:
#include "materials.def"
#include "maps.def"
        return true;
    default:
        return false;
    }
}

const char *param_dropped(int param, int *weight)
{
    switch (param) {
#define TILED(kind, name, by, what)                                                                \
    case P_##kind##_##name:                                                                        \
        *weight = P_##kind##_##by;                                                                 \
        return what;
#include "materials.def"
#include "maps.def"
    default:
        return NULL;
    }
}

/* Index ranges of parameters: an enumerator steps back by one before each kind's first
 * parameter. */
enum {
#define MATERIAL(name, sort, doc)                 FIRST_##name, RESET_##name = FIRST_##name - 1,
#define MAP(name, function, lowering, cost, doc)  MATERIAL(name, SHADER, doc)
#define PARAM(kind, name, type, init, range, doc) AT_##kind##_##name,
#include "materials.def"
#include "maps.def"
};
enum {
    KINDS_BEGIN = -1 /* a kind's count sums over the PARAM lines after its comma */
#define MATERIAL(name, sort, doc)                 , COUNT_##name = 0
#define MAP(name, function, lowering, cost, doc)  MATERIAL(name, SHADER, doc)
#define PARAM(kind, name, type, init, range, doc) +1
#include "materials.def"
#include "maps.def"
};

#define VOLUME LOWERING_VOLUME
#define OWN    LOWERING_OWN
const KindRow kind_table[KIND_COUNT] = {
#define KIND_ROW(kind, glsl, how, work, text)                                                      \
    [KIND_##kind].name = #kind, [KIND_##kind].function = #glsl, [KIND_##kind].lowering = how,      \
    [KIND_##kind].cost = work, [KIND_##kind].first = FIRST_##kind,                                 \
    [KIND_##kind].count = COUNT_##kind, [KIND_##kind].doc = text,
#define MATERIAL(name, sort, doc)                KIND_ROW(name, name, LOWERING_MATERIAL, 0, doc)
#define MAP(name, function, lowering, cost, doc) KIND_ROW(name, function, lowering, cost, doc)
#define FORMULA(kind, channels, text)                                                              \
    [KIND_##kind].answers = channels, [KIND_##kind].formula = text,
#define FILTER(kind, how, by, rest)                                                                \
    [KIND_##kind].filter = FILTER_##how, [KIND_##kind].mean = FN_##by,                             \
    [KIND_##kind].variance = FN_##rest,
#define FAR(kind, what)         [KIND_##kind].far = FAR_##what,
#define EXAMPLE(kind, document) [KIND_##kind].example = document,
#define MOVES(kind, which)      [KIND_##kind].moves = MOVES_##which,
#define STEP(kind, size, components)                                                               \
    [KIND_##kind].step = size, [KIND_##kind].step_components = components,
#include "materials.def"
#include "maps.def"
};

/* The first kind after each heading: its enumerator equals that of the next kind. */
enum {
#define SECTION(name, title) SECTION_FIRST_##name, SECTION_BACK_##name = SECTION_FIRST_##name - 1,

#define MATERIAL(name, sort, doc)                SECTION_KIND_##name,
#define MAP(name, function, lowering, cost, doc) SECTION_KIND_##name,
#include "materials.def"
#include "maps.def"
};
const SectionRow section_table[SECTION_COUNT] = {
#define SECTION(name, title) {title, SECTION_FIRST_##name},
#include "materials.def"
#include "maps.def"
};

Section section_of(Kind kind)
{
    int section = SECTION_COUNT - 1;
    while (section_table[section].first > (int)kind)
        section--;
    return (Section)section;
}

enum {
    FORMULAS = 0
#define FORMULA(kind, answers, formula) +1
#include "materials.def"
#include "maps.def"
};
_Static_assert((int)FORMULAS == (int)KIND_COUNT, "every map and material has a FORMULA");

const AliasRow alias_table[] = {
#define ALIAS(alias, name) {#alias, KIND_##name},
#include "materials.def"
#include "maps.def"
};
const int alias_count = sizeof alias_table / sizeof *alias_table;

#undef D
#define D(x) x
const PresetRow preset_table[] = {
#define PRESET(name, map, param, init, doc) {#name, KIND_##map, P_##map##_##param, init, doc},
#include "maps.def"
};
const int preset_count = sizeof preset_table / sizeof *preset_table;

const WaveRow wave_table[WAVE_COUNT] = {
#define WAVE(name, reference, build, doc) {#name, doc},
#include "waves.def"
};

const SlopeRow *slope_row(int function)
{
    static const SlopeRow rows[FUNCTION_COUNT] = {
#define SLOPE(function, kind, argument, by, arguments)                                             \
    [FN_##function] = {SLOPE_##kind, argument, FN_##by, arguments},
#include "slopes.def"
#define SLOPE(map, kind, by, arguments)                                                            \
    [FN_FIRST_MAP + KIND_##map] = {SLOPE_##kind, 0, FN_##by, arguments},
#include "maps.def"
    };
    return &rows[function];
}

const InputRow input_table[INPUT_COUNT] = {
#define INPUT(name, type, source, glsl, doc) {#name, TYPE_##type, SOURCE_##source, glsl, doc},
#include "inputs.def"
};

const ChangeRow change_table[] = {
#define CHANGE(name, of, type, operator, glsl, doc) {INPUT_##name, INPUT_##of, #operator},
#include "inputs.def"
};
const int change_count = sizeof change_table / sizeof *change_table;

const ColorRow color_table[] = {
#define COLOR(name, r, g, b) {#name, {r, g, b}},
#include "colors.def"
};
const int color_count = sizeof color_table / sizeof *color_table;

const TargetRow target_table[TARGET_COUNT] = {
#define TARGET(target, text, ...) {.name = #target, .doc = text, __VA_ARGS__},
#include "targets.def"
};

const PassRow pass_table[PASS_COUNT] = {
#define PASS(name, doc) {#name, doc},
#include "passes.def"
};

const NormalsRow normals_table[NORMALS_COUNT] = {
#define NORMALS(name, doc) {#name, doc},
#include "normals.def"
};

const TexelsRow texels_table[TEXELS_COUNT] = {
#define TEXELS(name, components, bits, doc) {#name, components, bits, doc},
#include "textures.def"
};

/* The first choice of every axis, counted by the compiler. */
enum {
#define AXIS(name, chunks, doc) FIRST_##name, BEFORE_##name = FIRST_##name - 1,
#define CHOICE(axis, name, doc) INDEX_##axis##_##name,
#include "variants.def"
};

const AxisRow axis_table[AXIS_COUNT] = {
#define AXIS(name, chunks, doc) {#name, chunks, FIRST_##name, doc},
#include "variants.def"
};

int axis_choices(Axis axis)
{
    return (axis + 1 < AXIS_COUNT ? axis_table[axis + 1].first : CHOICE_COUNT) -
           axis_table[axis].first;
}

const ChoiceRow choice_table[CHOICE_COUNT] = {
#define CHOICE(axis, name, doc) {AXIS_##axis, #name, doc},
#include "variants.def"
};

const PrecisionRow precision_table[PRECISION_COUNT] = {
#define PRECISION(name, a, b, c, d, doc)                                                           \
    {#name,                                                                                        \
     doc,                                                                                          \
     {[AXIS_noise] = CHOICE_noise_##a,                                                             \
      [AXIS_aa] = -1,                                                                              \
      [AXIS_derivatives] = -1,                                                                     \
      [AXIS_coordinates] = CHOICE_coordinates_##b,                                                 \
      [AXIS_powers] = CHOICE_powers_##c,                                                           \
      [AXIS_trigonometry] = CHOICE_trigonometry_##d}},
#include "variants.def"
};

#define LETTER_Float      "f"
#define LETTER_Int        "i"
#define LETTER_Vec3       "3"
#define LETTER_Bool       ""
#define LETTER_Map        ""
#define LETTER_Wave       ""
#define LETTER_Transform  ""
#define LETTER_Image      ""
#define LETTER_Items      ""
#define LETTER_Maps       ""
#define LETTER_List       ""
#define LETTER_Axis       ""
#define LETTER_Formula    ""
#define LETTER_ColorSpace ""
#define LETTER_Channel    ""
#define LETTER_Address    ""
#define LETTER_Texels     ""
#define LETTER_CellsValue ""
#define LETTER_Distance   ""
/* A volume map's function takes the position, then the PARAM lines. */
static const char *const map_arguments[KIND_COUNT] = {
    [0] = "" /* materials have none */
#define MAP(name, function, lowering, cost, doc) , [KIND_##name] = "3"
#define BASE_PARAM(kind, name, type, init, range, doc)
#define PARAM(kind, name, type, init, range, doc) LETTER_##type
#include "maps.def"
};

#undef VOLUME
#undef OWN
#define OWN_ROW(function, cost, doc)    {NULL, TYPE_float, cost, doc},
#define VOLUME_ROW(function, cost, doc) {#function, TYPE_float, cost, doc},
const FunctionRow function_table[FUNCTION_COUNT] = {
#define FUNCTION(name, result, arguments, range, cost, doc) {#name, TYPE_##result, cost, doc},
#include "functions.def"
#define MATERIAL(name, sort, doc)                OWN_ROW(name, 0, doc)
#define MAP(name, function, lowering, cost, doc) lowering##_ROW(function, cost, doc)
#include "materials.def"
#include "maps.def"
};

static const char *const fixed_arguments[] = {
#define FUNCTION(name, result, arguments, range, cost, doc) arguments,
#include "functions.def"
};

const char *function_arguments(int function)
{
    return function < FN_FIRST_MAP ? fixed_arguments[function]
                                   : map_arguments[function - FN_FIRST_MAP];
}

const FileRow file_table[] = {
#define FILE(name, doc)                   {FILE_ROW_file, #name, false, MEMBER_text, "", doc},
#define OBJECT(name, doc)                 {FILE_ROW_object, #name, false, MEMBER_text, "", doc},
#define MEMBER(name, must, type, of, doc) {FILE_ROW_member, #name, must, MEMBER_##type, of, doc},
#include "files.def"
};
const int file_row_count = sizeof file_table / sizeof *file_table;

/* -- Lobes */

const LobeRow lobe_table[LOBE_COUNT] = {
#define LOBE(slot, param, doc) {#slot, SLOT_##slot, P_Principled_##param, doc},
#include "slots.def"
};

/* -- Keys of documents */

const KeyRow key_table[DOCUMENT_KEY_COUNT] = {
#define KEY(name, where, doc, example) {#name, where, doc, example},
#include "keys.def"
};

/* -- Units */

#define ANY              -INFINITY, INFINITY
#define RANGE(low, high) low, high

const UnitRow unit_table[UNIT_COUNT] = {
#define UNIT(id, name, range, other, factor) {name, range, other, factor},
#include "units.def"
};

/* The unit of each parameter, counted from 1; 0: none. */
static const unsigned char measures[PARAM_COUNT] = {
#define MEASURE(kind, param, unit) [P_##kind##_##param] = UNIT_##unit + 1,
#include "units.def"
};

const UnitRow *unit_of(int param)
{
    return measures[param] ? &unit_table[measures[param] - 1] : NULL;
}

/* -- Translations */

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

/* -- Names in other tools */

#define ROW(group, kind, name, written, here) {FOREIGN_##group, kind, name, written, here},

const ForeignRow foreign_table[] = {
#define FOREIGN_MAP(name, here)           ROW(MAP, KIND_COUNT, #name, NULL, here)
#define FOREIGN_MATERIAL(name, here)      ROW(MATERIAL, KIND_COUNT, #name, NULL, here)
#define FOREIGN_PARAM(kind, name, here)   ROW(PARAM, KIND_##kind, #name, NULL, here)
#define FOREIGN_KEY(name, here)           ROW(KEY, KIND_COUNT, #name, NULL, here)
#define FOREIGN_TOP(name, here)           ROW(TOP, KIND_COUNT, #name, NULL, here)
#define FOREIGN_TYPE(name, here)          ROW(TYPE, KIND_COUNT, #name, NULL, here)
#define FOREIGN_SCENE(name, here)         ROW(SCENE, KIND_COUNT, #name, NULL, here)
#define FOREIGN_PLACE(name, here)         ROW(PLACE, KIND_COUNT, #name, NULL, here)
#define FOREIGN_COLOR(name, here)         ROW(COLOR, KIND_COUNT, #name, NULL, here)
#define FOREIGN_FORMULA(name, here)       ROW(FORMULA, KIND_COUNT, #name, NULL, here)
#define FOREIGN_FORM(name, written, here) ROW(FORM, KIND_COUNT, #name, written, here)
#include "foreign.def"
};
const int foreign_count = sizeof foreign_table / sizeof *foreign_table;

/* Returns the next letter (as lowercase) or digit of a name, and moves *at after it; 0 at the
 * end. */
static char next_letter(const char **at)
{
    while (**at == '_' || **at == '-' || **at == ' ')
        ++*at;
    const char c = **at;
    *at += c != 0;
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool foreign_is_alike(const char *a, const char *b)
{
    for (;;) {
        const char x = next_letter(&a), y = next_letter(&b);
        if (x != y || !x)
            return x == y;
    }
}

const char *foreign_name(ForeignGroup group, Kind kind, const char *name)
{
    for (int i = 0; i < foreign_count; i++) {
        const ForeignRow *row = &foreign_table[i];
        if (row->group != group || (group == FOREIGN_PARAM && row->kind != kind))
            continue;
        if (group == FOREIGN_FORMULA ? !strcmp(row->name, name) : foreign_is_alike(row->name, name))
            return row->here;
    }
    return NULL;
}

/* -- Expressions */

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

/* the letter after the arguments and '>' */
char term_result(const TermRow *row) { return row->signature[row->count + 1]; }

/* Compares `name` of `size` letters with a row's name, spelled out per row, so that the C
 * compiler sees constant sizes. */
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
    return row->components ? (int)strlen(row->components) : type_table[row->type].components;
}

const VectorRow vector_table[] = {
#define VECTOR(name, components, doc) {#name, doc, components},
#include "expression.def"
};
const int vector_count = sizeof vector_table / sizeof *vector_table;

int vector_named(const char *name, size_t size)
{
#define VECTOR(name, components, doc)                                                              \
    if (IS(name))                                                                                  \
        return components;
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
