/* Layouts as text: a file in YAML or JSON -> LayoutRow, and back. */
#ifndef MATC_LAYOUT_READ_H
#define MATC_LAYOUT_READ_H
#include "compiler/layout/layout.h"
#include "compiler/read/tree.h"

/* The layout of a tree, in the arena; NULL: see the diagnostics. */
const LayoutRow *layout_read(Session *session, const Tree *tree);
/* Whether all of its fields are possible, fit in, and make whole slots; `trees[i][k]` is where
 * field k of case i stands. */
bool layout_check(Session *session, const LayoutRow *row, const Tree *file,
                  Tree *const *const *trees);
/* Writes the layout as a file, which reads back to an equal row. */
void layout_write(Text *out, const LayoutRow *row);
#endif
