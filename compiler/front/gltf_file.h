/* Pictures within glTF 2.0 files. One has the file's name and its place in the JSON,
 * as a fragment (RFC 6901, section 6): "helmet.glb#/images/2". Files are untrusted: each length is held against what is there. */
#ifndef MATC_GLTF_FILE_H
#define MATC_GLTF_FILE_H
#include "compiler/front/gltf_chunks.h"
#include "compiler/front/tree.h"

/* Files whose pictures were asked for, and what was made of them. */
typedef struct GltfFile GltfFile;
typedef struct {
    GltfFile **at;
    size_t count, room;
} GltfFiles;

/* The bytes of a picture. */
typedef struct {
    const char *at;
    size_t size;
} GltfBytes;
/* Whether a path is that of a picture within a file. */
bool gltf_file_has(const char *path);
/* The picture of such a path; false: `why` says what is wrong. */
bool gltf_file_picture(Session *session, GltfFiles *files, const char *path, GltfBytes *picture, const char **why);
#endif
