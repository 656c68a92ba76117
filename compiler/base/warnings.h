/* Severities of warnings by -W of the command line and by MatcOptions.warnings. */
#ifndef MATC_WARNINGS_H
#define MATC_WARNINGS_H
#include "compiler/base/diag.h"

/* Severity of a kind of diags.def under settings such as "no-unordered_items,error" (NULL: none).
 * SEVERITY_none: do not report it. Advice becomes a note if a setting names it, and never an
 * error. */
Severity warnings_severity(const char *settings, DiagKind kind);
/* The first setting that means nothing, in place; NULL if there is none. *size: its length. */
const char *warnings_fault(const char *settings, size_t *size);
/* The i-th name that settings may use, NULL after the last; for suggestions. */
const char *warnings_name(const void *user, int i);
#endif
