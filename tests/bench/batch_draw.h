/* Draws the G-buffer programs of batches, by their manifests alone, and times them. */
#ifndef BATCH_DRAW_H
#define BATCH_DRAW_H
#include "batch_run.h"
#include "runtime/autotune/meter.h"
#include <cjson/cJSON.h>

/* A batch's programs and their render targets. */
typedef struct {
    const BatchFolder *folder;
    const char *out; /* output folder, below the batch's folder */
    cJSON *manifest;
    Framebuffer targets;
} BatchOutput;

/* Returns false after a message on standard error. Delete in any case. */
bool batch_output_read(BatchOutput *output, const BatchFolder *folder, const char *out);
bool batch_output_targets(BatchOutput *output, Meter *meter, int width, int height);
void batch_output_delete(BatchOutput *output, Meter *meter);

/* Makes a material's program, with its constants in a buffer. Returns false with meter->error;
 * delete in any case. */
bool batch_draw_make(Meter *meter, const BatchOutput *output, int material, Material *made);

/* The program of a material for a pass, and the manifest's entry of the material's use of the
 * program; or NULL. */
const cJSON *batch_program(const cJSON *manifest, int material, const char *pass,
                           const cJSON **use);
#endif
