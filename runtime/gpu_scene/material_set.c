/* Builds a set of programs: value ranges of all materials, a layout for them, keys of all
 * programs, groups of one shape, texts. */
#include "runtime/gpu_scene/material_set.h"
#include "runtime/gpu_scene/instances.h"
#include "compiler/base/hash.h"
#include "compiler/base/hash_index.h"
#include "compiler/layout/custom.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- Finding programs, and their texts */

const PassProgram *material_set_find(const MaterialSet *set, int material, const char *pass)
{
    int number = set->of_material[material];
    while (number && strcmp(set->programs[number - 1].pass, pass) != 0)
        number = set->programs[number - 1].other;
    return number ? &set->programs[number - 1] : NULL;
}

int material_set_rows(const MaterialSet *set, int text)
{
    int rows = 0;
    for (int i = text; i >= 0; i = set->programs[i].next)
        rows++;
    return rows;
}

const char *material_set_vertex(const MaterialSet *set, const PassProgram *program)
{
    return matc_output(set->programs[program->text].program, MATC_VERTEX, NULL);
}

const char *material_set_fragment(const MaterialSet *set, const PassProgram *program)
{
    return matc_output(set->programs[program->text].program, MATC_FRAGMENT, NULL);
}

const char *material_set_format(const MaterialSet *set, int target)
{
    for (int i = 0; i < set->count; i++)
        if (strcmp(set->programs[i].pass, "sky") != 0)
            return target < matc_target_count(set->programs[i].program)
                       ? matc_target_format(set->programs[i].program, target)
                       : NULL;
    return NULL;
}

const LayoutRow *material_set_layout(const MaterialSet *set, const MatcOptions *compile_options)
{
    const MatcLayout *custom = set->layout ? set->layout : compile_options->custom;
    if (custom)
        return custom->row;
    for (int i = 0; compile_options->layout && i < LAYOUT_COUNT; i++)
        if (!strcmp(layout_table[i].name, compile_options->layout))
            return &layout_table[i];
    return &layout_table[LAYOUT_compact]; /* default layout of programs in GLSL 3.30 and 4.50 */
}

enum { MAX_MEMBERS = 1024 /* max vec4 members of a buffer: every driver allows 16 KiB */ };

typedef struct {
    GlContext *gl;
    const Scene *scene;
    MatcOptions options;
    MaterialSet *set;
    int *last; /* indexed by the first program of a text: the last one */
} Maker;

/* Returns the pass that draws an object. */
static const char *pass_of(const SceneObject *object)
{
    return object->kind == SCENE_Plane ? "plane" : "gbuffer";
}

bool material_set_fail(GlContext *gl, const Scene *scene, int material)
{
    const SceneMaterial *of = &scene->materials[material];
    char why[sizeof gl->error], place[SCENE_PLACE];
    snprintf(why, sizeof why, "%s", gl->error);
    scene_material_place(of, place);
    return gl_fail(gl, "%s: the material '%s': %s", place,
                   matc_material_name(of->document, of->index), why);
}

static bool add_ranges(Maker *m, MatcRanges *ranges)
{
    bool *added = calloc((size_t)m->scene->material_count + 1, sizeof *added);
    bool fine = added || gl_fail(m->gl, "out of memory");
    for (int i = 0; fine && i < m->scene->object_count; i++) {
        const int material = m->scene->objects[i].material;
        const SceneMaterial *of = &m->scene->materials[material];
        char *fault = NULL;
        if (added[material])
            continue;
        added[material] = true;
        fine = matc_ranges_add(ranges, of->document, of->index, &m->options, &fault) ||
               (gl_fail(m->gl, "%s", fault ? fault : "out of memory"),
                material_set_fail(m->gl, m->scene, material));
        free(fault);
    }
    free(added);
    return fine;
}

/* Chooses the smallest layout that holds all materials of surfaces; a scene without surfaces
 * uses the default. */
static bool choose_layout(Maker *m)
{
    MatcRanges *ranges = malloc(sizeof *ranges);
    if (!ranges)
        return gl_fail(m->gl, "out of memory");
    matc_ranges_init(ranges);
    const bool fine = add_ranges(m, ranges);
    if (fine && m->scene->object_count) {
        m->set->layout = matc_layout_for(ranges, 0, &m->options);
        m->options.custom = m->set->layout;
    }
    free(ranges);
    return fine;
}

