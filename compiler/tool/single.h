/* The files of one program: its output, textures, depfile. For many programs see batch.h. */
#ifndef MATC_SINGLE_H
#define MATC_SINGLE_H
#include "compiler/tool/options.h"

enum { SINGLE_PATH = 4096 };

/* Writes the requested output of a program, or of its document alone (program NULL: the tree).
 * Returns NULL, or the reason of a failure, with the file in `path`. */
const char *single_write(const CommandLine *line, MatcDocument *document, MatcProgram *program,
                         char path[SINGLE_PATH]);
#endif
