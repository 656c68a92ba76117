/* An IR for a test, with its own memory. */
#ifndef MATC_VALUE_IR_SITE_H
#define MATC_VALUE_IR_SITE_H
#include "compiler/ir/ir.h"

typedef struct {
    Arena arena;
    Session compile;
    Graph graph;
    Ir *ir;
} Site;

static inline void site_open(Site *s)
{
    *s = (Site){0};
    s->compile.arena = &s->arena;
    s->ir = ir_new(&s->compile, &s->graph);
}

static inline void site_close(Site *s)
{
    ir_done(s->ir);
    arena_free(&s->arena);
}
#endif
