/* The HTML page: a template whose @NAMES@ are replaced by the measured results. */
#include "error.h"
#include <stdlib.h>
#include <string.h>

enum { LARGEST_TEMPLATE = 1 << 16 };

static char *read_template(void)
{
    char *text = calloc(1, LARGEST_TEMPLATE);
    FILE *file = fopen(SOURCE_FOLDER "/tests/bench/accuracy.md.in", "rb");
    if (!file)
        file = fopen("tests/bench/accuracy.md.in", "rb");
    if (!file || !text || !fread(text, 1, LARGEST_TEMPLATE - 1, file)) {
        free(text);
        text = NULL;
    }
    if (file)
        fclose(file);
    return text;
}

static void put_targets(const ErrorBench *bench, FILE *out)
{
    fputs("| what | target | measured | |\n| --- | --- | --- | --- |\n", out);
    for (int i = 0; i < bench->target_count; i++) {
        const ErrorTarget *t = &bench->targets[i];
        fprintf(out, "| %s | %s | %s | %s |\n", t->what, t->wanted, t->measured,
                t->reached ? "reached" : "**missed**");
    }
}

/* Insertions of the template. */
typedef struct {
    const char *plot;
    char *const *parts; /* SECTION_PART_count */
} Insertions;

/* Writes the text of a name of the template. */
static void put_name(ErrorBench *bench, const char *name, size_t size, const Insertions *texts,
                     FILE *out)
{
    static const char *const names[SECTION_PART_count] = {
        "MATERIALS", "NORMALS", "CHECKER", "NOISE", "POWERS", "CODES", "LAYOUTS"};
    const GlContext *gl = bench->meter->gl;
    for (int i = 0; i < SECTION_PART_count; i++)
        if (size == strlen(names[i]) && !strncmp(name, names[i], size))
            fputs(texts->parts[i], out);
    if (!strncmp(name, "TARGETS", size))
        put_targets(bench, out);
    if (!strncmp(name, "MACHINE", size))
        fprintf(out, "%s, GL %s%s", gl->renderer, gl->version, bench->quick ? ", --quick" : "");
    if (!strncmp(name, "COMMAND", size))
        fputs(bench->command, out);
    if (!strncmp(name, "CLOCK", size))
        fputs(gl->hardware && gl->GetQueryObjectui64v ? "the GPU's own clock"
                                                      : "the wall clock, around glFinish",
              out);
    if (!strncmp(name, "PLOT", size))
        fputs(texts->plot, out);
}

char *error_page(ErrorBench *bench, const char *plot, char *const *parts)
{
    char *template = read_template(), *page = NULL;
    size_t size;
    if (!template)
        return NULL;
    FILE *out = open_memstream(&page, &size);
    for (const char *at = template; *at && out;) {
        const char *end = *at == '@' ? strchr(at + 1, '@') : NULL;
        if (!end || end - at > 16) {
            fputc(*at++, out);
            continue;
        }
        put_name(bench, at + 1, (size_t)(end - at) - 1, &(Insertions){plot, parts}, out);
        at = end + 1;
    }
    if (out)
        fclose(out);
    free(template);
    return page;
}
