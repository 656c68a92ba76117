/* Writes a LayoutRow as YAML. */
#include "compiler/base/json_write.h"
#include "compiler/layout/layout_read.h"

/* Writes "diffuse", "diffuse.rg" or "[emissive.b, ambient.r]". */
static void put_slots(Text *out, const FieldRow *field)
{
    const SlotComponent *source = field->source;
    const Piece whole = {.field = field, .count = field->count};
    if (field->gray || piece_is_slot(&whole)) {
        text_put(out, slot_table[source[0].slot].name);
        return;
    }
    bool list = false;
    for (int i = 1; i < field->count; i++)
        list |= source[i].slot != source[0].slot;
    text_put(out, list ? "[" : "");
    for (int i = 0; i < field->count; i++) {
        if (!i || source[i].slot != source[i - 1].slot)
            text_format(out, "%s%s.", i ? ", " : "", slot_table[source[i].slot].name);
        text_char(out, "rgba"[source[i].component]);
    }
    text_put(out, list ? "]" : "");
}

static void put_field(Text *out, const FieldRow *field, const char *indent)
{
    const EncodingRow *encoding = &encoding_table[field->encoding];
    text_format(out, "%s- { slot: ", indent);
    put_slots(out, field);
    text_format(out, ", encoding: %s", encoding->name);
    if (encoding->least != encoding->most)
        text_format(out, ", bits: %d", field->bits);
    if (field_has_range(field)) {
        text_put(out, ", range: [");
        text_double(out, field->low);
        text_put(out, ", ");
        text_double(out, field->high);
        text_put(out, "]");
    }
    text_put(out, field->gray ? ", gray: true }\n" : " }\n");
}

static void put_doc(Text *out, const char *before, const char *doc)
{
    text_put(out, before);
    json_string(out, doc);
    text_char(out, '\n');
}

static void put_constants(Text *out, const FixedRow *rows, int count, const char *indent)
{
    if (count)
        text_format(out, "%sconstants:\n", indent);
    for (int i = 0; i < count; i++) {
        const int components = type_table[slot_table[rows[i].slot].type].components;
        text_format(out, components > 1 ? "%s  %s: [" : "%s  %s: ", indent,
                    slot_table[rows[i].slot].name);
        for (int component = 0; component < components; component++) {
            text_put(out, component ? ", " : "");
            text_double(out, rows[i].value[component]);
        }
        text_put(out, components > 1 ? "]\n" : "\n");
    }
}

void layout_write(Text *out, const LayoutRow *row)
{
    text_format(out, "layout: %s\n", row->name);
    if (*row->doc)
        put_doc(out, "doc: ", row->doc);
    text_put(out, "targets: [");
    for (int i = 0; i < layout_targets(row); i++)
        text_format(out, "%s%s", i ? ", " : "", format_table[row->formats[i]].name);
    text_put(out, "]\nfields:\n");
    for (int i = 0; i < row->cases[0].field_count; i++)
        put_field(out, &row->cases[0].fields[i], "  ");
    text_put(out, row->case_count > 1 ? "cases:\n" : "");
    for (int number = 1; number < row->case_count; number++) {
        put_doc(out, "  - doc: ", row->cases[number].doc);
        if (number >= row->case_count - row->further_count)
            text_put(out, "    further: true\n");
        put_constants(out, row->cases[number].fixed, row->cases[number].fixed_count, "    ");
        text_put(out, "    fields:\n");
        for (int i = 0; i < row->cases[number].field_count; i++)
            put_field(out, &row->cases[number].fields[i], "      ");
    }
    put_constants(out, row->fixed, row->fixed_count, "");
}
