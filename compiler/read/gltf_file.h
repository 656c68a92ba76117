/* Content of glTF 2.0 files: pictures, and the bytes of buffer views. A picture has the file's name
 * and its place in the JSON, as a fragment (RFC 6901, section 6): "helmet.glb#/images/2". Files are
 * untrusted: each length is checked against the file. */
#ifndef MATC_GLTF_FILE_H
#define MATC_GLTF_FILE_H
#include "compiler/base/names.h"
#include "compiler/read/gltf_chunks.h"
#include "compiler/read/tree.h"

/* The bytes of a picture, a buffer or a view. */
typedef struct {
    const char *at;
    size_t size;
} GltfBytes;

/* Files whose pictures were asked for, and the buffers and pictures that they name: each is read
 * once. */
typedef struct GltfFile GltfFile;
typedef struct GltfBeside GltfBeside;
typedef struct {
    GltfFile **at;
    size_t count, room;
    Names paths; /* of these */
    GltfBeside *beside;
    size_t beside_count, beside_room;
    Names beside_paths;
    Names source_paths; /* of the session's first `indexed` sources */
    uint32_t *sources;  /* by source_paths: the first source of that path */
    size_t source_count, source_room, indexed;
} GltfFiles;
/* Whether a path is that of a picture within a file. */
bool gltf_file_has(const char *path);
/* The picture of such a path; false: `why` says what is wrong. */
bool gltf_file_picture(Session *session, GltfFiles *files, const char *path, GltfBytes *picture,
                       const char **why);

typedef struct {
    Session *session;
    GltfFiles *files;
    const char *path;
} GltfPlace;
/* The JSON of a file; NULL: `why`. */
const Tree *gltf_file_root(const GltfPlace *place, const char **why);
/* The bytes of the view of a buffer that has the number `index`; false: `why`. The file has a
 * root. */
bool gltf_file_view(const GltfPlace *place, const Tree *index, GltfBytes *bytes, const char **why);

/* A member of an object, an item of a list at the outermost level; NULL: it is not there. */
const Tree *gltf_file_value(const Tree *tree, const char *key);
const Tree *gltf_file_item(const Tree *root, const char *list, size_t index);
/* A whole number of bytes or an index, below 2^32; `without` where nothing stands, SIZE_MAX where
 * it is none. */
size_t gltf_file_whole(const Tree *tree, size_t without);
#endif
