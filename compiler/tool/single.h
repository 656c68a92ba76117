/* The files of one program: its output, its textures, its depfile. batch.h is for many. */
#ifndef MATC_SINGLE_H
#define MATC_SINGLE_H
#include "compiler/tool/options.h"

enum { SINGLE_PATH = 4096 };

/* Writes what the command line asks for of a program, or of its document alone (program NULL: the
 * tree). NULL; or why not, and in `path` which file. */
const char *single_write(const CommandLine *line, MatcDocument *document, MatcProgram *program,
                         char path[SINGLE_PATH]);
#endif
