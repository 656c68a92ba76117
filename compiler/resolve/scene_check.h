/* The parts of a document that make it a scene, checked by the rows of scene.def: kinds, keys,
 * plain values, names of materials. runtime/scene reads them, with the same messages; whoever
 * compiles the materials of a scene alone learns of faults in its objects and lights here. */
#ifndef MATC_SCENE_CHECK_H
#define MATC_SCENE_CHECK_H
#include "compiler/resolve/resolve.h"
#include "grammar/scene_tables.h"

/* The kind of a part of that sort; -1: it has none, which is reported. */
int scene_check_kind(Session *session, const Tree *tree, SceneSort sort);
/* Reports a key that no row of the kind has. */
void scene_check_unknown(Session *session, SceneKind kind, const Member *member);
/* Checks all parts of a document, after its materials are resolved by `r`. Files are not read:
 * neither meshes nor materials of other documents. */
void scene_check(const Resolver *r, const Tree *document);
#endif
