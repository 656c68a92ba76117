/* Options -> job: looks up names in the tables, and describes the choices and their sources. */
#include "compiler/choice.h"
#include "compiler/base/warnings.h"
#include "compiler/layout/custom.h"
#include "compiler/pipeline.h"
#include <stddef.h>
#include <string.h>

/* Source of an axis' choice. */
typedef enum {
    CHOSEN_default,
    CHOSEN_by_name,
    CHOSEN_by_precision,
    CHOSEN_by_measuring
} ChoiceSource;

static const char *target_name(const void *user, int i)
{
    (void)user;
    return target_table[i].name;
}

static const char *pass_name(const void *user, int i)
{
    (void)user;
    return pass_table[i].name;
}

static const char *layout_name(const void *user, int i)
{
    (void)user;
    return layout_table[i].name;
}

static const char *slot_name(const void *user, int i)
{
    (void)user;
    return slot_table[i].name;
}

static const char *normals_name(const void *user, int i)
{
    (void)user;
    return normals_table[i].name;
}

static const char *precision_name(const void *user, int i)
{
    (void)user;
    return precision_table[i].name;
}

static const char *constants_name(const void *user, int i)
{
    static const char *const names[] = {"auto", "baked", "uniform"};
    (void)user;
    return names[i];
}

static const char *choice_name_of(const void *axis, int i)
{
    return choice_table[((const AxisRow *)axis)->first + i].name;
}

bool choice_values(const char *option, NameChoice *values)
{
    static const struct {
        const char *option;
        NameChoice values;
    } lists[] = {{"target", {target_name, NULL, TARGET_COUNT}},
                 {"pass", {pass_name, NULL, PASS_COUNT}},
                 {"slot", {slot_name, NULL, SLOT_COUNT}},
                 {"layout", {layout_name, NULL, LAYOUT_COUNT}},
                 {"normals", {normals_name, NULL, NORMALS_COUNT}},
                 {"precision", {precision_name, NULL, PRECISION_COUNT}},
                 {"constants", {constants_name, NULL, 3}},
                 {"warnings", {warnings_name, NULL, DIAG_COUNT}}};
    for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
        if (!strcmp(lists[i].option, option)) {
            *values = lists[i].values;
            return true;
        }
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        if (!strcmp(axis_table[axis].name, option)) {
            *values = (NameChoice){choice_name_of, &axis_table[axis], axis_choices(axis)};
            return true;
        }
    return false;
}

typedef struct {
    const char *name;
    size_t member;
} TextOption;

#define TEXT_OPTION(name)                                                                          \
    {                                                                                              \
#name, offsetof(MatcOptions, name)                                                         \
    }
static const TextOption text_options[] = {
#define AXIS(name, chunks, doc) TEXT_OPTION(name),
#include "grammar/variants.def"
    TEXT_OPTION(target),    TEXT_OPTION(pass),      TEXT_OPTION(slot),     TEXT_OPTION(layout),
    TEXT_OPTION(precision), TEXT_OPTION(constants), TEXT_OPTION(warnings), TEXT_OPTION(normals),
};

static const TextOption *text_option(const char *name)
{
    for (size_t i = 0; i < sizeof text_options / sizeof *text_options; i++)
        if (!strcmp(text_options[i].name, name))
            return &text_options[i];
    return NULL;
}

static const char *text_of(const MatcOptions *options, const TextOption *option)
{
    const char *value;
    memcpy(&value, (const char *)options + option->member, sizeof value);
    if (!value && option->member == offsetof(MatcOptions, warnings) && *options->warning_text)
        return options->warning_text;
    return value;
}

const char *choice_value(const MatcOptions *options, const char *option)
{
    return text_of(options, text_option(option));
}

bool choice_set(MatcOptions *options, const char *name, const char *value)
{
    const TextOption *option = text_option(name);
    if (!option || option->member + sizeof value > options->size)
        return false; /* the option is unknown, or missing in the caller's version */
    memcpy((char *)options + option->member, &value, sizeof value);
    return true;
}

