/* --layout=auto: claims about materials hold, for random trees by the oracle, and for material
 * sets as drawn. */
/* ctest: unsanitized seconds=29 */
#include "tests/test.h"
#include "compiler/layout/layout.h"
#include "compiler/pipeline.h"
#include "tests/layout_set.h"
#include "tests/stress/generate.h"
#include "tests/draw/kept.h"

enum { TREES = 1500, TREE_POINTS = 12 };

/* Slots that matter in a material, by the ranges of it alone. */
static void find_matters(const Document *d, int material, bool matters[SLOT_COUNT])
{
    MatcRanges one;
    matc_ranges_init(&one);
    add_material(&one, d->document, material, &d->options);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        matters[slot] = one.slot[slot].counted > 0;
}

static void check_set(Kept *kept, Drawer *drawer, const MaterialSet *set)
{
    for (int i = 0; i < set->count; i++) {
        Document *d = (Document *)(uintptr_t)&set->documents[i];
        MatcOptions options = d->options;
        options.custom = set->layout;
        for (int k = 0; k < d->graph->material_count; k++) {
            bool matters[SLOT_COUNT];
            find_matters(d, k, matters);
            if (!kept_check(kept, drawer, &(KeptMaterial){d, k, &options}, matters))
                fail_msg("%s, %s: %s\n%s", d->path, d->graph->materials[k].name, kept->error,
                         matc_layout_report(set->layout));
        }
    }
}

static void what_is_packed_comes_back(void **state)
{
    (void)state;
    static const char *const all[] = {
        "examples/materials/algorithmSwitch.yaml", "examples/materials/brick.yaml",
        "examples/materials/brushedSteel.yaml",    "examples/materials/chess.json",
        "examples/materials/glassChecker.yaml",    "examples/materials/lava.yaml",
        "examples/materials/leopardSkin.yaml",     "examples/materials/malachite.json",
        "examples/materials/marble.yaml",          "examples/materials/oak.yaml",
        "examples/materials/phong.yaml",           "examples/materials/planet.yaml",
        "examples/materials/polishedGranite.yaml", "examples/materials/rgba.yaml",
        "examples/materials/rustedMetal.yaml",     "examples/materials/sideSwitch.yaml",
        "examples/materials/sunSky.yaml",          "examples/materials/tiles.yaml"};
    static const struct {
        const char *const *paths;
        int count;
        double error;
    } sets[] = {{lambert, 1, 0}, {lambert, 1, 0.01}, {grays, 1, 0},      {grays, 1, 0.0002},
                {mixed, 1, 0},   {mixed, 1, 0.0005}, {mixed, 1, 0.02},   {glow, 1, 0},
                {glow, 1, 0.03}, {all, 18, 0},       {&all[5], 3, 0.001}};
    static Point points[POINT_COUNT];
    Drawer drawer;
    Kept kept = {0};
    int cases = 0;
    points_make(points);
    assert_true(drawer_open(&drawer, true, points, POINT_COUNT));
    for (size_t i = 0; i < sizeof sets / sizeof *sets; i++) {
        MaterialSet set;
        set_open(&set, sets[i].paths, sets[i].count, sets[i].error);
        memset(kept.drawn, 0, sizeof kept.drawn);
        check_set(&kept, &drawer, &set);
        print_message("%d materials, error %g: %d bytes\n", set.ranges.materials, sets[i].error,
                      matc_layout_bytes(set.layout));
        for (int k = 0; k < set.layout->row->case_count && set.layout->row->case_count > 1; k++) {
            char line[64]; /* of the report: it counts right */
            snprintf(line, sizeof line, "\n%-25d %-18d normal", k, kept.drawn[k]);
            assert_non_null(strstr(matc_layout_report(set.layout), line));
            cases += kept.drawn[k] > 0;
        }
        set_close(&set);
    }
    drawer_close(&drawer);
    print_message("%d materials, %d slots, %ld values, errors up to %.4f of their bounds\n",
                  kept.materials, kept.fields, kept.values, kept.worst);
    assert_true(kept.values > 100000 && kept.worst > 0.9 && cases > 8);
}

