/* Texts of the surface models. If a scene has both, their texts follow each other, with names
 * made distinct by macros, followed by a text that selects per pixel. */
#include "runtime/surface/surface_model.h"
#include "compiler/layout/layout.h"
#include "gen/render_text.h"
#include <stdio.h>

#define RENAMED(model)                                                                             \
    "#define Lit " model "Lit\n#define surfaceLit " model "SurfaceLit\n"                           \
    "#define surfaceOwn " model "Own\n#define surfaceAmbient " model                               \
    "Ambient\n#define surfaceEven " model "Even\n"                                                 \
    "#define surfaceLobe " model "Lobe\n#define surfaceSky " model                                 \
    "Sky\n#define surfaceArea " model "Area\n"                                                     \
    "#define surfaceHemisphere " model "Hemisphere\n#define surfaceMatt " model "Matt\n"           \
    "#define surfaceAreaSides " model "AreaSides\n#define surfaceAreaSide " model "AreaSide\n"
#define UNNAMED                                                                                    \
    "#undef Lit\n#undef surfaceLit\n#undef surfaceOwn\n#undef surfaceAmbient\n"                    \
    "#undef surfaceEven\n#undef surfaceLobe\n#undef surfaceSky\n#undef surfaceArea\n#undef "       \
    "surfaceHemisphere\n#undef "                                                                   \
    "surfaceMatt\n"                                                                                \
    "#undef surfaceAreaSides\n#undef surfaceAreaSide\n"

const SurfaceModel surface_model_phong = {.name = "Phong",
                                          .text = render_text_surface_phong,
                                          .parts = true,
                                          .more = {render_text_surface_through}};
const SurfaceModel surface_model_principled = {
    .name = "Principled",
    .text = render_text_surface_microfacets,
    .more = {render_text_surface_anisotropic, render_text_surface_principled,
             render_text_surface_principled_light, render_text_surface_through}};
static const SurfaceModel both = {.name = "Phong and Principled",
                                  .text = render_text_surface_microfacets,
                                  .more = {render_text_surface_anisotropic, RENAMED("phong"),
                                           render_text_surface_phong, UNNAMED RENAMED("principled"),
                                           render_text_surface_principled,
                                           render_text_surface_principled_light,
                                           render_text_surface_both, render_text_surface_through}};

const SurfaceModel *surface_model_of(const LayoutRow *layout, unsigned models)
{
    if (!layout || !layout_has_slot(layout, SLOT_model))
        return &surface_model_phong;
    const FixedRow *fixed = layout_fixed(layout, SLOT_model);
    models = fixed ? 1u << (unsigned)fixed->value[0] : models;
    models &= (1u << MODEL_COUNT) - 1;
    if (models == 1u << MODEL_Principled)
        return &surface_model_principled;
    return models >> MODEL_Principled & 1 ? &both : &surface_model_phong;
}

void surface_model_define(unsigned models, char text[SURFACE_MODEL_DEFINITIONS])
{
    char *end = text;
    *text = 0;
    for (int lobe = 0; lobe < LOBE_COUNT; lobe++)
        if (!(models & MODEL_LOBE(lobe)))
            end += snprintf(end, SURFACE_MODEL_DEFINITIONS - (size_t)(end - text),
                            "#define SURFACE_MISSING_%s\n", lobe_table[lobe].name);
}
