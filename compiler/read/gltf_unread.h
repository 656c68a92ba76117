/* Reports the content of a glTF file that is not read: grammar/gltf.def lists what is. */
#ifndef MATC_GLTF_UNREAD_H
#define MATC_GLTF_UNREAD_H
#include "compiler/base/session.h"
#include "compiler/read/tree.h"

/* Objects of a glTF file. */
typedef enum {
#define GLTF_OBJECT(object) GLTF_##object,
#include "grammar/gltf.def"
    GLTF_NONE = -1
} GltfObject;

/* Warns once about each unknown member and extension, at its first place. Reports an error for
 * each unknown extension of `extensionsRequired`. */
void gltf_unread_report(Session *session, const Tree *root);
/* Returns the content of a member or an extension of an object; GLTF_NONE: it is not read. */
GltfObject gltf_unread_member(GltfObject object, const char *member);
GltfObject gltf_unread_extension(GltfObject object, const char *extension);
#endif
