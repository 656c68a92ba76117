/* Price of means over the pixel beside their maps' points, found without a program of either. */
#ifndef MATC_PRICE_H
#define MATC_PRICE_H
#include "compiler/lower/lower.h"

/* Maps in the order of the document, equal ones once. */
typedef struct {
    int *ends; /* one more than the index of each */
    double *
        /* by how many: what the means of the first so many cost more than their points, in scalar
         * operations; ascending */
        upto;
    int count;
    int known; /* of so many first ones: the next costs more than was to be found out */
    int alike; /* of so many first ones means and points are the same */
} Prices;

/* As far as `most`. What else is in the program is not known here: a mean may share with it, and
 * cost less. What is met elsewhere than where the pass begins counts as nothing. */
Prices price_means(const LowerRequest *what, const MapList *maps, double most);
#endif
