/* Varyings as linear functions over the pixels; one program per draw. */
#include "sheet.h"
#include <stdio.h>
#include <string.h>

void sheet_init(ContactSheet *sheet)
{
    memset(sheet, 0, sizeof *sheet);
    sheet->at.input[INPUT_N][2] = sheet->at.input[INPUT_eyeN][2] = 1;
    sheet->at.input[INPUT_DU][0] = sheet->at.input[INPUT_XU][0] = 1;
    sheet->at.input[INPUT_DV][1] = sheet->at.input[INPUT_XV][1] = 1;
}

void contact_sheet_set(ContactSheet *sheet, int component, double middle, double right, double up)
{
    static const Input inputs[] = {INPUT_X, INPUT_P, INPUT_U};
    for (int i = 0; i < 3; i++) {
        if (inputs[i] == INPUT_U && component == 2)
            continue;
        sheet->right.input[inputs[i]][component] = (float)right;
        sheet->up.input[inputs[i]][component] = (float)up;
        sheet->at.input[inputs[i]][component] =
            (float)(middle - right * (SHEET_WIDTH - 1) / 2 - up * (SHEET_HEIGHT - 1) / 2);
    }
}

static double varying(const ContactSheet *sheet, int input, int component, double right, double up)
{
    return sheet->at.input[input][component] +
           right * (double)sheet->right.input[input][component] +
           up * (double)sheet->up.input[input][component];
}

void sheet_surface(const ContactSheet *sheet, int pixel, double right, double up, Surface *surface)
{
    static const Input input[] = {[GROUP_P] = INPUT_P,   [GROUP_N] = INPUT_N, [GROUP_DU] = INPUT_DU,
                                  [GROUP_DV] = INPUT_DV, [GROUP_U] = INPUT_U, [GROUP_X] = INPUT_X};
    right += pixel % SHEET_WIDTH;
    up += pixel / SHEET_WIDTH;
    point_surface(&sheet->at, true, surface);
    for (Group group = 0; group < GROUP_R; group++)
        for (int component = 0; component < type_table[input_table[input[group]].type].components;
             component++)
            surface->root[channel_id(group, component)] =
                varying(sheet, (int)input[group], component, right, up);
}

/* The corners of drawer_fill, in pixels relative to the center of the lower left one. */
static void find_corners(const ContactSheet *sheet, Point corners[3])
{
    for (int corner = 0; corner < 3; corner++)
        for (int input = 0; input < POINT_VARYINGS; input++)
            for (int component = 0; component < 3; component++)
                corners[corner].input[input][component] = (float)varying(
                    sheet, input, component, (corner == 1 ? 2 * SHEET_WIDTH : 0) - 0.5,
                    (corner == 2 ? 2 * SHEET_HEIGHT : 0) - 0.5);
}

static void set_options(const Filtered *filtered, MatcOptions *options)
{
    matc_options_init(options);
    options->pass = "value";
    options->pixels = options->check = true;
    options->slot = filtered->slot;
    options->target = filtered->target ? filtered->target : options->target;
    options->aa = filtered->aa ? filtered->aa : options->aa;
    options->noise = filtered->noise ? filtered->noise : options->noise;
}

const char *drawers_open(Drawers *drawers)
{
    static const Point none;
    if (!drawer_open(&drawers->core, true, &none, 1))
        return drawers->core.error;
    return drawer_open(&drawers->old, false, &none, 1) ? NULL : drawers->old.error;
}

void drawers_close(Drawers *drawers)
{
    drawer_close(&drawers->core);
    drawer_close(&drawers->old);
}

static bool fail(Filtered *filtered, const char *text)
{
    snprintf(filtered->error, sizeof filtered->error, "%s: %.3000s", filtered->map, text);
    return false;
}

bool filtered_open(Filtered *f, Drawers *drawers)
{
    MatcOptions options;
    /* the parameter of Phong that holds the normal */
    const char *param = strcmp(f->slot, "normal") ? f->slot : "input";
    snprintf(f->text, sizeof f->text, "material: Phong\n%s: %s\n", param, f->map);
    if (!document_open_text(&f->document, f->text))
        return fail(f, document_fault(&f->document));
    set_options(f, &options);
    if (choice_job(&options, &f->job))
        return fail(f, "no such option");
    f->program = matc_compile(f->document.document, 0, MATC_FRAGMENT, &options);
    if (!matc_ok(f->program))
        return fail(f, matc_program_diagnostics(f->program, MATC_TEXT));
    f->shading = (Shading){.fragment = matc_output(f->program, MATC_FRAGMENT, NULL),
                           .target = f->job.target,
                           .program = f->program,
                           .graph = f->document.graph};
    f->drawer = target_table[f->job.target].in_out ? &drawers->core : &drawers->old;
    return drawer_material(f->drawer, &f->shading, &f->material) || fail(f, f->drawer->error);
}

void filtered_close(Filtered *f)
{
    material_delete(&f->material);
    matc_program_free(f->program);
    document_close(&f->document);
}

Oracle *filtered_oracle(const Filtered *f)
{
    ReferenceContext context = {.noise = job_noise(f->job.choice[AXIS_noise], f->job.target)};
    return oracle_open(f->document.graph, &context);
}

bool filtered_draw(Filtered *f, const ContactSheet *sheet, float (*rgba)[4])
{
    Point corners[3];
    find_corners(sheet, corners);
    return drawer_fill(f->drawer, &f->material, corners, *rgba) || fail(f, f->drawer->error);
}
