/* matbench noise: time of our noise functions next to other noise functions, which are
 * reimplemented from their publications. Every function is summed over the same octaves at the
 * same places; the time of a constant color is subtracted. */
#include "compiler/base/file.h"
#include "matbench.h"
#include "runtime/autotune/meter.h"
#include "tests/draw/canvas.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 512, GPU_FACTOR = 4, ROUNDS = 41, TEXT_CAPACITY = 1 << 17, PATH_CAPACITY = 1024 };

/* A function `float noise(vec3)`: from a file in this folder, or from the library by a choice. */
typedef struct {
    const char *name, *file;
    Choice choice;
} Row;
static const Row rows[] = {
    {"Perlin 2002 over Jenkins' hash: MaterialX, three.js", "noise_perlin.glsl", 0},
    {"simplex of McEwan and others 2012", "noise_mcewan.glsl", 0},
    {"matc --noise=lattice", NULL, CHOICE_noise_lattice},
    {"matc --noise=simplex", NULL, CHOICE_noise_simplex},
};
enum { ROW_COUNT = sizeof rows / sizeof *rows };

static const char text_head[] = "#version 330 core\nlayout(location = 0) out vec4 colour;\n";
static const char text_main[] =
    "void main() {\n"
    "    vec3 p = vec3(0.04 * gl_FragCoord.xy, 0.01 * gl_FragCoord.x + 0.37);\n"
    "    float sum = 0.0, strength = 1.0;\n"
    "    for (int k = 0; k < 4; k++) {\n"
    "        sum += strength * noise(p);\n"
    "        strength *= 0.5;\n"
    "        p *= 2.0;\n"
    "    }\n"
    "    colour = vec4(sum);\n"
    "}\n";

/* Writes the fragment program of a row. Returns false after a message. */
static bool write_text(const Row *row, char text[TEXT_CAPACITY])
{
    char path[PATH_CAPACITY], *read = NULL;
    const char *why = "no such function";
    size_t size, head = sizeof text_head - 1, capacity = TEXT_CAPACITY - head - sizeof text_main;
    memcpy(text, text_head, sizeof text_head);
    if (!row->file) {
        canvas_library("noise", &row->choice, text + head, capacity);
    } else {
        snprintf(path, sizeof path, "%s/tests/bench/shaders/%s", SOURCE_FOLDER, row->file);
        read = file_read(path, &size, &why);
        if (!read) {
            fprintf(stderr, "matbench: %s: %s\n", path, why);
            return false;
        }
        snprintf(text + head, capacity, "%s", read);
        free(read);
    }
    strcat(text, text_main);
    return true;
}

/* A square that fills the picture. */
static bool make_square(Meter *m, Field *made)
{
    FieldVertex corners[4];
    memset(corners, 0, sizeof corners);
    for (int i = 0; i < 4; i++) {
        corners[i].at[0] = i % 2 ? 1 : -1;
        corners[i].at[1] = i < 2 ? -1 : 1;
        corners[i].at[3] = 1;
    }
    return field_make(m->gl, corners, 4, GL_TRIANGLE_STRIP, made);
}

static bool time_rows(Meter *m, double nanoseconds[ROW_COUNT])
{
    static char text[TEXT_CAPACITY];
    const int side = SIDE * (m->gl->hardware ? GPU_FACTOR : 1);
    const FramebufferSpec spec = {
        .width = side, .height = side, .color_count = 1, .color_format = GL_RGBA16F};
    Material materials[ROW_COUNT + 1];
    MeterDraw draws[ROW_COUNT + 1];
    double all[ROW_COUNT + 1];
    Framebuffer target;
    Field field;
    bool done = framebuffer_make(m->gl, &spec, &target) && make_square(m, &field) &&
                meter_make_constant(m, &materials[ROW_COUNT]);
    for (int i = 0; i < ROW_COUNT && done; i++)
        done =
            write_text(&rows[i], text) &&
            field_material(m->store, NULL, &(FieldText){TARGET_glsl330, text, NULL}, &materials[i]);
    for (int i = 0; i <= ROW_COUNT; i++)
        draws[i] = (MeterDraw){&materials[i], &field, &target};
    bench_show("four octaves of each");
    done = done && meter_time(m, draws, ROW_COUNT + 1, ROUNDS, all);
    bench_show("");
    for (int i = 0; i < ROW_COUNT && done; i++)
        nanoseconds[i] = fmax(all[i] - all[ROW_COUNT], 1e-6);
    if (!done)
        fprintf(stderr, "matbench: %s\n", *m->error ? m->error : m->gl->error);
    return done; /* meter_close releases the rest */
}

static bool measure(GlKind kind, double nanoseconds[ROW_COUNT])
{
    char error[1024];
    Meter *meter = meter_open(kind, error, sizeof error);
    if (!meter)
        fprintf(stderr, "matbench: %s\n", error);
    bool done = meter && time_rows(meter, nanoseconds);
    meter_close(meter);
    return done;
}

const Option bench_noise_options[] = {BENCH_UNTIMED, BENCH_GL, BENCH_HELP};

int bench_noise(const BenchOptions *options)
{
    double nanoseconds[ROW_COUNT];
    for (int i = 0; i < ROW_COUNT; i++)
        nanoseconds[i] = NAN;
    if (options->timed && !measure(options->gl, nanoseconds))
        return 1;
    printf("%-54s ns a pixel  times faster\n", "four octaves");
    for (int i = 0; i < ROW_COUNT; i++)
        printf("%-54s %10s %13s\n", rows[i].name, NUMBER(3, nanoseconds[i]),
               NUMBER(2, nanoseconds[0] / nanoseconds[i]));
    return 0;
}
