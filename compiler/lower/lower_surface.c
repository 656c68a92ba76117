/* Maps without noise: constants, checkers and images. */
#include "compiler/lower/area.h"
#include "compiler/lower/bump.h"
#define XXH_INLINE_ALL
#include <xxhash.h>

static bool is_derivative(Group group) { return group == GROUP_DU || group == GROUP_DV; }

static MapValue constant(Lower *l, Ref value, Group group)
{
    return map_value_of(is_derivative(group) ? build_vec3(l->ir, 0, 0, 0)
                                             : lower_as_group(l, value, group));
}

MapValue lower_Constant(Lower *l, const Node *node, Group group, const Env *env)
{
    (void)env;
    const Value *value = &node->params[0];
    return constant(l, lower_param(l, value, value->type), group);
}

MapValue lower_RGBColor(Lower *l, const Node *node, Group group, const Env *env)
{
    (void)env;
    Ref r = lower_param(l, node_param(node, P_RGBColor_r), TYPE_float);
    Ref g = lower_param(l, node_param(node, P_RGBColor_g), TYPE_float);
    Ref b = lower_param(l, node_param(node, P_RGBColor_b), TYPE_float);
    return constant(l, build_vec(l->ir, TYPE_vec3, r, g, b), group);
}

MapValue lower_Graytone(Lower *l, const Node *node, Group group, const Env *env)
{
    (void)env;
    return constant(l, lower_param(l, node_param(node, P_Graytone_value), TYPE_float), group);
}

static const char *const component_name[] = {"x", "y", "z", "w"};

/* Returns true where floor(2 q) is odd, from the integer and the fraction of 2 q, per component:
 * edges are at integers, near which the fraction is small and good to its last bit. */
static Ref odd_beside_edge(Lower *l, const LongCoordinate *twice, const char *component)
{
    Ir *ir = l->ir;
    Ref whole = build_swizzle(ir, twice->whole, component),
        fraction = build_swizzle(ir, twice->fraction, component);
    Ref half = build_fract(ir, build_scale(ir, whole, 0.5));
    Ref odd = build_le(ir, build_float(ir, 0.5), half);
    return build_ne(ir, odd, build_lt(ir, fraction, build_float(ir, 0)));
}

/* Returns true where the sum of the components of floor(2 q) is odd. floor(2 x) is odd where
 * fract(x) is not below 1/2: this form is exact for every float, while a sum of large integers
 * loses its last bit. */
static Ref odd_sum(Lower *l, Ref q)
{
    Ir *ir = l->ir;
    LongCoordinate twice;
    bool is_long = affine_coordinate(l, q, 2, &twice);
    Ref part = is_long ? 0 : build_fract(ir, q), odd = 0;
    for (int i = 0; i < ir_components(ir, q); i++) {
        const char *component = component_name[i];
        Ref upper = is_long
                        ? odd_beside_edge(l, &twice, component)
                        : build_le(ir, build_float(ir, 0.5), build_swizzle(ir, part, component));
        odd = i ? build_ne(ir, odd, upper) : upper;
    }
    return odd;
}

/* Returns uv + step; multiples of the period `turn` are dropped first, since far from the origin
 * the step would be lost to rounding. */
static Ref stepped(Lower *l, Ref uv, Ref step, double turn)
{
    Ir *ir = l->ir;
    Ref part = turn == 1 ? build_fract(ir, uv)
                         : build_scale(ir, build_fract(ir, build_scale(ir, uv, 1 / turn)), turn);
    return build_add(ir, part, step);
}

/* Returns true where floor(2u) + floor(2v) is odd at uv + (step_u, step_v). */
static Ref odd_square(Lower *l, Ref uv, double step_u, double step_v)
{
    if (step_u != 0 || step_v != 0)
        uv = stepped(l, uv, ir_const(l->ir, TYPE_vec2, (double[]){step_u, step_v}), 1);
    return odd_sum(l, uv);
}

/* Returns the difference of the two colors where a step crosses an edge, else the slope of the
 * color itself. */
