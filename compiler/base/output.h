/* Files that matc writes: whole or not at all. */
#ifndef MATC_OUTPUT_H
#define MATC_OUTPUT_H
#include "compiler/matc.h"
#include "compiler/base/staging/staging.h"

enum { OUTPUT_FOLDERS = 4 };

/* Files for some folders, which appear together: {0} at first. A device or a pipe is written at
 * once, since nothing can take its place; so are "-", which is standard output, and what stands for
 * an open file (/dev/stdout, /dev/fd/3). Another link is replaced by the file, and not followed. */
typedef struct {
    Staging *stagings[OUTPUT_FOLDERS];
    int count;
} Outputs;

/* The staging of a folder; NULL, and *why. */
Staging *outputs_open(Outputs *outputs, const char *folder, unsigned how, const char **why);
/* NULL, or why not. A file is replaced by an equal one, too. */
const char *outputs_put(Outputs *outputs, const char *path, const void *bytes, size_t size);
const char *outputs_commit(Outputs *outputs);
void outputs_close(Outputs *outputs);
/* All that with one file. */
const char *output_write(const char *path, const void *bytes, size_t size);
/* Gives each of the descriptors 0 to 2 that is closed a stand-in that neither reads nor writes.
 * Without it the next file to be opened would be standard output, and a picture for it would be
 * written into itself. */
void output_hold_streams(void);
/* A texture as a KTX 1 file (row 0 is v = 0), from malloc. */
char *output_ktx(const MatcTexture *texture, size_t *size);
#endif
