/* Cancels half a texel that is subtracted from the coordinate of imageSampled, which adds it
 * again:
 *
 *     imageSampled(s, uv - vec2(0.5) / size, size)    an image with `texels: centre`
 *     becomes imageCentred(s, uv), a plain texture(s, uv) that does not need the size */
#include "compiler/opt/opt.h"

/* Returns true for half a texel: vec2(0.5) / size, or its value if the size is constant. */
static bool is_half_texel(const Ir *ir, Ref shift, Ref size)
{
    if (ir_is(ir, shift, OP_div))
        return ir_is_number(ir, ir_arg(ir, shift, 0), 0.5) && ir_arg(ir, shift, 1) == size;
    if (!ir_is(ir, shift, OP_const) || !ir_is(ir, size, OP_const))
        return false;
    for (int i = 0; i < ir_components(ir, size); i++)
        if (ir_numbers(ir, shift)[i < ir_components(ir, shift) ? i : 0] !=
            0.5 / ir_numbers(ir, size)[i])
            return false;
    return true;
}

static Ref centre(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    if (!ir_is(ir, ref, OP_call) || ir_at(ir, ref)->payload != FN_imageSampled)
        return ref;
    const Ref uv = ir_arg(ir, ref, 1);
    if (!ir_is(ir, uv, OP_sub) || ir_components(ir, ir_arg(ir, uv, 0)) != 2 ||
        !is_half_texel(ir, ir_arg(ir, uv, 1), ir_arg(ir, ref, 2)))
        return ref;
    return build_call(ir, FN_imageCentred, ir_arg(ir, ref, 0), ir_arg(ir, uv, 0));
}

bool opt_centre(Ir *ir) { return ir_sweep(ir, centre, NULL); }
