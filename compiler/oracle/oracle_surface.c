/* Evaluates the checkers and the maps with a texture (semantics.md 2.2, and VolumeChecker of
 * 2.3). */
#include "compiler/oracle/oracle_maps.h"
#include "compiler/library/carpenter.h"
#include "compiler/library/references.h"

double oracle_along_steps(const Stepped *map, const double q0[3], const double q[3])
{
    const double here = map->at(map->map, q0);
    double value = here;
    for (int i = 0; i < 3; i++) {
        double there[3] = {q0[0], q0[1], q0[2]};
        if (map->step[i] == 0 || q[i] == q0[i])
            continue;
        there[i] += map->step[i];
        value += (map->at(map->map, there) - here) / map->step[i] * (q[i] - q0[i]);
    }
    return value;
}

/* Returns the parity of an integer. The parity of a sum is the exclusive or, which stays exact
 * where the sum would not. */
static bool is_odd(double whole) { return fmod(whole, 2) != 0; }

static bool odd_square(double u, double v) { return is_odd(floor(2 * u)) != is_odd(floor(2 * v)); }

static const double CHECKER_STEP = 0.05;

/* Returns the slope of a checker: across an edge of the pattern the difference of the colors;
 * within a square the slope of the color itself. */
static double checker_slope(Environment *environment, const Node *node, int channel,
                            const double uv[2])
{
    bool along_u = group_of(channel) == GROUP_DU;
    bool here = odd_square(uv[0], uv[1]);
    bool there =
        odd_square(uv[0] + (along_u ? CHECKER_STEP : 0), uv[1] + (along_u ? 0 : CHECKER_STEP));
    int this_colour = here ? P_Checker_color1 : P_Checker_color2;
    if (here == there)
        return oracle_query_param(environment, node, this_colour, channel);
    int other_colour = here ? P_Checker_color2 : P_Checker_color1;
    int component = channel_id(GROUP_R, component_of(channel));
    double other = oracle_query_param(environment, node, other_colour, component);
    return (other - oracle_query_param(environment, node, this_colour, component)) / CHECKER_STEP;
}

static void query_uv(Environment *environment, const Node *node, double uv[2])
{
    uv[0] = oracle_query_input(environment, node, channel_id(GROUP_U, 0));
    uv[1] = oracle_query_input(environment, node, channel_id(GROUP_U, 1));
}

/* Interpolates linearly from a to b as x goes from 0 to 1; constant outside. */
static double between(double a, double b, double x) { return a + fmin(fmax(x, 0), 1) * (b - a); }

double oracle_Ramp(Environment *environment, const Node *node, int channel)
{
    double uv[2];
    query_uv(environment, node, uv);
    const double a = oracle_query_param(environment, node, P_Ramp_a, channel),
                 b = oracle_query_param(environment, node, P_Ramp_b, channel);
    return between(a, b, uv[node_param(node, P_Ramp_along)->number[0] == KEYWORD_Axis_v]);
}

double oracle_CornerRamp(Environment *environment, const Node *node, int channel)
{
    double uv[2], corner[4];
    query_uv(environment, node, uv);
    for (int i = 0; i < 4; i++)
        corner[i] = oracle_query_param(environment, node, P_CornerRamp_bottomLeft + i, channel);
    return between(between(corner[0], corner[1], uv[0]), between(corner[2], corner[3], uv[0]),
                   uv[1]);
}

static double square_at(const void *map, const double q[3])
{
    (void)map;
    return odd_square(q[0], q[1]);
}

static double cube_at(const void *map, const double p[3])
{
    (void)map;
    return is_odd(floor(p[0])) ^ is_odd(floor(p[1])) ^ is_odd(floor(p[2]));
}

