/* Meshes that fetch.sh has downloaded into the build folder, for tests and benchmarks. README.md
 * lists them. */
#ifndef MATC_TEST_MESHES_H
#define MATC_TEST_MESHES_H
#include "runtime/gl/shape.h"

/* The path of a mesh by its name, "bunny", from malloc; NULL: there is none. */
char *meshes_path(const char *name);
/* A mesh for a test, in place (model_read). Where it isn't there the process ends as skipped, and
 * says how to fetch it. */
Shape meshes_read(const char *name);
#endif
