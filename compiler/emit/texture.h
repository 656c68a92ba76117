/* The textures a program samples. */
#ifndef MATC_TEXTURE_H
#define MATC_TEXTURE_H
#include "compiler/emit/emit.h"

/* Those in use: the document's pictures and reliefs, then the tables of noise. */
int texture_list(Session *session, const Ir *ir, const Interface *interface, MatcTexture **list,
                 int **made_by);
/* Fills in the texels of one that matc makes; made_by is its number from texture_list. */
void texture_fill(Session *session, const Ir *ir, MatcTexture *texture, int made_by);
#endif
