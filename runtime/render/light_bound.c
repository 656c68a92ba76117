/* Many lights: which are summed at each pixel, and which are taken together, so that the picture as it is shown is within half a step of 8 bits,
 * 1/510, of the sum of all. pass_gather.glsl does it, for each block of 16 x 16 pixels by itself:
 *
 *  1. Pixels that lie near each other are a group, with a centre c, a greatest distance from it, a cone of normals. Most blocks have one.
 *  2. A light that all of the group sees whole is a series around c (far_terms.glsl), whose rest is bounded; one that no pixel sees is nothing; any
 *     other is bounded by the most that it can give. Gloss of a light that is taken together is left out, and bounded too.
 *  3. E, what all whole lights give at least to each pixel, is a lower bound of the light. The bounds of what is taken together, the smallest first,
 *     may sum up to r E + a; what does not go into that is summed at each pixel.
 *
 * A pixel's light L is then off by r L + a at most, in each lane, whatever its colour is. r and a are such that this is less than a step's half after
 * exposure, tone mapping and the encoding as sRGB, whose slope T' may be steep: (r L + a) T'(L) <= 1/510 for every L. Clamp's slope is 12.92 at most,
 * where it is dark, and L T'(L) is 0.44 at most, where it is white: r = 0.9 / 0.44 / 510 and a = 0.9 / 12.92 / 510 leave 1/510 * 0.98 of it.
 * Filmic's are 0.286 and 6.395, of which 0.7 / 510 leave 0.93: see below. tests/test_frame_lights.c tries every L.
 *
 * Edges mix two such pixels by shares s and 1 - s once they are mapped, before the encoding e: of y = m(L), as it is mapped, off by d(y), they make
 * y = s y1 + (1 - s) y2, off by s d(y1) + (1 - s) d(y2). Let D be a concave function that is nowhere less than d: then this is D(y) at most, and all that
 * is to be shown is |e(y + D(y)) - e(y)| <= 1/510 and the same of y - D(y). The slope of e plays no part, which at sRGB's join jumps from 12.92 to 12.70.
 *
 *   Clamp: d(y) = r y + a, also where it is cut at 1, is a line, so concave itself: D = d, and what holds for each L holds for a mixture.
 *   Filmic: D is the least concave function that is not below d; it exceeds d by less than 1e-5 of it, and takes 0.93 of 1/510.
 *
 * The test mixes every two of 150 strengths of light, each off by as much as it may be. */
#include "runtime/render/frame.h"
#include <string.h>

enum {
    LEAST_HARDWARE = 128, /* lights from which on it takes less time */
    LEAST_SOFTWARE = 256,
    MOST = 4096,       /* whose bits an invocation group has room for */
    BINDINGS = 6,      /* points at which storage buffers are bound: 4 and 5 */
    STORAGE_BLOCKS = 3 /* of a program: two, and lists of what is transparent in shadow maps */
};

static const double half_step = 1. / 510;

/* Shares of half a step over the greatest L T'(L), and over the greatest T'(L), with exposure 0. */
static const struct {
    SceneKind tone;
    double relative, absolute;
} budgets[] = {{SCENE_Clamp, .9 / .4398, .9 / 12.92}, {SCENE_Filmic, .7 / .286, .7 / 6.395}};

/* Other tone mappings ask the whole picture: what a pixel is off moves all of them. */
bool light_far_budget(SceneKind tone, double budget[2])
{
    for (size_t i = 0; i < sizeof budgets / sizeof *budgets; i++)
        if (budgets[i].tone == tone) {
            budget[0] = budgets[i].relative * half_step;
            budget[1] = budgets[i].absolute * half_step;
            return true;
        }
    return false;
}

static int count_lights(const Scene *scene)
{
    int count = 0;
    for (int i = 0; i < scene->light_count; i++)
        count += view_space_section(&scene->lights[i], false) < VIEW_SPACE_AREAS;
    return count;
}

int light_far_most(const Render *render)
{
    int most = 512;
    while (most < count_lights(render->scene))
        most *= 2;
    return most;
}

static bool is_way(const RenderOptions *options, const char *way)
{
    return !strcmp(options->lights ? options->lights : "auto", way);
}

bool light_far_check(GlContext *gl, const RenderOptions *options)
{
    return is_way(options, "auto") || is_way(options, "all") || is_way(options, "bounded") ||
           gl_fail(gl, "lights are auto, all or bounded, not '%s'", options->lights);
}

/* The picture has 8 bits, and nothing else is asked for. */
static bool is_shown(const RenderOptions *options)
{
    return !options->deep && !options->linear && (!options->view || !strcmp(options->view, "shown"));
}

static bool has_buffers(const GlContext *gl)
{
    GLint blocks = 0, bindings = 0;
    gl->GetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    return blocks >= STORAGE_BLOCKS && bindings >= BINDINGS;
}

/* What hinders it, also where it is insisted on. */
static const char *find_lack(const Render *render, int count)
{
    double budget[2];
    if (count == 0)
        return "nothing to do";
    if (is_way(&render->options, "all"))
        return "all lights are asked for";
    if (count > MOST)
        return "there are more than 4096 lights";
    if (!light_far_budget(render->scene->tone, budget))
        return "the tone mapping asks the whole picture";
    if (!render->surface->parts)
        return "nothing bounds the surface model";
    if (render->parted)
        return "shadows are made in parts";
    if (shadow_sheet_needed(render))
        return "a plane's shadows are known pixel by pixel";
    return render->compute && has_buffers(render->gl) ? NULL : "it takes compute with three storage buffers";
}

const char *light_far_lacks(const Render *render)
{
    const int count = count_lights(render->scene), least = render->gl->hardware ? LEAST_HARDWARE : LEAST_SOFTWARE;
    const char *lack = find_lack(render, count);
    if (lack || is_way(&render->options, "bounded"))
        return lack;
    return count < least ? "lights are few" : is_shown(&render->options) ? NULL : "more than 8 bits are asked for";
}

bool light_far_used(const Render *render) { return !light_far_lacks(render); }
