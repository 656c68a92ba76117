/* Ranges of all materials, a layout for them, keys of all programs, groups of one shape, texts. */
#include "runtime/render/set.h"
#include "runtime/render/instances.h"
#include "compiler/base/hash.h"
#include "compiler/base/text.h"
#include "compiler/layout/custom.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_MEMBERS = 1024 /* of a buffer: every driver has room for 16 KiB */ };

typedef struct {
    GlContext *gl;
    const Scene *scene;
    MatcOptions options;
    Set *set;
} Maker;

/* A surface's pass; NULL: it has none of its own. */
static const char *pass_of(const SceneObject *object) { return object->kind == SCENE_Plane ? "plane" : "gbuffer"; }

bool set_fail(GlContext *gl, const Scene *scene, int material)
{
    const SceneMaterial *of = &scene->materials[material];
    char why[sizeof gl->error], place[SCENE_PLACE];
    snprintf(why, sizeof why, "%s", gl->error);
    scene_material_place(of, place);
    return gl_fail(gl, "%s: the material '%s': %s", place, matc_material_name(of->document, of->index), why);
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
               (gl_fail(m->gl, "%s", fault ? fault : "out of memory"), set_fail(m->gl, m->scene, material));
        free(fault);
    }
    free(added);
    return fine;
}

/* The smallest layout of all materials of surfaces; a scene without any takes the default. */
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

static bool compile(Maker *m, SetProgram *program, unsigned outputs)
{
    const SceneMaterial *of = &m->scene->materials[program->material];
    m->options.pass = program->pass;
    matc_program_free(program->program);
    program->program = matc_compile(of->document, of->index, outputs, &m->options);
    if (matc_ok(program->program))
        return true;
    gl_fail(m->gl, "%s", matc_program_diagnostics(program->program, MATC_TEXT));
    return set_fail(m->gl, m->scene, program->material);
}

static bool has_program(const Set *set, int material, const char *pass)
{
    for (int i = 0; i < set->count; i++)
        if (set->programs[i].material == material && !strcmp(set->programs[i].pass, pass))
            return true;
    return false;
}

/* Three numbers behind a name. */
static bool read_three(const char *at, float numbers[3])
{
    for (int i = 0; i < 3; i++) {
        const size_t size = strcspn(at, " \n");
        double number;
        if (!text_number(at, size, &number))
            return false;
        numbers[i] = (float)number;
        at += size + (at[size] == ' ');
    }
    return true;
}

/* By how much a plane is transparent, if that is a constant. */
static bool find_through(Maker *m, SetProgram *program)
{
    static const char name[] = "\ntransparency ";
    const SceneMaterial *of = &m->scene->materials[program->material];
    const char *fault;
    if (strcmp(program->pass, "plane") != 0 || strcmp(matc_opacity(program->program), "transparent") != 0)
        return true;
    char *values = matc_eval(of->document, of->index, "", &m->options, &fault);
    const char *line = values ? strstr(values, name) : NULL;
    program->even = line && read_three(line + sizeof name - 1, program->through);
    free(values);
    return program->even || gl_fail(m->gl, "out of memory");
}

/* Keys, shapes and numbers; no text yet. */
static bool add_program(Maker *m, int material, const char *pass)
{
    Set *set = m->set;
    SetProgram *program = &set->programs[set->count];
    *program = (SetProgram){.material = material, .pass = pass, .text = set->count++, .caster = -1};
    if (!compile(m, program, MATC_KEY))
        return false;
    program->transparent = strcmp(matc_opacity(program->program), "opaque") != 0;
    return find_through(m, program);
}

/* What is opaque casts shadows by depth alone. */
static bool add_caster(Maker *m, int surface)
{
    Set *set = m->set;
    if (!set->casts || !set->programs[surface].transparent || strcmp(set->programs[surface].pass, "gbuffer") != 0)
        return true;
    set->programs[surface].caster = set->count;
    return add_program(m, set->programs[surface].material, set->casts == SET_CASTS_colored ? "value" : "shadow");
}

static bool add_programs(Maker *m)
{
    const Scene *scene = m->scene;
    bool fine = true;
    m->set->programs = calloc(3 * (size_t)scene->material_count + 2, sizeof *m->set->programs);
    if (!m->set->programs)
        return gl_fail(m->gl, "out of memory");
    bool *met = calloc(2 * (size_t)scene->material_count + 2, sizeof *met);
    for (int i = 0; met && fine && i < scene->object_count; i++) {
        const SceneObject *object = &scene->objects[i];
        bool *known = &met[2 * object->material + (object->kind == SCENE_Plane)];
        if (!*known)
            fine = add_program(m, object->material, pass_of(object)) && add_caster(m, m->set->count - 1);
        *known = true;
    }
    free(met);
    if (fine && scene->sky >= 0 && !has_program(m->set, scene->sky, "sky"))
        fine = add_program(m, scene->sky, "sky");
    return fine;
}

/* The numbers of a place in all programs of a group, as a hash: alike in every material, and which columns are the same. */
typedef struct {
    Key key;
    bool differs;
} Column;

static Column column_of(const Set *set, int first, int place)
{
    const MatcConstant *head = matc_place(set->programs[first].program, place);
    Column column = {.key = key_of_bytes(head->type, strlen(head->type))};
    for (int i = first; i < set->count; i++) {
        if (set->programs[i].text != first)
            continue;
        const MatcConstant *number = matc_place(set->programs[i].program, place);
        const Key parts[] = {column.key, key_of_bytes(number->values, (size_t)number->lanes * sizeof *number->values)};
        column.differs |= memcmp(number->values, head->values, (size_t)number->lanes * sizeof *number->values) != 0;
        column.key = key_of_bytes(parts, sizeof parts);
    }
    return column;
}

