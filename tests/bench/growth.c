/* matbench growth [NAME...]: compile time against the size of the document, over the table that
 * test_growth.c bounds. */
#include "matbench.h"
#include "tests/growth/growth.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIZES = 4, RUNS = 3 };

static bool is_wanted(const char *name, const BenchOptions *options)
{
    for (int i = 0; i < options->word_count; i++)
        if (!strcmp(options->words[i], name))
            return true;
    return !options->word_count;
}

static void print_row(const GrowthRow *row)
{
    double seconds[SIZES];
    printf("%-20s %-34s %6d", row->name, row->options, row->count);
    for (int i = 0; i < SIZES; i++) {
        seconds[i] = growth_seconds(row, row->count << i, RUNS);
        printf(" %9.2f", seconds[i] * 1000);
        fflush(stdout);
    }
    GrowthRun last = growth_run(row, row->count << (SIZES - 1));
    double exponent = log(seconds[SIZES - 1] / seconds[0]) / log(GROWTH_FACTOR);
    printf(" %8.2f %8zu %8zu %6d\n", exponent, last.read / 1024, last.written / 1024, last.errors);
}

static void print_batch(const GrowthBatch *row)
{
    double seconds[SIZES];
    printf("%-20s %-34s %6d", row->name, row->options, row->count);
    for (int i = 0; i < SIZES; i++) {
        seconds[i] = growth_batch_seconds(row, MATC_PROGRAM, row->count << i, RUNS);
        printf(" %9.2f", seconds[i] * 1000);
        fflush(stdout);
    }
    printf(" %8.2f\n", log(seconds[SIZES - 1] / seconds[0]) / log(GROWTH_FACTOR));
}

int bench_growth(const BenchOptions *options)
{
    printf("%-20s %-34s %6s %9s %9s %9s %9s %8s %8s %8s %6s\n", "document", "options", "n", "n: ms",
           "2 n", "4 n", "8 n", "exponent", "KiB read", "written", "errors");
    for (int i = 0; i < growth_count; i++)
        if (is_wanted(growth_table[i].name, options))
            print_row(&growth_table[i]);
    for (int i = 0; i < growth_batch_count; i++)
        if (is_wanted(growth_batches[i].name, options))
            print_batch(&growth_batches[i]);
    return 0;
}
