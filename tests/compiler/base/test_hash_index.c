/* The hash table against a linear search through all entries, with few distinct hashes, many,
 * and all hashes equal. */
#include "tests/test.h"
#include "compiler/base/hash_index.h"
#include <unistd.h>

enum { COUNT = 3000, MAX_SECONDS = 60 }; /* a search in a full table would not end */

/* All numbers of a hash come, in the order in which they were added, and no other. */
static void check_all(const HashIndex *index, const uint32_t *hashes, int count, uint32_t asked)
{
    HashProbe probe = hash_probe(index, asked);
    for (int i = 0; i < count; i++)
        if (hashes[i] == asked) {
            assert_true(hash_probe_next(&probe));
            assert_int_equal(probe.number, i);
        }
    assert_false(hash_probe_next(&probe));
}

static void check(Arena *arena, uint32_t kinds, uint32_t factor)
{
    static uint32_t hashes[COUNT];
    HashIndex index = {0};
    for (int i = 0; i < COUNT; i++) {
        hashes[i] = (uint32_t)i * 2654435761u % kinds * factor;
        hash_index_add(arena, &index, hashes[i], (uint32_t)i);
        if ((i & (i - 1)) == 0) /* before and after the table grows */
            check_all(&index, hashes, i + 1, hashes[i / 2]);
    }
    for (uint32_t kind = 0; kind < kinds + 3 && kind < 200; kind++)
        check_all(&index, hashes, COUNT, kind * factor);
    assert_int_equal(index.count, COUNT);
    assert_true(index.mask >= 2 * COUNT - 1);
    if (!arena)
        hash_index_free(&index);
}

static void every_number_is_found_by_its_hash(void **state)
{
    (void)state;
    Arena arena = {0};
    static const uint32_t kinds[] = {1, 2, 100, 100000}, factors[] = {1, 64, 65536, 0x80000001u};
    for (int i = 0; i < 16; i++) {
        check(&arena, kinds[i / 4], factors[i % 4]);
        check(NULL, kinds[i / 4], factors[i % 4]);
    }
    arena_free(&arena);
}

static void an_empty_one_has_nothing(void **state)
{
    (void)state;
    HashIndex index = {0};
    HashProbe probe = hash_probe(&index, 7);
    assert_false(hash_probe_next(&probe));
    hash_index_free(&index);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_is_found_by_its_hash),
        cmocka_unit_test(an_empty_one_has_nothing),
    };
    alarm(MAX_SECONDS);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
