/* The documents that a command line names: one by one, or in lists. */
#ifndef MATC_OPTIONS_INPUT_H
#define MATC_OPTIONS_INPUT_H
#include "compiler/tool/options.h"

void options_add_input(CommandLine *line, const char *path);
/* Those of a list, a path a line. False: *fault says why it cannot be read. */
bool options_read_list(CommandLine *line, const char *path, const char **fault);
#endif
