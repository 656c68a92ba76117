/* Readers of mesh files, one for each format. */
#ifndef MATC_VIEW_MODEL_READER_H
#define MATC_VIEW_MODEL_READER_H
#include "runtime/mesh_import/model.h"
#include <stddef.h>

/* Content of a file in the file's axes. The runs cover the shape's vertices and indices in order.
 * Vertices have tangents in runs with `has_tangents` only, and 0 for all else that is missing. */
typedef struct {
    Shape shape;
    ModelRun *runs; /* from malloc, as the shape's arrays */
    int run_count;
} ModelParts;

/* Reads a file that exists and is no larger than MODEL_FILE_MIB. Returns false with the reason in
 * *error; the caller frees *parts in both cases. */
typedef bool ModelReader(const ModelSource *source, ModelParts *parts, char *error,
                         size_t capacity);

bool model_import(const ModelSource *source, ModelParts *parts, char *error, size_t capacity);
#endif