static Ref checker_slope(Lower *l, const Node *node, Ref uv, Group group, const Env *env)
{
    Ir *ir = l->ir;
    const Node *color1 = lower_param_node(node, P_Checker_color1),
               *color2 = lower_param_node(node, P_Checker_color2);
    const double step = kind_table[KIND_Checker].step;
    Ref odd = odd_square(l, uv, 0, 0);
    Ref beyond = odd_square(l, uv, group == GROUP_DU ? step : 0, group == GROUP_DV ? step : 0);
    Ref a = build_convert(ir, lower_query(l, color1, GROUP_R, env), TYPE_vec3);
    Ref b = build_convert(ir, lower_query(l, color2, GROUP_R, env), TYPE_vec3);
    Ref rise =
        build_scale(ir, build_select(ir, odd, build_sub(ir, b, a), build_sub(ir, a, b)), 1 / step);
    Ref inside = build_select(ir, odd, lower_query(l, color1, group, env),
                              lower_query(l, color2, group, env));
    return build_select(ir, build_ne(ir, odd, beyond), rise, inside);
}

/* The colors of a checker: color1 of odd squares, color2 of even ones. */
typedef struct {
    const Node *node[2];
    MapValue answer[2];
} Colors;

static void ask_colors(Lower *l, Colors *colors, Group group, const Env *env)
{
    for (int i = 0; i < 2; i++)
        colors->answer[i] = lower_arm(l, colors->node[i], group, env);
}

/* Returns the share of the pixel where the sum of the components of floor(2 q) is odd. Without a
 * footprint, or where --aa=auto keeps a branch around costly colors, a bool for the point
 * instead. */
static Ref odd_at(Lower *l, const void *map, MapValue q)
{
    const Colors *colors = map;
    const bool frugal = l->job->choice[AXIS_aa] == CHOICE_aa_auto;
    const bool branches =
        frugal && (lower_wants_branch(colors->node[0]) || lower_wants_branch(colors->node[1]));
    Ref share = branches ? 0 : area_odd_share(l, q);
    return share ? share : odd_sum(l, q.value);
}

/* Mixes both colors, by squares or cubes of edge 1/2. */
static MapValue odd_or_even(Lower *l, MapValue q, double step, const Colors *colors)
{
    Ref odd = odd_at(l, colors, q);
    Stepped map = {.at = odd_at, .map = colors, .q = q};
    for (int i = 0; i < ir_components(l->ir, q.value); i++)
        map.step[i] = step;
    bump_step(l, odd, &map);
    return map_value_either(l, odd, colors->answer[0], colors->answer[1]);
}

MapValue lower_Checker(Lower *l, const Node *node, Group group, const Env *env)
{
    const Node *color1 = lower_param_node(node, P_Checker_color1),
               *color2 = lower_param_node(node, P_Checker_color2);
    MapValue uv = map_value_swizzle(
        l, lower_map_value(l, lower_param_node(node, P_Checker_input), GROUP_U, env), "xy");
    if (is_derivative(group))
        return map_value_of(checker_slope(l, node, uv.value, group, env));
    Colors colors = {.node = {color1, color2}};
    ask_colors(l, &colors, group, env);
    return odd_or_even(l, uv, kind_table[KIND_Checker].step, &colors);
}

MapValue lower_VolumeChecker(Lower *l, const Node *node, Group group, const Env *env)
{
    MapValue p = lower_map_value(l, lower_param_node(node, P_VolumeChecker_input), GROUP_X, env);
    Colors colors = {.node = {lower_param_node(node, P_VolumeChecker_color1),
                              lower_param_node(node, P_VolumeChecker_color2)}};
    ask_colors(l, &colors, group, env);
    p = map_value_scaled(l, p, build_float(l->ir, 0.5));
    return odd_or_even(l, p, 0.5 * kind_table[KIND_VolumeChecker].step, &colors);
}

/* Returns true for equal images, or Carpenter reliefs with equal parameters. */
static bool same_texture(const IrTexture *a, const IrTexture *b)
{
    if (a->kind != b->kind || a->image != b->image || a->kind == TEXTURE_image)
        return a->kind == b->kind && a->image == b->image && a->srgb == b->srgb &&
               a->sampled == b->sampled && a->wrap == b->wrap;
    for (int i = 1; i < kind_table[KIND_Carpenter].count; i++) {
        double x[4], y[4];
        value_number(&a->node->params[i], TYPE_float, x);
        value_number(&b->node->params[i], TYPE_float, y);
        if (x[0] != y[0])
            return false;
    }
    return true;
}

