/* The parts of matbench batch. */
#ifndef BATCH_H
#define BATCH_H
#include "batch_run.h"
#include "runtime/gl/context.h"

/* Savings by shared programs, layouts made for a scene, and programs for each pass: a table on
 * standard output. */
bool batch_measure_scene(BatchFolder *folder, GlKind gl, bool timed);
#endif
