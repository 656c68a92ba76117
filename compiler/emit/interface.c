/* Declarations of a program for each target: version, inputs, uniforms, textures, outputs. */
#include "compiler/emit/emit.h"
#include "compiler/emit/emit_declare.h"
#include "compiler/emit/attribute.h"
#include <string.h>

void emit_version(Text *out, Target target)
{
    const TargetRow *row = &target_table[target];
    text_format(out, "#version %s\n", row->version);
    if (row->enables)
        text_format(out, "#extension %s : enable\n", row->enables);
    if (row->precision)
        text_format(out, "precision %s float;\nprecision %s int;\nprecision %s sampler2D;\n",
                    row->precision, row->precision, row->precision);
}

/* Bindings 1 to 15, then from 18 on. The two between are the blocks that fragment and vertex
 * program share. */
int emit_texture_binding(int index)
{
    const int below = DRAW_BLOCK - FIRST_TEXTURE_BINDING;
    return index < below ? FIRST_TEXTURE_BINDING + index : CONSTANT_BLOCK + 1 + index - below;
}

int emit_table_binding(const Ir *ir, const Interface *interface, const char *name)
{
    int index = 0;
    for (size_t i = 0; i < ir->texture_count; i++)
        index += interface->textures[i];
    for (size_t i = 0; i < interface->chunks.count; i++)
        for (const ChunkUniform *uniform = interface->chunks.at[i]->uniforms; uniform->name;
             uniform++) {
            if (uniform->sampler && !strcmp(uniform->name, name))
                return emit_texture_binding(index);
            index += uniform->sampler;
        }
    return -1;
}

const char *emit_texture_name(Session *session, const Ir *ir, int texture)
{
    Text name = text_new(session->arena);
    text_format(&name, "%sTexture%d",
                ir->textures[texture].kind == TEXTURE_image ? "image" : "carpenter", texture);
    return name.at;
}

void emit_varying(Text *out, Target target, Input input, const char *word)
{
    const InputRow *row = &input_table[input];
    if (target_table[target].locations)
        text_format(out, "layout(location = %d) ", emit_input_location(input));
    text_format(out, "%s %s %s;\n", target_table[target].in_out ? word : "varying",
                type_table[row->type].name, row->glsl);
}

static void put_members(Text *out, const Ir *ir, const char *prefix)
{
    for (size_t i = 0; i < ir->constant_count; i++)
        text_format(out, "%s%s %s;\n", prefix, type_table[ir->constants[i].type].name,
                    ir->constants[i].name);
}

/* Declares the constants of all materials that share the program; each vertex has the index of
 * its instance's material. */
static void put_numbers(Text *out, const Ir *ir)
{
    text_put(out, "struct Numbers {\n");
    put_members(out, ir, "    ");
    text_format(out, "};\nlayout(std140, binding = %d) readonly buffer " CONSTANT_BLOCK_NAME " {\n",
                NUMBER_BUFFER);
    text_put(out, "    Numbers matc_numbers[];\n};\n");
}

/* Declares a material's constants, as a block where GLSL has blocks. A block in use is declared
 * completely, since its offsets are guaranteed. */
static void put_constants(Text *out, const Ir *ir, const Job *job)
{
    bool block = target_table[job->target].blocks;
    if (!ir->constant_count)
        return;
    if (job->instances) {
        put_numbers(out, ir);
        return;
    }
    if (target_table[job->target].locations)
        text_format(out, "layout(std140, binding = %d) uniform " CONSTANT_BLOCK_NAME " {\n",
                    CONSTANT_BLOCK);
    else if (block)
        text_put(out, "layout(std140) uniform " CONSTANT_BLOCK_NAME " {\n");
    put_members(out, ir, block ? "    " : "uniform ");
    text_put(out, block ? "};\n" : "");
}

bool emit_is_uniform(const Interface *interface, Input input)
{
    const InputSource source = input_table[input].source;
    return interface->inputs[input] &&
           (source == SOURCE_draw || (source == SOURCE_object && !interface->instances));
}

/* Declares all plain uniforms: draw inputs, params, and those of chunks, each preceded by
 * `prefix`. Returns their number. */
