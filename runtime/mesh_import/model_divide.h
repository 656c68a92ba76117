/* A mesh by its materials. */
#ifndef MATC_VIEW_MODEL_DIVIDE_H
#define MATC_VIEW_MODEL_DIVIDE_H
#include "runtime/mesh_import/model.h"

/* A shape for each material of the runs, which go over the shape's triangles in their order: *made
 * has *count of them, by ascending material. False: memory ran out, and there is none. */
bool model_divide(const Shape *shape, const ModelRun *runs, int run_count, ModelPart **made,
                  int *count);
#endif
