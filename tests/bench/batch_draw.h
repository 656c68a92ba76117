/* Draws the G-buffer programs of batches, by their manifests alone, and times them. */
#ifndef BATCH_DRAW_H
#define BATCH_DRAW_H
#include "batch_run.h"
#include "runtime/autotune/meter.h"
#include <cjson/cJSON.h>

/* A batch's programs and the targets that they are drawn to. */
typedef struct {
    const BatchFolder *folder;
    const char *out; /* below the folder */
    cJSON *manifest;
    Framebuffer targets;
} BatchOutput;

/* False: see stderr. Delete in any case. */
bool batch_output_read(BatchOutput *output, const BatchFolder *folder, const char *out);
bool batch_output_targets(BatchOutput *output, Meter *meter, int width, int height);
void batch_output_delete(BatchOutput *output, Meter *meter);

/* A material's program, with its constants in a buffer. False: meter->error; delete in any case. */
bool batch_draw_make(Meter *meter, const BatchOutput *output, int material, Material *made);

/* The program of a material for a pass, and what the manifest says of the material's use of it;
 * NULL. */
const cJSON *batch_program(const cJSON *manifest, int material, const char *pass,
                           const cJSON **use);
#endif
