/* Steps of a parallel reduction, each with its own target. Their GLSL is measure.glsl. */
#include "runtime/gpu_material/measure.h"
#include "gen/render_text.h"
#include <math.h>

static bool make_step(Store *store, const int size[2], bool compute, const char *const *texts,
                      Measure *made)
{
    const int step = made->count;
    const FramebufferSpec spec = {.width = 3 * ((size[0] + MEASURE_BLOCK - 1) / MEASURE_BLOCK),
                                  .height = (size[1] + MEASURE_BLOCK - 1) / MEASURE_BLOCK,
                                  .color_count = 1,
                                  .color_format = GL_RGBA32F};
    ScreenPassText text = {.format = "RGBA32F", .compute = compute};
    int count = 0;
    for (; texts[count]; count++)
        text.body[count] = texts[count];
    text.body[count] = render_text_measure;
    if (!framebuffer_make(store_context(store), &spec, &made->targets[step]))
        return false;
    made->count++;
    ScreenPass *pass = &made->passes[step];
    if (!screen_pass_make(store, &text, pass))
        return false;
    material_set_number(&pass->material, "measure_width", (float)size[0]);
    material_set_number(&pass->material, "measure_height", (float)size[1]);
    material_set_number(&pass->material, "measure_first", step == 0);
    screen_pass_sampler(pass, "measure_from", 0);
    return true;
}

bool measure_make(Store *store, const int size[2], bool compute, const char *const *texts,
                  Measure *made)
{
    int left[2] = {size[0], size[1]};
    *made = (Measure){0};
    do {
        if (!make_step(store, left, compute, texts, made)) {
            measure_delete(store_context(store), made);
            return false;
        }
        for (int i = 0; i < 2; i++)
            left[i] = (left[i] + MEASURE_BLOCK - 1) / MEASURE_BLOCK;
    } while (left[0] > 1 || left[1] > 1);
    return true;
}

void measure_run(Measure *measure, GLuint picture, const Screen *screen)
{
    for (int i = 0; i < measure->count; i++) {
        GlContext *gl = store_context(measure->passes[i].material.store);
        texture_bind(gl, i ? measure->targets[i - 1].colors[0] : picture, 0);
        screen_pass_run(&measure->passes[i], &measure->targets[i], screen);
    }
}

void measure_set_part(Measure *measure, const int part[2][2])
{
    Material *first = &measure->passes[0].material;
    material_set_number(first, "measure_x", (float)part[0][0]);
    material_set_number(first, "measure_y", (float)part[0][1]);
    material_set_number(first, "measure_width", (float)part[1][0]);
    material_set_number(first, "measure_height", (float)part[1][1]);
}

bool measure_read(const Measure *measure, float texels[MEASURE_TEXELS][4])
{
    GlContext *gl = store_context(measure->passes[0].material.store);
    return framebuffer_read(gl, &measure->targets[measure->count - 1], 0, texels[0]);
}

void measure_merge(float texels[MEASURE_TEXELS][4], const float other[MEASURE_TEXELS][4])
{
    for (int i = 0; i < 4; i++) {
        texels[0][i] = fmaxf(texels[0][i], other[0][i]);
        texels[1][i] += other[1][i];
        texels[2][i] = i < 2 ? texels[2][i] + other[2][i] : fminf(texels[2][i], other[2][i]);
    }
}

GLuint measure_result(const Measure *measure)
{
    return measure->targets[measure->count - 1].colors[0];
}

void measure_delete(GlContext *gl, Measure *measure)
{
    for (int i = 0; i < measure->count; i++) {
        framebuffer_delete(gl, &measure->targets[i]);
        screen_pass_delete(&measure->passes[i]);
    }
    *measure = (Measure){0};
}