static int put_uniforms(Text *out, const Ir *ir, const Interface *interface, const char *prefix)
{
    int count = 0;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (emit_is_uniform(interface, (Input)i)) {
            text_format(out, "%s%s %s;\n", prefix, type_table[input_table[i].type].name,
                        input_table[i].glsl);
            count++;
        }
    for (int i = 0; i < ir->graph->uniform_count; i++) {
        if (!interface->uniforms[i])
            continue;
        const char *type =
            interface->counts[i] ? "int" : type_table[ir->graph->uniforms[i]->type].name;
        text_format(out, "%s%s %s;\n", prefix, type, ir->graph->uniforms[i]->name);
        count++;
    }
    for (size_t i = 0; i < interface->chunks.count; i++)
        for (const ChunkUniform *uniform = interface->chunks.at[i]->uniforms; uniform->name;
             uniform++)
            if (!uniform->sampler) {
                text_format(out, "%s%s %s;\n", prefix, uniform->type, uniform->name);
                count++;
            }
    return count;
}

static void put_sampler(Text *out, Target target, int index, const char *type, const char *name)
{
    if (target_table[target].locations)
        text_format(out, "layout(binding = %d) ", emit_texture_binding(index));
    text_format(out, "uniform %s %s;\n", type, name);
}

static bool has_chunk(const Chunks *chunks, const Chunk *chunk)
{
    for (size_t i = 0; i < chunks->count; i++)
        if (chunks->at[i] == chunk)
            return true;
    return false;
}

/* Writes samplers. Textures are numbered over all stages. */
static void put_samplers(Session *session, Text *out, const Ir *ir, const Job *job, Declared d)
{
    int index = 0;
    for (size_t i = 0; i < ir->texture_count; i++) {
        if (d.own->textures[i])
            put_sampler(out, job->target, index, "sampler2D",
                        emit_texture_name(session, ir, (int)i));
        index += d.all->textures[i];
    }
    for (size_t i = 0; i < d.all->chunks.count; i++)
        for (const ChunkUniform *uniform = d.all->chunks.at[i]->uniforms; uniform->name;
             uniform++) {
            if (uniform->sampler && has_chunk(&d.own->chunks, d.all->chunks.at[i]))
                put_sampler(out, job->target, index, uniform->type, uniform->name);
            index += uniform->sampler;
        }
}

/* Writes plain uniforms. Every stage that uses the block declares all of its members. */
static void put_plain(Session *session, Text *out, const Ir *ir, const Job *job, Declared d)
{
    Text uniforms = text_new(session->arena);
    bool block = target_table[job->target].locations;
    if (!put_uniforms(&uniforms, ir, d.own, "uniform "))
        return;
    if (block) {
        uniforms = text_new(session->arena);
        put_uniforms(&uniforms, ir, d.all, "    ");
        text_format(out, "layout(std140, binding = %d) uniform Material {\n", MATERIAL_BLOCK);
    }
    text_put(out, uniforms.at);
    text_put(out, block ? "};\n" : "");
}

void emit_move_declarations(Session *session, Text *out, const Ir *ir, const Job *job, Declared d)
{
    put_plain(session, out, ir, job, d);
    if (d.own->members)
        put_constants(out, ir, job);
    put_samplers(session, out, ir, job, d);
}

void emit_declarations(Session *session, Text *out, const Ir *ir, const Job *job, Declared d)
{
    emit_version(out, job->target);
    text_format(out, "// matc " MATC_VERSION ": pass %s", pass_table[job->pass].name);
    if (job->pass == PASS_gbuffer || job->pass == PASS_plane)
        text_format(out, ", layout %s%s", job->layout->name,
                    job->normals == NORMALS_world ? ", normals of the world" : "");
    if (job->pass == PASS_value)
        text_format(out, ", slot %s", slot_table[job->slot].name);
    text_put(out, "\n");
    job_put_choices(out, job);
    text_put(out, "\n");
    size_t before = out->size;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (d.own->inputs[i] && input_table[i].source == SOURCE_varying)
            emit_varying(out, job->target, (Input)i, "in");
    attribute_put_varyings(out, job, d.own, "in");
    if (job->instances && d.own->inputs[INPUT_object])
        text_format(out, "layout(location = %d) flat in float %s;\n", emit_object_location(),
                    input_table[INPUT_object].glsl);
    put_plain(session, out, ir, job, d);
    if (ir->constant_count && job->instances)
        text_format(out, "layout(location = %d) flat in uint matc_material;\n",
                    emit_input_location(INPUT_COUNT));
    put_constants(out, ir, job);
    put_samplers(session, out, ir, job, d);
    for (int i = 0; i < ir->output_count; i++)
        if (ir->outputs[i].kind == OUT_color && target_table[job->target].in_out)
            text_format(out, "layout(location = %d) out %s fragment%d;\n", ir->outputs[i].index,
                        type_table[ir_type(ir, ir->outputs[i].value)].name, ir->outputs[i].index);
    if (out->size > before)
        text_char(out, '\n');
}
