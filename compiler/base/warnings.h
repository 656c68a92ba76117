/* Which warnings are said, and which are errors: what -W of the command line and MatcOptions.warnings tell. */
#ifndef MATC_WARNINGS_H
#define MATC_WARNINGS_H
#include "compiler/base/diag.h"

/* Of a kind of diags.def by settings such as "no-unordered_items,error" (NULL: none); SEVERITY_none: not said. Advice
 * is a note where a setting names it, and never an error. */
Severity warnings_severity(const char *settings, DiagKind kind);
/* The first setting that means nothing, in place; NULL if there is none. *size: its length. */
const char *warnings_fault(const char *settings, size_t *size);
/* The i-th name that settings may give, NULL behind the last; for suggestions. */
const char *warnings_name(const void *user, int i);
#endif