/* Returns -1 for an unknown value. */
static int index_of(const char *value, const char *option)
{
    NameChoice values;
    if (!choice_values(option, &values))
        return -1;
    for (int i = 0; i < values.count; i++)
        if (!strcmp(values.name(values.user, i), value))
            return i;
    return -1;
}

static bool is_value(const char *option, const char *value)
{
    if (!value)
        return true; /* NULL selects the default */
    return strcmp(option, "warnings") ? index_of(value, option) >= 0
                                      : !warnings_fault(value, &(size_t){0});
}

/* Sets the warnings, whose list is not a name of a table. The options hold a copy, so that they
 * can be assigned. */
static bool set_warnings(MatcOptions *options, const char *value)
{
    const size_t size = value ? strlen(value) + 1 : 0;
    if (options->size < offsetof(MatcOptions, warning_text) + sizeof options->warning_text ||
        size > sizeof options->warning_text)
        return false;
    options->warnings = NULL;
    memset(options->warning_text, 0, sizeof options->warning_text);
    if (value)
        memcpy(options->warning_text, value, size);
    return true;
}

bool matc_options_set(MatcOptions *options, const char *name, const char *value)
{
    NameChoice values;
    if (!options || !name || !text_option(name) || !is_value(name, value))
        return false;
    if (!strcmp(name, "warnings"))
        return set_warnings(options, value);
    /* stores the table's string, which outlives the caller's */
    if (value && choice_values(name, &values))
        value = values.name(values.user, index_of(value, name));
    return choice_set(options, name, value);
}

static int index_or(const MatcOptions *options, const char *option, int otherwise)
{
    const char *value = choice_value(options, option);
    return value ? index_of(value, option) : otherwise;
}

static int precision_of(const MatcOptions *o) { return index_or(o, "precision", PRECISION_fast); }

/* Selects a choice by its name, otherwise by the precision's row, otherwise the axis' default. */
static int choose(const MatcOptions *o, Axis axis, ChoiceSource *source)
{
    const char *name = choice_value(o, axis_table[axis].name);
    int precision = precision_of(o), first = axis_table[axis].first,
        row = precision_table[precision].choice[axis];
    if (!name) {
        *source = o->precision && row >= 0 ? CHOSEN_by_precision : CHOSEN_default;
        return row >= 0 ? row : first;
    }
    *source = o->measured >> axis & 1 ? CHOSEN_by_measuring : CHOSEN_by_name;
    return first + index_of(name, axis_table[axis].name);
}

static int target_of(const MatcOptions *o) { return index_or(o, "target", TARGET_DEFAULT); }

const TargetRow *choice_target(const MatcOptions *options)
{
    int target = target_of(options);
    return target < 0 ? NULL : &target_table[target];
}

/* A caller of an older library may know fewer options, but at least all members above
 * `optimize`. */
bool choice_is_set(const MatcOptions *options)
{
    return options->size >= offsetof(MatcOptions, optimize);
}

/* Returns the first option with an unknown value; NULL: none. */
static const char *fault_of(const MatcOptions *o)
{
    if (o->custom && !o->custom->row)
        return "layout";
    for (size_t i = 0; i < sizeof text_options / sizeof *text_options; i++) {
        const char *name = text_options[i].name;
        const bool counts = !o->custom || strcmp(name, "layout") != 0;
        if (counts && !is_value(name, text_of(o, &text_options[i])))
            return name;
    }
    return NULL;
}

const char *choice_job(const MatcOptions *o, Job *job)
{
    const char *fault = fault_of(o);
    if (fault)
        return fault;
    const Target target = (Target)target_of(o);
    *job = (Job){.target = target,
                 .pass = (Pass)index_or(o, "pass", PASS_gbuffer),
                 .slot = (Slot)index_or(o, "slot", SLOT_diffuse),
                 .normals = (Normals)index_or(o, "normals", NORMALS_eye),
                 .from_buffer = o->constants && !strcmp(o->constants, "uniform")};
    job->moved = o->moved;
    job->computed = o->compute;
    job->origin = o->origin && job->pass != PASS_sky; /* the sky's position is a direction */
    job->instances = o->instances && target_table[target].storage && job->pass != PASS_plane &&
                     job->pass != PASS_sky;
    job->cases = o->cases;
    job->layout = o->custom ? o->custom->row
                            : &layout_table[index_or(o, "layout", target_table[target].layout)];
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        job->choice[axis] = (Choice)choose(o, (Axis)axis, &(ChoiceSource){0});
    return NULL;
}

