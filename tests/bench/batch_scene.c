/* Savings in a scene of 500 materials, a usual number in a game: programs that differ in
 * constants only are shared, layouts are made for the set of materials, and a pass computes only
 * its own outputs. Each saving is measured by comparison with the same scene without it. */
#include "batch.h"
#include "batch_documents.h"
#include "batch_draw.h"
#include "matbench.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MATERIALS = 500,
    EVERY = 5 /* every fifth material is timed */,
    SIDE = 128,
    SIDE_OF_GPU = 2048,
    ROUNDS = 5
};

typedef struct {
    const char *layout, *constants;
} Setting;
static const Setting settings[] = {
    {"thesis", "baked"},    {"thesis", "auto"}, {"compact", "baked"}, {"compact", "auto"},
    {"compact", "uniform"}, {"auto", "baked"},  {"auto", "auto"},
};
enum { SETTINGS = sizeof settings / sizeof *settings };

static void write_document(int index, Text *out)
{
    const char *family;
    batch_scene(index, out, &family);
}

static void name_of(const Setting *setting, char name[32])
{
    snprintf(name, 32, "%s-%s", setting->layout, setting->constants);
}

static bool compile(const BatchFolder *folder, const Setting *setting, const char *out)
{
    char layout[64], constants[64];
    BatchTimes times;
    snprintf(layout, sizeof layout, "--layout=%s", setting->layout);
    snprintf(constants, sizeof constants, "--constants=%s", setting->constants);
    return batch_run(
        folder, "s", out,
        (const char *const[]){"-j", "2", "--no-validate", "--pass=gbuffer,shadow,depth",
                              "--emit=glsl,vertex,reflect,unpack", layout, constants, NULL},
        &times);
}

/* Counts programs of a pass, NULL for all, and the bytes of their fragment texts. */
static int count_programs(const BatchOutput *output, const char *pass, size_t *bytes)
{
    const cJSON *program;
    int count = 0;
    *bytes = 0;
    cJSON_ArrayForEach(program, cJSON_GetObjectItem(output->manifest, "programs"))
    {
        const cJSON *fragment = cJSON_GetObjectItem(program, "fragment");
        if (pass && strcmp(cJSON_GetObjectItem(program, "pass")->valuestring, pass) != 0)
            continue;
        char *text =
            fragment ? batch_read(output->folder, output->out, fragment->valuestring) : NULL;
        *bytes += text ? strlen(text) : 0;
        free(text);
        count++;
    }
    return count;
}

static size_t unpack_bytes(const BatchOutput *output)
{
    const cJSON *name =
        cJSON_GetObjectItem(cJSON_GetObjectItem(output->manifest, "layout"), "unpack");
    char *text = name ? batch_read(output->folder, output->out, name->valuestring) : NULL;
    size_t bytes = text ? strlen(text) : 0;
    free(text);
    return bytes;
}

/* Sum over the timed materials of nanoseconds per pixel; the variants of one material are timed
 * alternately. */
static bool time_material(Meter *meter, BatchOutput *outputs, int material, const Field *field,
                          double *sums)
{
    Material materials[SETTINGS] = {0};
    MeterDraw timed[SETTINGS];
    double nanoseconds[SETTINGS];
    bool fine = true;
    for (int i = 0; i < SETTINGS && fine; i++) {
        fine = batch_draw_make(meter, &outputs[i], material, &materials[i]);
        timed[i] = (MeterDraw){&materials[i], field, &outputs[i].targets};
    }
    fine = fine && meter_time(meter, timed, SETTINGS, ROUNDS, nanoseconds);
    for (int i = 0; i < SETTINGS; i++) {
        sums[i] += fine ? nanoseconds[i] : 0;
        material_delete(&materials[i]);
    }
    return fine;
}

static bool time_outputs(BatchOutput *outputs, GlKind gl, double *means)
{
    char error[4096];
    FieldVertex plane[PLANE_VERTICES];
    Field field = {0};
    int side = gl == GL_KIND_osmesa ? SIDE : SIDE_OF_GPU;
    Meter *meter = meter_open(gl, error, sizeof error);
    sample_plane(plane, &(PlaneView){.yaw = 0.3, .scale = 1, .aspect = 1, .height = side});
    bool fine = meter && field_make(meter->gl, plane, PLANE_VERTICES, GL_TRIANGLE_STRIP, &field);
    for (int i = 0; i < SETTINGS && fine; i++)
        fine = batch_output_targets(&outputs[i], meter, side, side);
    for (int m = 0; m < MATERIALS && fine; m += EVERY) {
        char what[64];
        snprintf(what, sizeof what, "material %d of %d is timed", m, MATERIALS);
        bench_show(what);
        fine = time_material(meter, outputs, m, &field, means);
    }
    bench_show("");
    for (int i = 0; i < SETTINGS; i++)
        means[i] /= MATERIALS / EVERY;
    if (!fine)
        fprintf(stderr, "matbench: %s\n", meter ? meter->error : error);
    for (int i = 0; i < SETTINGS && meter; i++)
        framebuffer_delete(meter->gl, &outputs[i].targets);
    if (meter)
        field_delete(meter->gl, &field);
    meter_close(meter);
    return fine;
}

static void put_row(const BatchOutput *output, const Setting *setting, double nanoseconds)
{
    size_t gbuffer, all;
    int programs = count_programs(output, "gbuffer", &gbuffer);
    int passes = count_programs(output, NULL, &all) - programs;
    const cJSON *bytes =
        cJSON_GetObjectItem(cJSON_GetObjectItem(output->manifest, "layout"), "bytes");
    printf("%-9s%-10s %8d %10zu %12d %10zu %8d %8zu %9s\n", setting->layout, setting->constants,
           programs, gbuffer, passes, all - gbuffer, bytes ? bytes->valueint : 0,
           unpack_bytes(output), NUMBER(2, nanoseconds));
}

bool batch_measure_scene(BatchFolder *folder, GlKind gl, bool timed)
{
    BatchOutput outputs[SETTINGS] = {0};
    char names[SETTINGS][32];
    double means[SETTINGS] = {0};
    bool fine = batch_folder_fill(folder, "s", MATERIALS, write_document);
    for (int i = 0; i < SETTINGS && fine; i++) {
        name_of(&settings[i], names[i]);
        fine = compile(folder, &settings[i], names[i]) &&
               batch_output_read(&outputs[i], folder, names[i]);
    }
    fine = fine && (!timed || time_outputs(outputs, gl, means));
    if (fine)
        printf("\na scene of %d materials\n%-19s %8s %10s %12s %10s %8s %8s %9s\n%-9s%-10s %8s "
               "%10s %12s %10s %8s %8s "
               "%9s\n",
               MATERIALS, "", "G-buffer", "bytes of", "shadow and", "bytes of", "bytes", "bytes of",
               "ns a pixel", "layout", "constants", "programs", "GLSL", "depth progr.", "GLSL",
               "a pixel", "unpack", gl == GL_KIND_osmesa ? "(llvmpipe)" : "(GPU)");
    for (int i = 0; i < SETTINGS; i++) {
        if (fine)
            put_row(&outputs[i], &settings[i], timed ? means[i] : NAN);
        batch_output_delete(&outputs[i], NULL);
    }
    return fine;
}
