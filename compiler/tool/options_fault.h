/* Errors in a word of the command line: the word, the choices, a proposal. */
#ifndef MATC_OPTIONS_FAULT_H
#define MATC_OPTIONS_FAULT_H
#include "compiler/base/option.h"
#include "compiler/tool/options.h"

/* The values of an option such as "--aa", from matc_options_set or from the program itself. */
bool options_values(const char *option, NameChoice *values);
/* Names that --explain knows, and kinds that --list knows. */
const char *options_fault_explain(Arena *arena, const char *name);
const char *options_fault_list(Arena *arena, const char *kind);
/* The point of --eval; NULL: nothing is wrong with it. */
const char *options_fault_point(Arena *arena, const char *point);
#endif
