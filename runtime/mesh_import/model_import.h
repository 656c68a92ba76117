/* Imports a mesh with assimp, which must run in a sandboxed process. */
#ifndef MATC_VIEW_MODEL_IMPORT_H
#define MATC_VIEW_MODEL_IMPORT_H
#include "runtime/mesh_import/model.h"
#include <stddef.h>

/* Unprocessed content of a file; vertices have no tangents. */
typedef struct {
    Shape shape;
    ModelRun *runs;
    int run_count;
    bool has_normals, has_coordinates;
} ModelParts;

/* Reads a file. Returns false with the reason in *error. */
bool model_import(const ModelSource *source, ModelParts *parts, char *error, size_t capacity);
#endif
