/* Checks the parts of a document that make it a scene by the rows of scene.def: kinds, keys,
 * plain values, names of materials. runtime/scene reads the parts with the same messages. These
 * checks report faults in objects and lights even when only the materials are compiled. */
#ifndef MATC_SCENE_CHECK_H
#define MATC_SCENE_CHECK_H
#include "compiler/resolve/resolve.h"
#include "grammar/scene_tables.h"

/* Returns the kind of a part of that sort; -1 after reporting a part without a valid kind. */
int scene_check_kind(Session *session, const Tree *tree, SceneSort sort);
/* Reports a key that no row of the kind has. */
void scene_check_unknown(Session *session, SceneKind kind, const Member *member);
/* Checks all parts of a document, after `r` has resolved its materials. Referenced files are not
 * read: neither meshes nor materials of other documents. */
void scene_check(const Resolver *r, const Tree *document);
#endif