/* Returns options for the single slot transparency, without antialiasing. */
static MatcOptions sheet_options(const Maker *m)
{
    MatcOptions options = m->options;
    options.pass = "plane";
    options.layout = NULL;
    options.custom = m->set->sheet;
    options.aa = "none";
    return options;
}

static bool compile(Maker *m, PassProgram *program, unsigned outputs)
{
    const SceneMaterial *of = &m->scene->materials[program->material];
    MatcOptions options = m->options;
    options.pass = program->pass;
    if (!strcmp(program->pass, SET_SHEET))
        options = sheet_options(m);
    matc_program_free(program->program);
    program->program = matc_compile(of->document, of->index, outputs, &options);
    if (matc_ok(program->program))
        return true;
    gl_fail(m->gl, "%s", matc_program_diagnostics(program->program, MATC_TEXT));
    return material_set_fail(m->gl, m->scene, program->material);
}

static bool packs(const PassProgram *program)
{
    return !strcmp(program->pass, "plane") || !strcmp(program->pass, "gbuffer");
}

/* Finds the transmittance of a surface or a plane if it is constant. */
static bool find_through(Maker *m, PassProgram *program)
{
    const SceneMaterial *of = &m->scene->materials[program->material];
    if (!packs(program) || strcmp(matc_opacity(program->program), "transparent") != 0)
        return true;
    const MatcNumbers through = matc_eval_slot(of->document, of->index, "", &m->options);
    for (int i = 0; i < through.components; i++)
        program->through[i] = (float)through.component[i];
    program->even = !through.fault;
    return program->even || (gl_fail(m->gl, "%s", through.fault),
                             material_set_fail(m->gl, m->scene, program->material));
}

/* Adds a program with its key, shape and constants, but without text. */
static bool add_program(Maker *m, int material, const char *pass)
{
    MaterialSet *set = m->set;
    PassProgram *program = &set->programs[set->count];
    *program = (PassProgram){.material = material,
                             .pass = pass,
                             .text = set->count,
                             .next = -1,
                             .caster = -1,
                             .cut = -1,
                             .other = set->of_material[material]};
    set->of_material[material] = ++set->count;
    if (!compile(m, program, MATC_KEY))
        return false;
    if (packs(program))
        m->options.cases |= 1u << matc_case(program->program);
    program->transparent = strcmp(matc_opacity(program->program), "opaque") != 0;
    return find_through(m, program);
}

static bool make_sheet_layout(Maker *m)
{
    static const char text[] =
        "layout: sheet\ntargets: [RGBA32UI]\nfields:\n- { slot: transparency, encoding: full }\n";
    MaterialSet *set = m->set;
    if (!set->sheet)
        set->sheet = matc_layout_read("sheet", text, sizeof text - 1, &m->options);
    return (set->sheet && matc_layout_ok(set->sheet)) || gl_fail(m->gl, "out of memory");
}

/* Reports whether fragment programs can read and write images. */
static bool has_images(const GlContext *gl)
{
    return gl->major * 10 + gl->minor >= 43 && gl->BindImageTexture && gl->MemoryBarrier;
}

/* Reports whether a shadow caster needs no program since its transmittance is constant: planes,
 * and surfaces if shadow techniques support that. */
static bool casts_by_numbers(const Maker *m, const PassProgram *surface)
{
    return surface->even && (m->set->uses.even || !strcmp(surface->pass, "plane"));
}

/* Adds the program that casts a transparent surface's shadows; opaque surfaces need only depth. */
static bool add_caster(Maker *m, int number)
{
    MaterialSet *set = m->set;
    PassProgram *surface = &set->programs[number];
    const bool plane = !strcmp(surface->pass, "plane");
    if (!set->uses.casts || !surface->transparent || casts_by_numbers(m, surface) ||
        (plane && !has_images(m->gl)))
        return true;
    surface->caster = set->count;
    if (plane)
        return make_sheet_layout(m) && add_program(m, surface->material, SET_SHEET);
    return add_program(m, surface->material,
                       set->uses.casts == SET_CASTS_colored ? "value" : "shadow");
}

