/* The chunks of a .glb file, glTF 2.0, section 4.4. */
#ifndef MATC_GLTF_CHUNKS_H
#define MATC_GLTF_CHUNKS_H
#include "compiler/base/session.h"

/* A .glb in its parts. */
typedef struct {
    const char *text; /* of the JSON */
    size_t size;
    const char *binary; /* the buffer that has no address; NULL: none */
    size_t binary_size;
} GltfChunks;
/* NULL, or what is wrong. */
const char *gltf_chunks_of(Arena *arena, const char *bytes, size_t size, GltfChunks *chunks);

/* The source's JSON takes the place of its bytes, where its name ends in .glb; false: the file is
 * broken, and that was said. */
bool gltf_chunks_open(Session *session, uint32_t file);

/* Between a file's name and the number of one of its pictures: a fragment, RFC 6901. */
#define GLTF_IMAGES "#/images/"
/* The name that a document beside it has for a file's picture of that number. */
const char *gltf_chunks_picture(Session *session, uint32_t file, const char *number);
#endif
