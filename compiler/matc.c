/* The library's surface: documents and questions. program.c has the programs. */
#include "compiler/choice.h"
#include "compiler/document.h"
#include "compiler/evaluate.h"
#include "compiler/oracle/oracle.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *matc_version(void) { return MATC_VERSION; }

MatcDocument *matc_read(const char *name, const char *text, size_t size, const MatcOptions *options)
{
    MatcDocument *d = calloc(1, sizeof *d);
    if (!d)
        abort();
    Locale locale = locale_enter();
    d->options = choice_whole_options(options);
    d->session = session_open(&d->options, &d->arena);
    d->session.measure = d->options.measure;
    d->session.stage_start = session_now();
    Source source = {arena_string(&d->arena, name, strlen(name)), arena_string(&d->arena, text, size), size};
    ARENA_PUSH(&d->arena, d->session.sources, d->session.source_count, d->session.source_room, source);
    session_depend_on(&d->session, source.name);
    d->graph = compile_front(&d->session, 0, &d->tree);
    locale_leave(locale);
    return d;
}

void document_lend(const MatcDocument *d, Session *session)
{
    session->sources = d->session.sources;
    session->source_count = d->session.source_count;
    session->depends = d->session.depends;
}

void matc_document_free(MatcDocument *d)
{
    if (!d)
        return;
    arena_free(&d->arena);
    free(d);
}

int matc_material_count(const MatcDocument *d) { return d->graph ? d->graph->material_count : 0; }
const char *matc_material_name(const MatcDocument *d, int material) { return d->graph->materials[material].name; }

int matc_material_find(const MatcDocument *d, const char *name)
{
    for (int i = 0; i < matc_material_count(d); i++)
        if (!strcmp(matc_material_name(d, i), name))
            return i;
    return -1;
}

int matc_depend_count(const MatcDocument *d) { return (int)d->session.depends.count; }
const char *matc_depend(const MatcDocument *d, int index) { return d->session.depends.at[index]; }
int matc_error_count(const MatcDocument *d) { return d->session.diags.errors; }

const char *matc_tree_text(MatcDocument *d)
{
    Text out = text_new(&d->arena);
    if (!d->tree)
        return "";
    tree_print(&out, d->tree);
    return out.at;
}

const char *matc_diagnostics(MatcDocument *d, MatcForm form) { return diag_all(&d->session, form); }

/* "u=0.3 v=0.4 front=0" */
static const char *read_point(Surface *surface, const char *point)
{
    for (const char *at = point; *(at += strspn(at, " ,\t\n"));) {
        size_t size = strcspn(at, " ,\t\n"), name = strcspn(at, "=");
        char key[16] = {0};
        double value;
        if (name >= size || name >= sizeof key || !text_number(at + name + 1, size - name - 1, &value) ||
            !isfinite(value))
            return "a point is a list of channel=number";
        memcpy(key, at, name);
        if (!strcmp(key, "front"))
            surface->front = value != 0;
        else if (!oracle_surface_set(surface, key, value))
            return "no such channel; see --list";
        at += size;
    }
    return NULL;
}

bool document_evaluate(const MatcDocument *d, int material, const MatcOptions *options, const Surface *points,
                       int count, SlotValues *values)
{
    Job job;
    choice_job(options, &job);
    const ReferenceContext context = {.noise = job_noise(job.choice[AXIS_noise], job.target)};
    Oracle *oracle = oracle_open(d->graph, &context);
    oracle_exact_derivatives(oracle, job.choice[AXIS_derivatives] == CHOICE_derivatives_analytic);
    bool known = true;
    for (int i = 0; i < count; i++) {
        if (oracle_material(oracle, d->graph->materials[material].node, &points[i], &values[i]))
            continue;
        known = false;
        for (int slot = 0; slot < SLOT_COUNT; slot++)
            values[i].lane[slot][0] = NAN;
    }
    oracle_close(oracle);
    return known;
}

char *matc_eval(const MatcDocument *d, int material, const char *point, const MatcOptions *options, const char **fault)
{
    Job job;
    Surface surface;
    SlotValues values;
    Arena arena = {0};
    Text out = text_new(&arena);
    Locale locale = locale_enter();
    const MatcOptions whole = choice_whole_options(options);
    oracle_surface_default(&surface);
    *fault = choice_job(&whole, &job) ? "no such option" : read_point(&surface, point);
    if (!*fault && (!d->graph || material < 0 || material >= d->graph->material_count))
        *fault = "no such material";
    if (!*fault && !document_evaluate(d, material, &whole, &surface, 1, &values))
        *fault = "the value takes too many answers of maps: filters within filters";
    if (!*fault) {
        for (int slot = 0; slot < SLOT_COUNT; slot++) {
            text_put(&out, slot_table[slot].name);
            for (int i = 0; i < type_table[slot_table[slot].type].lanes; i++) {
                text_char(&out, ' ');
                text_double(&out, values.lane[slot][i]);
            }
            text_char(&out, '\n');
        }
    }
    char *result = *fault ? NULL : strdup(out.at);
    locale_leave(locale);
    arena_free(&arena);
    return result;
}
