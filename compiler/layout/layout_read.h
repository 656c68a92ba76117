/* Layout files in YAML or JSON: parsing to a LayoutRow, and writing. */
#ifndef MATC_LAYOUT_READ_H
#define MATC_LAYOUT_READ_H
#include "compiler/layout/layout.h"
#include "compiler/read/tree.h"

/* Returns the layout of a tree, in the arena; NULL after reporting faults. */
const LayoutRow *layout_read(Session *session, const Tree *tree);
/* Checks that all fields are possible and fit, and that slots are complete; `trees[i][k]` is the
 * tree of field k of case i. */
bool layout_check(Session *session, const LayoutRow *row, const Tree *file,
                  Tree *const *const *trees);
/* Writes a layout as a file that parses to an equal row. */
void layout_write(Text *out, const LayoutRow *row);
#endif
