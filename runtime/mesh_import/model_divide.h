/* Splits a mesh by material. */
#ifndef MATC_VIEW_MODEL_DIVIDE_H
#define MATC_VIEW_MODEL_DIVIDE_H
#include "runtime/mesh_import/model.h"

/* Builds a shape for each material of the runs, which cover the shape's triangles in order.
 * *made has *count parts by ascending material. Returns false if memory runs out; *made is then
 * NULL. */
bool model_divide(const Shape *shape, const ModelRun *runs, int run_count, ModelPart **made,
                  int *count);
#endif
