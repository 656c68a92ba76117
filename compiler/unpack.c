/* The other side of a layout: GLSL that reads the render targets back into a Surface. Made from the layout's rows. */
#include "emit.h"
#include <string.h>

static void put_body(Compile *c, Text *out, const Job *job, const char *chunk)
{
    Chunks chunks = {0};
    chunks_add(c, &chunks, chunk, job);
    for (size_t i = 0; i < chunks.count; i++) {
        text_put(out, chunks.at[i]->body);
        text_char(out, '\n');
    }
}

static bool has_encoding(Layout layout, Encoding encoding)
{
    for (int i = 0; i < field_count; i++)
        if (field_table[i].layout == layout && field_table[i].encoding == encoding)
            return true;
    return false;
}

static bool has_slot(Layout layout, Slot slot)
{
    for (int i = 0; i < field_count; i++)
        if (field_table[i].layout == layout &&
            (field_table[i].slot == slot || (field_table[i].encoding == ENCODING_pair && field_table[i].other == slot)))
            return true;
    return false;
}

static void put_struct(Text *out, Layout layout)
{
    text_put(out, "struct Surface {\n");
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (has_slot(layout, (Slot)slot))
            text_format(out, "    %s %s; // %s\n", type_table[slot_table[slot].type].name, slot_table[slot].name,
                        slot == SLOT_normal ? "Shading normal in eye space, unit length." : slot_table[slot].doc);
    text_put(out, "};\n\n");
}

static void put_lanes(Text *out, int from, int count)
{
    text_char(out, '.');
    for (int i = 0; i < count; i++)
        text_char(out, "xyzw"[from + i]);
}

static void put_target(Text *out, const FieldRow *field, int count)
{
    text_format(out, "target%d", field->target);
    put_lanes(out, field->lane, count);
}

/* surface.slot, and the lane if the slot has more than one. */
static void put_destination(Text *out, Slot slot, int lane)
{
    text_format(out, "    surface.%s", slot_table[slot].name);
    if (type_table[slot_table[slot].type].lanes > 1)
        put_lanes(out, lane, 1);
}

static void put_field(Text *out, const FieldRow *field, int index)
{
    if (field->encoding == ENCODING_spheremap) {
        text_format(out, "    surface.%s = decodeSpheremap(", slot_table[field->slot].name);
        put_target(out, field, 2);
        text_put(out, ");\n");
    } else if (field->encoding == ENCODING_raw) {
        text_format(out, "    surface.%s = ", slot_table[field->slot].name);
        put_target(out, field, field->count);
        text_put(out, ";\n");
    } else {
        text_format(out, "    vec2 pair%d = unpackPair(", index);
        put_target(out, field, 1);
        text_put(out, ");\n");
        put_destination(out, field->slot, field->from);
        text_format(out, " = pair%d.x;\n", index);
        put_destination(out, field->other, field->other_lane);
        text_format(out, " = pair%d.y;\n", index);
    }
}

const char *emit_unpack(Compile *c, const Job *job)
{
    Text out = text_new(c->arena);
    bool old = job->target == TARGET_glsl110;
    const LayoutRow *layout = &layout_table[job->layout];
    text_format(&out, "// matc " MATC_VERSION ": reads layout %s back. The normal is in eye space.\n\n", layout->name);
    for (int i = 0; i < layout->targets; i++) {
        if (job->target == TARGET_glsl450 || job->target == TARGET_spirv)
            text_format(&out, "layout(binding = %d) ", i);
        text_format(&out, "uniform sampler2D matc_gbuffer%d;\n", i);
    }
    text_char(&out, '\n');
    put_struct(&out, job->layout);
    if (has_encoding(job->layout, ENCODING_spheremap))
        put_body(c, &out, job, "decodeSpheremap");
    if (has_encoding(job->layout, ENCODING_pair))
        put_body(c, &out, job, "unpackPair");
    text_format(&out, "Surface unpackSurface(%s) {\n", old ? "vec2 coordinate" : "ivec2 pixel");
    for (int i = 0; i < layout->targets; i++)
        text_format(&out,
                    old ? "    vec4 target%d = texture2D(matc_gbuffer%d, coordinate);\n"
                        : "    vec4 target%d = texelFetch(matc_gbuffer%d, pixel, 0);\n",
                    i, i);
    text_put(&out, "    Surface surface;\n");
    for (int i = 0; i < field_count; i++)
        if (field_table[i].layout == job->layout)
            put_field(&out, &field_table[i], i);
    text_put(&out, "    return surface;\n}\n");
    return out.at;
}
