/* Texture addressing other than `repeat`, as a change of the coordinate. A texel's value is
 * located at its lower corner, so the four texels mixed at u surround the sampler's position u +
 * 1/2 texel:
 *
 *     clamp     u' = clamp(u, 0, 1 - 1 texel): from the first texel to the last, without
 *     wrapping around to the first
 *     mirror    the sampler's position is folded into [0, 1], 1 - |1 - x| of x mod 2, then
 *     clamped
 *     border    as clamp, times the share of the box, one texel wide or as wide as the pixel,
 *     that lies in the image
 *
 * An image of 4 texels at u = -.1: the sampler's position is .025, .1 texel; clamp reads u' =
 * 0; the box from -.4 to .6 texels has .6 in the image, so border is .6 of the first texel, as
 * GL mixes a texel with its border color. */
#include "compiler/lower/address.h"
#include "compiler/ir/build_words.h"

/* Converts `count` texels to a distance in texture coordinates, in u and v. */
static Ref texels(Ir *ir, const Addressed *picture, double count)
{
    return build_div(ir, build_all(ir, TYPE_vec2, count), picture->size);
}

/* Returns the center of the texel at uv. */
static Ref centred(Ir *ir, const Addressed *picture, Ref uv)
{
    Ref texel = build_floor(ir, build_mul(ir, uv, picture->size));
    return build_div(ir, build_add(ir, texel, build_all(ir, TYPE_vec2, 0.5)), picture->size);
}

/* Folds u + shift into [0, 1]. Multiples of 2, the period, are dropped before the shift is
 * added, which would be lost to rounding far from the origin. A sum above 2 comes out below 0,
 * and is clamped to the edge like its mirror image. Shift 0: none. */
static Ref folded(Ir *ir, Ref u, Ref shift)
{
    Ref one = build_all(ir, TYPE_vec2, 1);
    Ref turn = build_scale(ir, build_fract(ir, build_scale(ir, u, 0.5)), 2);
    Ref place = shift ? build_add(ir, turn, shift) : turn;
    return build_sub(ir, one, build_abs(ir, build_sub(ir, one, place)));
}

Ref address_unfolded(Ir *ir, const Addressed *picture, Ref uv)
{
    if (picture->address != KEYWORD_Address_mirror)
        return uv;
    Ref half = picture->smooth ? texels(ir, picture, 0.5) : 0;
    Ref place = folded(ir, uv, half);
    return half ? build_sub(ir, place, half) : place;
}

Ref address_place(Ir *ir, const Addressed *picture, Ref uv)
{
    if (picture->address == KEYWORD_Address_repeat)
        return uv;
    Ref place = address_unfolded(ir, picture, picture->smooth ? uv : centred(ir, picture, uv));
    Ref least = picture->smooth ? build_all(ir, TYPE_vec2, 0) : texels(ir, picture, 0.5);
    Ref most =
        build_sub(ir, build_all(ir, TYPE_vec2, 1), texels(ir, picture, picture->smooth ? 1 : 0.5));
    return build_clamp(ir, place, least, most);
}

/* Returns the share of a box that lies in the image, per component. A box of one texel begins
 * at u, in texels; a wider one has the same center. */
static Ref overlap(Ir *ir, const Addressed *picture, Ref uv, Ref wide)
{
    Ref zero = build_all(ir, TYPE_vec2, 0), one = build_all(ir, TYPE_vec2, 1);
    Ref begin = build_mul(ir, uv, picture->size);
    if (wide)
        begin = build_sub(ir, begin, build_scale(ir, build_sub(ir, wide, one), 0.5));
    Ref end = build_add(ir, begin, wide ? wide : one);
    Ref part = build_sub(ir, build_min(ir, end, picture->size), build_max(ir, begin, zero));
    Ref inside = build_max(ir, part, zero);
    return wide ? build_div(ir, inside, wide) : inside;
}

static Ref is_inside(Ir *ir, Ref uv)
{
    Ref zero = build_all(ir, TYPE_vec2, 0), one = build_all(ir, TYPE_vec2, 1);
    return build_sub(ir, build_step(ir, zero, uv), build_step(ir, one, uv));
}

Ref address_share(Ir *ir, const Addressed *picture, Ref uv, Ref wide)
{
    if (picture->address != KEYWORD_Address_border)
        return 0;
    Ref most = wide ? build_max(ir, build_all(ir, TYPE_vec2, 1), wide) : 0;
    Ref share = picture->smooth ? overlap(ir, picture, uv, most) : is_inside(ir, uv);
    return build_mul(ir, build_swizzle(ir, share, "x"), build_swizzle(ir, share, "y"));
}

Ref address_texels(Ir *ir, Ref call)
{
    const IrNode node = *ir_at(ir, call);
    if (node.op != OP_call ||
        (node.payload != FN_imageSampled && node.payload != FN_imageSampledOver))
        return 0;
    Ref sampler = ir_arg(ir, call, 0), uv = ir_arg(ir, call, 1);
    const Addressed picture = {ir->textures[ir_at(ir, sampler)->payload].wrap, true,
                               ir_arg(ir, call, 2)};
    if (picture.address == KEYWORD_Address_repeat)
        return 0;
    Ref share = address_share(ir, &picture, uv, 0);
    Ref value =
        build_call(ir, FN_imageBilinear, sampler, address_place(ir, &picture, uv), picture.size);
    return share ? build_mul(ir, value, build_splat(ir, share, TYPE_vec4)) : value;
}
