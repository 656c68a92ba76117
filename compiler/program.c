/* Library API: programs. Compiles a material's IR; program_outputs.c generates the outputs. */
#include "compiler/program.h"
#include "compiler/base/memory.h"
#include "compiler/choice.h"
#include "compiler/layout/layout.h"
#include "compiler/emit/texture.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Lists the live uniforms, in the document's order. */
static void list_uniforms(MatcProgram *p, const Graph *graph)
{
    /* bits per uniform: 1 if used, 2 if used as an int */
    uint8_t *used = ARENA_ARRAY(&p->arena, uint8_t, graph->uniform_count);
    p->uniforms = ARENA_ARRAY(&p->arena, MatcUniform, graph->uniform_count);
    for (Ref ref = 1; ref < p->ir->count; ref++)
        if (ir_is(p->ir, ref, OP_uniform))
            used[ir_at(p->ir, ref)->payload] = ir_type(p->ir, ref) == TYPE_int ? 2 : 1;
    for (int i = 0; i < graph->uniform_count; i++) {
        const Uniform *u = graph->uniforms[i];
        MatcUniform uniform = {u->name, u->name, type_table[u->type].components, used[i] == 2, {0}};
        memcpy(uniform.initial, u->initial, sizeof uniform.initial);
        if (used[i])
            p->uniforms[p->uniform_count++] = uniform;
    }
}

/* Lists the members of the uniform block, with this material's values. */
static void list_constants(MatcProgram *p)
{
    p->constants = ARENA_ARRAY(&p->arena, MatcConstant, p->ir->constant_count + 1);
    for (size_t i = 0; i < p->ir->constant_count; i++) {
        const IrConstant *own = &p->ir->constants[i];
        p->constants[i] = (MatcConstant){own->name,
                                         type_table[own->type].name,
                                         type_table[own->type].components,
                                         own->offset,
                                         own->member,
                                         {0}};
        memcpy(p->constants[i].values, own->numbers, sizeof own->numbers);
    }
}

/* Returns true if the program has outputs; a discard counts as one. */
static bool writes_pixels(const Ir *ir)
{
    for (int i = 0; i < ir->output_count; i++)
        if (ir_is_of_fragments(&ir->outputs[i]))
            return true;
    return false;
}

static bool compile_program(MatcProgram *p)
{
    const Graph *graph = p->document->graph;
    p->ir = compile_ir(&p->session, graph, program_material(p), &p->job);
    if (!p->ir)
        return false;
    if (p->job.pass == PASS_shadow && !writes_pixels(p->ir))
        p->job.pass = PASS_depth; /* nothing is discarded */
    if (p->job.pass == PASS_gbuffer || p->job.pass == PASS_plane)
        p->layout = p->job.layout;
    list_uniforms(p, graph);
    p->attribute_count = attribute_list(p->ir, p->attributes);
    list_constants(p);
    p->texture_count = texture_list(&p->session, p->ir, NULL, &p->textures, &p->texture_made_by);
    return true;
}

/* Validates material and options; invalid ones are faults of the program. */
static bool open_job(MatcProgram *p)
{
    if (!choice_check(&p->session))
        return false;
    if (!p->document)
        return diag_add(&p->session, NO_SPAN, DIAG_null_argument, "document");
    const int count = matc_material_count(p->document);
    if (p->material < 0 || p->material >= count)
        return diag_add(&p->session, NO_SPAN, DIAG_no_material_index, p->material, count);
    const char *fault = choice_fault(&p->arena, &p->options);
    if (fault)
        return diag_add(&p->session, NO_SPAN, DIAG_unknown_option, fault);
    return !choice_job(&p->options, &p->job);
}

MatcProgram *matc_compile(const MatcDocument *d, int material, unsigned outputs,
                          const MatcOptions *options)
{
    MatcProgram *p = calloc(1, sizeof *p);
    if (!p)
        memory_exhausted();
    p->options = choice_whole_options(options);
    p->options.compute |= (outputs & MATC_COMPUTE) != 0;
    p->document = d;
    p->material = material;
    p->session = session_open(&p->options, &p->arena);
    p->session.measure = (outputs & MATC_STATS) != 0;
    if (d)
        document_lend(d, &p->session);
    p->session.stage_start = session_now();
    p->ok = open_job(p) && compile_program(p) &&
            (outputs == MATC_KEY || program_write(p, outputs)) && !p->session.diags.errors;
    return p;
}

