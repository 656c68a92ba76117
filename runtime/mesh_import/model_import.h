/* The part of a mesh's reading that is not ours: assimp's, which has to run where it can do no
 * harm. */
#ifndef MATC_VIEW_MODEL_IMPORT_H
#define MATC_VIEW_MODEL_IMPORT_H
#include "runtime/mesh_import/model.h"
#include <stddef.h>

/* Content of a file as it is; vertices without tangents. */
typedef struct {
    Shape shape;
    ModelRun *runs;
    int run_count;
    bool has_normals, has_coordinates;
} ModelParts;

/* False: *error. */
bool model_import(const ModelSource *source, ModelParts *parts, char *error, size_t room);
#endif
