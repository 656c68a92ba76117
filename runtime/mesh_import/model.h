/* Imports meshes from files. */
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
    MODEL_NODES = 1 << 18,     /* nodes of a glTF file */
    MODEL_INSTANCES = 1 << 18, /* nodes with meshes, and their EXT_mesh_gpu_instancing instances */
    MODEL_VALUES = 1 << 28,    /* numbers that are read from a glTF file's accessors */
    MODEL_NO_MATERIAL = INT32_MAX,
    MODEL_SECONDS = 30,     /* CPU time limit of reading */
    MODEL_MEMORY_MIB = 4096 /* max memory for reading a file, in MiB */
};

/* Consecutive triangles that share a material, such as a glTF primitive. A run uses consecutive
 * vertices, which no other run uses. */
typedef struct {
    int material;     /* index in the file; MODEL_NO_MATERIAL: glTF triangles without material */
    int index_count;  /* number of indices, three per triangle */
    int vertex_count; /* number of vertices, used or not */
    bool has_normals, has_coordinates;
    /* Both tangents are directions of the file: their lengths are computed, as for others. */
    bool has_tangents;
} ModelRun;

/* Reads all triangles of an OBJ, glTF 2 (.gltf, .glb) or PLY file. Rotates OBJ and glTF meshes
 * from y up to z up. Moves and scales the mesh until the corners of its bounding box are at most
 * 1 from the origin. Missing normals become smoothed face normals. Missing texture coordinates
 * become longitude and latitude. Tangents are dP/du and dP/dv of the triangles, as on every
 * shape. A vertex between mirrored and unmirrored texture coordinates is split in two. Returns
 * false with the reason in *error; *made is then empty. */
bool model_read(const char *path, Shape *made, char *error, size_t capacity);

/* Reads a mesh for a scene, at its original position and size. */
bool model_read_in_place(const char *path, Shape *made, char *error, size_t capacity);

/* Reads a mesh as one shape per used material, in the order of the file's materials. *made is an
 * array of *count parts, from malloc. */
typedef struct {
    int material;
    Shape shape;
} ModelPart;
bool model_read_parts(const char *path, ModelPart **made, int *count, char *error, size_t capacity);

/* A mesh file named by an untrusted document. */
typedef struct {
    const char *path;
    /* Folder that must contain the mesh and all files it refers to (root.h). NULL: no
     * restriction. */
    const char *root;
    bool whole; /* read the file as a single part with material -1, ignoring the materials */
} ModelSource;
/* Reads a mesh at its original position and size, in parts as model_read_parts(). */
bool model_read_source(const ModelSource *source, ModelPart **made, int *count, char *error,
                       size_t capacity);

/* Adds the additional files of a mesh to the list: a .gltf's buffers, existing or missing. */
void model_files(const char *path, WatchList *files);

/* Checks the data read from a file, and computes missing normals, texture coordinates and
 * tangents. Returns NULL, or an error message. The second function keeps the mesh's position and
 * size. */
const char *model_complete(Shape *shape, bool has_normals, bool has_coordinates);
const char *model_complete_in_place(Shape *shape, bool has_normals, bool has_coordinates);

/* Complete each of several runs, which cover all vertices and indices in order. */
const char *model_complete_runs(Shape *shape, const ModelRun *runs, int run_count);
const char *model_complete_runs_in_place(Shape *shape, const ModelRun *runs, int run_count);
#endif
