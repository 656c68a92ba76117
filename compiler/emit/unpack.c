/* The other side of a layout: GLSL that reads the render targets back into a Surface. Made from the layout's rows. */
#include "compiler/emit/emit.h"
#include "compiler/layout/layout.h"
#include <string.h>

static bool takes(const Job *job, int number) { return !job->cases || job->cases >> number & 1; }

/* The slot is in what comes back: of the layout, or of a case that is taken. */
static bool comes_back(const Job *job, Slot slot)
{
    if (layout_fixed(job->layout, slot))
        return true;
    for (int i = 0; i < job->layout->case_count; i++)
        if (takes(job, i) &&
            (layout_case_has_slot(&job->layout->cases[i], slot) || layout_case_fixed(&job->layout->cases[i], slot)))
            return true;
    return false;
}

/* Of the cases that are taken, the last, which needs no question. */
static int last_taken(const Job *job)
{
    int last = job->layout->case_count - 1;
    while (last > 0 && !takes(job, last))
        last--;
    return last;
}

static int first_taken(const Job *job)
{
    int first = 0;
    while (first < last_taken(job) && !takes(job, first))
        first++;
    return first;
}

/* The chunks that decode the layout's fields, each once. */
static void put_chunks(Session *session, Text *out, const Job *job)
{
    Chunks chunks = {0};
    for (int i = 0; i < job->layout->case_count; i++)
        for (int k = 0; takes(job, i) && k < job->layout->cases[i].field_count; k++) {
            const char *name = encoding_table[job->layout->cases[i].fields[k].encoding].unpack;
            if (*name)
                chunks_add(session, &chunks, name, job);
        }
    for (size_t i = 0; i < chunks.count; i++) {
        text_put(out, chunks.at[i]->body);
        text_char(out, '\n');
    }
}

static const char *in_space(const Job *job) { return job->normals == NORMALS_world ? "in the world" : "in eye space"; }

/* What a light pass can ask for: SURFACE_HAS_<slot> stands for each member, SURFACE_NORMALS_<space> for where the normal is. */
static void put_struct(Text *out, const Job *job)
{
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (comes_back(job, (Slot)slot))
            text_format(out, "#define SURFACE_HAS_%s\n", slot_table[slot].name);
    if (comes_back(job, SLOT_normal))
        text_format(out, "#define SURFACE_NORMALS_%s\n", normals_table[job->normals].name);
    text_put(out, "struct Surface {\n");
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (slot == SLOT_normal && comes_back(job, SLOT_normal))
            text_format(out, "    vec3 normal; // Shading normal %s, unit length.\n", in_space(job));
        else if (comes_back(job, (Slot)slot))
            text_format(out, "    %s %s; // %s\n", type_table[slot_table[slot].type].name, slot_table[slot].name,
                        slot_table[slot].doc);
    text_put(out, "};\n\n");
}

static void put_lanes(Text *out, int from, int count)
{
    text_char(out, '.');
    for (int i = 0; i < count; i++)
        text_char(out, "xyzw"[from + i]);
}

/* What the piece takes of its target: lanes, or bits: "target0.x >> 8 & 255u". */
static void put_code(Text *out, const LayoutRow *layout, const Piece *piece)
{
    const FormatRow *format = &format_table[layout->formats[piece->target]];
    text_format(out, "target%d", piece->target);
    put_lanes(out, piece->lane, format->words ? 1 : piece->size);
    if (piece->shift)
        text_format(out, " >> %d", piece->shift);
    if (format->words && piece->shift + piece->size < format->bits)
        text_format(out, " & %luu", (1ul << piece->size) - 1);
}

/* The numbers of a piece; of a range, from where it begins: "0.2 + unormFromBits(...) * 0.5". */
static void put_value(Text *out, const LayoutRow *layout, const Piece *piece)
{
    const FieldRow *field = piece->field;
    const char *unpack = encoding_table[field->encoding].unpack;
    if (field->low != 0) {
        text_float(out, field->low);
        text_put(out, " + ");
    }
    text_put(out, unpack);
    text_put(out, *unpack ? "(" : "");
    put_code(out, layout, piece);
    if (piece_takes_bits(piece))
        text_format(out, ", %d", piece->field->bits);
    text_put(out, *unpack ? ")" : "");
    if (field_has_range(field) && field->high - field->low != 1) {
        text_put(out, " * ");
        text_float(out, field->high - field->low);
    }
}

