/* Parts of reference.md on formulas, and on the library's definitions. */
#ifndef MATC_DOCS_FORMULAS_H
#define MATC_DOCS_FORMULAS_H
#include "compiler/base/text.h"

void docs_functions(Text *out);
void docs_library(Text *out);
/* Writes functions.yaml, with a material per function, from which matview renders the pictures. */
void docs_function_document(Text *out);
#endif
