/* Screen passes of the previous scene, kept alive while the next scene is built: the store
 * shares programs of equal text, so programs that both scenes use are not compiled again. */
#include "runtime/frame_graph/frame.h"

void frame_retire(Renderer *renderer, ScreenPass *pass)
{
    if (pass->material.store && renderer->retired_count < FRAME_RETIRED_MAX)
        renderer->retired[renderer->retired_count++] = *pass;
    else
        screen_pass_delete(pass);
    *pass = (ScreenPass){0};
}

void frame_retired_delete(Renderer *renderer)
{
    while (renderer->retired_count)
        screen_pass_delete(&renderer->retired[--renderer->retired_count]);
}