const char *choice_fault(Arena *arena, const MatcOptions *options)
{
    const char *option = choice_is_set(options) ? fault_of(options) : "size",
               *value = option && text_option(option) ? choice_value(options, option) : NULL;
    NameChoice values;
    if (!option)
        return NULL;
    Text out = text_new(arena);
    if (!strcmp(option, "size")) {
        text_put(&out, "the options were not initialized by matc_options_init");
        return out.at;
    }
    if (!value || !choice_values(option, &values)) {
        text_format(&out, "%s: the given layout has errors", option);
        return out.at;
    }
    text_format(&out, "%s: unknown value '%s'; expected %s%s", option, value,
                suggest_list(arena, &values),
                suggest(arena, value, values.name, values.user, values.count));
    return out.at;
}

void matc_options_init_sized(MatcOptions *options, size_t size)
{
    MatcOptions all = {.size = size, .optimize = 2, .validate = true};
#ifndef NDEBUG
    all.check = true;
#endif
    if (!options)
        return;
    memset(options, 0, size);
    memcpy(options, &all, size < sizeof all ? size : sizeof all);
}

MatcOptions choice_whole_options(const MatcOptions *given)
{
    MatcOptions options;
    matc_options_init(&options);
    if (!given)
        return options;
    if (choice_is_set(given))
        memcpy(&options, given, given->size < sizeof options ? given->size : sizeof options);
    options.size = choice_is_set(given) ? sizeof options : given->size;
    options.member_count = options.members && options.member_count > 0 ? options.member_count : 0;
    options.include_count =
        options.include && options.include_count > 0 ? options.include_count : 0;
    return options;
}

bool choice_check(Session *session)
{
    const MatcOptions *options = session->options;
    return choice_is_set(options) ||
           diag_add(session, NO_SPAN, DIAG_unset_options, (int)options->size);
}

void choice_store_options(Bytes *to, const MatcOptions *options)
{
    for (size_t i = 0; i < sizeof text_options / sizeof *text_options; i++) {
        const char *value = text_of(options, &text_options[i]);
        bytes_number(to, value != NULL);
        bytes_text(to, value ? value : "");
    }
    bytes_number(to, (uint32_t)options->optimize);
    bytes_number(to, options->validate);
    bytes_number(to, options->compute);
    bytes_text(to, options->custom ? options->custom->text : "");
    bytes_text(to, options->root ? options->root : "");
}

const char *matc_options_fault(const MatcOptions *options)
{
    const MatcOptions whole = choice_whole_options(options);
    return choice_is_set(&whole) ? fault_of(&whole) : "size";
}

static const char *choice_name(const Job *job, int axis)
{
    return choice_table[job->choice[axis]].name;
}

void choice_explain(Text *out, const MatcOptions *options, const Job *job)
{
    static const char *const by[] = {[CHOSEN_default] = "default",
                                     [CHOSEN_by_name] = "by name",
                                     [CHOSEN_by_precision] = "--precision=",
                                     [CHOSEN_by_measuring] = "measured for --max-error"};
    text_put(out, "choices\n");
    if (job->pass == PASS_gbuffer || job->pass == PASS_plane)
        text_format(out, "  %-12s %-12s %s%s\n", "layout", job->layout->name,
                    options->custom   ? "custom"
                    : options->layout ? "by name"
                                      : "default of ",
                    options->custom || options->layout ? "" : target_table[job->target].name);
    for (int axis = 0; axis < AXIS_COUNT; axis++) {
        ChoiceSource source;
        choose(options, (Axis)axis, &source);
        text_format(out, "  %-12s %-12s %s%s\n", axis_table[axis].name, choice_name(job, axis),
                    by[source], source == CHOSEN_by_precision ? options->precision : "");
    }
}
