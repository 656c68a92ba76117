/* Cost of means over the pixel relative to point samples, found without lowering a whole
 * program. */
#ifndef MATC_PRICE_H
#define MATC_PRICE_H
#include "compiler/lower/lower.h"

/* Prices of maps in document order; each map is listed once. */
typedef struct {
    int *ends; /* per map: the map's index + 1 */
    /* upto[n]: additional cost of the first n means over point samples, in scalar
     * operations; ascending. */
    double *upto;
    int count;
    int known; /* prices of the first `known` maps are found; the next exceeds the limit */
    int alike; /* the means of the first `alike` maps equal the point samples */
} Prices;

/* Adds up prices until they exceed `most`. The rest of the program is unknown here, so a mean
 * that shares work with it may cost less. Queries from elsewhere than where the pass begins
 * count 0. */
Prices price_means(const LowerRequest *what, const MapList *maps, double most);
#endif