/* Adds the alpha-tested program for voxels, unless the shadow caster's program is the same. */
static bool add_cut(Maker *m, int number)
{
    MaterialSet *set = m->set;
    PassProgram *surface = &set->programs[number];
    const bool plane = !strcmp(surface->pass, "plane");
    if (!set->uses.cuts || !surface->transparent || surface->even || plane)
        return true;
    surface->cut =
        set->uses.casts == SET_CASTS_cut && surface->caster >= 0 ? surface->caster : set->count;
    return surface->cut < set->count || add_program(m, surface->material, "shadow");
}

static bool add_uses(Maker *m, int number) { return add_caster(m, number) && add_cut(m, number); }

static bool add_programs(Maker *m)
{
    const Scene *scene = m->scene;
    bool fine = true;
    m->set->programs = calloc(5 * (size_t)scene->material_count + 2, sizeof *m->set->programs);
    m->set->of_material = calloc((size_t)scene->material_count + 1, sizeof *m->set->of_material);
    if (!m->set->programs || !m->set->of_material)
        return gl_fail(m->gl, "out of memory");
    bool *met = calloc(2 * (size_t)scene->material_count + 2, sizeof *met);
    for (int i = 0; met && fine && i < scene->object_count; i++) {
        const SceneObject *object = &scene->objects[i];
        bool *known = &met[2 * object->material + (object->kind == SCENE_Plane)];
        if (!*known)
            fine =
                add_program(m, object->material, pass_of(object)) && add_uses(m, m->set->count - 1);
        *known = true;
    }
    free(met);
    if (fine && scene->sky >= 0 && !material_set_find(m->set, scene->sky, "sky"))
        fine = add_program(m, scene->sky, "sky");
    return fine;
}

/* A constant of all programs of a group: hash of its values, to find equal columns, and whether
 * the programs differ. */
typedef struct {
    Key key;
    bool differs;
} Column;

static Column column_of(const MaterialSet *set, int first, int place)
{
    const MatcConstant *head = matc_place(set->programs[first].program, place);
    Column column = {.key = key_of_bytes(head->type, strlen(head->type))};
    for (int i = first; i >= 0; i = set->programs[i].next) {
        const MatcConstant *number = matc_place(set->programs[i].program, place);
        const Key parts[] = {column.key, key_of_bytes(number->values, (size_t)number->components *
                                                                          sizeof *number->values)};
        column.differs |= memcmp(number->values, head->values,
                                 (size_t)number->components * sizeof *number->values) != 0;
        column.key = key_of_bytes(parts, sizeof parts);
    }
    return column;
}

/* Finds the constants in which programs of a group differ; these become members of the buffer,
 * and equal columns share one. Returns the number of members; -1 if memory runs out. */
static int find_members(const MaterialSet *set, int first, int *members, int count)
{
    Column *columns = calloc((size_t)count + 1, sizeof *columns);
    int found = columns ? 0 : -1;
    for (int i = 0; columns && i < count; i++) {
        columns[i] = column_of(set, first, i);
        members[i] = columns[i].differs ? i : -1;
        for (int k = 0; columns[i].differs && k < i; k++)
            if (columns[k].differs && key_equal(columns[k].key, columns[i].key)) {
                members[i] = members[k];
                break;
            }
        found += members[i] == i;
    }
    free(columns);
    return found;
}

/* Reports whether programs can share a text: equal passes and shapes, and, with `numbers`, equal
 * keys. */
static bool is_alike(const PassProgram *a, const PassProgram *b, bool numbers)
{
    return !strcmp(a->pass, b->pass) && !strcmp(matc_shape(a->program), matc_shape(b->program)) &&
           (!numbers || !strcmp(matc_key(a->program), matc_key(b->program)));
}

