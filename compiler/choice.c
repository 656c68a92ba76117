/* Options -> a job: names become rows of the tables. What was chosen, and by what, as text. */
#include "compiler/choice.h"
#include "compiler/base/warnings.h"
#include "compiler/layout/custom.h"
#include "compiler/pipeline.h"
#include <stddef.h>
#include <string.h>

/* What settled an axis. */
typedef enum { CHOSEN_default, CHOSEN_by_name, CHOSEN_by_precision, CHOSEN_by_measuring } ChoiceSource;

static const char *target_name(int i) { return target_table[i].name; }
static const char *pass_name(int i) { return pass_table[i].name; }
static const char *layout_name(int i) { return layout_table[i].name; }
static const char *slot_name(int i) { return slot_table[i].name; }
static const char *precision_name(int i) { return precision_table[i].name; }

static int index_of(const char *name, const char *(*names)(int), int count, int otherwise)
{
    if (!name)
        return otherwise;
    for (int i = 0; i < count; i++)
        if (!strcmp(names(i), name))
            return i;
    return -1;
}

typedef struct {
    const char *name;
    size_t member;
} TextOption;

#define TEXT_OPTION(name)                                                                                              \
    {                                                                                                                  \
#name, offsetof(MatcOptions, name)                                                                             \
    }
static const TextOption text_options[] = {
#define AXIS(name, chunks, doc) TEXT_OPTION(name),
#include "grammar/variants.def"
    TEXT_OPTION(target),    TEXT_OPTION(pass),      TEXT_OPTION(slot),     TEXT_OPTION(layout),
    TEXT_OPTION(precision), TEXT_OPTION(constants), TEXT_OPTION(warnings),
};

bool matc_options_set(MatcOptions *options, const char *name, const char *value)
{
    for (size_t i = 0; i < sizeof text_options / sizeof *text_options; i++) {
        if (strcmp(text_options[i].name, name) != 0)
            continue;
        if (text_options[i].member + sizeof value > options->size)
            return false; /* the caller was compiled without it */
        memcpy((char *)options + text_options[i].member, &value, sizeof value);
        return true;
    }
    return false;
}

/* The axes come first. */
static const char *option_of(const MatcOptions *options, Axis axis)
{
    const char *value;
    memcpy(&value, (const char *)options + text_options[axis].member, sizeof value);
    return value;
}

/* A choice by its name, else the row's, else the axis' own default; -1: there is no such choice. */
static int choose(const MatcOptions *o, Axis axis, int precision, ChoiceSource *source)
{
    const char *name = option_of(o, axis);
    int first = axis_table[axis].first, row = precision_table[precision].choice[axis];
    if (!name) {
        *source = o->precision && row >= 0 ? CHOSEN_by_precision : CHOSEN_default;
        return row >= 0 ? row : first;
    }
    *source = o->measured >> axis & 1 ? CHOSEN_by_measuring : CHOSEN_by_name;
    for (int i = 0; i < axis_choices(axis); i++)
        if (!strcmp(choice_table[first + i].name, name))
            return first + i;
    return -1;
}

static int target_of(const MatcOptions *o) { return index_of(o->target, target_name, TARGET_COUNT, TARGET_DEFAULT); }

const TargetRow *choice_target(const MatcOptions *options)
{
    int target = target_of(options);
    return target < 0 ? NULL : &target_table[target];
}

const char *choice_job(const MatcOptions *o, Job *job)
{
    int target = target_of(o);
    int pass = index_of(o->pass, pass_name, PASS_COUNT, PASS_gbuffer);
    int layout =
        index_of(o->custom ? NULL : o->layout, layout_name, LAYOUT_COUNT, target < 0 ? 0 : target_table[target].layout);
    int slot = index_of(o->slot, slot_name, SLOT_COUNT, SLOT_diffuse);
    int precision = index_of(o->precision, precision_name, PRECISION_COUNT, PRECISION_fast);
    if (o->custom && !o->custom->row)
        return "layout";
    if (target < 0 || pass < 0 || layout < 0 || slot < 0 || precision < 0)
        return target < 0 ? "target" : pass < 0 ? "pass" : layout < 0 ? "layout" : slot < 0 ? "slot" : "precision";
    if (o->constants && strcmp(o->constants, "baked") != 0 && strcmp(o->constants, "uniform") != 0 &&
        strcmp(o->constants, "auto") != 0)
        return "constants";
    if (warnings_fault(o->warnings, &(size_t){0}))
        return "warnings";
    *job = (Job){.target = (Target)target, .pass = (Pass)pass, .layout = &layout_table[layout], .slot = (Slot)slot};
    if (o->custom)
        job->layout = o->custom->row;
    job->from_buffer = o->constants && !strcmp(o->constants, "uniform");
    for (int axis = 0; axis < AXIS_COUNT; axis++) {
        ChoiceSource source;
        int choice = choose(o, (Axis)axis, precision, &source);
        if (choice < 0)
            return axis_table[axis].name;
        job->choice[axis] = (Choice)choice;
    }
    return NULL;
}

void matc_options_init_sized(MatcOptions *options, size_t size)
{
    MatcOptions all = {.size = size, .optimize = 2, .validate = true};
#ifndef NDEBUG
    all.check = true;
#endif
    memset(options, 0, size);
    memcpy(options, &all, size < sizeof all ? size : sizeof all);
}

MatcOptions choice_whole_options(const MatcOptions *given)
{
    MatcOptions options;
    matc_options_init(&options);
    memcpy(&options, given, given->size < sizeof options ? given->size : sizeof options);
    options.size = sizeof options;
    return options;
}

void choice_store_options(Bytes *to, const MatcOptions *options)
{
    for (size_t i = 0; i < sizeof text_options / sizeof *text_options; i++) {
        const char *value;
        memcpy(&value, (const char *)options + text_options[i].member, sizeof value);
        bytes_number(to, value != NULL);
        bytes_text(to, value ? value : "");
    }
    bytes_number(to, (uint32_t)options->optimize);
    bytes_number(to, options->validate);
    bytes_text(to, options->custom ? options->custom->text : "");
}

const char *matc_options_fault(const MatcOptions *options)
{
    const MatcOptions whole = choice_whole_options(options);
    return choice_job(&whole, &(Job){0});
}

static const char *choice_name(const Job *job, int axis) { return choice_table[job->choice[axis]].name; }

void choice_explain(Text *out, const MatcOptions *options, const Job *job)
{
    static const char *const by[] = {[CHOSEN_default] = "default",
                                     [CHOSEN_by_name] = "by name",
                                     [CHOSEN_by_precision] = "--precision=",
                                     [CHOSEN_by_measuring] = "measured for --max-error"};
    int precision = index_of(options->precision, precision_name, PRECISION_COUNT, PRECISION_fast);
    text_put(out, "choices\n");
    if (job->pass == PASS_gbuffer || job->pass == PASS_plane)
        text_format(out, "  %-12s %-12s %s%s\n", "layout", job->layout->name,
                    options->custom   ? "custom"
                    : options->layout ? "by name"
                                      : "default of ",
                    options->custom || options->layout ? "" : target_table[job->target].name);
    for (int axis = 0; axis < AXIS_COUNT; axis++) {
        ChoiceSource source;
        choose(options, (Axis)axis, precision, &source);
        text_format(out, "  %-12s %-12s %s%s\n", axis_table[axis].name, choice_name(job, axis), by[source],
                    source == CHOSEN_by_precision ? options->precision : "");
    }
}
