/* Describes names that are not in matc's own tables: names of other tools, and definitions of
 * the library. */
#include "compiler/describe/describe.h"
#include "grammar/foreign_table.h"
#include "grammar/library_table.h"
#include <string.h>

enum { NAME_WIDTH = 24, GROUPS = FOREIGN_FORM + 1 };

static const char *const group_names[GROUPS] = {
    [FOREIGN_MAP] = "map",
    [FOREIGN_MATERIAL] = "material",
    [FOREIGN_PARAM] = "parameter",
    [FOREIGN_KEY] = "key",
    [FOREIGN_TOP] = "key of a document",
    [FOREIGN_TYPE] = "key",
    [FOREIGN_SCENE] = "part of a scene",
    [FOREIGN_PLACE] = "parameter of a part of a scene",
    [FOREIGN_COLOR] = "colour",
    [FOREIGN_FORMULA] = "name in a formula",
    [FOREIGN_FORM] = "form of a value",
};

void describe_foreign(Text *out, const char *name)
{
    bool begun = false;
    for (int i = 0; i < foreign_count; i++) {
        const ForeignRow *row = &foreign_table[i];
        if (row->group == FOREIGN_FORMULA ? strcmp(row->name, name) != 0
                                          : !foreign_is_alike(row->name, name))
            continue;
        if (!begun)
            text_format(out, "%s%s (of other tools)\n", out->size ? "\n" : "", row->name);
        begun = true;
        text_format(out, "%s", group_names[row->group]);
        if (row->group == FOREIGN_PARAM)
            text_format(out, " of %s", kind_table[row->kind].name);
        if (row->written)
            text_format(out, ", %s", row->written);
        text_format(out, ": here it is %s\n", row->here);
    }
}

static void put_group(Text *out, ForeignGroup group)
{
    text_format(out, "%sOf other tools: %s\n", out->size ? "\n" : "", group_names[group]);
    for (int i = 0; i < foreign_count; i++) {
        const ForeignRow *row = &foreign_table[i];
        Text name = text_new(out->arena);
        if (row->group != group)
            continue;
        if (group == FOREIGN_PARAM)
            text_format(&name, "%s ", kind_table[row->kind].name);
        text_put(&name, row->written ? row->written : row->name);
        text_format(out, "  %-*s  %s\n", NAME_WIDTH, name.at, row->here);
    }
}

void describe_foreign_list(Text *out)
{
    for (int group = 0; group < GROUPS; group++)
        put_group(out, (ForeignGroup)group);
}

void describe_library_list(Text *out)
{
    text_format(out,
                "%sLibrary (definitions that come with matc: include: FILE, then { ref: NAME })\n",
                out->size ? "\n" : "");
    for (int i = 0; i < library_name_count; i++)
        text_format(out, "  %-*s  %s: %s\n", NAME_WIDTH, library_names[i].name,
                    library_names[i].file, library_names[i].doc);
}
