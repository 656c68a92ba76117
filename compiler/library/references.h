/* Which C function computes what a GLSL function computes. */
#ifndef MATC_REFERENCES_H
#define MATC_REFERENCES_H

/* Arguments are all components in a row, in double; the context is a ReferenceContext
 * (reference.h). */
typedef void (*Reference)(const void *context, const double *args, double *result);
/* By a Function or FN_FIRST_MAP + Kind (grammar/tables.h). NULL: it has none. */
Reference reference_of(int function);
#endif
