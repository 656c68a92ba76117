/* The rows of foreign.def as a const array, and the look-up of a name. */
#include "foreign_table.h"
#include <stddef.h>
#include <string.h>

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

/* The next letter or digit of a name, a capital as a small letter; *at moves behind it. 0: there is
 * none. */
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
