/* The rows of foreign_kinds.def as a const array, and the look-up of a name. */
#include "foreign_table.h"
#include <stddef.h>

const ForeignRow foreign_table[] = {
#define FOREIGN_MAP(name, here)         {FOREIGN_MAP, KIND_COUNT, #name, here},
#define FOREIGN_MATERIAL(name, here)    {FOREIGN_MATERIAL, KIND_COUNT, #name, here},
#define FOREIGN_PARAM(kind, name, here) {FOREIGN_PARAM, KIND_##kind, #name, here},
#define FOREIGN_KEY(name, here)         {FOREIGN_KEY, KIND_COUNT, #name, here},
#define FOREIGN_SCENE(name, here)       {FOREIGN_SCENE, KIND_COUNT, #name, here},
#define FOREIGN_PLACE(name, here)       {FOREIGN_PLACE, KIND_COUNT, #name, here},
#include "foreign_kinds.def"
};
const int foreign_count = sizeof foreign_table / sizeof *foreign_table;

/* The next letter or digit of a name, a capital as a small letter; *at moves behind it. 0: there is none. */
static char next_letter(const char **at)
{
    while (**at == '_' || **at == '-' || **at == ' ')
        ++*at;
    const char c = **at;
    *at += c != 0;
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static bool is_alike(const char *a, const char *b)
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
        if (row->group == group && (group != FOREIGN_PARAM || row->kind == kind) && is_alike(row->name, name))
            return row->here;
    }
    return NULL;
}
