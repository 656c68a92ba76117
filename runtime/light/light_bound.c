/* Light clustering with an error bound: which lights are summed at each pixel, and which are
 * summed together per group of pixels, so that the displayed picture is within half a step of 8
 * bits, 1/510, of the sum of all lights. pass_groups.glsl, pass_near.glsl and
 * pass_light_cluster.glsl compute it, for each block of 32 x 32 pixels:
 *
 *  1. Pixels that are close to each other form a group, with a center c, a radius, and a cone of
 *     normals. Most blocks have one; a block that shows a box has one for each side, as a light
 *     may reach only one side.
 *  2. A light that reaches the whole group is expanded in a series around c (far_terms.glsl),
 *     whose remainder is bounded; a light that reaches no pixel is dropped; any other is bounded
 *     by its max. The specular part of lights that are summed together is linear around c
 *     (far_lobe.glsl) or omitted, whichever has the smaller bound.
 *  3. E, the min over pixels of all lights that reach the whole group, is a lower bound of a
 *     pixel's light. Lights are summed together in order of their bounds, smallest first, while
 *     the bounds sum up to at most r E + a; each pixel sums the remaining lights itself.
 *
 * The error of a pixel's light L is then at most r L + a in each color component. r and a are
 * such that the error is less than half a step after exposure, tone mapping m and the encoding e
 * as sRGB. Edges and samples mix pixels by shares s after tone mapping, before e: if y = m(L)
 * has an error of d(y), the mixture has the sum of s d(y). Let D be a concave function with D >=
 * d: then the error is at most D(y) of the mixture's y, and it remains to show e(y) - e(y -
 * D(y)) <= 1/510; upwards e rises less, since it is concave.
 *
 *   Clamp: D(y) = r y + a, also if y is clamped to 1. y e'(y) is at most 0.44, at y = 1, and e'
 *   is at most 12.92: r and a are 0.9 of half a step over each, which leaves a margin for
 *   squares of r below.
 *   Shoulder: as Clamp. m is concave and m(L) <= L, so that m(L) - m(L - d) <= m(L) d / L, which
 *   is at most r m(L) + a for d = r L + a.
 *   Exponential: a component x of the max g is mapped to y = x h(g), h(g) = (1 - exp(-g)) / g,
 *   and g h'(g) lies between -h(g) and 0. With s = -g h'(g) / h(g), the error of y is h (r x +
 *   a) + x h s (r g + a) / g <= 2 r y + a h (1 + s), and h (1 + s) <= 1: so D(y) = 2 r y + a,
 *   and r is half of Clamp's.
 *   Linear: y = x / g with g the max component of the picture, both with a relative error of r:
 *   D(y) = 2 r y / (1 - r). a is 0, as a / g has no bound.
 *   Filmic: D(y) is the lesser of 2.6 r y + 0.6 a and 0.85 r y + 3.65 a.
 *   OpenEXR with half floats stores light itself: relative steps of at least 2^-11, so r is 0.9
 *   / 2^12, and a is 0.
 *
 * ReinhardDevlin stretches the range between the picture's min and max, and Drago counts the
 * pixels above a threshold: both may jump. With steps of 1/65535, or none, hardly any light
 * would be far.
 *
 * tests/renderer/light/test_light_bound.c proves the claims about e and Filmic, by intervals and
 * by the signs of polynomials, and tries the others; test_far_terms.c tries the bounds of the
 * series and of specular lobes. */
#include "runtime/light/light_far.h"
#include "runtime/shadow/shadow.h"
#include <string.h>

enum {
    MIN_HARDWARE = 128, /* min number of lights at which clustering is faster */
    MIN_SOFTWARE = 256,
    MOST = 4096,        /* max lights, as bits that fit into shared memory of a work group */
    BINDINGS = 6,       /* needed bindings of storage buffers: up to point 5 */
    STORAGE_BLOCKS = 3, /* blocks per program: two, and the lists of transparent shadow casters */
    /* Needed per program: six of a G-buffer, depth, lights, a sky, shadows, and the two buffers. */
    TEXTURES = 18
};

/* Budgets of Clamp at exposure 0, and factors on them for other tone mappings. */
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

int light_far_most(const Renderer *renderer)
{
    int most = 512;
    while (most < count_lights(renderer->scene))
        most *= 2;
    return most;
}

static bool is_way(const RendererOptions *options, const char *way)
{
    return !strcmp(options->lights ? options->lights : "auto", way);
}

bool light_far_check(GlContext *gl, const RendererOptions *options)
{
    return is_way(options, "auto") || is_way(options, "all") || is_way(options, "bounded") ||
           gl_fail(gl, "lights are auto, all or bounded, not '%s'", options->lights);
}

/* Reports whether the picture has 8 bits or half floats, and is the requested view. */
static bool is_shown(const RendererOptions *options)
{
    return !options->deep && (!options->view || !strcmp(options->view, "final"));
}

static bool has_buffers(const GlContext *gl)
{
    GLint blocks = 0, bindings = 0, textures = 0;
    gl->GetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    gl->GetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    gl->GetIntegerv(GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS, &textures);
    return blocks >= STORAGE_BLOCKS && bindings >= BINDINGS && textures >= TEXTURES;
}

/* Returns the reason why clustering cannot be used, even on request; NULL if it can. */
static const char *find_lack(const Renderer *renderer, int count)
{
    double budget[2];
    if (count == 0)
        return "nothing to do";
    if (is_way(&renderer->options, "all"))
        return "all lights are asked for";
    if (count > MOST)
        return "there are more than 4096 lights";
    if (!light_far_budget(renderer->scene->tone, renderer->options.linear, budget))
        return "what the tone mapping makes of it has no bound";
    if (!renderer->surface->parts)
        return "nothing bounds the surface model";
    if (renderer->tiled)
        return "shadows are made in parts";
    if (plane_transmittance_needed(renderer))
        return "a plane's shadows are known pixel by pixel";
    return renderer->compute && has_buffers(renderer->gl)
               ? NULL
               : "it takes compute with three storage buffers and 18 textures";
}

const char *light_far_missing(const Renderer *renderer)
{
    const int count = count_lights(renderer->scene),
              least = renderer->gl->hardware ? MIN_HARDWARE : MIN_SOFTWARE;
    const char *lack = find_lack(renderer, count);
    if (lack || is_way(&renderer->options, "bounded"))
        return lack;
    return count < least                  ? "lights are few"
           : is_shown(&renderer->options) ? NULL
                                          : "more than 8 bits, or halves, are asked for";
}

bool light_far_used(const Renderer *renderer) { return !light_far_missing(renderer); }