/* Places at which the group differs become members of the buffer; equal columns are one. The number of members, -1: no memory. */
static int find_members(const Set *set, int first, int *members, int count)
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

/* Programs behind `first` that have its shape, pass and uniforms are drawn with its text. */
static void gather(Set *set, int first)
{
    SetProgram *head = &set->programs[first];
    for (int i = first + 1; i < set->count; i++) {
        SetProgram *other = &set->programs[i];
        if (other->text == i && !strcmp(other->pass, head->pass) &&
            !strcmp(matc_shape(other->program), matc_shape(head->program)))
            other->text = first;
    }
}

/* Too many differences for a buffer: only equal programs share. */
static void part(Set *set, int first)
{
    for (int i = first + 1; i < set->count; i++)
        if (set->programs[i].text == first &&
            strcmp(matc_key(set->programs[i].program), matc_key(set->programs[first].program)) != 0)
            set->programs[i].text = i;
}

static bool write_group(Maker *m, int first, const int *members, int count)
{
    Set *set = m->set;
    m->options.members = members;
    m->options.member_count = count;
    bool fine = true;
    for (int i = first; fine && i < set->count; i++)
        if (set->programs[i].text == first)
            fine = compile(m, &set->programs[i], i == first ? MATC_FRAGMENT | MATC_VERTEX | MATC_UNPACK : MATC_KEY);
    m->options.members = NULL;
    m->options.member_count = 0;
    return fine;
}

static void number_rows(Set *set, int first)
{
    int rows = 0;
    for (int i = first; i < set->count; i++)
        if (set->programs[i].text == first)
            set->programs[i].row = rows++;
}

/* One text for all that share it. */
static bool write_text(Maker *m, int first)
{
    Set *set = m->set;
    gather(set, first);
    const int count = matc_place_count(set->programs[first].program);
    int *members = malloc((size_t)count * sizeof *members + 1);
    int found = members ? find_members(set, first, members, count) : -1;
    if (found > MOST_MEMBERS) {
        part(set, first);
        found = 0;
    }
    number_rows(set, first);
    const bool fine = found >= 0 ? write_group(m, first, members, found ? count : 0) : gl_fail(m->gl, "out of memory");
    free(members);
    set->texts++;
    return fine;
}

static bool make(Maker *m)
{
    Set *set = m->set;
    const bool automatic = !m->options.layout && !m->options.custom;
    if ((automatic && !choose_layout(m)) || !add_programs(m))
        return false;
    for (int i = 0; i < set->count; i++)
        if (set->programs[i].text == i && !write_text(m, i))
            return false;
    for (int i = 0; i < set->count && !set->unpack; i++)
        if (set->programs[i].text == i && strcmp(set->programs[i].pass, "sky") != 0)
            set->unpack = matc_output(set->programs[i].program, MATC_UNPACK, NULL);
    return true;
}

bool set_make(GlContext *gl, const Scene *scene, const MatcOptions *compile_options, SetCasts casts, Set *made)
{
    Maker maker = {.gl = gl, .scene = scene, .options = *compile_options, .set = made};
    *made = (Set){.target = gl->major * 10 + gl->minor >= 45 ? "glsl450" : "glsl330", .casts = casts};
    maker.options.slot = "transparency"; /* of the pass value */
    made->instances = !strcmp(made->target, "glsl450") && instances_there(gl);
    maker.options.target = made->target;
    maker.options.instances = made->instances;
    maker.options.validate = false; /* the driver does */
    if (make(&maker))
        return true;
    set_free(made);
    return false;
}

void set_free(Set *set)
{
    for (int i = 0; i < set->count; i++)
        matc_program_free(set->programs[i].program);
    free(set->programs);
    matc_layout_free(set->layout);
    *set = (Set){0};
}

const SetProgram *set_find(const Set *set, int material, const char *pass)
{
    for (int i = 0; i < set->count; i++)
        if (set->programs[i].material == material && !strcmp(set->programs[i].pass, pass))
            return &set->programs[i];
    return NULL;
}

int set_rows(const Set *set, int text)
{
    int rows = 0;
    for (int i = text; i < set->count; i++)
        rows += set->programs[i].text == text;
    return rows;
}

const char *set_vertex(const Set *set, const SetProgram *program)
{
    return matc_output(set->programs[program->text].program, MATC_VERTEX, NULL);
}

const char *set_fragment(const Set *set, const SetProgram *program)
{
    return matc_output(set->programs[program->text].program, MATC_FRAGMENT, NULL);
}

const char *set_format(const Set *set, int target)
{
    for (int i = 0; i < set->count; i++)
        if (strcmp(set->programs[i].pass, "sky") != 0)
            return target < matc_target_count(set->programs[i].program)
                       ? matc_target_format(set->programs[i].program, target)
                       : NULL;
    return NULL;
}

const LayoutRow *set_layout(const Set *set, const MatcOptions *compile_options)
{
    const MatcLayout *custom = set->layout ? set->layout : compile_options->custom;
    if (custom)
        return custom->row;
    for (int i = 0; compile_options->layout && i < LAYOUT_COUNT; i++)
        if (!strcmp(layout_table[i].name, compile_options->layout))
            return &layout_table[i];
    return &layout_table[LAYOUT_compact]; /* the default of the targets here */
}
