/* Reader of Wavefront OBJ files: polygons with positions, colors, texture coordinates and normals.
 * Points, lines and curves are left out. Materials are not read, nor are MTL files. A corner
 * without a normal gets the mean of its faces' normals, weighted by area: over all faces of its
 * position that have the same number of `s`, or the face alone behind `s off`. */
#ifndef MATC_VIEW_OBJ_READ_H
#define MATC_VIEW_OBJ_READ_H
#include "runtime/mesh_import/model_reader.h"

bool obj_read(const ModelSource *source, ModelParts *parts, char *error, size_t capacity);
#endif
