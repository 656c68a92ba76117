/* Diagnostics: collected in order and printed by the caller. */
#ifndef MATC_DIAG_H
#define MATC_DIAG_H
#include "compiler/base/source.h"
#include "compiler/base/text.h"
#include "compiler/matc.h"
#include <stdbool.h>

/* advice: occurs only in rows of diags.def. Advice is a note that is off until a setting names
 * its kind. none: the diagnostic is not reported. */
typedef enum {
    SEVERITY_note,
    SEVERITY_warning,
    SEVERITY_error,
    SEVERITY_advice,
    SEVERITY_none
} Severity;

typedef enum {
#define DIAG(name, severity, format, doc) DIAG_##name,
#include "grammar/diags.def"
    DIAG_COUNT
} DiagKind;

typedef struct {
    DiagKind kind;
    Severity severity;
    Span span;
    const char *message;
} Diag;

typedef struct {
    Diag *at;
    size_t count, capacity;
    int errors;
} DiagList;

#define NO_FILE UINT32_MAX
enum { MAX_DIAGS = 100 };
/* The span of a diagnostic that concerns no file. */
#define NO_SPAN ((Span){0, 0, NO_FILE})

typedef struct {
    const char *name; /* name in diags.def: "unknown_map" */
    Severity severity;
    const char *format;
    const char *doc;
} DiagRow;
extern const DiagRow diag_table[DIAG_COUNT];

/* Returns true for warnings and advice, which have a name that settings can give. Errors, and
 * notes that belong to errors, have no name. */
bool diag_is_named(DiagKind kind);
/* Formats the message of a kind with the arguments of its format. Names and texts of the
 * document are cut to their first LIMIT_QUOTE bytes. */
void diag_message(Text *out, DiagKind kind, va_list args);
/* Sorts the diagnostics by file and line. A note stays behind its diagnostic; diagnostics
 * without a file come last. */
void diag_sort(DiagList *diags);
/* Prints a diagnostic in gcc's form, with the source line and a caret. */
void diag_print(Text *out, const Diag *diag, const Source *sources);
/* Prints a message about a file or an option: "matc: error: what: why". The JSON form is an
 * array of one object whose kind is "run" and whose subject is `what`. `what` may be NULL: the
 * message then names no file or option. */
void diag_complain(Text *out, MatcForm form, Severity severity, const char *what, const char *why);
/* Prints a diagnostic as one JSON object. */
void diag_print_json(Text *out, const Diag *diag, const Source *sources);
#endif
