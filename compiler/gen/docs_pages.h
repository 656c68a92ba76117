/* Pages of docs/reference that are committed: scenes.md, diagnostics.md and layout-tables.md.
 * tests/docs/reference.sh compares them with what these functions write. */
#ifndef MATC_DOCS_PAGES_H
#define MATC_DOCS_PAGES_H
#include "compiler/base/text.h"

void docs_scenes(Text *out);
void docs_diagnostics(Text *out);
void docs_layouts(Text *out);
#endif
