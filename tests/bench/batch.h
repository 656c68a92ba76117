/* The parts of matbench batch. */
#ifndef BATCH_H
#define BATCH_H
#include "batch_run.h"
#include "runtime/gl/context.h"

/* Measures savings by shared programs, by layouts made for a scene, and by programs for each
 * pass: prints a table. */
bool batch_measure_scene(BatchFolder *folder, GlKind gl, bool timed);
#endif
