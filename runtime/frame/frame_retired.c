/* Screen passes of the previous scene, kept alive while the next scene is built: the store
 * shares programs of equal text, so programs that both scenes use are not compiled again. */
#include "runtime/frame/frame.h"

void frame_retire(Render *render, ScreenPass *pass)
{
    if (pass->material.store && render->retired_count < FRAME_RETIRED_MAX)
        render->retired[render->retired_count++] = *pass;
    else
        screen_pass_delete(pass);
    *pass = (ScreenPass){0};
}

void frame_retired_delete(Render *render)
{
    while (render->retired_count)
        screen_pass_delete(&render->retired[--render->retired_count]);
}
