/* How a BumpMap's displacement rises along u and v, by the choice of --derivatives. */
#ifndef MATC_RELIEF_H
#define MATC_RELIEF_H
#include "compiler/lower/answer.h"

/* The derivatives of the red of a BumpMap's displacement by u and v; of --derivatives=finite by
 * those of the maps themselves. Says it where there are none. */
Slopes relief_slopes(Lower *l, const Node *bump, const Env *env);

/* A value that `make` makes of `what` in an environment, and its derivatives by u and v, by the
 * same choice, in which `finite` counts as `auto`: of true displacement there is none of GroIMP's.
 * 0 where there are none. */
typedef Ref ReliefValue(Lower *l, const Node *what, const Env *env);
typedef struct {
    Ref value;
    Slopes slopes;
} Risen;
Risen relief_of(Lower *l, ReliefValue *make, const Node *what, const Env *env);

/* In a displacement, where nothing from a map down jumps or is a picture: its answer as outside,
 * which is the same node. */
Answer relief_smooth(Lower *l, const Node *map, Group group, const Env *env);

/* A map as a function of its coordinate. */
typedef struct {
    Ref (*at)(Lower *l, const void *map, Answer q); /* its value, a bool for one of two */
    /* of which kind, with which parameters: the caller's */
    const void *map;
    Answer q; /* its coordinate at the point */
    /* by lane of it; 0: it does not go by that lane */
    double step[3];
} Stepped;
/* In a displacement of --derivatives=auto: how `value`, the map's at the point, changes by u and v
 * is its finite steps' to say. */
void relief_step(Lower *l, Ref value, const Stepped *map);
/* Slopes of a value whose derivatives by the components of its coordinate are known; 0: it does not
 * depend on that component. */
void relief_rise(Lower *l, Ref value, Ref q, const Ref rate[3]);
#endif