/* surface.slot, and the lane if the slot has more than one. */
static void put_destination(Text *out, SlotLane to)
{
    text_format(out, "surface.%s", slot_table[to.slot].name);
    if (type_table[slot_table[to.slot].type].lanes > 1)
        put_lanes(out, to.lane, 1);
    text_put(out, " = ");
}

/* The number of a piece whose lanes belong to several slots is kept, then dealt out. */
static void put_dealt(Text *out, const LayoutRow *layout, const Piece *piece, const char *indent, int index)
{
    static const char *const types[] = {"float", "float", "vec2", "vec3", "vec4"};
    text_format(out, "%s%s group%d = ", indent, types[piece->count], index);
    put_value(out, layout, piece);
    text_put(out, ";\n");
    for (int i = 0; i < piece->count; i++) {
        text_put(out, indent);
        put_destination(out, piece->field->source[piece->first + i]);
        text_format(out, "group%d", index);
        put_lanes(out, i, 1);
        text_put(out, ";\n");
    }
}

static void put_piece(Text *out, const LayoutRow *layout, const Piece *piece, const char *indent, int index)
{
    const SlotLane *source = &piece->field->source[piece->first];
    if (piece->count > 1 && !piece_is_slot(piece)) {
        put_dealt(out, layout, piece, indent, index);
        return;
    }
    const SlotRow *slot = &slot_table[source->slot];
    text_put(out, indent);
    if (piece->count == 1 && !piece->field->gray)
        put_destination(out, *source);
    else
        text_format(out, "surface.%s = ", slot->name);
    if (piece->field->gray)
        text_format(out, "%s(", type_table[slot->type].name);
    put_value(out, layout, piece);
    text_put(out, piece->field->gray ? ");\n" : ";\n");
}

/* A slot that is not stored: the same for all of the case or the layout, or as absent ones are. */
static void put_known(Text *out, const LayoutRow *layout, const CaseRow *of, Slot slot, const char *indent)
{
    const FixedRow *own = layout_case_fixed(of, slot), *fixed = own ? own : layout_fixed(layout, slot);
    const bool single = type_table[slot_table[slot].type].lanes == 1;
    text_format(out, "%ssurface.%s = %s%s", indent, slot_table[slot].name,
                single ? "" : type_table[slot_table[slot].type].name, single ? "" : "(");
    for (int lane = 0; lane < (fixed ? type_table[slot_table[slot].type].lanes : 1); lane++) {
        text_put(out, lane ? ", " : "");
        text_float(out, fixed ? fixed->value[lane] : slot_table[slot].absent);
    }
    text_put(out, single ? ";\n" : ");\n");
}

/* In ESSL a fragment program has no precision of its own for float, and a sampler's is lowp: 8 bits of a half float. */
static void put_samplers(Text *out, const Job *job)
{
    const TargetRow *target = &target_table[job->target];
    for (int i = 0; i < layout_targets(job->layout); i++) {
        bool words = format_table[job->layout->formats[i]].words;
        if (target->locations)
            text_format(out, "layout(binding = %d) ", i);
        text_format(out, "uniform %s%s%ssampler2D matc_gbuffer%d;\n", target->precision ? target->precision : "",
                    target->precision ? " " : "", words ? "u" : "", i);
    }
    text_char(out, '\n');
}

/* "uvec4 target0, vec4 target1" */
static void put_parameters(Text *out, const Job *job)
{
    for (int i = 0; i < layout_targets(job->layout); i++)
        text_format(out, "%s%s target%d", i ? ", " : "", format_table[job->layout->formats[i]].words ? "uvec4" : "vec4",
                    i);
}

/* From where the targets lie. */
static void put_fetching(Text *out, const Job *job)
{
    const bool fetches = target_table[job->target].words;
    text_format(out, "\nSurface unpackSurface(%s) {\n    return unpackTexels(",
                fetches ? "ivec2 pixel" : "vec2 coordinate");
    for (int i = 0; i < layout_targets(job->layout); i++)
        text_format(out, fetches ? "%stexelFetch(matc_gbuffer%d, pixel, 0)" : "%stexture2D(matc_gbuffer%d, coordinate)",
                    i ? ", " : "", i);
    text_put(out, ");\n}\n");
}