typedef struct {
    long bounded, constant; /* slots of trees */
    /* components: sums, products and powers of maps may leave what a number holds, and are no
     * number then */
    long compared, overflown;
} Claims;

/* The oracle's value lies in the interval that is claimed, roundings aside. */
static void compare_claim(const MatcRanges *ranges, const SlotValues *values, uint64_t tree,
                          Claims *claims)
{
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        const SlotRow *row = &slot_table[slot];
        const MatcSlotRange *range = &ranges->slot[slot];
        for (int component = 0; component < type_table[row->type].components && range->counted;
             component++) {
            const bool is_number = !isnan(values->component[slot][component]);
            claims->compared++;
            claims->overflown += !is_number;
            if (!is_number)
                continue;
            double value = fmin(fmax(values->component[slot][component], row->low), row->high);
            double slack = 1e-5 * fmax(1, fabs(value));
            if (!(value >= range->low[component] - slack &&
                  value <= range->high[component] + slack))
                fail_msg("tree %d: %s lane %d is %.9g, claimed %.9g to %.9g", (int)tree, row->name,
                         component, value, range->low[component], range->high[component]);
            if (range->alike &&
                !(fabs(values->component[slot][component] - values->component[slot][0]) <= slack))
                fail_msg("tree %d: %s lanes %.9g, %.9g are not alike", (int)tree, row->name,
                         values->component[slot][0], values->component[slot][component]);
        }
    }
}

/* A random document; the slots' widths are summed up, to see that the claims are not empty. */
static void check_tree(uint64_t tree, const Point *points, Claims *claims)
{
    Arena arena = {0};
    Choices choices;
    MatcRanges ranges;
    Text text = text_new(&arena);
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    options.read_file = generate_file;
    choices_random(&choices, 11, tree);
    generate_document(&choices, &text);
    MatcDocument *document = matc_read("stress.yaml", text.at, text.size, &options);
    assert_int_equal(matc_material_count(document), 1);
    matc_ranges_init(&ranges);
    add_material(&ranges, document, 0, &options);
    Oracle *oracle = oracle_open(document->graph, &(ReferenceContext){0});
    for (int i = 0; i < TREE_POINTS; i++) {
        Surface surface;
        SlotValues values;
        point_surface(&points[(tree * 131 + (uint64_t)i * 53) % POINT_COUNT], i % 4 != 0, &surface);
        oracle_material(oracle, document->graph->materials[0].node, &surface, &values);
        compare_claim(&ranges, &values, tree, claims);
    }
    for (int slot = SLOT_diffuse; slot < SLOT_COUNT; slot++) {
        const MatcSlotRange *range = &ranges.slot[slot];
        claims->constant += range->counted && range->low[0] == range->high[0];
        claims->bounded +=
            range->counted && range->low[0] < range->high[0] &&
            range->high[0] - range->low[0] < 0.999 * (slot_table[slot].high - slot_table[slot].low);
    }
    oracle_close(oracle);
    matc_document_free(document);
    arena_free(&arena);
}

static void claims_are_sound(void **state)
{
    (void)state;
    static Point points[POINT_COUNT];
    Claims claims = {0};
    points_make(points);
    for (uint64_t tree = 0; tree < TREES; tree++)
        check_tree(tree, points, &claims);
    print_message("%d trees: %ld slots constant, %ld in a part of what a surface can have; of %ld "
                  "lanes %ld overflow\n",
                  TREES, claims.constant, claims.bounded, claims.compared, claims.overflown);
    /* the claims are not empty */
    assert_true(claims.constant > TREES && claims.bounded > TREES / 10);
    assert_true(claims.overflown < claims.compared / 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_packed_comes_back),
        cmocka_unit_test(claims_are_sound),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
