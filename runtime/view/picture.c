/* Compiles and draws; finds out where a sky is worth looking at. */
#include "runtime/view/picture.h"
#include "compiler/evaluate.h"
#include <math.h>
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

bool picture_draw(const MatcDocument *document, int material, const PictureOptions *options, Picture *picture)
{
    ViewOptions view = options->view;
    const unsigned unpack = view.sky ? 0 : MATC_UNPACK;
    *picture->error = 0;
    MatcProgram *program = matc_compile(document, material, MATC_FRAGMENT | MATC_VERTEX | unpack, &options->compile);
    bool done = matc_ok(program);
    picture->diagnostics = strdup(matc_program_diagnostics(program, MATC_TEXT));
    if (done && view.sky)
        view.azimuth = find_azimuth(document, material, &options->compile);
    if (done)
        done = view_render(&view, program, picture->rgb, picture->error, sizeof picture->error);
    matc_program_free(program);
    return done;
}