static bool leaves_out(const Job *job, int number, Slot slot)
{
    return comes_back(job, slot) && !layout_case_has_slot(&job->layout->cases[number], slot);
}

/* The pieces of a case, then the slots that it leaves out; of `several` cases those alone that it says itself. */
static void put_case(Text *out, const Job *job, int number, bool several)
{
    const LayoutRow *layout = job->layout;
    const CaseRow *row = &layout->cases[number];
    const char *indent = several ? "        " : "    ";
    Placement placement;
    layout_allocate(layout, number, &placement); /* lowering has told what does not fit */
    for (int i = 0; i < placement.count; i++)
        put_piece(out, layout, &placement.pieces[i], indent, i);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (leaves_out(job, number, (Slot)slot) && (!several || layout_case_fixed(row, (Slot)slot)))
            put_known(out, layout, row, (Slot)slot, indent);
}

/* What slots are in cases that leave them out: said once, before it is known which case it is. */
static void put_left_out(Text *out, const Job *job)
{
    static const CaseRow none = {0};
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        for (int i = 0; i <= last_taken(job); i++)
            if (takes(job, i) && leaves_out(job, i, (Slot)slot) &&
                !layout_case_fixed(&job->layout->cases[i], (Slot)slot)) {
                put_known(out, job->layout, &none, (Slot)slot, "    ");
                break;
            }
}

/* Which case it is. */
static void put_number(Text *out, const LayoutRow *layout)
{
    const int bits = layout_case_bits(layout), last = layout_targets(layout) - 1;
    const int plain = layout->case_count - layout->further_count;
    const Further further = layout_further(layout);
    if (bits)
        text_format(out, "    uint number = target0.x & %uu;\n", (1u << bits) - 1);
    else
        text_put(out, "    uint number = 0u;\n");
    if (layout->further_count) {
        text_format(out, bits ? "    if (number == 0u && target%d." : "    if (target%d.", last);
        text_char(out, "xyzw"[format_table[layout->formats[last]].lanes - 1]);
        text_format(out, " >> %d == 1u) number = %du", format_table[layout->formats[last]].bits - 1, plain);
        if (further.bits)
            text_format(out, " + (target0.x >> %d & %uu)", bits, (1u << further.bits) - 1);
        text_put(out, ";\n");
    }
    if (further.more_bits)
        text_format(out, "    if (number == %du) number += target0.x >> %d & %uu;\n", plain + further.few,
                    bits + further.bits, (1u << further.more_bits) - 1);
    text_put(out, "    ");
}

static void put_cases(Text *out, const Job *job)
{
    const int last = last_taken(job);
    if (first_taken(job) == last) {
        put_case(out, job, last, false);
        return;
    }
    put_left_out(out, job);
    put_number(out, job->layout);
    for (int i = 0; i <= last; i++) {
        if (!takes(job, i))
            continue;
        if (i < last)
            text_format(out, "if (number == %du) ", i);
        text_put(out, "{\n");
        put_case(out, job, i, true);
        text_put(out, i < last ? "    } else " : "    }\n");
    }
}

const char *emit_unpack(Session *session, const Job *job)
{
    const TargetRow *target = &target_table[job->target];
    Text out = text_new(session->arena);
    text_format(&out, "// matc " MATC_VERSION ": reads layout %s back. The normal is %s.\n\n", job->layout->name,
                in_space(job));
    if (target->precision)
        text_format(&out, "precision %s float;\nprecision %s int;\n", target->precision, target->precision);
    put_samplers(&out, job);
    put_struct(&out, job);
    put_chunks(session, &out, job);
    text_put(&out, "Surface unpackTexels(");
    put_parameters(&out, job);
    text_put(&out, ") {\n    Surface surface;\n");
    put_cases(&out, job);
    text_put(&out, "    return surface;\n}\n");
    put_fetching(&out, job);
    return out.at;
}
