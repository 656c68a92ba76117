/* The oracle's count of work is proportional to its time: values of every costly kind are timed
 * per counted step. An uncounted kind would be hundreds of times as slow. */
/* ctest: small-pages */
#include "tests/test.h"
#include "compiler/oracle/oracle.h"
#include "tests/sanitized.h"
#include "tests/value/documents.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* A step is some 5 ns; a busy machine and a sanitizer take several times as long. */
static const double MAX_NANOSECONDS = SANITIZED ? 500 : 60;
static const double MIN_SECONDS = 2e-3; /* shorter ones tell nothing */
enum { ITEMS = 20000, WAVES = 120, RELIEFS = 3 };

typedef struct {
    const char *name;
    int filters; /* around it */
    const char *map;
} Row;

static const Row rows[] = {
    {"constant", 3, "0.5"},
    {"granite", 2, "{ map: Granite }"},
    {"turbulence", 2, "{ map: VolumeTurbulence, octaves: 11 }"},
    {"vectorTurbulence", 2, "{ map: Wood, input: { map: Turbulence, octaves: 10 } }"},
    {"mandel", 2, "{ map: Mandel, iterations: 1000 }"},
    {"julia", 2, "{ map: Julia, iterations: 1000, cx: -0.1, cy: 0.1 }"},
    {"items", 1, "items"},
    {"waves", 2, "waves"},
    {"reliefs", 0, "reliefs"},
};

static void put_items(FILE *out)
{
    fputs("{ map: Blend, blend: [", out);
    for (int i = 0; i < ITEMS; i++)
        fprintf(out, "{ value: %d, input: 0.5 }, ", i - 2 * ITEMS);
    fputs("] }", out);
}

static void put_waves(FILE *out)
{
    fputs("{ map: Gradient, waveForm: ", out);
    for (int i = 0; i < WAVES; i++)
        fputs("{ wave: Chain, second: Sin, first: ", out);
    fputs("Sin", out);
    for (int i = 0; i < WAVES; i++)
        fputs(" }", out);
    fputs(" }", out);
}

static void put_reliefs(FILE *out)
{
    for (int i = 0; i < RELIEFS; i++)
        fprintf(out,
                "{ map: Blend, blend: [{ value: -1, input: { map: Carpenter, width: 512, height: "
                "512, seed: %d } }, "
                "{ value: 1, input: ",
                i);
    fputs("0.5", out);
    for (int i = 0; i < RELIEFS; i++)
        fputs(" }] }", out);
}

static char *text_of(const Row *row)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fputs("material: Phong\ndiffuse: ", out);
    for (int i = 0; i < row->filters; i++)
        fputs("{ map: Smooth3D, sx: 0.1, sy: 0.1, sz: 0.1, input: ", out);
    if (!strcmp(row->map, "items"))
        put_items(out);
    else if (!strcmp(row->map, "waves"))
        put_waves(out);
    else if (!strcmp(row->map, "reliefs"))
        put_reliefs(out);
    else
        fputs(row->map, out);
    for (int i = 0; i < row->filters; i++)
        fputs(" }", out);
    fputc('\n', out);
    fclose(out);
    return text;
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

static bool is_counted(const Row *row)
{
    Document d;
    char *text = text_of(row);
    if (!document_open_text(&d, text))
        fail_msg("%s: %s", row->name, document_fault(&d));
    const ReferenceContext context = {.noise = REFERENCE_LATTICE};
    Oracle *oracle = oracle_open(d.graph, &context);
    Surface surface;
    SlotValues values;
    oracle_surface_default(&surface);
    oracle_surface_set(&surface, "x", .5);
    oracle_surface_set(&surface, "y", .5);
    double start = now();
    assert_true(oracle_material(oracle, d.graph->materials[0].node, &surface, &values));
    double seconds = now() - start, nanoseconds = seconds * 1e9 / oracle_work(oracle);
    print_message("%-18s %9.0f steps, %7.1f ms, %5.1f ns a step\n", row->name, oracle_work(oracle),
                  seconds * 1e3, nanoseconds);
    oracle_close(oracle);
    document_close(&d);
    free(text);
    return seconds < MIN_SECONDS || nanoseconds <= MAX_NANOSECONDS;
}

static void work_is_counted(void **state)
{
    (void)state;
    int faults = 0;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (!is_counted(&rows[i])) {
            print_error("%s costs more than is counted\n", rows[i].name);
            faults++;
        }
    assert_int_equal(faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(work_is_counted)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
