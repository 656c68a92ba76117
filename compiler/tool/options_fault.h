/* Faults of a word of the command line: the word, the choices, a suggestion. */
#ifndef MATC_OPTIONS_FAULT_H
#define MATC_OPTIONS_FAULT_H
#include "compiler/base/option.h"
#include "compiler/tool/options.h"

/* Finds the values of an option such as "--aa", of matc_options_set or of the program itself. */
bool options_values(const char *option, NameChoice *values);
/* Return the fault of an unknown name for --explain, or kind for --list. */
const char *options_fault_explain(Arena *arena, const char *name);
const char *options_fault_list(Arena *arena, const char *kind);
/* Returns the fault in the point of --eval; NULL: none. */
const char *options_fault_point(Arena *arena, const char *point);
#endif