/* Hashes a texture: equal textures have equal hashes. */
static uint32_t texture_hash(const IrTexture *texture)
{
    double numbers[16] = {0};
    int count = texture->kind == TEXTURE_image ? 0 : kind_table[KIND_Carpenter].count;
    for (int i = 1; i < count; i++)
        value_number(&texture->node->params[i], TYPE_float, &numbers[i]);
    for (int i = 1; i < count; i++)
        numbers[i] += 0.0; /* turns -0 into 0, so that both have the same hash */
    return (uint32_t)XXH3_64bits_withSeed(numbers, sizeof numbers, (uintptr_t)texture->image);
}

/* Returns the number of an equal texture, which is added on first use. */
static uint32_t texture_number(Ir *ir, const IrTexture *wanted)
{
    const uint32_t hash = texture_hash(wanted);
    for (HashProbe probe = hash_probe(&ir->texture_index, hash); hash_probe_next(&probe);)
        if (same_texture(&ir->textures[probe.number], wanted))
            return probe.number;
    hash_index_add(ir->arena, &ir->texture_index, hash, (uint32_t)ir->texture_count);
    ARENA_PUSH(ir->arena, ir->textures, ir->texture_count, ir->texture_capacity, *wanted);
    return (uint32_t)ir->texture_count - 1;
}

enum { ALL_COMPONENTS = -1 };

/* An image, the function that reads it, and the step of finite differences along u and v; 0:
 * one texel. */
typedef struct {
    IrTexture texture;
    Function function;
    double step;
    int component;   /* selected component, or ALL_COMPONENTS */
    Keyword address; /* addressing that the sampler cannot do */
    bool centred;    /* a texel's color is at its center */
} Sampled;

/* Returns the components of an image function's result. */
static Ref components_of(Lower *l, const Sampled *sampled, Ref value)
{
    return sampled->component == ALL_COMPONENTS
               ? value
               : build_swizzle(l->ir, value, component_name[sampled->component]);
}

/* Returns the image's width and height: queried from the sampler where possible, so that
 * images of all sizes share a program. */
static Ref size_of(Lower *l, const IrTexture *texture, Ref sampler)
{
    if (texture->sampled && target_table[l->job->target].words)
        return build_call(l->ir, FN_pictureSize, sampler);
    return ir_const(l->ir, TYPE_vec2, (double[]){texture->width, texture->height});
}

/* Moves uv near 0 by whole periods. A relief is periodic, but differs on both sides of 0: uv is
 * moved into -2 ... 2 and stays on its side.
 *   5.3 - (5 - 1) = 1.3; -3.002 - (-4 + 2) = -1.002, and a step of .005 from there stays on that
 *   side */
static Ref near_zero(Ir *ir, Ref uv)
{
    Ref turns = build_floor(ir, uv);
    Ref kept = build_clamp(ir, turns, build_all(ir, TYPE_vec2, -2), build_all(ir, TYPE_vec2, 1));
    return build_sub(ir, uv, build_sub(ir, turns, kept));
}

/* Returns the period in u and v after which the image repeats exactly; 0: none, or a sampler
 * reads it, which would take a dropped period for a wide footprint. */
static double uv_transform_chain(const Sampled *sampled)
{
    if (sampled->texture.sampled)
        return 0;
    return sampled->address == KEYWORD_Address_repeat   ? 1
           : sampled->address == KEYWORD_Address_mirror ? 2
                                                        : 0;
}

/* Returns uv + step, or an equivalent point: far from the origin the step would be lost to
 * rounding. */
static Ref beyond_of(Lower *l, const Sampled *sampled, Ref uv, Ref step)
{
    if (sampled->texture.kind == TEXTURE_carpenter)
        return build_add(l->ir, near_zero(l->ir, uv), step);
    const double turn = uv_transform_chain(sampled);
    return turn > 0 ? stepped(l, uv, step, turn) : build_add(l->ir, uv, step);
}

/* Returns the forward difference, the base rule of surface maps: (f(u + h, v) - f(u, v)) / h,
 * per component. */
