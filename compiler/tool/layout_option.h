/* --layout=auto and --layout=FILE: layouts that are not in the tables. */
#ifndef MATC_LAYOUT_OPTION_H
#define MATC_LAYOUT_OPTION_H
#include "compiler/tool/options.h"

/* Returns true if the option's value is a file name. */
bool layout_is_file(const char *layout);
/* Returns true if the value is a file name or `auto`. */
bool layout_is_custom(const char *layout);
/* Returns the layout of --layout, shared by all materials of the command line; also used if
 * --explain names a file. NULL without a fault: a layout of the tables. *fault, from malloc, is
 * a complete message; a layout that is not ok has diagnostics. */
MatcLayout *layout_open(const CommandLine *line, char **fault);
#endif
