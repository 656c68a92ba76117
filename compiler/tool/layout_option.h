/* --layout=auto and --layout=FILE: the layout of a command line that is none of the tables'. */
#ifndef MATC_LAYOUT_OPTION_H
#define MATC_LAYOUT_OPTION_H
#include "compiler/tool/options.h"

/* The option's value is the name of a file. */
bool layout_is_file(const char *layout);
/* It is that, or auto. */
bool layout_is_custom(const char *layout);
/* The layout of --layout, which all materials of the command line then share; also where --explain
 * names a file. NULL and no fault: it is one of the tables'. A fault is from malloc and says all; a
 * layout that is not ok has diagnostics. */
MatcLayout *layout_open(const CommandLine *line, char **fault);
#endif
