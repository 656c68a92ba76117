/* Library API: evaluation of a material at points. */
#include "compiler/evaluate.h"
#include "compiler/base/memory.h"
#include "compiler/base/vec3.h"
#include "compiler/choice.h"
#include "compiler/document.h"
#include "compiler/pipeline.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_CHANNEL = LIMIT_NAME + 4, ATTRIBUTE_MARK = '@' };

/* Sets a channel. A name after '@' must be an attribute of `graph`; NULL: any name. */
static bool set_channel(const Graph *graph, Surface *surface, const char *name, double value)
{
    if (*name == ATTRIBUTE_MARK)
        return !graph || oracle_surface_attribute(graph, surface, name + 1, value);
    if (!strcmp(name, "front"))
        surface->front = value != 0;
    return !strcmp(name, "front") || oracle_surface_set(surface, name, value);
}

/* Parses "u=0.3 v=0.4 front=0 @wetness=1". Returns NULL, or a fault of the word at *word. */
static const char *read_point(const Graph *graph, Surface *surface, const char *point,
                              const char **word)
{
    for (*word = point; *(*word += strspn(*word, " ,\t\n"));) {
        const char *at = *word;
        size_t size = strcspn(at, " ,\t\n"), name = strcspn(at, "=");
        char key[LONGEST_CHANNEL] = {0};
        double value;
        if (name >= size || name >= sizeof key ||
            !text_number(at + name + 1, size - name - 1, &value) || !isfinite(value))
            return "a point is a list of channel=number";
        memcpy(key, at, name);
        if (!set_channel(graph, surface, key, value))
            return *key == ATTRIBUTE_MARK
                       ? "the document has no attribute of that name, or no such component"
                       : "no such channel; see --list";
        *word += size;
    }
    return NULL;
}

/* Names that a point can set: channels of a surface, and its side. */
static const char *point_name(const void *user, int i)
{
    Surface surface;
    (void)user;
    if (i == CHANNEL_COUNT)
        return "front";
    oracle_surface_default(&surface);
    return oracle_surface_set(&surface, channel_table[i].name, 0) ? channel_table[i].name : NULL;
}

const char *evaluate_point_fault(Arena *arena, const char *point)
{
    static const NameChoice names = {point_name, NULL, CHANNEL_COUNT + 1};
    Surface surface;
    const char *word;
    Text out = text_new(arena);
    oracle_surface_default(&surface);
    if (!read_point(NULL, &surface, point, &word))
        return NULL;
    const size_t size = strcspn(word, " ,\t\n"), name = strcspn(word, "=");
    const char *key = arena_string(arena, word, name < size ? name : size);
    if (name < size && strlen(key) < LONGEST_CHANNEL && set_channel(NULL, &surface, key, 0))
        text_format(&out, "'%s' is not a number; a point is a list of channel=number",
                    arena_string(arena, word + name + 1, size - name - 1));
    else if (name < size)
        text_format(&out, "unknown channel '%s'; expected %s%s", key, suggest_list(arena, &names),
                    suggest(arena, key, point_name, NULL, names.count));
    else
        text_format(&out, "'%s' is not channel=number; a point is a list of channel=number", key);
    return out.at;
}

bool evaluate_material(const MatcDocument *d, int material, const MatcOptions *options,
                       SurfacePoints points, SlotValues *values)
{
    Job job;
    choice_job(options, &job);
    const ReferenceContext context = {.noise = job_noise(job.choice[AXIS_noise], job.target)};
    Oracle *oracle = oracle_open(d->graph, &context);
    oracle_derivatives(oracle, (Choice)job.choice[AXIS_derivatives]);
    bool known = true;
    double work = 0;
    for (int i = 0; i < points.count && known; i++) {
        known =
            oracle_material(oracle, d->graph->materials[material].node, &points.at[i], &values[i]);
        work += oracle_work(oracle);
        known = known && work <= (double)LIMIT_WORK * LIMIT_WORK_POINTS;
    }
    oracle_close(oracle);
    return known;
}

