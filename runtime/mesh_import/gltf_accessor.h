/* Numbers of a glTF file's accessors. */
#ifndef MATC_SCENE_GLTF_ACCESSOR_H
#define MATC_SCENE_GLTF_ACCESSOR_H
#include "runtime/mesh_import/gltf_mesh.h"

/* Component types of glTF 2.0, section 3.6.2.2. */
typedef enum {
    GLTF_BYTE = 5120,
    GLTF_UNSIGNED_BYTE,
    GLTF_SHORT,
    GLTF_UNSIGNED_SHORT,
    GLTF_UNSIGNED_INT = 5125,
    GLTF_FLOAT
} GltfComponent;
enum { GLTF_MATRIX = 16 }; /* components of a MAT4, the only matrix that is read */

/* Writes the message "meshes/0/primitives/1<part>: <why>". Returns false. */
bool gltf_fail(const GltfMesh *mesh, const char *part, const char *why);

/* A validated accessor. */
typedef struct {
    const unsigned char *at; /* NULL: all values are 0 */
    size_t stride, count;
    int components; /* 1 to 4, or GLTF_MATRIX */
    GltfComponent component;
    bool normalized;
    /* Sparse substitution of some rows (section 3.6.2.3). */
    size_t sparse_count, sparse_wide; /* sparse_wide: bytes of an index */
    const unsigned char *sparse_indices, *sparse_values;
} GltfAccessor;

/* Rows of an accessor. `slots` gives 1 + the place of a row in `rows`, 0: not among them. NULL:
 * all rows, in order. */
typedef struct {
    const uint32_t *rows, *slots;
    size_t count;
} GltfRows;

/* Validates the accessor with the number `index`. Returns NULL, or an error message. */
const char *gltf_accessor_open(GltfMesh *mesh, const Tree *index, GltfAccessor *made);
/* Writes `wide` numbers for each row. Components that the accessor lacks are 0, and 1 for the
 * fourth. Integers keep their value, or are normalized (section 3.6.2.2). Returns NULL, or an
 * error message. */
const char *gltf_accessor_numbers(GltfMesh *mesh, const GltfAccessor *a, GltfRows rows, int wide,
                                  float *to);
/* Returns whole numbers of unsigned components, such as indices, allocated in the scratch arena.
 * NULL with the reason in *why. */
uint32_t *gltf_accessor_indices(GltfMesh *mesh, const Tree *index, size_t *count, const char **why);
#endif
