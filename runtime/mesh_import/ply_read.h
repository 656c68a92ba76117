/* Reader of PLY files: vertices with normals, texture coordinates and colors; faces and triangle
 * strips. All other elements and properties are skipped. */
#ifndef MATC_VIEW_PLY_READ_H
#define MATC_VIEW_PLY_READ_H
#include "runtime/mesh_import/model_reader.h"

bool ply_read(const ModelSource *source, ModelParts *parts, char *error, size_t capacity);
#endif
