/* Content of glTF 2.0 files: images, and the bytes of buffer views. An image's path is the
 * file's name with a fragment for its place in the JSON (RFC 6901, section 6):
 * "helmet.glb#/images/2". Files are untrusted: each length is checked against the file. */
#ifndef MATC_GLTF_FILE_H
#define MATC_GLTF_FILE_H
#include "compiler/base/names.h"
#include "compiler/read/gltf_chunks.h"
#include "compiler/read/tree.h"

/* The bytes of an image, a buffer or a buffer view. */
typedef struct {
    const char *at;
    size_t size;
} GltfBytes;

/* Cache of glTF files and of the buffers and images that they refer to; each is read once. */
typedef struct GltfFile GltfFile;
typedef struct GltfBeside GltfBeside;
typedef struct {
    GltfFile **at;
    size_t count, capacity;
    Names paths; /* paths of the files in `at` */
    GltfBeside *beside;
    size_t beside_count, beside_capacity;
    Names beside_paths;
    Names source_paths; /* paths of the session's first `indexed` sources */
    uint32_t *sources;  /* indexed as source_paths: the first source with the same path */
    size_t source_count, source_capacity, indexed;
} GltfFiles;
/* Returns true if a path refers to an image inside a glTF file. */
bool gltf_file_has(const char *path);
/* Reads the image with this path. Returns false and *why on failure. */
bool gltf_file_picture(Session *session, GltfFiles *files, const char *path, GltfBytes *picture,
                       const char **why);

typedef struct {
    Session *session;
    GltfFiles *files;
    const char *path;
} GltfPlace;
/* Returns the JSON root of a file; NULL and *why on failure. */
const Tree *gltf_file_root(const GltfPlace *place, const char **why);
/* Returns the bytes of the buffer view with the number `index`. Returns false and *why on
 * failure. The file must have a root. */
bool gltf_file_view(const GltfPlace *place, const Tree *index, GltfBytes *bytes, const char **why);
/* Returns the content of the buffer with this number. Returns false and *why on failure. */
bool gltf_file_buffer(const GltfPlace *place, size_t number, GltfBytes *bytes, const char **why);

/* Returns a member of an object, or an item of a top-level list; NULL if it is missing. */
const Tree *gltf_file_value(const Tree *tree, const char *key);
const Tree *gltf_file_item(const Tree *root, const char *list, size_t index);
/* Returns a byte count or an index below 2^32; `without` if `tree` is missing, SIZE_MAX if the
 * value is invalid. */
size_t gltf_file_whole(const Tree *tree, size_t without);
#endif
