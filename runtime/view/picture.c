/* Compiles and draws; finds out where a sky is worth looking at. */
#include "runtime/view/picture.h"
#include "compiler/evaluate.h"
#include "runtime/gl/message.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

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

static const MatcUniform *find_uniform(const MatcProgram *program, const char *param)
{
    for (int i = 0; i < matc_uniform_count(program); i++)
        if (!strcmp(matc_uniform(program, i)->param, param))
            return matc_uniform(program, i);
    return NULL;
}

/* There is no such param: those that there are. */
static bool fail_unknown(const MatcProgram *program, const char *name, char *error, size_t room)
{
    size_t size = (size_t)snprintf(error, room, "--param: the material has no param '%s'%s", name,
                                   matc_uniform_count(program) ? "; it has" : " and no other");
    for (int i = 0; i < matc_uniform_count(program) && size < room; i++)
        size += (size_t)snprintf(error + size, room - size, "%s %s", i ? "," : "", matc_uniform(program, i)->param);
    return false;
}

/* Params as values of a program's uniforms. */
typedef struct {
    int colors; /* param_colors */
    Param params[PARAM_LIMIT];
    MaterialValue values[PARAM_LIMIT];
} Fitted;

static bool fit_params(const PictureOptions *options, const MatcProgram *program, Fitted *fitted, Picture *picture)
{
    const size_t room = sizeof picture->error;
    for (int i = 0; i < options->param_count; i++) {
        const MatcUniform *uniform = find_uniform(program, options->params[i].name);
        Param *param = &fitted->params[i];
        if (!uniform)
            return fail_unknown(program, options->params[i].name, picture->error, room);
        *param = options->params[i];
        if (!param_fit(param, uniform->lanes))
            return message_fail(picture->error, room, "--param: '%s' takes %d numbers, not %d", uniform->param,
                                uniform->lanes, param->lanes);
        fitted->values[i] = (MaterialValue){uniform->name, uniform->lanes, param->values[fitted->colors]};
    }
    return true;
}

bool picture_draw(MatcDocument *document, int material, const PictureOptions *options, Picture *picture)
{
    ViewOptions view = options->view;
    Fitted fitted = {.colors = param_colors(document)};
    const unsigned unpack = view.sky ? 0 : MATC_UNPACK;
    *picture->error = 0;
    view.values = fitted.values;
    view.value_count = options->param_count;
    MatcProgram *program = matc_compile(document, material, MATC_FRAGMENT | MATC_VERTEX | unpack, &options->compile);
    bool done = matc_ok(program);
    picture->diagnostics = strdup(matc_program_diagnostics(program, MATC_TEXT));
    if (done && view.sky)
        view.azimuth = find_azimuth(document, material, &options->compile);
    if (done)
        done = fit_params(options, program, &fitted, picture) &&
               view_render(&view, program, picture->rgb, picture->error, sizeof picture->error);
    matc_program_free(program);
    return done;
}
