/* The reference pages scenes.md, diagnostics.md and layout-tables.md. They link to pages of
 * docs/reference as if they were there, where the site puts them. */
#ifndef MATC_DOCS_PAGES_H
#define MATC_DOCS_PAGES_H
#include "compiler/base/text.h"

void docs_scenes(Text *out);
void docs_diagnostics(Text *out);
void docs_layouts(Text *out);
#endif
