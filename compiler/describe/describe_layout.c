/* Writes a layout as a page: its targets, then every field of every case with its place, bits,
 * range and error. */
#include "compiler/describe/describe.h"

static void put_constants(Text *out, const FixedRow *fixed, int count)
{
    for (int i = 0; i < count; i++) {
        text_format(out, "  %-9s  %-42s ", "constant", slot_table[fixed[i].slot].name);
        for (int component = 0; component < type_table[slot_table[fixed[i].slot].type].components;
             component++) {
            text_char(out, ' ');
            text_rounded(out, fixed[i].value[component], 6);
        }
        text_char(out, '\n');
    }
}

static void put_pieces(Text *out, const LayoutRow *layout, int number)
{
    Placement placement;
    /* cannot fail, as an earlier check ensures that every row fits */
    layout_allocate(layout, number, &placement);
    if (number)
        text_format(out, "\nCase %d: %s\n", number, layout->cases[number].doc);
    text_format(out, "  %-9s  %-42s  %-18s  %-18s  %s\n", "place", "slot", "encoding", "stored",
                "error at most");
    for (int i = 0; i < placement.count; i++) {
        const Piece *piece = &placement.pieces[i];
        Text cells[5];
        for (int k = 0; k < 5; k++)
            cells[k] = text_new(out->arena);
        describe_allocation(&cells[0], layout, piece);
        describe_piece(&cells[1], piece);
        layout_put_encoding(&cells[2], piece->field);
        layout_put_range(&cells[3], piece->field);
        describe_error(&cells[4], piece->field);
        text_format(out, "  %-9s  %-42s  %-18s  %-18s  %s\n", cells[0].at, cells[1].at, cells[2].at,
                    cells[3].at, cells[4].at);
    }
    put_constants(out, layout->cases[number].fixed, layout->cases[number].fixed_count);
}

void describe_layout(Text *out, const LayoutRow *layout)
{
    text_format(out, "%s (layout, %d bytes a pixel)\n", layout->name, layout_bytes(layout));
    if (*layout->doc)
        text_format(out, "%s\n", layout->doc);
    text_put(out, "Targets:");
    for (int target = 0; target < layout_targets(layout); target++)
        text_format(out, " %d %s%s", target, format_table[layout->formats[target]].name,
                    target + 1 < layout_targets(layout) ? "," : ".\n\n");
    for (int number = 0; number < layout->case_count; number++)
        put_pieces(out, layout, number);
    text_put(out, layout->fixed_count ? "\n" : "");
    put_constants(out, layout->fixed, layout->fixed_count);
    if (!layout_is_whole(layout))
        text_put(
            out,
            "\nNo case stores all slots: a material that has more than each of them is refused.\n");
}
