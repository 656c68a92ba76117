/* The oracle by a document's handle, for who measures programs against it. matc.c */
#ifndef MATC_EVALUATE_H
#define MATC_EVALUATE_H
#include "compiler/matc.h"
#include "compiler/oracle/oracle.h"

/* The slots of a material at `count` points, in double, as the options compute them (their noise and derivatives). The material exists, and
 * the options name what exists. Pictures are 0.5 where the document was read without `pixels`. False: one takes
 * more than LIMIT_ANSWERS; its values are no numbers. */
bool document_evaluate(const MatcDocument *document, int material, const MatcOptions *options, const Surface *points,
                       int count, SlotValues *values);
#endif
