/* Lowers terms of formulas to IR, by the BUILD lines of expression.def. */
#ifndef MATC_LOWER_TERM_H
#define MATC_LOWER_TERM_H
#include "compiler/lower/lower.h"
#include "grammar/expression_tables.h"

/* Returns the value of a term, from its arguments; missing arguments are 0. */
Ref lower_term(Lower *l, Term term, const Ref *args);
/* Returns a to an integer power, per component: a product, or its inverse. */
Ref lower_whole_power(Lower *l, Ref a, int power);
#endif
