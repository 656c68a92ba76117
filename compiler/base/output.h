/* Output files, which are written completely or not at all. */
#ifndef MATC_OUTPUT_H
#define MATC_OUTPUT_H
#include "compiler/matc.h"
#include "compiler/base/staging/staging.h"

enum { OUTPUT_FOLDERS = 4 };

/* Files for several folders that appear together; initialized with {0}. Three destinations are
 * written directly: "-" (standard output), devices and pipes, which cannot be replaced, and
 * paths of open files (/dev/stdout, /dev/fd/3). Any other symbolic link is replaced by the file,
 * not followed. */
typedef struct {
    Staging *stagings[OUTPUT_FOLDERS];
    int count;
} Outputs;

/* Returns the staging of a folder, or NULL and *why. */
Staging *outputs_open(Outputs *outputs, const char *folder, unsigned how, const char **why);
/* Stages a file, or writes a special one directly. Returns NULL or a fault. outputs_commit()
 * replaces an existing file even if the bytes are equal. */
const char *outputs_put(Outputs *outputs, const char *path, const void *bytes, size_t size);
const char *outputs_commit(Outputs *outputs);
void outputs_close(Outputs *outputs);
/* Writes and commits a single file. Returns NULL or a fault. */
const char *output_write(const char *path, const void *bytes, size_t size);
/* Opens /dev/null for each closed descriptor of 0 to 2, in the mode that makes reads and writes
 * fail. Otherwise the next opened file would become standard output, and a picture for standard
 * output would be written into that file. */
void output_hold_streams(void);
/* Formats a texture as a KTX 1 file (row 0 is v = 0); from malloc. */
char *output_ktx(const MatcTexture *texture, size_t *size);
#endif
