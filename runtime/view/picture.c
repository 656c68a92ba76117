/* A compiled material as the view wants it: its texts, textures and uniforms' defaults. */
#include "runtime/view/picture.h"
#include "compiler/evaluate.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/message.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    ViewProgram program;
    ViewTexture *textures;
    ProgramValue *uniforms;
    float (*numbers)[4]; /* of the uniforms */
    void *constants;
} Parts;

static void *array(int count, size_t size)
{
    void *made = calloc((size_t)count + 1, size);
    if (!made)
        abort();
    return made;
}

static void take_textures(Parts *parts, MatcProgram *program)
{
    int count = matc_texture_count(program);
    parts->textures = array(count, sizeof *parts->textures);
    for (int i = 0; i < count; i++) {
        MatcTexture t = *matc_texture(program, i);
        TextureSpec spec = {t.width, t.height, t.lanes, t.bytes, t.floats, false, true, t.mipmaps};
        parts->textures[i] = (ViewTexture){t.name, spec};
    }
    parts->program.textures = parts->textures;
    parts->program.texture_count = count;
}

static void take_uniforms(Parts *parts, const MatcProgram *program)
{
    int count = matc_uniform_count(program);
    parts->uniforms = array(count, sizeof *parts->uniforms);
    parts->numbers = array(count, sizeof *parts->numbers);
    for (int i = 0; i < count; i++) {
        MatcUniform u = *matc_uniform(program, i);
        for (int lane = 0; lane < u.lanes; lane++)
            parts->numbers[i][lane] = (float)u.initial[lane];
        parts->uniforms[i] = (ProgramValue){u.name, u.lanes, parts->numbers[i]};
    }
    parts->program.uniforms = parts->uniforms;
    parts->program.uniform_count = count;
}

static void take_constants(Parts *parts, const MatcProgram *program)
{
    parts->program.constant_bytes = (size_t)matc_constant_bytes(program);
    parts->constants = array((int)parts->program.constant_bytes + 1, 1);
    matc_constant_block(program, parts->constants);
    parts->program.constants = parts->constants;
}

static void take_targets(Parts *parts, const MatcProgram *program)
{
    int count = matc_target_count(program);
    parts->program.target_count = count < VIEW_TARGETS ? count : VIEW_TARGETS;
    for (int i = 0; i < parts->program.target_count; i++)
        parts->program.targets[i] = framebuffer_format(matc_target_format(program, i));
}

static bool draw(MatcProgram *program, const ViewOptions *view, unsigned char *rgb, char *error, size_t room)
{
    Parts parts = {.program = {.vertex_text = matc_output(program, MATC_VERTEX, NULL),
                               .fragment_text = matc_output(program, MATC_FRAGMENT, NULL),
                               .unpack_text = matc_output(program, MATC_UNPACK, NULL)}};
    take_textures(&parts, program);
    take_uniforms(&parts, program);
    take_constants(&parts, program);
    take_targets(&parts, program);
    bool done = view_render(view, &parts.program, rgb, error, room);
    free(parts.textures);
    free(parts.uniforms);
    free(parts.numbers);
    free(parts.constants);
    return done;
}

/* The azimuth at which the material is brightest a little above the horizon, by the C reference: there it is worth looking. A
 * direction that takes too long is no number, and never the brightest. */
static double find_azimuth(const MatcDocument *document, int material, const MatcOptions *options)
{
    enum { STEPS = 72 };
    const double step = 6.283185307179586 / STEPS, height = 0.3;
    Surface surfaces[STEPS];
    SlotValues values[STEPS];
    double best = 0, azimuth = 0;
    for (int i = 0; i < STEPS; i++) {
        oracle_surface_default(&surfaces[i]);
        double *position = &surfaces[i].root[channel_id(GROUP_X, 0)];
        position[0] = cos(i * step);
        position[1] = sin(i * step);
        position[2] = height;
    }
    evaluate_material(document, material, options, (SurfacePoints){surfaces, STEPS}, values);
    for (int i = 0; i < STEPS; i++) {
        const double *rgb = values[i].lane[SLOT_emissive], bright = rgb[0] + rgb[1] + rgb[2];
        azimuth = bright > best ? i * step : azimuth;
        best = bright > best ? bright : best;
    }
    return azimuth;
}

bool picture_draw(const MatcDocument *document, int material, const PictureOptions *options, unsigned char *rgb,
                  char **diagnostics, char *error, size_t room)
{
    ViewOptions view = options->view;
    unsigned unpack = view.sky ? 0 : MATC_UNPACK;
    *error = 0;
    MatcProgram *program = matc_compile(document, material, MATC_FRAGMENT | MATC_VERTEX | unpack, &options->compile);
    bool done = matc_ok(program);
    *diagnostics = strdup(matc_program_diagnostics(program, MATC_TEXT));
    if (done && view.sky)
        view.azimuth = find_azimuth(document, material, &options->compile);
    if (done)
        done = draw(program, &view, rgb, error, room);
    matc_program_free(program);
    return done;
}
