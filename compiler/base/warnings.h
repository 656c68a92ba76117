/* Severities of warnings as set by -W and by MatcOptions.warnings. */
#ifndef MATC_WARNINGS_H
#define MATC_WARNINGS_H
#include "compiler/base/diag.h"

/* Returns the severity of a kind of diags.def under settings such as "no-unordered_items,error"
 * (NULL: none). SEVERITY_none: do not report it. Advice becomes a note if a setting names it,
 * and never an error. */
Severity warnings_severity(const char *settings, DiagKind kind);
/* Returns the first invalid setting, a pointer into `settings`, and its length in *size; NULL if
 * all are valid. */
const char *warnings_fault(const char *settings, size_t *size);
/* Returns the present name of a warning that was renamed; NULL for any other name. */
const char *warnings_renamed(const char *name);
/* Returns the i-th name that settings may use, NULL after the last; for suggestions. */
const char *warnings_name(const void *user, int i);
#endif
