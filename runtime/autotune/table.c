/* Formats measurement results as CSV and as a table. */
#include "runtime/autotune/autotune.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static FILE *open_text(char **text, size_t *size)
{
    FILE *out = open_memstream(text, size);
    if (!out)
        abort();
    return out;
}

static void put_number(FILE *out, double number)
{
    if (isnan(number))
        fputc(',', out);
    else
        fprintf(out, ",%.6g", number);
}

static void put_header(FILE *out)
{
    fputs("subject,gl", out);
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        fprintf(out, ",%s", axis_table[axis].name);
    fputs(",layout,ns_per_pixel,error_max,error_rms,error_8bit,aliasing_rms,front,aliasing_front",
          out);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        fprintf(out, ",packed_%s,computed_%s,aliased_%s", slot_table[slot].name,
                slot_table[slot].name, slot_table[slot].name);
    fputc('\n', out);
}

/* Writes a CSV field, quoted if necessary. */
static void put_field(FILE *out, const char *text)
{
    bool plain = !strpbrk(text, ",\"\n");
    if (plain) {
        fputs(text, out);
        return;
    }
    fputc('"', out);
    for (; *text; text++)
        fputs((char[]){*text, *text == '"' ? '"' : 0, 0}, out);
    fputc('"', out);
}

static void put_line(FILE *out, const Measured *m, const char *subject, const GlContext *gl)
{
    put_field(out, subject);
    fprintf(out, ",%s%s", gl_kind_name(gl->kind), gl->hardware ? " hardware" : "");
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        fprintf(out, ",%s", choice_table[m->variant.choice[axis]].name);
    fprintf(out, ",%s", layout_table[m->variant.layout].name);
    put_number(out, m->nanoseconds);
    put_number(out, m->error);
    put_number(out, m->rms);
    put_number(out, m->error * 255);
    put_number(out, m->aliasing);
    fprintf(out, ",%d,%d", m->front, m->alias_front);
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        put_number(out, m->packed[slot].maximum);
        put_number(out, m->computed[slot].maximum);
        put_number(out, m->aliased[slot].rms);
    }
    fputc('\n', out);
}

char *autotune_csv(const MeasuredList *list, const char *subject, const GlContext *gl, bool header)
{
    char *text;
    size_t size;
    FILE *out = open_text(&text, &size);
    if (header)
        put_header(out);
    for (int i = 0; i < list->count; i++)
        put_line(out, &list->at[i], subject, gl);
    fclose(out);
    return text;
}

static int by_time(const void *a, const void *b)
{
    double x = (*(const Measured *const *)a)->nanoseconds,
           y = (*(const Measured *const *)b)->nanoseconds;
    return (x > y) - (x < y);
}

char *autotune_table(const MeasuredList *list)
{
    char *text, name[VARIANT_NAME];
    size_t size;
    FILE *out = open_text(&text, &size);
    const Measured **sorted = calloc((size_t)list->count + 1, sizeof *sorted);
    if (!sorted)
        abort();
    for (int i = 0; i < list->count; i++)
        sorted[i] = &list->at[i];
    qsort(sorted, (size_t)list->count, sizeof *sorted, by_time);
    fputs(" ns/pixel   error max       rms  8-bit steps  aliasing rms  front  choices\n", out);
    for (int i = 0; i < list->count; i++) {
        const Measured *m = sorted[i];
        variant_name(&m->variant, &list->at[0].variant, name);
        fprintf(out, "%9.3f %11.3g %9.3g %12.3g", m->nanoseconds, m->error, m->rms, m->error * 255);
        if (isnan(m->aliasing))
            fprintf(out, "%14s", "-");
        else
            fprintf(out, "%14.4f", m->aliasing);
        fprintf(out, "  %c%c     %s\n", m->front ? 'e' : ' ', m->alias_front ? 'a' : ' ', name);
    }
    free(sorted);
    fclose(out);
    return text;
}
