/* Unpacking of a layout: GLSL that reads the render targets back into a Surface, generated from
 * the layout's rows. */
#include "compiler/emit/emit.h"
#include "compiler/emit/unpack_shared.h"
#include "compiler/layout/layout.h"
#include <string.h>

/* Returns true if unpacking yields the slot: constant in the layout, or stored or constant in a
 * case that is read. */
static bool comes_back(const Job *job, Slot slot)
{
    if (layout_fixed(job->layout, slot))
        return true;
    for (int i = 0; i < job->layout->case_count; i++)
        if (unpack_takes(job, i) && (layout_case_has_slot(&job->layout->cases[i], slot) ||
                                     layout_case_fixed(&job->layout->cases[i], slot)))
            return true;
    return false;
}

/* Returns the last case that is read, which needs no comparison. */
static int last_taken(const Job *job)
{
    int last = job->layout->case_count - 1;
    while (last > 0 && !unpack_takes(job, last))
        last--;
    return last;
}

static int first_taken(const Job *job)
{
    int first = 0;
    while (first < last_taken(job) && !unpack_takes(job, first))
        first++;
    return first;
}

/* Writes a library function. Its comments are kept only when all cases are read: that text
 * documents the layout for readers. */
static void put_chunk(Text *out, const Job *job, const char *body)
{
    for (size_t size; *body; body += size) {
        size = strcspn(body, "\n");
        size += body[size] == '\n';
        if (!job->cases || strncmp(body, "//", 2) != 0)
            text_add(out, body, size);
    }
    text_char(out, '\n');
}

/* Writes the chunks that decode the layout's fields, each once. */
static void put_chunks(Session *session, Text *out, const Job *job)
{
    Chunks chunks = {0};
    for (int i = 0; i < job->layout->case_count; i++)
        for (int k = 0; unpack_takes(job, i) && k < job->layout->cases[i].field_count; k++) {
            const char *name = encoding_table[job->layout->cases[i].fields[k].encoding].unpack;
            if (*name)
                chunks_add(session, &chunks, name, job);
        }
    for (size_t i = 0; i < chunks.count; i++)
        put_chunk(out, job, chunks.at[i]->body);
}

static const char *in_space(const Job *job)
{
    return job->normals == NORMALS_world ? "in the world" : "in eye space";
}

/* Declares macros for light passes: SURFACE_HAS_<slot> for each member, SURFACE_NORMALS_<space>
 * for the space of normals. */
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
            text_format(out, "    vec3 normal; // Shading normal %s, unit length.\n",
                        in_space(job));
        else if (comes_back(job, (Slot)slot))
            text_format(out, "    %s %s; // %s\n", type_table[slot_table[slot].type].name,
                        slot_table[slot].name, slot_table[slot].doc);
    text_put(out, "};\n\n");
}

static void put_components(Text *out, int from, int count)
{
    text_char(out, '.');
    for (int i = 0; i < count; i++)
        text_char(out, "xyzw"[from + i]);
}

/* Extracts a piece from its target, components or bits: "target0.x >> 8 & 255u". */
static void put_code(Text *out, const LayoutRow *layout, const Piece *piece)
{
    const FormatRow *format = &format_table[layout->formats[piece->target]];
    text_format(out, "target%d", piece->target);
    put_components(out, piece->component, format->words ? 1 : piece->size);
    if (piece->shift)
        text_format(out, " >> %d", piece->shift);
    if (format->words && piece->shift + piece->size < format->bits)
        text_format(out, " & %luu", (1ul << piece->size) - 1);
}

/* Writes the decoded value of a piece, with its range: "0.2 + unormFromBits(...) * 0.5". */
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

/* Writes surface.slot, and the component if the slot has several. */
static void put_destination(Text *out, SlotComponent to)
{
    text_format(out, "surface.%s", slot_table[to.slot].name);
    if (type_table[slot_table[to.slot].type].components > 1)
        put_components(out, to.component, 1);
    text_put(out, " = ");
}

/* Decodes a piece whose components belong to several slots into a variable, then assigns the
 * components. */
