/* Diagnostics: collected in order, printed by the caller. */
#ifndef MATC_DIAG_H
#define MATC_DIAG_H
#include "compiler/base/source.h"
#include "compiler/base/text.h"
#include "compiler/matc.h"
#include <stdbool.h>

/* advice: only in rows of diags.def; such a diagnostic is a note that is off until a setting names
 * it. none: the diagnostic is not reported. */
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
    size_t count, room;
    int errors;
} DiagList;

#define NO_FILE UINT32_MAX
enum { MOST_DIAGS = 100 };
/* A span that belongs to no file. */
#define NO_SPAN ((Span){0, 0, NO_FILE})

typedef struct {
    const char *name; /* "unknown_map" */
    Severity severity;
    const char *format;
    const char *doc;
} DiagRow;
extern const DiagRow diag_table[DIAG_COUNT];

/* Warnings and advice have a name that settings may give; errors and the notes about them have
 * none. */
bool diag_is_named(DiagKind kind);
/* The message of a kind, its format's arguments being these. Of names and texts of the document it
 * has the first LIMIT_QUOTE bytes. */
void diag_message(Text *out, DiagKind kind, va_list args);
/* Puts what has been said in the order of files and lines, a note behind what it is of; what is in
 * no file comes last. */
void diag_sort(DiagList *diags);
/* gcc's form, with the source line and a caret. */
void diag_print(Text *out, const Diag *diag, const Source *sources);
/* A message of a program about a file or an option: "matc: error: what: why", or an array of one
 * object whose kind is "run" and whose subject is `what`. NULL for `what`: the message is about
 * nothing that has a name. */
void diag_complain(Text *out, MatcForm form, Severity severity, const char *what, const char *why);
/* One JSON object. */
void diag_print_json(Text *out, const Diag *diag, const Source *sources);
#endif
