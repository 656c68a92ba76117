/* The pass rays: from depth, G-buffer and light to openness and indirect light. Its GLSL is pass_rays.glsl, behind indirect_place.glsl and that of the
 * method. */
#include "runtime/render/frame.h"
#include <stdio.h>
#include <string.h>

extern const char render_text_indirect_place[], render_text_indirect_march[], render_text_pass_rays[];

enum { DEPTH_UNIT = FRAMEBUFFER_COLORS, LIGHT_UNIT, DEFINITIONS = 640, BLOCK_HEAD = 4 };

bool pass_rays_needed(const Render *render) { return indirect_is(render); }

static bool shows_bent(const Render *render) { return render->options.view && !strcmp(render->options.view, "bent"); }

static void define(const Render *render, char text[DEFINITIONS])
{
    const SceneIndirect *in = &render->scene->indirect;
    const bool uniform = in->distribution == WORD_Distribution_uniform;
    snprintf(text, DEFINITIONS,
             "#define INDIRECT_RAYS %d\n#define INDIRECT_STEPS %d\n#define INDIRECT_WEIGHT %d\n"
             "#define INDIRECT_ROTATION %d\n#define INDIRECT_JITTER %s\n%s%s%s%s%s",
             in->rays, in->steps, (int)(in->weight - WORD_Weight_none), (int)(in->rotation - WORD_Rotation_none),
             in->jitter ? "1.0" : "0.0",
             uniform ? "#define INDIRECT_UNIFORM\n#define INDIRECT_SHARE(cosine) (2.0 * (cosine))\n"
                     : "#define INDIRECT_SHARE(cosine) 1.0\n",
             in->march == WORD_March_picture ? "#define INDIRECT_PICTURE\n" : "",
             in->checked ? "#define INDIRECT_CHECKED\n" : "",
             in->bounces > 0 && !shows_bent(render) ? "#define INDIRECT_LIGHT\n" : "",
             shows_bent(render) ? "#define INDIRECT_BENT\n" : "");
}

static const char no_surface[] = "struct Surface { float nothing; };\n";

/* The block Indirect. Where no offset is said, rays begin so far off that the surface which they leave is not met: a place of it is up to sqrt(1/2) of a
 * pixel beside the middle of its pixel, by which depth is off as by a lift of as much. */
void pass_rays_place(Render *render)
{
    const double lift = .75;
    const SceneIndirect *in = &render->scene->indirect;
    ScreenPass *pass = &render->indirect.rays;
    float block[BLOCK_HEAD + INDIRECT_RAYS_MOST][4] = {{0}};
    double samples[INDIRECT_RAYS_MOST][2];
    if (!pass->material.store)
        return;
    memcpy(block[0], render->space.ray, sizeof block[0]);
    memcpy(block[1], render->space.depth, sizeof block[1]);
    block[2][0] = (float)indirect_radius(render->scene, &render->cache);
    block[2][1] = (float)in->offset;
    block[2][2] = in->offset > 0 ? 0 : (float)lift;
    block[2][3] = (float)in->contrast;
    for (int i = 0; i < 2; i++)
        block[3][i] = (float)render->size[i];
    indirect_samples(in->sequence, in->rays, samples);
    for (int i = 0; i < in->rays; i++)
        for (int k = 0; k < 2; k++)
            block[BLOCK_HEAD + i][k] = (float)samples[i][k];
    material_write(&pass->material, "Indirect", block, sizeof *block * (size_t)(BLOCK_HEAD + in->rays));
}

bool pass_rays_make(Render *render)
{
    char defined[DEFINITIONS], name[] = "matc_gbuffer0";
    ScreenPass *pass = &render->indirect.rays;
    define(render, defined);
    const ScreenPassText text = {.body = {render->set.unpack ? render->set.unpack : no_surface, defined,
                                          render_text_indirect_place, render_text_indirect_march,
                                          render_text_pass_rays},
                                 .format = frame_format(render, FRAME_TARGET_open, 0),
                                 .compute = render->compute};
    if (!screen_pass_make(render->store, &text, pass))
        return false;
    for (int i = 0; set_format(&render->set, i); i++) {
        name[sizeof name - 2] = (char)('0' + i);
        screen_pass_sampler(pass, name, i);
    }
    screen_pass_sampler(pass, "indirect_depth", DEPTH_UNIT);
    screen_pass_sampler(pass, "indirect_light", LIGHT_UNIT);
    pass_rays_place(render);
    return true;
}

void pass_rays_draw(Render *render)
{
    for (int i = 0; frame_format(render, FRAME_TARGET_gbuffer, i); i++)
        texture_bind(render->gl, frame_texture(render, FRAME_TARGET_gbuffer, i), i);
    texture_bind(render->gl, frame_texture(render, FRAME_TARGET_depth, 0), DEPTH_UNIT);
    if (render->plan.there >> FRAME_TARGET_light & 1)
        texture_bind(render->gl, frame_texture(render, FRAME_TARGET_light, 0), LIGHT_UNIT);
    screen_pass_run(&render->indirect.rays, &render->draws[FRAME_DRAW_open], &render->screen);
}
