/* Screen passes of the scene before, kept while the next one is made: the store shares programs of equal texts. */
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
