/* The C reference of each GLSL function. */
#ifndef MATC_REFERENCES_H
#define MATC_REFERENCES_H

/* args: all components in order, in double; context: a ReferenceContext (reference.h). */
typedef void (*Reference)(const void *context, const double *args, double *result);
/* Index: a Function, or FN_FIRST_MAP + Kind (grammar/tables.h). NULL if the function has no
 * reference. */
Reference reference_of(int function);
#endif
