/* Compile time grows linearly with the document: every row of growth/growth.def, at n and at 8 n
 * parts. */
/* ctest: small-pages seconds=20 */
#include "tests/test.h"
#include "compiler/base/arena.h"
#include "compiler/base/session.h"
#include "tests/growth/growth.h"
#include "tests/sanitized.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Eight times as much takes 8 times as long, 8 log 8 at most; 64 times where something is
 * quadratic. Between them lies what a busy machine adds, caches that are too small for the longer
 * one, tables that are grown. */
static const double MOST = 24;
/* what a clock and a scheduler leave of a time; shorter ones count as that */
static const double MIN_SECONDS = 5e-4;
enum { RUNS = 3, TRIES = 4 };

/* Sanitizers look for faults in the longer documents. They are not timed: their allocator takes
 * each large block from the system and gives it back, and the system's pages cost more than what is
 * written into them. */
static void timed(void)
{
    if (SANITIZED)
        skip();
}

/* The longer run is repeated only if it seems too long: what else the machine does can only add to
 * it. */
static double ratio(const GrowthRow *row)
{
    double base = fmax(growth_seconds(row, row->count, RUNS), MIN_SECONDS), least = INFINITY;
    for (int i = 0; i < TRIES && least > MOST * base; i++)
        least = fmin(least, growth_seconds(row, GROWTH_FACTOR * row->count, 1));
    return least / base;
}

/* Ratio for batches. The shorter batch has nothing to do except start; growth is what exceeds that.
 * */
static double batch_ratio(const GrowthBatch *row)
{
    double base = growth_batch_seconds(row, MATC_PROGRAM, row->count, 1), least = INFINITY;
    assert_true(isfinite(base));
    for (int i = 0; i < TRIES && least > MOST * base; i++)
        least = fmin(least, growth_batch_seconds(row, MATC_PROGRAM, GROWTH_FACTOR * row->count, 1));
    assert_true(isfinite(least));
    return least / base;
}

static void every_document_takes_time_by_its_length(void **state)
{
    (void)state;
    timed();
    int failed = 0;
    for (int i = 0; i < growth_count; i++) {
        double times = ratio(&growth_table[i]);
        if (times <= MOST)
            continue;
        fprintf(stderr, "%s %s: %d parts take %.1f times as long as %d\n", growth_table[i].name,
                growth_table[i].options, GROWTH_FACTOR * growth_table[i].count, times,
                growth_table[i].count);
        failed++;
    }
    assert_int_equal(failed, 0);
}

static void every_batch_takes_time_by_its_documents(void **state)
{
    (void)state;
    timed();
    int failed = 0;
    for (int i = 0; i < growth_batch_count; i++) {
        double times = batch_ratio(&growth_batches[i]);
        if (times <= MOST)
            continue;
        fprintf(stderr, "%s: %d documents take %.1f times as long as %d\n", growth_batches[i].name,
                GROWTH_FACTOR * growth_batches[i].count, times, growth_batches[i].count);
        failed++;
    }
    assert_int_equal(failed, 0);
}

/* A row that is refused before its end would measure nothing. */
static void read_as_meant(const GrowthRow *row, int count)
{
    GrowthRun run = growth_run(row, count);
    if (!run.errors != !row->faulty)
        fail_msg("%s: %d errors", row->name, run.errors);
    assert_true(run.written > 0);
}

static void documents_are_read_as_they_are_meant(void **state)
{
    (void)state;
    for (int i = 0; i < growth_count; i++) {
        const GrowthRow *row = &growth_table[i];
        read_as_meant(row, row->count);
        if (!SANITIZED)
            read_as_meant(row, GROWTH_FACTOR * row->count);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(documents_are_read_as_they_are_meant),
        cmocka_unit_test(every_document_takes_time_by_its_length),
        cmocka_unit_test(every_batch_takes_time_by_its_documents),
    };
    /* as matc does: a page that the system takes and gives anew costs more than what is written
     * into it, and small documents have none */
    arena_keep_pages();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
