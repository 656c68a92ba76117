/* Cost of encodings: nanoseconds per pixel to pack and to unpack, drawn over a square, next to
 * their bits and errors. The time of an empty square is subtracted. */
#include "matbench.h"
#include "compiler/describe/describe.h"
#include "tests/draw/canvas.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 512, REPEATS = 80, VALUE_CAPACITY = 256, TEXT_CAPACITY = 512 };

/* Cheap inputs that vary from pixel to pixel. */
static const char *const inputs[] = {
    "", "fract(float(index) * 0.618)", "fract(vec2(index, index + 1u) * vec2(0.618, 0.414))",
    "normalize(fract(vec3(index, index + 1u, index + 2u) * vec3(0.618, 0.414, 0.732)) - 0.5)"};

/* NAN without a canvas. */
static double measure(Canvas *canvas, const char *functions, const char *expression, bool words)
{
    if (!canvas)
        return NAN;
    const Drawing drawing = {.functions = functions, .expression = expression};
    const Framebuffer *target = words ? &canvas->words : &canvas->floats;
    double seconds = canvas_time(canvas, &drawing, target, REPEATS);
    if (seconds < 0) {
        fprintf(stderr, "matbench: %s\n", canvas->error);
        exit(1);
    }
    return seconds * 1e9 / SIDE / SIDE;
}

/* A call of a library function, and its result. */
typedef struct {
    const char *function, *value;
    int bits;       /* the second argument; 0: none */
    int components; /* components of the result */
    bool words;
} Call;

/* Writes a call's result to the target; fewer than four components are repeated or padded. */
static double measure_call(Canvas *canvas, const Call *call)
{
    static const char *const fill[] = {"", "", ", 0.0, 0.0", ", 0.0", ""};
    char text[TEXT_CAPACITY], last[16] = "";
    if (call->bits)
        snprintf(last, sizeof last, ", %d", call->bits);
    snprintf(text, sizeof text, "%s(%s(%s%s)%s)", call->words ? "uvec4" : "vec4", call->function,
             call->value, last, fill[call->components]);
    return measure(canvas, call->function, text, call->words);
}

/* Time minus that of the store itself; at least 0. */
static double beyond(double all, double nothing)
{
    return isnan(all) ? all : fmax(all - nothing, 0);
}

static void put_row(Canvas *canvas, const FieldRow *field)
{
    const EncodingRow *row = &encoding_table[field->encoding];
    const char *input = inputs[row->takes];
    char code[VALUE_CAPACITY], empty[TEXT_CAPACITY];
    Arena arena = {0};
    Text name = text_new(&arena), error = text_new(&arena);
    bench_show(row->name);
    int bits = strchr(function_arguments(row->pack), 'i') ? field->bits : 0;
    int packed = row->words ? 1 : type_table[function_row(row->pack)->result].components;
    layout_put_encoding(&name, field);
    describe_error(&error, field);
    snprintf(empty, sizeof empty, "%s(%s%s)", "vec4", input,
             row->takes == 3   ? ", 0.0"
             : row->takes == 2 ? ", 0.0, 0.0"
                               : "");
    double pack = measure_call(
        canvas, &(Call){function_row(row->pack)->name, input, bits, packed, row->words});
    double before = measure(canvas, "", empty, false);
    const char *mask = "index * 40503u";
    unsigned long most = (1ul << field_size(field)) - 1;
    if (row->words)
        snprintf(code, sizeof code, "%s & %luu", mask, most > 0xFFFFFFFF ? 0xFFFFFFFF : most);
    else
        snprintf(code, sizeof code,
                 packed == 2 ? "vec2(index & 511u, index >> 9)"
                             : "float(index & 65535u) - 32768.0");
    if (field->encoding == ENCODING_spheremap)
        snprintf(code, sizeof code, "%s", inputs[2]);
    double unpack = canvas ? 0 : NAN, nothing = 0;
    if (*row->unpack) {
        unpack = measure_call(canvas, &(Call){row->unpack, code, bits, row->takes, false});
        snprintf(empty, sizeof empty, "vec4(%s%s)", code, packed == 2 ? ", 0.0, 0.0" : "");
        nothing = measure(canvas, "", empty, false);
    }
    bench_show("");
    printf("%-20s %6d  %-14s %8s %8s %6d\n", name.at, field_size(field) * (row->words ? 1 : 16),
           error.at, NUMBER(2, beyond(pack, before)), NUMBER(2, beyond(unpack, nothing)),
           function_row(row->pack)->cost);
    arena_free(&arena);
}

/* Every encoding that has a function, at the usual widths. */
int bench_layout(const BenchOptions *options)
{
    bool timed = options->timed;
    static const int widths[] = {7, 8, 9, 12, 16, 32};
    Canvas canvas;
    if (timed && !canvas_open(&canvas, SIDE)) {
        fprintf(stderr, "matbench: %s\n", canvas.error);
        return 1;
    }
    printf("%-20s %6s  %-14s %8s %8s %6s\n", "encoding", "bits", "error at most", "pack ns",
           "unpack", "cost");
    for (int i = 0; i < ENCODING_COUNT; i++) {
        const EncodingRow *row = &encoding_table[i];
        for (size_t k = 0; k < sizeof widths / sizeof *widths; k++) {
            FieldRow field = {.encoding = (Encoding)i, .bits = widths[k], .count = row->takes};
            if (row->pack != FN_none && widths[k] >= row->least && widths[k] <= row->most)
                put_row(timed ? &canvas : NULL, &field);
        }
    }
    if (timed)
        canvas_close(&canvas);
    const int fault = bench_layout_frame(timed);
    return bench_layout_set(timed) | fault;
}
