/* Slopes of a BumpMap's displacement along u and v, computed as --derivatives selects. */
#ifndef MATC_BUMP_H
#define MATC_BUMP_H
#include "compiler/lower/map_value.h"

/* Returns the derivatives of the red component of a BumpMap's displacement by u and v; with
 * --derivatives=finite the maps' own derivative channels. Records slopes that are 0 for a
 * warning. */
Slopes bump_slopes(Lower *l, const Node *bump, const Env *env);

/* A value that `make` computes from `what` in an environment, with its derivatives by u and v, 0
 * for none. --derivatives selects the method; `finite` counts as `auto`, since GroIMP has no
 * finite differences of true displacement. */
typedef Ref BumpValue(Lower *l, const Node *what, const Env *env);
typedef struct {
    Ref value;
    Slopes slopes;
} Risen;
Risen bump_of(Lower *l, BumpValue *make, const Node *what, const Env *env);

/* Lowers, within a displacement, a map below which nothing jumps and no image is read as
 * outside of the displacement, so that both share one node. */
MapValue bump_smooth(Lower *l, const Node *map, Group group, const Env *env);

/* A height map as a function of its coordinate. */
typedef struct {
    /* Returns the map's value at q; a bool if the value is one of two. */
    Ref (*at)(Lower *l, const void *map, MapValue q);
    /* The caller's data: kind and parameters of the map. */
    const void *map;
    MapValue q; /* coordinate at the shaded point */
    /* Step of the finite difference per component of q; 0: the map does not depend on that
     * component. */
    double step[3];
} Stepped;
/* Sets the derivatives of `value`, the map's value at the point, by u and v to finite
 * differences. Has an effect only in a displacement of --derivatives=auto. */
void bump_step(Lower *l, Ref value, const Stepped *map);
/* Sets the slopes of a value from its derivatives by the components of its coordinate q; 0: the
 * value does not depend on that component. */
void bump_rise(Lower *l, Ref value, Ref q, const Ref rate[3]);
#endif
