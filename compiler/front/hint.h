/* Hints for values and names that authors bring from elsewhere: each function reports a fault that it
 * recognizes, and says what to write instead. True: it is reported. mistake.h has older ones. */
#ifndef MATC_HINT_H
#define MATC_HINT_H
#include "compiler/front/resolve.h"

/* A literal colour or list where one number is read. A map of a colour is none of these: it is
 * converted. Constants that are reached through `ref:` count, too. hint_number.c
 *
 *     emission: "#ff8800"     red alone would count: emissionColor is meant
 *     roughness: [0.2, 0.3]   a list */
bool hint_number_list(Resolver *r, const ParamRow *row, const Tree *tree);
bool hint_number_color(Resolver *r, const ParamRow *row, const Tree *tree, const Value *constant);
#endif