static void put_dealt(Text *out, const LayoutRow *layout, const Piece *piece, const char *indent,
                      int index)
{
    static const char *const types[] = {"float", "float", "vec2", "vec3", "vec4"};
    text_format(out, "%s%s group%d = ", indent, types[piece->count], index);
    put_value(out, layout, piece);
    text_put(out, ";\n");
    for (int i = 0; i < piece->count; i++) {
        text_put(out, indent);
        put_destination(out, piece->field->source[piece->first + i]);
        text_format(out, "group%d", index);
        put_components(out, i, 1);
        text_put(out, ";\n");
    }
}

static void put_piece(Text *out, const LayoutRow *layout, const Piece *piece, const char *indent,
                      int index)
{
    const SlotComponent *source = &piece->field->source[piece->first];
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

/* Returns the number of leading pieces that are the components of one slot in order; 0: none. */
static int vector_of(const Piece *pieces, int count)
{
    const SlotComponent *first = &pieces->field->source[pieces->first];
    const int components = type_table[slot_table[first->slot].type].components;
    if (components < 2 || components > count)
        return 0;
    for (int i = 0; i < components; i++) {
        const SlotComponent *source = &pieces[i].field->source[pieces[i].first];
        if (pieces[i].count != 1 || pieces[i].field->gray || source->slot != first->slot ||
            source->component != i)
            return 0;
    }
    return components;
}

/* Writes surface.diffuse = vec3(...); */
static void put_vector(Text *out, const LayoutRow *layout, const Piece *pieces, const char *indent)
{
    const SlotRow *slot = &slot_table[pieces->field->source[pieces->first].slot];
    text_format(out, "%ssurface.%s = %s(", indent, slot->name, type_table[slot->type].name);
    for (int i = 0; i < type_table[slot->type].components; i++) {
        text_put(out, i ? ", " : "");
        put_value(out, layout, &pieces[i]);
    }
    text_put(out, ");\n");
}

/* Writes the pieces of a case, except those that cases share; NULL: none are shared. */
static void put_pieces(Text *out, const Job *job, const Placement *placement,
                       const UnpackShared *shared)
{
    const char *indent = shared ? "        " : "    ";
    for (int i = 0, components; i < placement->count; i += components) {
        const Piece *piece = &placement->pieces[i];
        bool any = false;
        components = vector_of(piece, placement->count - i);
        for (int k = 0; k < components; k++)
            any |= shared && unpack_is_shared(shared, &piece[k]);
        if (components && !any)
            put_vector(out, job->layout, piece, indent);
        components = components && !any ? components : 1;
        if (components == 1 && !(shared && unpack_is_shared(shared, piece)))
            put_piece(out, job->layout, piece, indent, i);
    }
}

/* Assigns a slot that is not stored: its constant in the case or the layout, or the value of
 * absent slots. */
static void put_known(Text *out, const LayoutRow *layout, const CaseRow *of, Slot slot,
                      const char *indent)
{
    const FixedRow *own = layout_case_fixed(of, slot),
                   *fixed = own ? own : layout_fixed(layout, slot);
    const bool single = type_table[slot_table[slot].type].components == 1;
    text_format(out, "%ssurface.%s = %s%s", indent, slot_table[slot].name,
                single ? "" : type_table[slot_table[slot].type].name, single ? "" : "(");
    for (int component = 0; component < (fixed ? type_table[slot_table[slot].type].components : 1);
         component++) {
        text_put(out, component ? ", " : "");
        text_float(out, fixed ? fixed->value[component] : slot_table[slot].absent);
    }
    text_put(out, single ? ";\n" : ");\n");
}

/* ESSL fragment programs have no default precision for float, and samplers default to lowp,
 * which keeps only 8 bits of a half float. */
static void put_samplers(Text *out, const Job *job)
{
    const TargetRow *target = &target_table[job->target];
    for (int i = 0; i < layout_targets(job->layout); i++) {
        bool words = format_table[job->layout->formats[i]].words;
        if (target->locations)
            text_format(out, "layout(binding = %d) ", i);
        text_format(out, "uniform %s%s%ssampler2D matc_gbuffer%d;\n",
                    target->precision ? target->precision : "", target->precision ? " " : "",
                    words ? "u" : "", i);
    }
    text_char(out, '\n');
}

/* Writes "uvec4 target0, vec4 target1". */
static void put_parameters(Text *out, const Job *job)
{
    for (int i = 0; i < layout_targets(job->layout); i++)
        text_format(out, "%s%s target%d", i ? ", " : "",
                    format_table[job->layout->formats[i]].words ? "uvec4" : "vec4", i);
}

/* Writes unpackSurface(), which fetches the texels. */
static void put_fetching(Text *out, const Job *job)
{
    const bool fetches = target_table[job->target].words;
    text_format(out, "\nSurface unpackSurface(%s) {\n    return unpackTexels(",
                fetches ? "ivec2 pixel" : "vec2 coordinate");
    for (int i = 0; i < layout_targets(job->layout); i++)
        text_format(out,
                    fetches ? "%stexelFetch(matc_gbuffer%d, pixel, 0)"
                            : "%stexture2D(matc_gbuffer%d, coordinate)",
                    i ? ", " : "", i);
    text_put(out, ");\n}\n");
}

static bool leaves_out(const Job *job, int number, Slot slot)
{
    return comes_back(job, slot) && !layout_case_has_slot(&job->layout->cases[number], slot);
}

/* Writes the pieces of a case, then the slots that it omits. */
static void put_case(Text *out, const Job *job, int number)
{
    Placement placement;
    /* lowering has reported fields that do not fit */
    layout_allocate(job->layout, number, &placement);
    put_pieces(out, job, &placement, NULL);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (leaves_out(job, number, (Slot)slot))
            put_known(out, job->layout, &job->layout->cases[number], (Slot)slot, "    ");
}

/* Writes one of several cases: everything not written before the branch. */
static void put_case_of(Text *out, const Job *job, int number, const UnpackShared *shared)
{
    const CaseRow *row = &job->layout->cases[number];
    Placement placement;
    layout_allocate(job->layout, number, &placement);
    put_pieces(out, job, &placement, shared);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (leaves_out(job, number, (Slot)slot) &&
            (layout_case_fixed(row, (Slot)slot) || unpack_shares(shared, (Slot)slot)))
            put_known(out, job->layout, row, (Slot)slot, "        ");
}

/* Writes, before the branch on the case, slots that most cases share, and defaults of slots that
 * some cases omit. */
static void put_before_cases(Text *out, const Job *job, const UnpackShared *shared)
{
    static const CaseRow none = {0};
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        for (int component = 0; component < FIELD_COMPONENTS; component++)
            if (shared->has[slot][component])
                put_piece(out, job->layout, &shared->pieces[slot][component], "    ", slot);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        for (int i = 0; i <= last_taken(job) && !unpack_shares(shared, (Slot)slot); i++)
            if (unpack_takes(job, i) && leaves_out(job, i, (Slot)slot) &&
                !layout_case_fixed(&job->layout->cases[i], (Slot)slot)) {
                put_known(out, job->layout, &none, (Slot)slot, "    ");
                break;
            }
}

/* Decodes the case number. */
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
        text_char(out, "xyzw"[format_table[layout->formats[last]].components - 1]);
        text_format(out, " >> %d == 1u) number = %du", format_table[layout->formats[last]].bits - 1,
                    plain);
        if (further.bits)
            text_format(out, " + (target0.x >> %d & %uu)", bits, (1u << further.bits) - 1);
        text_put(out, ";\n");
    }
    if (further.more_bits)
        text_format(out, "    if (number == %du) number += target0.x >> %d & %uu;\n",
                    plain + further.few, bits + further.bits, (1u << further.more_bits) - 1);
    text_put(out, "    ");
}

static void put_cases(Text *out, const Job *job)
{
    const int last = last_taken(job);
    if (first_taken(job) == last) {
        put_case(out, job, last);
        return;
    }
    const UnpackShared shared = unpack_shared(job);
    put_before_cases(out, job, &shared);
    put_number(out, job->layout);
    for (int i = 0; i <= last; i++) {
        if (!unpack_takes(job, i))
            continue;
        if (i < last)
            text_format(out, "if (number == %du) ", i);
        text_put(out, "{\n");
        put_case_of(out, job, i, &shared);
        text_put(out, i < last ? "    } else " : "    }\n");
    }
}

const char *emit_unpack(Session *session, const Job *job)
{
    const TargetRow *target = &target_table[job->target];
    Text out = text_new(session->arena);
    text_format(&out, "// matc " MATC_VERSION ": reads layout %s back. The normal is %s.\n\n",
                job->layout->name, in_space(job));
    if (target->precision)
        text_format(&out, "precision %s float;\nprecision %s int;\n", target->precision,
                    target->precision);
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
