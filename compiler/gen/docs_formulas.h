/* Pages of reference.md on formulas, and on the definitions that come with matc. */
#ifndef MATC_DOCS_FORMULAS_H
#define MATC_DOCS_FORMULAS_H
#include "compiler/base/text.h"

void docs_functions(Text *out);
void docs_library(Text *out);
/* functions.yaml, of which matview makes the functions' pictures: a material each. */
void docs_function_document(Text *out);
#endif
