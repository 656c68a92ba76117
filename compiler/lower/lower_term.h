/* The terms of formulas as IR: the BUILD lines of expression.def. */
#ifndef MATC_LOWER_TERM_H
#define MATC_LOWER_TERM_H
#include "compiler/lower/lower.h"
#include "grammar/expression_tables.h"

/* The value of a term, from its arguments; those it does not have are 0. */
Ref lower_term(Lower *l, Term term, const Ref *args);
/* a to a whole power, lane by lane: a product, or its inverse. */
Ref lower_whole_power(Lower *l, Ref a, int power);
#endif