double oracle_odd_share(Environment *environment, const Node *checker)
{
    static const double cube_step = 0.1;
    static const Stepped squares = {square_at, NULL, {CHECKER_STEP, CHECKER_STEP, 0}},
                         cubes = {cube_at, NULL, {cube_step, cube_step, cube_step}};
    const bool volume = checker->kind == KIND_VolumeChecker;
    const Stepped *map = volume ? &cubes : &squares;
    double q[3], q0[3];
    oracle_query_input3(environment, checker, volume ? GROUP_X : GROUP_U, q);
    if (!environment->centre)
        return map->at(NULL, q);
    oracle_query_input3(environment->centre, checker, volume ? GROUP_X : GROUP_U, q0);
    return oracle_along_steps(map, q0, q);
}

/* Mixes both colors by the checker's share; `color1` is the parameter of the first color,
 * followed by color2. */
static double one_of(Environment *environment, const Node *checker, int channel, int color1)
{
    const double share = oracle_odd_share(environment, checker);
    double mean = 0;
    if (share != 0)
        mean += share * oracle_query_param(environment, checker, color1, channel);
    if (share != 1)
        mean += (1 - share) * oracle_query_param(environment, checker, color1 + 1, channel);
    return mean;
}

double oracle_Checker(Environment *environment, const Node *node, int channel)
{
    double uv[2];
    query_uv(environment, node, uv);
    if (is_derivative(channel))
        return checker_slope(environment, node, channel, uv);
    return one_of(environment, node, channel, P_Checker_color1);
}

double oracle_VolumeChecker(Environment *environment, const Node *node, int channel)
{
    return one_of(environment, node, channel, P_VolumeChecker_color1);
}

/* A texture as a function of u and v: one component of it, and the steps of its finite
 * differences. */
typedef struct {
    Environment *environment;
    int function; /* library function that reads the texture */
    ReferenceTexture texture;
    double step_u, step_v;
    bool centred; /* a texel's color is at its center */
    bool gray;    /* a single component, `channel`, as gray with alpha 1 */
    int channel;
} Picture;

/* Returns a component of an image at (u, v). Components that the function does not write are
 * those of a gray. */
static double picture_at(const Picture *picture, double u, double v, int component)
{
    ReferenceContext context = picture->environment->oracle->context;
    context.textures = &picture->texture;
    const double half = picture->centred ? 0.5 : 0;
    const int width = picture->texture.width, height = picture->texture.height;
    double args[5] = {0, u - half / width, v - half / height, width, height};
    double texel[4];
    reference_of(picture->function)(&context, args, texel);
    if (picture->gray)
        return component == 3 ? 1 : texel[picture->channel];
    if (picture->texture.components == 4)
        return texel[component];
    return component == 3 ? 1 : texel[0];
}

/* A component of an image. */
typedef struct {
    const Picture *picture;
    int component;
} Component;

static double component_at(const void *map, const double q[3])
{
    const Component *c = map;
    return picture_at(c->picture, q[0], q[1], c->component);
}

static double picture_beside(const Picture *picture, const Node *node, const double uv[2],
                             int component)
{
    const Component c = {picture, component};
    const Stepped map = {component_at, &c, {picture->step_u, picture->step_v, 0}};
    double centre[2];
    query_uv(picture->environment->centre, node, centre);
    return oracle_along_steps(&map, (double[3]){centre[0], centre[1]}, (double[3]){uv[0], uv[1]});
}

/* Evaluates a channel of an image. A derivative channel is the difference quotient of its own
 * component, the rule of all surface maps, so BumpMap gets the slope of red. */
static double picture_channel(const Picture *picture, const Node *node, int channel)
{
    int component = component_of(channel);
    double uv[2];
    query_uv(picture->environment, node, uv);
    if (picture->environment->centre && !is_derivative(channel))
        return picture_beside(picture, node, uv, component);
    double here = picture_at(picture, uv[0], uv[1], component);
    if (!is_derivative(channel))
        return here;
    if (group_of(channel) == GROUP_DU)
        return (picture_at(picture, uv[0] + picture->step_u, uv[1], component) - here) /
               picture->step_u;
    return (picture_at(picture, uv[0], uv[1] + picture->step_v, component) - here) /
           picture->step_v;
}

