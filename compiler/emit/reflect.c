/* The reflection of a program as JSON: its inputs and outputs. */
#include "compiler/ir/constants.h"
#include "compiler/emit/emit.h"
#include "compiler/emit/emit_declare.h"
#include "compiler/emit/attribute.h"
#include "compiler/emit/compute.h"
#include "compiler/base/json_write.h"
#include "compiler/emit/texture.h"
#include "compiler/ir/std140.h"
#include <math.h>
#include <string.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

static const char *const sources[] = {"varying", "system", "draw", "change", "vertex", "object"};

typedef struct {
    Text *out;
    bool first; /* the list is still empty */
} List;

static List open_list(Text *out, const char *name)
{
    text_put(out, ",\n  ");
    json_key(out, name);
    text_put(out, "[");
    return (List){out, true};
}

static void next(List *list)
{
    text_put(list->out, list->first ? "\n    " : ",\n    ");
    list->first = false;
}

/* Begins an object with its name and type. */
static void put_typed(Text *out, const char *name, const char *type)
{
    text_put(out, "{");
    json_member(out, "name", name);
    json_next(out, "type", type);
}

/* Writes a top-level member on its own line. */
static void put_line(Text *out, const char *key, const char *value)
{
    text_put(out, ",\n  ");
    json_member(out, key, value);
}

static void close_list(List *list) { text_put(list->out, list->first ? "]" : "\n  ]"); }

/* Writes a plain uniform's offset in the block, for targets that have one. */
static void put_offset(Text *out, const Job *job, const char *type, int *size)
{
    if (target_table[job->target].locations)
        text_format(out, ", \"offset\": %d", std140_offset(type, size));
}

/* `size` is the size of the uniform block so far. */
static void put_inputs(Text *out, const Ir *ir, const Job *job, const Interface *interface,
                       int *size)
{
    List list = open_list(out, "inputs");
    for (int i = 0; i < INPUT_COUNT; i++) {
        const InputRow *row = &input_table[i];
        if (!interface->inputs[i] || row->source == SOURCE_change)
            continue;
        next(&list);
        put_typed(out, row->glsl, type_table[row->type].name);
        json_next(out, "source", sources[row->source]);
        if (row->source == SOURCE_varying && target_table[job->target].locations)
            text_format(out, ", \"location\": %d", emit_input_location((Input)i));
        if (emit_is_uniform(interface, (Input)i))
            put_offset(out, job, type_table[row->type].name, size);
        text_put(out, "}");
    }
    for (int i = 0; i < ir->graph->attribute_count; i++) {
        Text name = text_new(ir->arena);
        if (!interface->attributes[i])
            continue;
        next(&list);
        attribute_put_name(&name, ir->graph->attributes[i], ATTRIBUTE_value);
        put_typed(out, name.at, type_table[ir->graph->attributes[i]->type].name);
        json_next(out, "source", "varying");
        if (target_table[job->target].locations)
            text_format(out, ", \"location\": %d", attribute_location(i));
        text_put(out, "}");
    }
    close_list(&list);
}

static void put_uniforms(Text *out, const Ir *ir, const Job *job, const Interface *interface,
                         int *size_of_block)
{
    List list = open_list(out, "uniforms");
    for (int i = 0; i < ir->graph->uniform_count; i++) {
        const Uniform *uniform = ir->graph->uniforms[i];
        if (!interface->uniforms[i])
            continue;
        const char *glsl = interface->counts[i] ? "int" : type_table[uniform->type].name;
        next(&list);
        put_typed(out, uniform->name, glsl);
        put_offset(out, job, glsl, size_of_block);
        text_put(out, ", \"default\": [");
        for (int component = 0; component < type_table[uniform->type].components; component++) {
            text_put(out, component ? ", " : "");
            text_double(out, uniform->initial[component]);
        }
        text_put(out, "]}");
    }
    for (size_t i = 0; i < interface->chunks.count; i++)
        for (const ChunkUniform *uniform = interface->chunks.at[i]->uniforms; uniform->name;
             uniform++) {
            if (uniform->sampler)
                continue;
            next(&list);
            put_typed(out, uniform->name, uniform->type);
            put_offset(out, job, uniform->type, size_of_block);
            text_char(out, '}');
        }
    close_list(&list);
    if (*size_of_block)
        text_format(out, ",\n  \"block\": {\"name\": \"Material\", \"binding\": %d, \"size\": %d}",
                    MATERIAL_BLOCK, std140_size(*size_of_block));
}

/* Describes the constants: members of their own block. The manifest of a batch lists every
 * material's values; a program's reflection does not depend on them. */
static void put_constants(Text *out, const Ir *ir, const Job *job)
{
    if (!ir->constant_count)
        return;
    text_format(out, ",\n  \"constants\": {\"block\": \"" CONSTANT_BLOCK_NAME "\", \"size\": %d",
                constants_size(ir));
    if (target_table[job->target].locations)
        text_format(out, ", \"binding\": %d", CONSTANT_BLOCK);
    List list = {out, true};
    text_put(out, ", \"members\": [");
    for (size_t i = 0; i < ir->constant_count; i++) {
        const IrConstant *own = &ir->constants[i];
        next(&list);
        put_typed(out, own->name, type_table[own->type].name);
        text_format(out, ", \"offset\": %d}", own->offset);
    }
    close_list(&list);
    text_put(out, "}");
}

/* Returns true if a vertex stage samples the texture and the fragment program does not. */
static bool is_of_vertices(const Interface *interface, const MatcTexture *texture, int made_by)
{
    if (!interface->fragment_textures)
        return false;
    return made_by >= 0 ? !interface->fragment_textures[made_by]
                        : !chunks_declare(&interface->fragment_chunks, texture->name);
}

