/* Many lights: which are summed at each pixel, and which are taken together, so that the picture as
 * it is shown is within half a step of 8 bits, 1/510, of the sum of all. pass_groups.glsl,
 * pass_near.glsl and pass_gather.glsl do it, for each block of 32 x 32 pixels by itself:
 *
 *  1. Pixels that lie near each other are a group, with a centre c, a greatest distance from it, a
 *     cone of normals. Most blocks have one; a
 *     block that shows a box has one for each side, as a light that one side sees another may not.
 *  2. A light that all of the group sees whole is a series around c (far_terms.glsl), whose rest is
 *     bounded; one that no pixel sees is nothing; any
 *     other is bounded by the most that it can give. Gloss of a light that is taken together is
 *         linear around c (far_lobe.glsl) or left out, whichever
 *     has the lesser bound.
 *  3. E, what all whole lights give at least to each pixel, is a lower bound of the light. The
 *     bounds of what is taken together, the smallest first,
 *     may sum up to r E + a; what does not go into that is summed at each pixel.
 *
 * A pixel's light L is then off by r L + a at most, in each lane, whatever its colour is. r and a
 * are such that this is less than a step's half after exposure, tone mapping m and the encoding e
 * as sRGB. Edges and samples mix pixels by shares s once they are mapped, before e: if y = m(L) is
 * off by d(y), the mixture is off by the sum of s d(y). Let D be a concave function that is nowhere
 * less than d: then that is D(y) at most, of the mixture's y, and all that is to be shown is e(y) -
 * e(y - D(y)) <= 1/510; upwards e rises less, since it is concave.
 *
 *   Clamp: D(y) = r y + a, also where it is cut at 1. y e'(y) is 0.44 at most, where y is 1, and e'
 *   is 12.92 at most: 0.9 of half a step over each
 *      is their share, and leaves room for squares of r below.
 *   Shoulder: the same. m is concave and m(L) <= L, so that m(L) - m(L - d) <= m(L) d / L, which is
 *   r m(L) + a at most for d = r L + a. Exponential: a lane x of the greatest g is shown as y = x
 *   h(g), h(g) = (1 - exp(-g)) / g, and g h'(g) lies between -h(g) and 0. With s = -g h'(g) / h(g),
 *      y is off by h (r x + a) + x h s (r g + a) / g <= 2 r y + a h (1 + s), and h (1 + s) <= 1: so
 *          D(y) = 2 r y + a, where r is half of Clamp's.
 *   Linear: y = x / g with g the greatest lane of the picture, both off by r: D(y) = 2 r y / (1 -
 *   r). a is 0, as a / g has no bound. Filmic: D(y) is the lesser of 2.6 r y + 0.6 a and 0.85 r y +
 *   3.65 a.
 *   OpenEXR as halves, which are light itself: steps of 2^-11 of it at least, so r is 0.9 / 2^12,
 *   and a is 0.
 *
 * ReinhardDevlin stretches what it maps from its least to its greatest, and Drago counts the pixels
 * that are brighter than some: both may jump. What has steps of 1/65535, or none, would leave
 * hardly a light far.
 *
 * tests/renderer/light/test_light_bound.c proves what is said of e and of Filmic, by intervals and
 * by the signs of polynomials, and tries the rest; test_far_terms.c tries the bounds of the series
 * and of gloss. */
#include "runtime/light/light_far.h"
#include "runtime/shadow/shadow.h"
#include <string.h>

enum {
    LEAST_HARDWARE = 128, /* lights from which on it takes less time */
    LEAST_SOFTWARE = 256,
    MOST = 4096,        /* whose bits an invocation group has room for */
    BINDINGS = 6,       /* points at which storage buffers are bound: 4 and 5 */
    STORAGE_BLOCKS = 3, /* of a program: two, and lists of what is transparent in shadow maps */
    /* of a program: six of a G-buffer, depth, lights, a sky, shadows, and the two buffers */
    TEXTURES = 18
};

/* Clamp's, with exposure 0, and which part of them another takes. */
static const double relative = .9 / .4398 / 510, absolute = .9 / 12.92 / 510,
                    relative_of_halves = .9 / 4096;
static const struct {
    SceneKind tone;
    double relative, absolute;
} parts[] = {{SCENE_Clamp, 1, 1},
             {SCENE_Shoulder, 1, 1},
             {SCENE_Exponential, .5, 1},
             {SCENE_Linear, .49, 0},
             {SCENE_Filmic, 1.025, 1.346}};

bool light_far_budget(SceneKind tone, bool linear, double budget[2])
{
    budget[0] = relative_of_halves;
    budget[1] = 0;
    for (size_t i = 0; !linear && i < sizeof parts / sizeof *parts; i++)
        if (parts[i].tone == tone) {
            budget[0] = parts[i].relative * relative;
            budget[1] = parts[i].absolute * absolute;
            return true;
        }
    return linear;
}

static int count_lights(const Scene *scene)
{
    int count = 0;
    for (int i = 0; i < scene->light_count; i++)
        count += view_space_section(&scene->lights[i], false) < VIEW_SPACE_KINDS;
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

/* The picture has 8 bits or halves, and nothing else is asked for. */
static bool is_shown(const RenderOptions *options)
{
    return !options->deep && (!options->view || !strcmp(options->view, "shown"));
}

static bool has_buffers(const GlContext *gl)
{
    GLint blocks = 0, bindings = 0, textures = 0;
    gl->GetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    gl->GetIntegerv(GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS, &textures);
    return blocks >= STORAGE_BLOCKS && bindings >= BINDINGS && textures >= TEXTURES;
}

/* Reason why it cannot be used, even on request. */
static const char *find_lack(const Render *render, int count)
{
    double budget[2];
    if (count == 0)
        return "nothing to do";
    if (is_way(&render->options, "all"))
        return "all lights are asked for";
    if (count > MOST)
        return "there are more than 4096 lights";
    if (!light_far_budget(render->scene->tone, render->options.linear, budget))
        return "what the tone mapping makes of it has no bound";
    if (!render->surface->parts)
        return "nothing bounds the surface model";
    if (render->parted)
        return "shadows are made in parts";
    if (shadow_sheet_needed(render))
        return "a plane's shadows are known pixel by pixel";
    return render->compute && has_buffers(render->gl)
               ? NULL
               : "it takes compute with three storage buffers and 18 textures";
}

const char *light_far_lacks(const Render *render)
{
    const int count = count_lights(render->scene),
              least = render->gl->hardware ? LEAST_HARDWARE : LEAST_SOFTWARE;
    const char *lack = find_lack(render, count);
    if (lack || is_way(&render->options, "bounded"))
        return lack;
    return count < least                ? "lights are few"
           : is_shown(&render->options) ? NULL
                                        : "more than 8 bits, or halves, are asked for";
}

bool light_far_used(const Render *render) { return !light_far_lacks(render); }
