/* matc --list: every name of the language with a one-line description. */
#include "compiler/describe/describe.h"
#include "compiler/matc.h"
#include <string.h>

enum { NAME_WIDTH = 24 };

static void put_line(Text *out, const char *name, const char *doc)
{
    text_format(out, "  %-*s  %s\n", NAME_WIDTH, name, doc);
}

static void put_heading(Text *out, const char *title)
{
    text_format(out, out->size ? "\n%s\n" : "%s\n", title);
}

static void list_kinds(Text *out, bool materials, bool maps)
{
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        const SectionRow *section = &section_table[section_of((Kind)kind)];
        const bool material = section_of((Kind)kind) == SECTION_material;
        if (!(material ? materials : maps))
            continue;
        if (section->first == kind)
            put_heading(out, section->title);
        put_line(out, kind_table[kind].name, kind_table[kind].doc);
    }
}

static void list_materials(Text *out) { list_kinds(out, true, false); }
static void list_maps(Text *out) { list_kinds(out, false, true); }

static void list_presets(Text *out)
{
    put_heading(out, "Presets (maps with other defaults)");
    for (int i = 0; i < preset_count; i++)
        if (describe_is_preset_head(i))
            text_format(out, "  %-*s  %s: %s\n", NAME_WIDTH, preset_table[i].name,
                        kind_table[preset_table[i].kind].name, preset_table[i].doc);
}

static void list_aliases(Text *out)
{
    put_heading(out, "Aliases (other names of maps and materials)");
    for (int i = 0; i < alias_count; i++)
        put_line(out, alias_table[i].alias, kind_table[alias_table[i].kind].name);
}

static void list_colors(Text *out)
{
    put_heading(out, "Colours");
    for (int i = 0; i < color_count; i++) {
        const unsigned char *rgb = color_table[i].rgb;
        text_format(out, "  %-*s  #%02x%02x%02x\n", NAME_WIDTH, color_table[i].name, rgb[0], rgb[1],
                    rgb[2]);
    }
}

/* Lists tables whose rows have a name and a doc. */
#define LIST(function, title, table, count)                                                        \
    static void function(Text *out)                                                                \
    {                                                                                              \
        put_heading(out, title);                                                                   \
        for (int i = 0; i < (count); i++)                                                          \
            put_line(out, (table)[i].name, (table)[i].doc);                                        \
    }
LIST(list_plain_waves, "Waves (functions of a number v)", wave_table, WAVE_COUNT)
LIST(list_channels, "Channels (what a map can be asked for)", channel_table, CHANNEL_COUNT)
LIST(list_slots, "Slots (what a material tells about a point)", slot_table, SLOT_COUNT)
LIST(list_targets, "Targets", target_table, TARGET_COUNT)
LIST(list_passes, "Passes", pass_table, PASS_COUNT)
LIST(list_normals, "Normals (--normals: which space those of a G-buffer are in)", normals_table,
     NORMALS_COUNT)
LIST(list_layouts, "Layouts", layout_table, LAYOUT_COUNT)
LIST(list_encodings, "Encodings", encoding_table, ENCODING_COUNT)

static void list_waves(Text *out)
{
    list_plain_waves(out);
    put_line(out, "Chain", CHAIN_DOC);
}

static void list_scenes(Text *out)
{
    for (int kind = 0; kind < SCENE_KIND_COUNT; kind++) {
        const SceneSort sort = scene_kind_table[kind].sort;
        Text title = text_new(out->arena);
        text_format(&title, "Of scenes: %s", scene_sort_table[sort].name);
        if (!kind || scene_kind_table[kind - 1].sort != sort)
            put_heading(out, title.at);
        put_line(out, scene_kind_table[kind].name, scene_kind_table[kind].doc);
    }
}

static void list_choices_of(Text *out, const AxisRow *axis)
{
    put_heading(out, axis->doc);
    for (int i = 0; i < CHOICE_COUNT; i++)
        if (&axis_table[choice_table[i].axis] == axis)
            put_line(out, choice_table[i].name, choice_table[i].doc);
}

static void list_choices(Text *out)
{
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        list_choices_of(out, &axis_table[axis]);
}

static void list_warnings(Text *out)
{
    put_heading(out, "Warnings (-Wno-NAME, -Werror=NAME)");
    for (int i = 0; i < DIAG_COUNT; i++)
        if (diag_is_named((DiagKind)i))
            put_line(out, diag_table[i].name, diag_table[i].doc);
}

static const struct {
    const char *kind;
    void (*put)(Text *out);
} lists[] = {{"materials", list_materials},
             {"maps", list_maps},
             {"presets", list_presets},
             {"aliases", list_aliases},
             {"waves", list_waves},
             {"functions", describe_functions},
             {"colors", list_colors},
             {"channels", list_channels},
             {"slots", list_slots},
             {"targets", list_targets},
             {"passes", list_passes},
             {"normals", list_normals},
             {"layouts", list_layouts},
             {"encodings", list_encodings},
             {"scenes", list_scenes},
             {"choices", list_choices},
             {"warnings", list_warnings},
             {"library", describe_library_list},
             {"foreign", describe_foreign_list}};
enum { LISTS = sizeof lists / sizeof *lists };

char *matc_list(void)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    for (int i = 0; i < LISTS; i++)
        /* all lists except that of foreign names contain names of matc */
        if (lists[i].put != describe_foreign_list)
            lists[i].put(&out);
    return describe_finish(&out);
}

/* Returns the list of a kind of names, or the choices of an axis. */
char *matc_list_of(const char *kind)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    for (int i = 0; kind && i < LISTS; i++)
        if (!strcmp(lists[i].kind, kind))
            lists[i].put(&out);
    for (int axis = 0; kind && axis < AXIS_COUNT; axis++)
        if (!strcmp(axis_table[axis].name, kind))
            list_choices_of(&out, &axis_table[axis]);
    if (out.size)
        return describe_finish(&out);
    arena_free(&arena);
    return NULL;
}

const char *describe_list_kind(const void *user, int i)
{
    (void)user;
    return i < LISTS ? lists[i].kind : i < LISTS + AXIS_COUNT ? axis_table[i - LISTS].name : NULL;
}
