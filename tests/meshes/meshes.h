/* Meshes that fetch.sh has downloaded into the build folder, for tests and benchmarks. README.md
 * lists them. */
#ifndef MATC_TEST_MESHES_H
#define MATC_TEST_MESHES_H
#include "runtime/gl/shape.h"

/* The path of a mesh by its name, "bunny", from malloc; NULL if it was not fetched. */
char *meshes_path(const char *name);
/* A mesh for a test, normalized by model_read. If the file is missing the process ends as
 * skipped, and prints how to fetch it. */
Shape meshes_read(const char *name);
#endif
