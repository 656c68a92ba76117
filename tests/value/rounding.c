#include "tests/value/rounding.h"
#include "compiler/layout/layout.h"
#include "tests/stress/spread.h"

enum { FEW = 16, MANY = 400 }; /* numbers of evaluations; MANY before a fault is reported */

/* The program of a slot, and its textures. */
typedef struct {
    Arena arena;
    const Ir *ir;
    ReferenceTexture textures[EVALUATE_TEXTURES];
} Rounded;

static void rounded_open(Rounded *r, Document *document, int material, const MatcOptions *options,
                         int level)
{
    Session session = {.options = options, .arena = &r->arena, .optimize = level};
    Job job;
    r->arena = (Arena){0};
    choice_job(options, &job);
    r->ir = compile_ir(&session, document->graph, document->graph->materials[material].node, &job);
    if (r->ir && !evaluate_textures(&r->arena, r->ir, r->textures))
        r->ir = NULL;
}

/* Error of one version of the program. */
static double miss_of(const Rounded *r, const DrawnNumber *drawn, double bound)
{
    const ReferenceContext context = {r->ir->noise, r->textures};
    double inputs[INPUT_COUNT][4], miss = INFINITY;
    Evaluation exact;
    evaluate_inputs(drawn->point, drawn->front, inputs);
    evaluate_double(r->ir, &context, (const double(*)[4])inputs, &exact);
    const double value = exact.value[0][drawn->component];
    const Evaluated at = {r->ir, &context, (const double(*)[4])inputs,
                          (const double(*)[4])exact.value};
    if (hull_miss(drawn->hull, drawn->slot, drawn->component, value) > bound)
        return INFINITY;
    for (int count = FEW; count <= MANY && miss > bound; count *= MANY / FEW) {
        Spread spread;
        spread_make(&at, MACHINE_float, count, &spread);
        miss = spread_miss(&spread, 0, drawn->component, value, drawn->number);
    }
    return miss;
}

double rounding_miss(Document *document, int material, const MatcOptions *options,
                     const DrawnNumber *drawn, double bound)
{
    MatcOptions baked = *options;
    double miss = INFINITY;
    if (!(hull_miss(drawn->hull, drawn->slot, drawn->component, drawn->number) <= ROUNDING_MAX))
        return INFINITY;
    baked.constants = "baked";
    for (int level = 0; level <= options->optimize && miss > bound; level += 2) {
        Rounded rounded;
        rounded_open(&rounded, document, material, &baked, level);
        if (rounded.ir)
            miss = fmin(miss, miss_of(&rounded, drawn, bound));
        arena_free(&rounded.arena);
    }
    return miss;
}
