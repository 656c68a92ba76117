/* --layout=auto: the set of slots that is stored for many materials, and its division into
 * cases. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/layout/auto_layout.h"
#include "compiler/layout/custom.h"
#include <stdlib.h>
#include <string.h>

enum { STORABLE = (1 << SLOT_COUNT) - 1 - (1 << SLOT_alpha), EXHAUSTIVE = 6, DIVISIONS = 1000 };

static unsigned next_random(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (unsigned)(*state >> 33);
}

/* Normal and each of the others with a chance of 1 in `rarity`. */
enum { OF_PHONG = (1 << SLOT_metalness) - 1 }; /* no material has slots of both models */
enum { OF_BASES = (1 << SLOT_coat) - 1 };      /* most have no further lobe */
static unsigned random_slots(uint64_t *state, unsigned rarity)
{
    unsigned slots = 1u << SLOT_normal;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        slots |= (unsigned)(next_random(state) % rarity == 0) << slot;
    return slots & STORABLE;
}

/* One material, all of whose slots have the range that a surface can have. */
static MatcRanges ranges_of(unsigned slots)
{
    MatcRanges ranges;
    matc_ranges_init(&ranges);
    ranges.materials = 1;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        for (int component = 0; component < type_table[slot_table[slot].type].components;
             component++) {
            ranges.slot[slot].counted = slot_class_table[slot].kind != CLASS_none;
            ranges.slot[slot].low[component] = slot_table[slot].low;
            ranges.slot[slot].high[component] = slot_table[slot].high;
        }
    auto_sets_add(&ranges, (MatcSlotSet){slots, 1});
    return ranges;
}

static MatcRanges join_all(const unsigned *slots, int count)
{
    MatcRanges all;
    matc_ranges_init(&all);
    for (int i = 0; i < count; i++) {
        const MatcRanges one = ranges_of(slots[i]);
        matc_ranges_join(&all, &one);
    }
    return all;
}

static MatcLayout *layout_of(const MatcRanges *ranges)
{
    MatcOptions options;
    matc_options_init(&options);
    MatcLayout *layout = matc_layout_for(ranges, 0, &options);
    assert_true(matc_layout_ok(layout));
    return layout;
}

static unsigned slots_of(const CaseRow *row)
{
    unsigned slots = 0;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        slots |= (unsigned)layout_case_has_slot(row, (Slot)slot) << slot;
    return slots;
}

static bool has_case(const LayoutRow *row, unsigned slots)
{
    for (int i = 0; i < row->case_count; i++)
        if (!(slots & ~slots_of(&row->cases[i])))
            return true;
    return false;
}

/* More sets than there is room for, shuffled and joined in parts: the same bytes, and no material
 * is lost. */
static void order_is_of_no_account(void **state)
{
    (void)state;
    enum { COUNT = 2000, PARTS = 7, ROUNDS = 20 };
    static unsigned slots[COUNT];
    static MatcRanges parts[PARTS];
    uint64_t random = 1;
    for (int i = 0; i < COUNT; i++)
        slots[i] = random_slots(&random, 2);
    const MatcRanges want = join_all(slots, COUNT);
    int sum = want.others.materials;
    for (int i = 0; i < want.set_count; i++)
        sum += want.sets[i].materials;
    assert_int_equal(want.set_count, MATC_SETS);
    assert_true(want.others.materials > 0 && sum == COUNT && want.materials == COUNT);
    for (int round = 0; round < ROUNDS; round++) {
        for (int i = COUNT - 1; i > 0; i--) {
            const unsigned at = next_random(&random) % (unsigned)(i + 1), kept = slots[i];
            slots[i] = slots[at];
            slots[at] = kept;
        }
        for (int i = 0, from = 0; i < PARTS; i++) {
            const int to =
                i + 1 < PARTS ? from + (int)(next_random(&random) % (COUNT / PARTS)) : COUNT;
            parts[i] = join_all(slots + from, to - from);
            from = to;
        }
        for (int count = PARTS; count > 1; count--) { /* any two, until one is left */
            const unsigned a = next_random(&random) % (unsigned)count;
            const MatcRanges taken = parts[a];
            parts[a] = parts[count - 1];
            matc_ranges_join(&parts[next_random(&random) % (unsigned)(count - 1)], &taken);
        }
        assert_memory_equal(&parts[0], &want, sizeof want);
    }
}

