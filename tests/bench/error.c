/* matbench error: run time against error of every variant, as a CSV, a plot and a page. */
#include "error.h"
#include "compiler/base/output.h"
#include "matbench.h"
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PANEL_COLUMNS = 4, LONGEST_PATH = 4096, HARDWARE_FACTOR = 8 };
static const double picture_scale = 1, quick_seconds = 1.2, full_seconds = 40;

void error_target(ErrorBench *bench, const char *what, bool reached, const char *format, ...)
{
    char text[2 * TARGET_TEXT];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (bench->target_count == TARGETS_LIMIT)
        return;
    ErrorTarget *target = &bench->targets[bench->target_count++];
    char *bar = strchr(text, '|');
    if (bar)
        *bar = 0;
    snprintf(target->what, sizeof target->what, "%s", what);
    snprintf(target->wanted, sizeof target->wanted, "%.*s", TARGET_TEXT - 1, text);
    snprintf(target->measured, sizeof target->measured, "%.*s", TARGET_TEXT - 1,
             bar ? bar + 1 : "");
    target->reached = reached;
}

void error_figure(ErrorBench *bench, ErrorSubject of, const char *quantity, double value)
{
    const GlContext *gl = bench->meter->gl;
    fprintf(bench->csv, "%s,\"%s\",%s%s,%s,%s,%.6g\n", of.group, of.name, gl_kind_name(gl->kind),
            gl->hardware ? " hardware" : "", of.variant, quantity, value);
}

MatcDocument *error_document(const char *name, const char *text)
{
    char path[LONGEST_PATH];
    const char *root =
        /* the binary may have been copied to another machine */
        access(SOURCE_FOLDER "/examples", R_OK) ? "." : SOURCE_FOLDER;
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    snprintf(path, sizeof path, "%s/%s.yaml", root, name);
    MatcDocument *document = matc_read(path, text, strlen(text), &options);
    if (matc_material_count(document))
        return document;
    fputs(matc_diagnostics(document, MATC_TEXT), stderr);
    exit(1); /* a built-in document */
}

MatcProgram *error_program(const MatcDocument *document, const Variant *variant)
{
    MatcOptions options;
    matc_options_init(&options);
    options = variant_options(variant, &options);
    options.pass = "value";
    return variant_compile(document, 0, MATC_FRAGMENT, &options);
}

bool error_material(ErrorBench *bench, const MatcDocument *document, const Variant *variant,
                    Material *made)
{
    MatcProgram *program = error_program(document, variant);
    *made = (Material){0};
    bool fine = program && meter_make_material(bench->meter, program, made);
    matc_program_free(program);
    return fine;
}

static bool write_text(const char *path, const char *text)
{
    const char *why = output_write(path, text, strlen(text));
    if (why)
        fprintf(stderr, "matbench: %s: %s\n", path, why);
    return !why;
}

static bool write_plot(const ErrorBench *bench, const char *basename)
{
    char path[LONGEST_PATH], note[512], error[512];
    const char *renderer = bench->meter->gl->renderer;
    snprintf(note, sizeof note,
             "Of every material: the greatest error through the G-buffer; the aliasing on a plane "
             "up to its horizon. %s",
             renderer);
    char *svg = plot_svg(
        &(Plot){"Run time against error", note, bench->panels, bench->panel_count, PANEL_COLUMNS});
    snprintf(path, sizeof path, "%s.svg", basename);
    bool done = write_text(path, svg);
    snprintf(path, sizeof path, "%s.png", basename);
    if (done && !plot_png(svg, picture_scale, path, error, sizeof error))
        fprintf(stderr, "matbench: no %s: %s\n", path, error); /* the SVG exists */
    free(svg);
    return done;
}

static void run_all(ErrorBench *bench)
{
    error_normals(bench);
    error_codes(bench);
    error_layouts(bench);
    error_powers(bench);
    error_noise(bench);
    error_checker(bench);
    error_materials(bench);
    bench_show("");
}

static void print_targets(const ErrorBench *bench)
{
    for (int i = 0; i < bench->target_count; i++) {
        const ErrorTarget *t = &bench->targets[i];
        printf("%-8s %s: %s / %s\n", t->reached ? "reached" : "missed", t->what, t->wanted,
               t->measured);
    }
}

/* The plot's path relative to the page's folder. */
static const char *plot_from_page(const BenchOptions *a)
{
    const char *slash = a->page ? strrchr(a->page, '/') : NULL;
    size_t folder = slash ? (size_t)(slash - a->page) + 1 : 0;
    return a->plot && folder && !strncmp(a->plot, a->page, folder) ? a->plot + folder
           : a->plot                                               ? a->plot
                                                                   : "accuracy";
}

static int finish(ErrorBench *bench, const BenchOptions *a, const char *csv, char *const *parts)
{
    bool done = !a->csv || write_text(a->csv, csv);
    if (a->plot)
        done = write_plot(bench, a->plot) && done;
    char *page = a->page ? error_page(bench, plot_from_page(a), parts) : NULL;
    if (a->page && !page)
        fputs("matbench: tests/bench/accuracy.md.in cannot be read\n", stderr);
    if (a->page)
        done = page && write_text(a->page, page) && done;
    free(page);
    if (!a->csv && !a->page)
        fputs(csv, stdout);
    else
        print_targets(bench);
    return done ? 0 : 1;
}

const Option bench_error_options[] = {
    BENCH_FLAG("--quick", quick, "coarse, in half a minute"),
    {"--seconds", OPTION_real, BENCH_AT(seconds), .label = "=N", .min = 0, .max = 1e6,
     .wants = "--seconds wants a number", .help = "that each variant is drawn for"},
    BENCH_GL,
    BENCH_TEXT("--csv", csv, " FILE", "where the measurements are written"),
    BENCH_TEXT("--plot", plot, " BASENAME", "where the plots are written"),
    BENCH_TEXT("--page", page, " FILE", "where the page of docs/ is written"),
    BENCH_HELP,
};

int bench_error(const BenchOptions *options)
{
    char error[4096], *csv, *parts[SECTION_PART_count];
    size_t sizes[1 + SECTION_PART_count];
    ErrorBench *bench = calloc(1, sizeof *bench);
    bench->quick = options->quick;
    for (int i = 0; i < options->argument_count; i++) {
        size_t size = strlen(bench->command);
        snprintf(bench->command + size, sizeof bench->command - size,
                 i ? " %s" : "build/matbench %s", options->arguments[i]);
    }
    bench->seconds = options->seconds > 0 ? options->seconds
                     : options->quick     ? quick_seconds
                                          : full_seconds;
    bench->meter = meter_open(options->gl, error, sizeof error);
    if (!bench->meter) {
        fprintf(stderr, "matbench: %s\n", error);
        free(bench);
        return 1;
    }
    bench->factor = bench->meter->gl->hardware ? HARDWARE_FACTOR : 1;
    bench->csv = open_memstream(&csv, &sizes[0]);
    for (int i = 0; i < SECTION_PART_count; i++)
        bench->part[i] = open_memstream(&parts[i], &sizes[1 + i]);
    fputs("group,subject,gl,variant,quantity,value\n", bench->csv);
    run_all(bench);
    fclose(bench->csv);
    for (int i = 0; i < SECTION_PART_count; i++)
        fclose(bench->part[i]);
    int status = finish(bench, options, csv, parts);
    for (int i = 0; i < SECTION_PART_count; i++)
        free(parts[i]);
    free(csv);
    meter_close(bench->meter);
    free(bench);
    return status;
}