bool matc_emit(MatcProgram *p, unsigned outputs)
{
    if (p)
        p->ok = p->ok && program_write(p, outputs) && !p->session.diags.errors;
    return p && p->ok;
}

const char *matc_program_diagnostics(MatcProgram *p, MatcForm form)
{
    return p ? diag_all(&p->session, form) : "";
}

bool matc_ok(const MatcProgram *p) { return p && p->ok; }

void matc_program_free(MatcProgram *p)
{
    if (!p)
        return;
    arena_free(&p->arena);
    free(p);
}

int matc_texture_count(const MatcProgram *p) { return p ? p->texture_count : 0; }

static bool is_within(int index, int count) { return index >= 0 && index < count; }

const MatcTexture *matc_texture(MatcProgram *p, int index)
{
    if (!is_within(index, matc_texture_count(p)))
        return NULL;
    texture_fill(&p->session, p->ir, &p->textures[index], p->texture_made_by[index]);
    return &p->textures[index];
}

int matc_case(const MatcProgram *p) { return p && p->layout ? p->ir->layout_case : -1; }

int matc_target_count(const MatcProgram *p)
{
    return p && p->layout ? layout_targets(p->layout) : 0;
}

const char *matc_target_format(const MatcProgram *p, int index)
{
    return is_within(index, matc_target_count(p)) ? format_table[p->layout->formats[index]].name
                                                  : NULL;
}

int matc_uniform_count(const MatcProgram *p) { return p ? p->uniform_count : 0; }

int matc_attribute_count(const MatcProgram *p) { return p ? p->attribute_count : 0; }

const MatcAttribute *matc_attribute(const MatcProgram *p, int index)
{
    return is_within(index, matc_attribute_count(p)) ? &p->attributes[index] : NULL;
}

const MatcUniform *matc_uniform(const MatcProgram *p, int index)
{
    return is_within(index, matc_uniform_count(p)) ? &p->uniforms[index] : NULL;
}

const char *matc_pass(const MatcProgram *p) { return p ? pass_table[p->job.pass].name : NULL; }

static void list_places(MatcProgram *p)
{
    p->places = ARENA_ARRAY(&p->arena, MatcConstant, p->key.place_count + 1);
    for (int i = 0; i < p->key.place_count; i++) {
        Ref value = p->key.places[i].value;
        MatcConstant *place = &p->places[i];
        *place = (MatcConstant){
            NULL, type_table[ir_type(p->ir, value)].name, ir_components(p->ir, value), 0, -1, {0}};
        memcpy(place->values, ir_numbers(p->ir, value), sizeof(double) * (size_t)place->components);
    }
}

/* Returns NULL if there is no program. */
static const IrKey *key_of(MatcProgram *p)
{
    if (!p || !p->ir)
        return NULL;
    if (!p->keyed) {
        p->key = ir_key(&p->session, p->ir, &p->job);
        key_text(p->key.key, p->key_digits);
        key_text(p->key.shape, p->shape_digits);
        list_places(p);
        p->keyed = true;
    }
    return &p->key;
}

const char *matc_key(MatcProgram *p) { return key_of(p) ? p->key_digits : NULL; }
const char *matc_shape(MatcProgram *p) { return key_of(p) ? p->shape_digits : NULL; }
int matc_place_count(MatcProgram *p) { return key_of(p) ? key_of(p)->place_count : 0; }

const MatcConstant *matc_place(MatcProgram *p, int index)
{
    return is_within(index, matc_place_count(p)) ? &p->places[index] : NULL;
}

int matc_constant_count(const MatcProgram *p)
{
    return p && p->ir ? (int)p->ir->constant_count : 0;
}

const MatcConstant *matc_constant(const MatcProgram *p, int index)
{
    return is_within(index, matc_constant_count(p)) ? &p->constants[index] : NULL;
}

int matc_constant_bytes(const MatcProgram *p) { return p && p->ir ? constants_size(p->ir) : 0; }

void matc_constant_block(const MatcProgram *p, void *block)
{
    if (!block || !matc_constant_bytes(p))
        return;
    memset(block, 0, (size_t)matc_constant_bytes(p));
    for (int i = 0; i < matc_constant_count(p); i++) {
        const MatcConstant *member = &p->constants[i];
        char *at = (char *)block + member->offset;
        for (int component = 0; component < member->components; component++, at += 4) {
            uint32_t bits = constant_bits(member->values[component], member->type[0] == 'u');
            memcpy(at, &bits, sizeof bits);
        }
    }
}
