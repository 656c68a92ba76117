/* matbench guards: counts, for the formulas of the examples, the totality guards that lowering
 * makes (for quotients, roots, logarithms, powers, arcs and exponentials), and the guards that
 * remain after interval analysis removed the provably unneeded ones. */
#include "matbench.h"
#include "tests/value/documents.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct {
    int made, left;
} Guards;

static bool is_number(const Ir *ir, Ref ref, double number)
{
    return ir_is(ir, ref, OP_const) && fabs(ir_numbers(ir, ref)[0] / number - 1) < 1e-6;
}

static bool has_number(const Ir *ir, Ref ref, double number)
{
    for (int i = 0; i < ir_at(ir, ref)->count; i++)
        if (is_number(ir, ir_arg(ir, ref, i), number))
            return true;
    return false;
}

/* Recognizes guards by the constants that lower_term.c uses for them alone. */
static bool is_guard(const Ir *ir, Ref ref)
{
    const IrNode *node = ir_at(ir, ref);
    if (node->op == OP_lt)
        return has_number(ir, ref, 1e-30);
    if (node->op == OP_max)
        return has_number(ir, ref, 1e-37);
    if (node->op == OP_min)
        return has_number(ir, ref, 1e37) || has_number(ir, ref, 88) || has_number(ir, ref, 127);
    if (node->op == OP_sqrt)
        return ir_is(ir, ir_arg(ir, ref, 0), OP_max);
    if (node->op == OP_asin || node->op == OP_acos)
        return ir_is(ir, ir_arg(ir, ref, 0), OP_clamp);
    return false;
}

/* Every slot's program displaces the vertices; only one of them counts. */
static void drop_displacement(Ir *ir)
{
    int kept = 0;
    for (int i = 0; i < ir->output_count; i++)
        if (ir->outputs[i].kind != OUT_displacement)
            ir->outputs[kept++] = ir->outputs[i];
    ir->output_count = kept;
}

static int count_of(const MatcOptions *options, const Graph *graph, const Node *material, int level)
{
    int count = 0;
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        Arena arena = {0};
        Session session = {.options = options, .arena = &arena, .optimize = level};
        Job job;
        choice_job(&(MatcOptions){.pass = "value"}, &job);
        job.slot = (Slot)slot;
        job.choice[AXIS_aa] = CHOICE_aa_none;
        Ir *ir = slot == SLOT_normal ? NULL : compile_ir(&session, graph, material, &job);
        if (ir && slot != SLOT_diffuse)
            drop_displacement(ir);
        const uint8_t *live = ir ? ir_live(ir, &arena) : NULL;
        for (Ref ref = 1; ir && ref < ir->count; ref++)
            count += live[ref] && is_guard(ir, ref);
        arena_free(&arena);
    }
    return count;
}

static bool has_formula(const Node *node)
{
    for (int i = 0; i < kind_table[node->kind].count; i++) {
        const Value *value = &node->params[i];
        if (value->kind == VALUE_formula || (value->kind == VALUE_node && has_formula(value->node)))
            return true;
        for (int k = 0; value->kind == VALUE_items && k < value->items->count; k++)
            if (value->items->item[k].input && has_formula(value->items->item[k].input))
                return true;
    }
    return false;
}

int bench_guards(const BenchOptions *options)
{
    DocumentList list = documents_list(SOURCE_FOLDER);
    Guards all = {0};
    int programs = 0, without = 0;
    (void)options;
    printf("document                               guards made   left\n");
    for (int i = 0; i < list.count; i++) {
        Document d;
        const bool good = document_open(&d, list.paths[i]);
        for (int m = 0; good && m < d.graph->material_count; m++) {
            const Node *material = d.graph->materials[m].node;
            if (!material || !has_formula(material))
                continue;
            const Guards own = {count_of(&d.options, d.graph, material, 0),
                                count_of(&d.options, d.graph, material, 2)};
            printf("%-38s %11d %6d\n", document_name(&d), own.made, own.left);
            all.made += own.made, all.left += own.left;
            programs++, without += !own.left;
        }
        document_close(&d);
    }
    printf("%d of %d materials need none; %d guards of %d are left\n", without, programs, all.left,
           all.made);
    documents_free(&list);
    return 0;
}
