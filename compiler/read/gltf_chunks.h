/* Splits a .glb file into its chunks: glTF 2.0, section 4.4. */
#ifndef MATC_GLTF_CHUNKS_H
#define MATC_GLTF_CHUNKS_H
#include "compiler/base/session.h"

/* The chunks of a .glb file. */
typedef struct {
    const char *text; /* text of the JSON chunk */
    size_t size;
    const char *binary; /* the binary chunk, a buffer without a uri; NULL: absent */
    size_t binary_size;
} GltfChunks;
/* Returns NULL or a fault. */
const char *gltf_chunks_of(Arena *arena, const char *bytes, size_t size, GltfChunks *chunks);

/* Replaces the bytes of a source whose name ends in .glb by its JSON chunk. Returns false if the
 * file is broken, which is reported. */
bool gltf_chunks_open(Session *session, uint32_t file);

/* Separates a file's name from the index of one of its images, as a fragment (RFC 6901). */
#define GLTF_IMAGES "#/images/"
/* Returns the path of the file's image with this index, as a document in the same folder would
 * write it. */
const char *gltf_chunks_picture(Session *session, uint32_t file, const char *number);
#endif