/* So many sets that some share a case: each set still has a case, and every case has its bits. */
static void every_set_finds_a_case(void **state)
{
    (void)state;
    enum { COUNT = 600, MOST = 4 };
    int crowded = 0, several = 0;
    for (unsigned rarity = 2; rarity < 8; rarity++) {
        static unsigned slots[COUNT];
        uint64_t random = rarity;
        for (int i = 0; i < COUNT; i++)
            do
                slots[i] = random_slots(&random, rarity) & OF_BASES;
            while (__builtin_popcount(slots[i]) > 9 - (int)rarity / 2);
        const MatcRanges ranges = join_all(slots, COUNT);
        MatcLayout *layout = layout_of(&ranges);
        print_message("1 in %u: %d sets, %d more materials, %d bytes in %d cases\n", rarity,
                      ranges.set_count, ranges.others.materials, matc_layout_bytes(layout),
                      layout->row->case_count);
        for (int i = 0; i < COUNT; i++)
            assert_true(has_case(layout->row, slots[i]));
        for (int number = 0; number < layout->row->case_count; number++) {
            Placement placement;
            assert_null(layout_allocate(layout->row, number, &placement));
        }
        crowded += ranges.others.materials > 0;
        several += layout->row->case_count > 1;
        matc_layout_free(layout);
    }
    assert_true(crowded > 0 && several > 0);
}

/* The fields of a layout that would store all. */
static int all_fields(const MatcRanges *ranges, FieldRow fields[SLOT_COUNT])
{
    int count = 0;
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        const Plan plan = auto_plan_slot((Slot)slot, &ranges->slot[slot], 1);
        if (plan.fate == FATE_field)
            fields[count++] = plan.field;
    }
    return count;
}

static int group_bits(const FieldRow *fields, int count, unsigned slots)
{
    int bits = 0;
    for (int i = 0; i < count; i++)
        bits += slots >> fields[i].source[0].slot & 1 ? auto_field_bits(&fields[i]) : 0;
    return bits;
}

/* A way to put sets into at most so many cases, on its way. */
typedef struct {
    const FieldRow *fields;
    int count;
    const unsigned *sets; /* EXHAUSTIVE */
    unsigned cases[EXHAUSTIVE];
    int most;
} Search;

/* The fewest bits that the largest case has, by all ways to put the sets from `next` on into them;
 * `used` have one already. */
static int fewest_bits(Search *s, int next, int used)
{
    int best = 1 << 20, largest = 0;
    if (next == EXHAUSTIVE) {
        for (int i = 0; i < used; i++) {
            const int bits = group_bits(s->fields, s->count, s->cases[i]);
            largest = bits > largest ? bits : largest;
        }
        return largest;
    }
    for (int i = 0; i < used + (used < s->most); i++) {
        const unsigned before = i < used ? s->cases[i] : 0;
        s->cases[i] = before | s->sets[next];
        const int bits = fewest_bits(s, next + 1, used + (i == used));
        best = bits < best ? bits : best;
        s->cases[i] = before;
    }
    return best;
}

/* No division has fewer words than its bits need; what is found has no more, but where pieces do
 * not fill words. */
static void few_sets_are_divided_best(void **state)
{
    (void)state;
    static const int case_bits[] = {0, 0, 1, 2, 2, 3, 3};
    uint64_t random = 5;
    int exact = 0, several = 0;
    for (int round = 0; round < DIVISIONS; round++) {
        unsigned sets[EXHAUSTIVE];
        FieldRow fields[SLOT_COUNT];
        for (int i = 0; i < EXHAUSTIVE; i++)
            sets[i] = random_slots(&random, 3) & OF_PHONG;
        const MatcRanges ranges = join_all(sets, EXHAUSTIVE);
        const int count = all_fields(&ranges, fields);
        MatcLayout *layout = layout_of(&ranges);
        const int words = matc_layout_bytes(layout) / 4, found = layout->row->case_count;
        int least = 1 << 20, fewest = 0;
        for (int most = 1; most <= EXHAUSTIVE; most++) {
            Search search = {.fields = fields, .count = count, .sets = sets, .most = most};
            const int bits = fewest_bits(&search, 0, 0) + case_bits[most];
            if ((bits + 31) / 32 < least) {
                least = (bits + 31) / 32;
                fewest = most;
            }
        }
        assert_true(words >= least && words <= least + 1);
        assert_true(words > least || found >= fewest);
        exact += words == least && found == fewest;
        several += found > 1;
        matc_layout_free(layout);
    }
    print_message(
        "%d of %d divisions into cases, %d with the words and cases that bits alone would need\n",
        several, DIVISIONS, exact);
    assert_true(several > DIVISIONS / 4 && exact > DIVISIONS * 3 / 4);
}

/* Cases that bring nothing are none. */
static void one_case_where_that_does(void **state)
{
    (void)state;
    const unsigned plain = 1u << SLOT_normal | 1u << SLOT_diffuse,
                   shiny = plain | 1u << SLOT_specular;
    const MatcRanges same = join_all((unsigned[]){shiny, shiny | 1u << SLOT_emissive, plain}, 3);
    MatcLayout *layout = layout_of(&same);
    assert_int_equal(layout->row->case_count, 1);
    assert_true(layout_is_whole(layout->row));
    assert_null(strstr(matc_layout_report(layout), "one case would take"));
    matc_layout_free(layout);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(order_is_of_no_account),
        cmocka_unit_test(every_set_finds_a_case),
        cmocka_unit_test(few_sets_are_divided_best),
        cmocka_unit_test(one_case_where_that_does),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
