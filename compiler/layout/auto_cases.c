/* --layout=auto: groups slots into cases. A case stores the slots of some of the materials' slot
 * sets. Finds the fewest words per pixel such that every set is contained in a case, then the
 * fewest cases, by backtracking.
 *
 *     sets {diffuse, emissive} of 40 bits, {diffuse, specular} of 32, {diffuse, ior} of 28,
 *         and words of 32 bits
 *     1 word: the first set alone is too large
 *     2 words, 1 case: the union of all sets takes 52 bits and fits: 8 bytes, and no bits for
 *         a case number
 *     If the union took 70 bits, the second set would join the first case if both fit there,
 *         otherwise open the second case; a dead end returns to the last choice. */
#include "compiler/layout/auto_layout.h"
#include <stdlib.h>
#include <string.h>

enum {
    MAX_WORDS = 4 * LAYOUT_TARGETS,
    MAX_STEPS = 20000, /* limit of a search: eight sets have 4,140 partitions */
    TRIED = 1 << 12,
};

/* Cache: whether the slots of a case fit; the last query of each hash slot. */
typedef struct {
    unsigned slots;
    bool tried, fits;
} Tried;

/* State of partitioning the sets into a given number of cases of a given number of words. */
typedef struct {
    const FieldRow *fields; /* fields, sorted by decreasing size */
    int field_count;
    /* Sets of which none contains another, by decreasing number of bits. */
    unsigned sets[MATC_SETS + 1];
    int set_count;
    LayoutRow row; /* formats and number of the cases being tried */
    int steps;
    Division *found;
    Tried tried[TRIED];
} Search;

void auto_choose_formats(LayoutRow *row, int words)
{
    int count = 0;
    for (; words >= 4; words -= 4)
        row->formats[count++] = FORMAT_RGBA32UI;
    if (words >= 2)
        row->formats[count++] = FORMAT_RG32UI;
    if (words % 2)
        row->formats[count++] = FORMAT_R32UI;
    row->formats[count] = FORMAT_none;
}

static int targets_of(int words) { return words / 4 + words % 4 / 2 + words % 2; }

static bool can_fit(const Search *s, unsigned slots)
{
    FieldRow fields[SLOT_COUNT];
    CaseRow only = {.fields = fields};
    /* Allocates the case alone; the case number's bits are reserved by the row. */
    LayoutRow row = s->row;
    Placement placement;
    for (int i = 0; i < s->field_count; i++)
        if (slots >> s->fields[i].source[0].slot & 1)
            fields[only.field_count++] = s->fields[i];
    row.cases = &only;
    return !layout_allocate(&row, 0, &placement);
}

static bool fits(Search *s, unsigned slots)
{
    static const uint32_t spread = 2654435769; /* 2^32 divided by the golden ratio */
    Tried *at = &s->tried[(slots * spread >> 16) % TRIED];
    if (!at->tried || at->slots != slots)
        *at = (Tried){slots, true, can_fit(s, slots)};
    return at->fits;
}

/* Assigns the sets from `next` on to cases: to a case that already contains the set, to one that
 * can be extended, or to a new one. */
static bool divide(Search *s, int next)
{
    Division *found = s->found;
    if (next == s->set_count)
        return true;
    if (s->steps++ == MAX_STEPS)
        return false;
    const unsigned set = s->sets[next];
    for (int i = 0; i < found->count; i++)
        if (!(set & ~found->slots[i]))
            return divide(s, next + 1);
    for (int i = 0; i < found->count && s->steps <= MAX_STEPS; i++) {
        const unsigned before = found->slots[i];
        if (!fits(s, before | set))
            continue;
        found->slots[i] |= set;
        if (divide(s, next + 1))
            return true;
        found->slots[i] = before;
    }
    if (found->count == s->row.case_count || s->steps > MAX_STEPS)
        return false;
    found->slots[found->count++] = set;
    if (divide(s, next + 1))
        return true;
    found->count--;
    return false;
}

/* Returns false also if the search is abandoned. */
static bool divide_into(Search *s, int words, int cases)
{
    if (targets_of(words) > LAYOUT_TARGETS)
        return false;
    auto_choose_formats(&s->row, words);
    s->row.case_count = cases;
    s->found->count = s->steps = 0;
    memset(s->tried, 0, sizeof s->tried);
    for (int i = 0; i < s->set_count; i++)
        if (!fits(s, s->sets[i]))
            return false;
    return divide(s, 0);
}

static int slots_bits(const Search *s, unsigned slots)
{
    int bits = 0;
    for (int i = 0; i < s->field_count; i++)
        if (slots >> s->fields[i].source[0].slot & 1)
            bits += auto_field_bits(&s->fields[i]);
    return bits;
}

/* Adds a set unless another set contains it; removes sets that it contains. */
static void add_set(Search *s, unsigned set)
{
    int at, kept = 0;
    for (int i = 0; i < s->set_count; i++)
        if (!(set & ~s->sets[i]))
            return;
    for (int i = 0; i < s->set_count; i++)
        if (s->sets[i] & ~set)
            s->sets[kept++] = s->sets[i];
    for (at = kept; at > 0 && slots_bits(s, s->sets[at - 1]) < slots_bits(s, set); at--)
        s->sets[at] = s->sets[at - 1];
    s->sets[at] = set;
    s->set_count = kept + 1;
}

static int by_slots(const void *a, const void *b)
{
    const unsigned x = *(const unsigned *)a, y = *(const unsigned *)b;
    const int difference = __builtin_popcount(x) - __builtin_popcount(y);
    return difference ? difference : x < y ? -1 : x > y;
}

/* Counts a material for the first case with its slots, as lower_layout_case selects the case. */
static void count_materials(Division *division, unsigned stored, const MatcSlotSet *set)
{
    int number = 0;
    while (number < division->count && set->slots & stored & ~division->slots[number])
        number++;
    division->materials[number] += set->materials;
}

static void finish(Division *division, unsigned stored, const MatcRanges *ranges)
{
    qsort(division->slots, (size_t)division->count, sizeof *division->slots, by_slots);
    for (int i = 0; i < ranges->set_count; i++)
        count_materials(division, stored, &ranges->sets[i]);
    if (ranges->others.materials)
        count_materials(division, stored, &ranges->others);
}

/* Finds the fewest words with a single case, then fewer words with the fewest cases. */
static bool find_division(Search *s, unsigned stored)
{
    Division *found = s->found;
    Search whole = *s;
    whole.sets[0] = stored;
    whole.set_count = 1;
    for (found->words_of_one = 1; !divide_into(&whole, found->words_of_one, 1);)
        if (++found->words_of_one > MAX_WORDS)
            return false;
    for (found->words = 1; found->words < found->words_of_one; found->words++)
        for (int cases = 2; cases <= MAX_AUTO_CASES; cases++)
            if (divide_into(s, found->words, cases))
                return true;
    return divide_into(&whole, found->words_of_one, 1);
}

bool auto_divide(const FieldRow *fields, int count, const MatcRanges *ranges, Division *division)
{
    Search s = {.fields = fields, .field_count = count, .found = division};
    unsigned stored = 0;
    *division = (Division){0};
    for (int i = 0; i < count; i++)
        stored |= 1u << fields[i].source[0].slot;
    for (int i = 0; i < ranges->set_count; i++)
        add_set(&s, ranges->sets[i].slots & stored);
    if (ranges->others.materials)
        add_set(&s, ranges->others.slots & stored);
    if (!find_division(&s, stored))
        return false;
    finish(division, stored, ranges);
    return true;
}