static Ref difference(Lower *l, const Sampled *sampled, const Picture *picture, Ref uv, bool by_v)
{
    Ir *ir = l->ir;
    Ref zero = build_float(ir, 0), component = build_swizzle(ir, picture->size, by_v ? "y" : "x");
    Ref h = sampled->step > 0 ? build_float(ir, sampled->step)
                              : build_div(ir, build_float(ir, 1), component);
    Ref step = by_v ? build_vec(ir, TYPE_vec2, zero, h) : build_vec(ir, TYPE_vec2, h, zero);
    Ref beyond = beyond_of(l, sampled, uv, step);
    Ref here = components_of(l, sampled, area_picture_near(l, picture, uv, uv));
    Ref there = components_of(l, sampled, area_picture_near(l, picture, beyond, uv));
    Ref rise = build_sub(ir, there, here);
    return sampled->step > 0 ? build_scale(ir, rise, 1 / sampled->step)
                             : build_mul(ir, rise, component);
}

/* Returns the slope over a step of one texel, from eight texels instead of three samples where
 * the sampler allows it. */
static Ref sampled_slope(Lower *l, const Sampled *sampled, const Picture *picture, Ref uv,
                         bool by_v)
{
    Ir *ir = l->ir;
    const bool all = sampled->component == ALL_COMPONENTS;
    Ref slope[4], by[2];
    for (int i = 0; i < 2; i++)
        by[i] = difference(l, sampled, picture, uv, i);
    for (int i = 0; i < (all ? 4 : 1); i++) {
        Ref shown = build_vec(ir, TYPE_vec2, build_swizzle(ir, by[0], component_name[i]),
                              build_swizzle(ir, by[1], component_name[i]));
        Ref rise = sampled->step > 0
                       ? 0
                       : area_picture_rise(l, picture, uv, all ? i : sampled->component, shown);
        if (!rise)
            return by[by_v];
        slope[i] = build_swizzle(ir, rise, by_v ? "y" : "x");
    }
    return all ? build_vec_of(ir, TYPE_vec4, slope, 4) : slope[0];
}

static Ref sample_group(Lower *l, const Sampled *sampled, Ref uv, Group group)
{
    Ref sampler =
        build_leaf(l->ir, OP_texture, TYPE_sampler, (int)texture_number(l->ir, &sampled->texture));
    const Picture picture = {sampled->function, sampler, size_of(l, &sampled->texture, sampler),
                             sampled->address};
    if (sampled->centred)
        uv = build_sub(l->ir, uv, build_div(l->ir, build_all(l->ir, TYPE_vec2, 0.5), picture.size));
    if (is_derivative(group))
        return lower_as_group(l, sampled_slope(l, sampled, &picture, uv, group == GROUP_DV), group);
    Ref value = components_of(l, sampled, area_picture(l, &picture, uv));
    if (l->relief) {
        Ref by_u = sampled_slope(l, sampled, &picture, uv, false),
            by_v = sampled_slope(l, sampled, &picture, uv, true);
        bump_rise(l, value, uv, REFS(l->ir, by_u, by_v, 0));
    }
    return lower_as_group(l, value, group);
}

static bool is_word(const Node *node, int param, Keyword word)
{
    const Value *value = node_param(node, param);
    return value->kind == VALUE_number && value->number[0] == word;
}

/* Returns the component that the parameter `channel` selects. */
static int channel_component(const Node *node)
{
    const Value *value = node_param(node, P_ImageMap_channel);
    return value->kind == VALUE_number ? (int)value->number[0] - (int)KEYWORD_Channel_r
                                       : ALL_COMPONENTS;
}

/* Returns the texel format. An encoding that no texture of the target decodes is decoded to 16
 * bits when the texture is filled. Half floats replace words if the target has none, and replace
 * floats if its samplers do not filter floats. */
static Texels texels_of(const Lower *l, const Image *image, bool srgb)
{
    const TargetRow *target = &target_table[l->job->target];
    if (image->bits == 32)
        return image->halves || !target->float_filters ? TEXELS_RGBA16F : TEXELS_RGBA32F;
    if (image->bits == 8 && !srgb)
        return TEXELS_RGBA8;
    if (image->bits == 8 && target->srgb_textures)
        return TEXELS_SRGB8_ALPHA8;
    return target->word_textures ? TEXELS_RGBA16 : TEXELS_RGBA16F;
}

