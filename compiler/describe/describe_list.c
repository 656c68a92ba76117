/* matc --list: every name of the language with a line on it. */
#include "compiler/describe/describe.h"
#include "compiler/matc.h"
#include <string.h>

enum { NAME_WIDTH = 24 };

static void put_line(Text *out, const char *name, const char *doc)
{
    text_format(out, "  %-*s  %s\n", NAME_WIDTH, name, doc);
}

static void put_heading(Text *out, const char *title) { text_format(out, out->size ? "\n%s\n" : "%s\n", title); }

static void list_kinds(Text *out)
{
    for (int kind = 0; kind < KIND_COUNT; kind++) {
        const SectionRow *section = &section_table[section_of((Kind)kind)];
        if (section->first == kind)
            put_heading(out, section->title);
        put_line(out, kind_table[kind].name, kind_table[kind].doc);
    }
}

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
        text_format(out, "  %-*s  #%02x%02x%02x\n", NAME_WIDTH, color_table[i].name, rgb[0], rgb[1], rgb[2]);
    }
}

/* Tables whose rows have a name and a doc. */
#define LIST(out, title, table, count)                                                                                 \
    do {                                                                                                               \
        put_heading(out, title);                                                                                       \
        for (int i = 0; i < (count); i++)                                                                              \
            put_line(out, (table)[i].name, (table)[i].doc);                                                            \
    } while (0)

char *matc_list(void)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    list_kinds(&out);
    list_presets(&out);
    list_aliases(&out);
    LIST(&out, "Waves (functions of a number v)", wave_table, WAVE_COUNT);
    put_line(&out, "Chain", CHAIN_DOC);
    list_colors(&out);
    LIST(&out, "Channels (what a map can be asked for)", channel_table, CHANNEL_COUNT);
    LIST(&out, "Slots (what a material tells about a point)", slot_table, SLOT_COUNT);
    LIST(&out, "Targets", target_table, TARGET_COUNT);
    LIST(&out, "Passes", pass_table, PASS_COUNT);
    LIST(&out, "Layouts", layout_table, LAYOUT_COUNT);
    LIST(&out, "Encodings", encoding_table, ENCODING_COUNT);
    for (int i = 0; i < CHOICE_COUNT; i++) {
        const AxisRow *axis = &axis_table[choice_table[i].axis];
        if (axis->first == i)
            put_heading(&out, axis->doc);
        put_line(&out, choice_table[i].name, choice_table[i].doc);
    }
    return describe_finish(&out);
}
