/* The textures that a program samples. */
#ifndef MATC_TEXTURE_H
#define MATC_TEXTURE_H
#include "compiler/emit/emit.h"

/* Lists the textures in use: the document's images and reliefs, then noise tables. Returns their
 * number. */
int texture_list(Session *session, const Ir *ir, const Interface *interface, MatcTexture **list,
                 int **made_by);
/* Fills in the texels of a texture; made_by is its number from texture_list. */
void texture_fill(Session *session, const Ir *ir, MatcTexture *texture, int made_by);
#endif