static bool is_sampled(Function function)
{
    return function == FN_imageSampled || function == FN_imageSampledOver;
}

/* Returns the wrap mode of the sampler, as far as the sampler can do the addressing and the
 * program allows it. Without filtering texels are fetched, and one sampler is enough. */
static Keyword wrap_of(const Lower *l, Keyword address, bool sampled)
{
    const bool borders = sampled && target_table[l->job->target].borders;
    if (l->job->choice[AXIS_aa] == CHOICE_aa_none)
        return KEYWORD_Address_repeat;
    return address == KEYWORD_Address_border && !borders ? KEYWORD_Address_clamp : address;
}

static Sampled sampled_image(Lower *l, const Node *node, const Image *picture, Ref uv)
{
    double bilinear[4];
    value_number(node_param(node, P_ImageMap_bilinearFiltering), TYPE_float, bilinear);
    const Keyword address = (Keyword)node_param(node, P_ImageMap_address)->number[0];
    const Function function = area_picture_function(l, uv, bilinear[0] != 0);
    const bool srgb = is_word(node, P_ImageMap_colorspace, KEYWORD_ColorSpace_srgb) &&
                      !is_word(node, P_ImageMap_channel, KEYWORD_Channel_a);
    const IrTexture texture = {
        .kind = TEXTURE_image,
        .image = picture,
        .width = picture->width,
        .height = picture->height,
        .sampled = is_sampled(function),
        .srgb = srgb,
        .floats = picture->bits == 32,
        .texels = texels_of(l, picture, srgb),
        .wrap = wrap_of(l, address, is_sampled(function)),
    };
    return (Sampled){
        .texture = texture,
        .function = function,
        .component = channel_component(node),
        .address =
            is_sampled(function) && texture.wrap == address ? KEYWORD_Address_repeat : address,
        .centred = bilinear[0] != 0 && is_word(node, P_ImageMap_texels, KEYWORD_Texels_centre),
    };
}

MapValue lower_ImageMap(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    const Value *image = node_param(node, P_ImageMap_image);
    if (image->kind != VALUE_image)
        return constant(l, build_float(ir, 0.5), group);
    Ref uv = build_swizzle(
        ir, lower_query(l, lower_param_node(node, P_ImageMap_input), GROUP_U, env), "xy");
    const bool opaque =
        image->image->opaque && !is_word(node, P_ImageMap_address, KEYWORD_Address_border);
    if (opaque && is_word(node, P_ImageMap_channel, KEYWORD_Channel_a))
        return constant(l, build_float(ir, 1), group);
    const Sampled sampled = sampled_image(l, node, image->image, uv);
    Ref value = sample_group(l, &sampled, uv, group);
    if (group == GROUP_R && opaque && sampled.component == ALL_COMPONENTS)
        value = build_vec(ir, TYPE_vec4, build_swizzle(ir, value, "xyz"), build_float(ir, 1));
    return map_value_of(value);
}

MapValue lower_Carpenter(Lower *l, const Node *node, Group group, const Env *env)
{
    const KindRow *row = &kind_table[KIND_Carpenter];
    for (int i = 1; i < row->count; i++)
        lower_reject_uniform(l, &node->params[i], param_table[row->first + i].name,
                             "the height map is computed at compile time");
    double width[4], height[4];
    value_number(node_param(node, P_Carpenter_width), TYPE_float, width);
    value_number(node_param(node, P_Carpenter_height), TYPE_float, height);
    Ref uv = build_swizzle(
        l->ir, lower_query(l, lower_param_node(node, P_Carpenter_input), GROUP_U, env), "xy");
    const IrTexture texture = {.kind = TEXTURE_carpenter,
                               .texels = TEXELS_R32F,
                               .wrap = KEYWORD_Address_repeat,
                               .node = node,
                               .width = (int)width[0],
                               .height = (int)height[0]};
    return map_value_of(sample_group(l,
                                     &(Sampled){texture, FN_carpenterRelief, row->step,
                                                ALL_COMPONENTS, KEYWORD_Address_repeat, false},
                                     uv, group));
}
