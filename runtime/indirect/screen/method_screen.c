/* The method screen: visibility bit masks from the depth buffer, along lines through the pixel.
 * Its GLSL is indirect_mask.glsl; the view visibility traces single rays. */
#include "gen/render_text.h"
#include "runtime/indirect/settings/indirect_method.h"

const IndirectMethod indirect_screen = {
    .word = KEYWORD_Indirect_screen,
    .automatic = true,
    .one_shift = true,
    .steps = 8,
    .hit = render_text_indirect_march,
    .around = render_text_indirect_mask,
};