/* Evaluates the slots at a point given as text. Returns NULL, or a fault. */
static const char *evaluate(const MatcDocument *d, int material, const char *point,
                            const MatcOptions *options, SlotValues *values)
{
    Job job;
    Surface surface;
    const char *word;
    oracle_surface_default(&surface);
    if (!choice_is_set(options))
        return "the options were not initialized by matc_options_init";
    if (choice_job(options, &job))
        return "an option has an invalid value; see matc_options_fault";
    if (!d)
        return "the document is NULL";
    const char *fault = read_point(d->graph, &surface, point ? point : "", &word);
    if (fault)
        return fault;
    if (!d->graph || material < 0 || material >= d->graph->material_count)
        return "no such material";
    if (!evaluate_material(d, material, options, (SurfacePoints){&surface, 1}, values))
        return "evaluation takes too many operations: nested filters over expensive maps";
    return NULL;
}

MatcNumbers matc_eval_slot(const MatcDocument *d, int material, const char *point,
                           const MatcOptions *options)
{
    Job job;
    SlotValues values;
    const MatcOptions whole = choice_whole_options(options);
    MatcNumbers numbers = {.fault = evaluate(d, material, point, &whole, &values)};
    if (numbers.fault)
        return numbers;
    choice_job(&whole, &job);
    numbers.components = type_table[slot_table[job.slot].type].components;
    memcpy(numbers.component, values.component[job.slot],
           (size_t)numbers.components * sizeof *numbers.component);
    return numbers;
}

char *matc_eval(const MatcDocument *d, int material, const char *point, const MatcOptions *options,
                const char **fault)
{
    SlotValues values;
    Arena arena = {0};
    Text out = text_new(&arena);
    const MatcOptions whole = choice_whole_options(options);
    const char *wrong = evaluate(d, material, point, &whole, &values);
    for (int slot = 0; !wrong && slot < SLOT_COUNT; slot++) {
        text_put(&out, slot_table[slot].name);
        for (int i = 0; i < type_table[slot_table[slot].type].components; i++) {
            text_char(&out, ' ');
            text_double(&out, values.component[slot][i]);
        }
        text_char(&out, '\n');
    }
    if (fault)
        *fault = wrong;
    char *result = wrong ? NULL : memory_checked(strdup(out.at));
    arena_free(&arena);
    return result;
}

/* Returns true if a displacement reads inputs that change when the object moves. */
static bool reads_world(const Ir *ir)
{
    Arena arena = {0};
    const uint8_t *live = ir_live(ir, &arena);
    bool reads = false;
    for (Ref ref = 1; ref < ir->count; ref++) {
        const uint32_t input =
            live[ref] && ir_is(ir, ref, OP_input) ? ir_at(ir, ref)->payload : INPUT_COUNT;
        reads |= input == INPUT_vertexP || input == INPUT_vertexN || input == INPUT_vertexDU ||
                 input == INPUT_vertexDV;
    }
    arena_free(&arena);
    return reads;
}

MatcMoves matc_moves(const MatcDocument *d, int material, const MatcOptions *given)
{
    Job job;
    Arena arena = {0};
    MatcOptions options = choice_whole_options(given);
    MatcMoves moves = MATC_MOVES_none;
    options.pass = "depth";
    options.moved = false;
    options.members = NULL;
    options.member_count = 0;
    if (material >= 0 && material < matc_material_count(d) && choice_is_set(&options) &&
        !choice_job(&options, &job)) {
        Session quiet = session_open(&options, &arena);
        const Ir *ir = compile_ir(&quiet, d->graph, d->graph->materials[material].node, &job);
        if (ir && ir->displaced)
            moves = reads_world(ir) ? MATC_MOVES_world : MATC_MOVES_local;
    }
    arena_free(&arena);
    return moves;
}

static void set_components(Surface *surface, Group group, const double *from, int count)
{
    for (int component = 0; component < count; component++)
        surface->root[channel_id(group, component)] = from[component];
}

