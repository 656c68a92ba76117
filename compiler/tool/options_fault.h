/* What is wrong with a word of the command line: the word, what may stand there, what was perhaps meant. */
#ifndef MATC_OPTIONS_FAULT_H
#define MATC_OPTIONS_FAULT_H
#include "compiler/base/suggest.h"
#include "compiler/tool/options.h"

/* "--target=hlsl: there is glsl110, glsl330, ...; did you mean ...?"; in the arena. */
const char *options_fault_value(Arena *arena, const char *option, const char *value, const NameChoice *values);
/* The values of an option that matc_options_set takes, and what the program takes beyond; false: it is none of these. */
bool options_fault_values(const char *option, NameChoice *values);
/* Names that --explain knows, and kinds that --list knows. */
const char *options_fault_explain(Arena *arena, const char *name);
const char *options_fault_list(Arena *arena, const char *kind);
/* Of -O, of -W, and the point of --eval; NULL: nothing is wrong with it. */
const char *options_fault_level(Arena *arena, const char *level);
const char *options_fault_warning(Arena *arena, const char *name);
const char *options_fault_point(Arena *arena, const char *point);
/* "--range wants a number above 0, not 'x'" */
const char *options_fault_number(Arena *arena, const char *wants, const char *value);
#endif