/* Evaluates a missing image: a constant gray, whose difference quotients are 0. */
static double no_picture(int channel)
{
    if (is_derivative(channel))
        return 0;
    return component_of(channel) == 3 ? 1 : .5;
}

enum { NO_WORD = -1 };

static int keyword_of(const Node *node, int param)
{
    const Value *value = node_param(node, param);
    return value->kind == VALUE_number ? (int)value->number[0] : NO_WORD;
}

/* Returns true if a texel's color is at its center. Without filtering that makes no difference. */
static bool is_centred(const Node *node)
{
    return oracle_number(node, P_ImageMap_bilinearFiltering) != 0 &&
           keyword_of(node, P_ImageMap_texels) == KEYWORD_Texels_centre;
}

double oracle_ImageMap(Environment *environment, const Node *node, int channel)
{
    const Value *value = node_param(node, P_ImageMap_image);
    const Image *image = value->kind == VALUE_image ? value->image : NULL;
    if (!image || !image->texels)
        return no_picture(channel);
    Picture picture = {
        .environment = environment,
        .function = oracle_number(node, P_ImageMap_bilinearFiltering) != 0 ? FN_imageBilinear
                                                                           : FN_imageNearest,
        .texture = {.width = image->width,
                    .height = image->height,
                    .components = 4,
                    .bytes = image_bytes(image),
                    .words = image_words(image),
                    .floats = image_floats(image),
                    .srgb = keyword_of(node, P_ImageMap_colorspace) == KEYWORD_ColorSpace_srgb,
                    .wrap = (ReferenceWrap)(keyword_of(node, P_ImageMap_address) -
                                            KEYWORD_Address_repeat)},
        .gray = keyword_of(node, P_ImageMap_channel) != NO_WORD,
        .channel = keyword_of(node, P_ImageMap_channel) - KEYWORD_Channel_r,
        .centred = is_centred(node),
        .step_u = 1. / image->width,
        .step_v = 1. / image->height,
    };
    return picture_channel(&picture, node, channel);
}

/* Returns a Carpenter's texels, baked on first use; NULL: baking exceeds the limit of work. */
static const float *relief(const Environment *environment, const Node *node, int width, int height)
{
    Oracle *oracle = environment->oracle;
    size_t number = node_number(&oracle->arena, &oracle->baked, node);
    oracle->reliefs = arena_reach(&oracle->arena, oracle->reliefs, number, &oracle->relief_capacity,
                                  sizeof *oracle->reliefs);
    float **texels = &oracle->reliefs[number];
    if (*texels)
        return *texels;
    oracle_spend(environment, (double)TEXEL_WORK * width * height);
    if (oracle_spent(oracle))
        return NULL;
    *texels = ARENA_ARRAY(&oracle->arena, float, (size_t)width *(size_t)height);
    const CarpenterRelief carpenter = {
        .color = oracle_number(node, P_Carpenter_color),
        .noise = oracle_number(node, P_Carpenter_noise),
        .roughness = oracle_number(node, P_Carpenter_roughness),
        .seed = (int64_t)oracle_number(node, P_Carpenter_seed),
        .width = width,
        .height = height,
    };
    carpenter_bake(&carpenter, *texels);
    return *texels;
}

static const double SURFACE_STEP = 0.005; /* step for surface maps that have no step of their own */

double oracle_Carpenter(Environment *environment, const Node *node, int channel)
{
    int width = (int)oracle_number(node, P_Carpenter_width),
        height = (int)oracle_number(node, P_Carpenter_height);
    Picture picture = {
        .environment = environment,
        .function = FN_carpenterRelief,
        .texture = {.width = width,
                    .height = height,
                    .components = 1,
                    .floats = relief(environment, node, width, height)},
        .step_u = SURFACE_STEP,
        .step_v = SURFACE_STEP,
    };
    if (!picture.texture.floats)
        return 0;
    return picture_channel(&picture, node, channel);
}