/* Splits a chain of programs into one per text, in the order of their first programs. */
static void part(Maker *m, int first, bool numbers)
{
    PassProgram *programs = m->set->programs;
    HashIndex heads = {0};
    for (int i = first, next; i >= 0; i = next) {
        PassProgram *program = &programs[i];
        const Key key =
            key_read(numbers ? matc_key(program->program) : matc_shape(program->program));
        int head = -1;
        for (HashProbe probe = hash_probe(&heads, (uint32_t)key.low);
             head < 0 && hash_probe_next(&probe);)
            if (is_alike(&programs[probe.number], program, numbers))
                head = (int)probe.number;
        next = program->next;
        program->next = -1;
        program->text = head < 0 ? i : head;
        if (head < 0)
            hash_index_add(NULL, &heads, (uint32_t)key.low, (uint32_t)i);
        else
            programs[m->last[head]].next = i;
        m->last[program->text] = i;
    }
    hash_index_free(&heads);
}

/* Chains all programs, then splits the chain by text. */
static bool share_texts(Maker *m)
{
    MaterialSet *set = m->set;
    m->last = calloc((size_t)set->count + 1, sizeof *m->last);
    if (!m->last)
        return gl_fail(m->gl, "out of memory");
    for (int i = 0; i + 1 < set->count; i++)
        set->programs[i].next = i + 1;
    if (set->count)
        part(m, 0, false);
    return true;
}

static bool write_group(Maker *m, int first, const int *members, int count)
{
    MaterialSet *set = m->set;
    m->options.members = members;
    m->options.member_count = count;
    bool fine = true;
    for (int i = first; fine && i >= 0; i = set->programs[i].next)
        fine = compile(m, &set->programs[i],
                       i == first ? MATC_FRAGMENT | MATC_VERTEX | MATC_UNPACK : MATC_KEY);
    m->options.members = NULL;
    m->options.member_count = 0;
    return fine;
}

static void number_rows(MaterialSet *set, int first)
{
    int rows = 0;
    for (int i = first; i >= 0; i = set->programs[i].next)
        set->programs[i].row = rows++;
}

/* Compiles one text for all programs that share it. */
static bool write_text(Maker *m, int first)
{
    MaterialSet *set = m->set;
    const int count = matc_place_count(set->programs[first].program);
    int *members = malloc((size_t)count * sizeof *members + 1);
    int found = members ? find_members(set, first, members, count) : -1;
    if (found > MAX_MEMBERS) { /* too many members: only programs with equal constants share */
        part(m, first, true);
        found = 0;
    }
    number_rows(set, first);
    const bool fine = found >= 0 ? write_group(m, first, members, found ? count : 0)
                                 : gl_fail(m->gl, "out of memory");
    free(members);
    set->texts++;
    return fine;
}

static bool make(Maker *m)
{
    MaterialSet *set = m->set;
    const bool automatic = !m->options.layout && !m->options.custom;
    if ((automatic && !choose_layout(m)) || !add_programs(m) || !share_texts(m))
        return false;
    for (int i = 0; i < set->count; i++)
        if (set->programs[i].text == i && !write_text(m, i))
            return false;
    for (int i = 0; i < set->count && !set->unpack; i++)
        if (set->programs[i].text == i && strcmp(set->programs[i].pass, "sky") != 0)
            set->unpack = matc_output(set->programs[i].program, MATC_UNPACK, NULL);
    return true;
}

bool material_set_make(GlContext *gl, const Scene *scene, const MatcOptions *compile_options,
                       MaterialSetUses uses, MaterialSet *made)
{
    Maker maker = {.gl = gl, .scene = scene, .options = *compile_options, .set = made};
    *made = (MaterialSet){.target = gl->major * 10 + gl->minor >= 45 ? "glsl450" : "glsl330",
                          .uses = uses};
    maker.options.slot = "transparency"; /* slot that the pass value outputs */
    made->instances = !strcmp(made->target, "glsl450") && instances_supported(gl);
    maker.options.target = made->target;
    maker.options.instances = made->instances;
    maker.options.moved = scene->displaced > 0;
    maker.options.validate = false; /* the driver validates the programs */
    const bool fine = make(&maker);
    free(maker.last);
    if (fine)
        return true;
    material_set_free(made);
    return false;
}

void material_set_free(MaterialSet *set)
{
    for (int i = 0; i < set->count; i++)
        matc_program_free(set->programs[i].program);
    free(set->programs);
    free(set->of_material);
    matc_layout_free(set->layout);
    matc_layout_free(set->sheet);
    *set = (MaterialSet){0};
}
