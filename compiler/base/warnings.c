/* Parses the settings of warnings, separated by commas: NAME, no-NAME, error, no-error,
 * error=NAME, no-error=NAME. The last setting that applies to a warning is effective.
 *
 *     no-unordered_items,error    unordered_items is off, every other warning is an error
 *     linear_colors               enables advice, which is off by default */
#include "compiler/base/warnings.h"
#include <string.h>

typedef struct {
    const char *name; /* name of a warning; NULL: all warnings */
    size_t size;
    bool no, error;
} Setting;

static bool take(const char **at, size_t *size, const char *prefix)
{
    const size_t length = strlen(prefix);
    if (*size < length || strncmp(*at, prefix, length) != 0)
        return false;
    *at += length;
    *size -= length;
    return true;
}

static Setting read_setting(const char *at, size_t size)
{
    Setting setting = {.no = take(&at, &size, "no-")};
    if (size == strlen("error") && take(&at, &size, "error")) {
        setting.error = true;
        return setting;
    }
    setting.error = take(&at, &size, "error=");
    setting.name = at;
    setting.size = size;
    return setting;
}

/* Compares names; '-' in the setting equals '_', since other compilers write names with dashes. */
static bool has_name(const Setting *setting, const char *name)
{
    if (strlen(name) != setting->size)
        return false;
    for (size_t i = 0; i < setting->size; i++)
        if (name[i] != (setting->name[i] == '-' ? '_' : setting->name[i]))
            return false;
    return true;
}

/* Names of version 0.1. */
static const struct {
    const char *old;
    DiagKind kind;
} aliases[] = {{"parted", DIAG_dropped}};

/* Returns true if the setting names the warning, by its present name or by an alias. */
static bool names_warning(const Setting *setting, DiagKind kind)
{
    bool named = has_name(setting, diag_table[kind].name);
    for (size_t i = 0; i < sizeof aliases / sizeof *aliases; i++)
        named |= aliases[i].kind == kind && has_name(setting, aliases[i].old);
    return named;
}

Severity warnings_severity(const char *settings, DiagKind kind)
{
    const DiagRow *row = &diag_table[kind];
    const bool advice = row->severity == SEVERITY_advice;
    bool reported = !advice, error = false;
    if (!diag_is_named(kind))
        return row->severity;
    for (size_t size; settings && *settings; settings += size + (settings[size] == ',')) {
        size = strcspn(settings, ",");
        const Setting setting = read_setting(settings, size);
        if (setting.name && !names_warning(&setting, kind))
            continue;
        if (setting.error)
            error = !setting.no;
        else
            reported = !setting.no;
    }
    return !reported ? SEVERITY_none
           : advice  ? SEVERITY_note
           : error   ? SEVERITY_error
                     : SEVERITY_warning;
}

const char *warnings_renamed(const char *name)
{
    for (size_t i = 0; i < sizeof aliases / sizeof *aliases; i++)
        if (strcmp(name, aliases[i].old) == 0)
            return diag_table[aliases[i].kind].name;
    return NULL;
}

const char *warnings_name(const void *user, int i)
{
    (void)user;
    for (int kind = 0; kind < DIAG_COUNT; kind++)
        if (diag_is_named((DiagKind)kind) && i-- == 0)
            return diag_table[kind].name;
    return NULL;
}

static bool is_known(const Setting *setting)
{
    for (int kind = 0; setting->name && kind < DIAG_COUNT; kind++)
        if (diag_is_named((DiagKind)kind) && names_warning(setting, (DiagKind)kind))
            return true;
    return !setting->name;
}

const char *warnings_fault(const char *settings, size_t *size)
{
    for (; settings && *settings; settings += *size + (settings[*size] == ',')) {
        *size = strcspn(settings, ",");
        const Setting setting = read_setting(settings, *size);
        if (!is_known(&setting))
            return settings;
    }
    return NULL;
}