static Surface surface_of(const MatcPoint *point, double time)
{
    Surface surface;
    oracle_surface_default(&surface);
    set_components(&surface, GROUP_T, &time, 1);
    set_components(&surface, GROUP_P, point->position, 3);
    set_components(&surface, GROUP_N, point->normal, 3);
    set_components(&surface, GROUP_DU, point->tangent_u, 3);
    set_components(&surface, GROUP_DV, point->tangent_v, 3);
    set_components(&surface, GROUP_X, point->local, 3);
    set_components(&surface, GROUP_U, point->uv, 2);
    memcpy(surface.local_u, point->local_u, sizeof surface.local_u);
    memcpy(surface.local_v, point->local_v, sizeof surface.local_v);
    return surface;
}

/* Adds v as a unit vector times `by`; nothing if v has no length. */
static void add_along(double position[3], const double v[3], double by)
{
    const double least = 1e-30, size = fmax(vec3_length(v), least);
    for (int component = 0; component < 3; component++)
        position[component] += by * v[component] / size;
}

static bool has_material(const MatcDocument *d, int material)
{
    return material >= 0 && material < matc_material_count(d);
}

/* Returns true for a valid list: empty, or a pointer and a positive count. */
static bool is_list(const void *points, int count) { return count == 0 || (points && count > 0); }

/* Opens the oracle of a document with the options; NULL if they are invalid. */
static Oracle *oracle_for(const MatcDocument *d, int material, const MatcOptions *options)
{
    Job job;
    if (!has_material(d, material) || !choice_is_set(options) || choice_job(options, &job))
        return NULL;
    const ReferenceContext context = {.noise = job_noise(job.choice[AXIS_noise], job.target)};
    return oracle_open(d->graph, &context);
}

bool matc_has_volume(const MatcDocument *d, int material)
{
    const Node *displaced =
        has_material(d, material) ? oracle_displaced(d->graph->materials[material].node) : NULL;
    return displaced && graph_displaces_volume(displaced);
}

bool matc_solid(const MatcDocument *d, int material, const MatcOptions *given, MatcSolid *points,
                int count)
{
    const MatcOptions options = choice_whole_options(given);
    Oracle *oracle = matc_has_volume(d, material) ? oracle_for(d, material, &options) : NULL;
    bool fine = oracle && is_list(points, count);
    for (int i = 0; fine && i < count; i++) {
        const Surface surface = surface_of(&points[i].at, options.time);
        fine = oracle_displacement_at(oracle, d->graph->materials[material].node, &surface,
                                      points[i].heights);
    }
    oracle_close(oracle);
    return fine;
}

/* Replaces the solid intervals by a displacement to their highest point along the normal; 0 if
 * none is solid. */
static void to_top(double by[ORACLE_HEIGHTS])
{
    const bool first = by[0] < by[1], second = by[2] < by[3];
    const double top = first && second ? fmax(by[1], by[3]) : first ? by[1] : second ? by[3] : 0;
    by[0] = by[1] = 0;
    by[2] = top;
}

bool matc_move(const MatcDocument *d, int material, const MatcOptions *given, MatcPoint *points,
               int count)
{
    const MatcOptions options = choice_whole_options(given);
    const bool volume = matc_has_volume(d, material);
    Oracle *oracle = oracle_for(d, material, &options);
    bool fine = oracle && is_list(points, count);
    for (int i = 0; fine && i < count; i++) {
        const Surface surface = surface_of(&points[i], options.time);
        double move[ORACLE_HEIGHTS];
        fine = oracle_displacement_at(oracle, d->graph->materials[material].node, &surface, move);
        if (volume)
            to_top(move);
        add_along(points[i].position, points[i].tangent_u, move[0]);
        add_along(points[i].position, points[i].tangent_v, move[1]);
        add_along(points[i].position, points[i].normal, move[2]);
    }
    oracle_close(oracle);
    return fine;
}

bool matc_set_default(MatcDocument *d, const char *param, const double *components, int count,
                      double *before)
{
    for (int i = 0; d && d->graph && param && components && i < d->graph->uniform_count; i++) {
        Uniform *uniform = d->graph->uniforms[i];
        if (strcmp(uniform->name, param) != 0 || type_table[uniform->type].components != count)
            continue;
        if (before)
            memcpy(before, uniform->initial, sizeof uniform->initial);
        memcpy(uniform->initial, components, (size_t)count * sizeof *components);
        return true;
    }
    return false;
}
