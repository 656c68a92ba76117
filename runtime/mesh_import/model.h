/* Meshes out of files. */
#ifndef MATC_VIEW_MODEL_H
#define MATC_VIEW_MODEL_H
#include "compiler/base/watch.h"
#include "runtime/gl/shape.h"
#include <stddef.h>

enum {
    MODEL_FILE_MIB = 256,
    MODEL_VERTICES = 1 << 22,
    MODEL_INDICES = 1 << 24,
    MODEL_RUNS = 1 << 20,
    MODEL_NO_MATERIAL = INT32_MAX,
    MODEL_SECONDS = 30,     /* of reading */
    MODEL_MEMORY_MIB = 4096 /* for reading */
};

/* Triangles one after the other that have one material. */
typedef struct {
    int material;    /* as the file counts them; MODEL_NO_MATERIAL: a glTF's that have none */
    int index_count; /* three for each triangle */
} ModelRun;

/* Reads an OBJ, glTF 2 (.gltf, .glb) or PLY file: all its triangles, turned so that z is up (OBJ
 * and glTF have y up), moved and scaled until the corners of its bounding box are at most 1 from
 * the origin. Normals that are missing become those of the faces, smoothed; texture coordinates
 * longitude and latitude; tangents are dP/du and dP/dv of the triangles, as on every shape. A
 * vertex where mirrored texture coordinates meet others becomes two. False: *error, and *made is
 * empty. */
bool model_read(const char *path, Shape *made, char *error, size_t room);

/* Reads a mesh with its own position and size, for scenes. */
bool model_read_in_place(const char *path, Shape *made, char *error, size_t room);

/* Reads a shape for each material that triangles have, in the order of the file's materials: *made
 * has count of them, from malloc. */
typedef struct {
    int material;
    Shape shape;
} ModelPart;
bool model_read_parts(const char *path, ModelPart **made, int *count, char *error, size_t room);

/* A mesh's file that somebody else's document names. */
typedef struct {
    const char *path;
    /* the folder below which it lies, and all files that it names: root.h. NULL: anywhere */
    const char *root;
    bool whole; /* one part, of material -1, whatever materials it has */
} ModelSource;
/* Reads it in place, in parts as model_read_parts() returns them. */
bool model_read_source(const ModelSource *source, ModelPart **made, int *count, char *error,
                       size_t room);

/* Adds the files beside itself that a mesh's file is made of: a .gltf's buffers, whether they are
 * there or not. */
void model_files(const char *path, WatchList *files);

/* The second half: checks what was read, and adds what is missing. NULL, or what is wrong. */
const char *model_complete(Shape *shape, bool has_normals, bool has_coordinates);
const char *model_complete_in_place(Shape *shape, bool has_normals, bool has_coordinates);
#endif