/* Returns the number of mipmap levels down to one texel. */
static int level_count(const MatcTexture *t)
{
    int count = 1;
    for (int side = t->width > t->height ? t->width : t->height; side > 1; side /= 2)
        count++;
    return count;
}

static void put_textures(Session *session, Text *out, const Ir *ir, const Job *job,
                         const Interface *interface)
{
    MatcTexture *textures;
    int *made_by, count = texture_list(session, ir, interface, &textures, &made_by);
    List list = open_list(out, "textures");
    for (int i = 0; i < count; i++) {
        const MatcTexture *t = &textures[i];
        next(&list);
        text_put(out, "{");
        json_member(out, "name", t->name);
        text_format(out, ", \"width\": %d, \"height\": %d", t->width, t->height);
        json_next(out, "format", t->format);
        if (made_by[i] >= 0 && ir->textures[made_by[i]].srgb)
            json_next(out, "colorspace", "srgb");
        json_next(out, "filter", t->mipmaps ? "mipmaps" : "nearest");
        text_format(out, ", \"levels\": %d, \"anisotropy\": %d", t->mipmaps ? level_count(t) : 1,
                    t->anisotropy);
        json_next(out, "wrap", t->wrap);
        if (!strcmp(t->wrap, "clamp_to_border"))
            text_put(out, ", \"border\": [0, 0, 0, 0]");
        text_put(out, ", \"origin\": \"bottom-left\", ");
        if (target_table[job->target].locations)
            text_format(out, "\"binding\": %d, ",
                        made_by[i] >= 0 ? emit_texture_binding(i)
                                        : emit_table_binding(ir, interface, t->name));
        if (is_of_vertices(interface, t, made_by[i]))
            text_put(out, "\"stage\": \"vertex\", ");
        if (t->path)
            json_member(out, "file", t->path);
        text_put(out, t->path ? "}" : "\"baked\": true}");
    }
    close_list(&list);
}

static void put_outputs(Text *out, const Ir *ir, const Job *job)
{
    List list = open_list(out, "outputs");
    bool layout = job->pass == PASS_gbuffer || job->pass == PASS_plane;
    for (int i = 0; i < ir->output_count; i++) {
        const IrOutput *output = &ir->outputs[i];
        bool color = output->kind == OUT_color;
        if (!ir_is_of_fragments(output))
            continue;
        next(&list);
        text_put(out, "{");
        json_member(out, "kind", color ? "color" : output->kind == OUT_depth ? "depth" : "discard");
        if (color) {
            text_format(out, ", \"location\": %d", output->index);
            json_next(out, "format",
                      layout ? format_table[job->layout->formats[output->index]].name : "float");
        }
        text_put(out, "}");
    }
    close_list(&list);
}

static void put_vector(Text *out, const char *name, const double v[3])
{
    text_put(out, ", ");
    json_key(out, name);
    text_char(out, '[');
    for (int i = 0; i < 3; i++) {
        text_put(out, i ? ", " : "");
        text_double(out, v[i]);
    }
    text_char(out, ']');
}

/* Writes the data by which a renderer lights a scene with a SunSkyLight. */
static void put_sky(Text *out, const GraphSky *sky)
{
    text_format(out, ",\n  \"sky\": {\"disableLight\": %s, \"disableSun\": %s",
                sky->light ? "false" : "true", sky->disc ? "false" : "true");
    put_vector(out, "sun", sky->sun);
    put_vector(out, "sunIrradiance", sky->irradiance);
    text_char(out, '}');
}

static void put_displacement(Text *out, const VertexMove *move, double bound)
{
    text_put(out, ",\n  \"displacement\": {");
    json_member(out, "along",
                move->along_tangents ? "tangents"
                : move->volume       ? "volume"
                                     : "normal");
    if (isfinite(bound)) {
        text_put(out, ", \"bound\": ");
        text_double(out, bound);
    }
    text_char(out, '}');
}

const char *emit_reflection(Session *session, const Ir *ir, const Job *job,
                            const Reflected *program)
{
    const Interface *interface = program->interface;
    Text text = text_new(session->arena), *out = &text;
    XXH128_hash_t hash = XXH3_128bits(program->fragment, strlen(program->fragment));
    text_put(out, "{\n  ");
    json_member(out, "matc", MATC_VERSION);
    put_line(out, "material", program->material);
    put_line(out, "target", target_table[job->target].name);
    put_line(out, "pass", pass_table[job->pass].name);
    if (job->pass == PASS_gbuffer || job->pass == PASS_plane) {
        put_line(out, "layout", job->layout->name);
        put_line(out, "normals", normals_table[job->normals].name);
    }
    if (job->pass == PASS_value)
        put_line(out, "slot", slot_table[job->slot].name);
    put_line(out, "noise", choice_table[job->choice[AXIS_noise]].name);
    put_line(out, "opacity", program->opacity);
    if (program->sky)
        put_sky(out, program->sky);
    text_put(out, ",\n  \"choices\": ");
    job_put_json(out, job);
    int block = 0;
    put_inputs(out, ir, job, interface, &block);
    put_uniforms(out, ir, job, interface, &block);
    put_constants(out, ir, job);
    put_textures(session, out, ir, job, interface);
    put_outputs(out, ir, job);
    if (interface->move)
        put_displacement(out, interface->move, program->bound);
    emit_describe_vertex(out, job, interface);
    if (job->computed)
        compute_describe(out, job, interface);
    List files = open_list(out, "sources");
    for (size_t i = 0; i < session->depends.count; i++) {
        next(&files);
        json_string(out, session->depends.at[i]);
    }
    close_list(&files);
    text_format(out, ",\n  \"hash\": \"%016llx%016llx\"\n}\n", (unsigned long long)hash.high64,
                (unsigned long long)hash.low64);
    return out->at;
}
