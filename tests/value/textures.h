/* The textures of an IR, as the reference functions take them. */
#ifndef MATC_VALUE_TEXTURES_H
#define MATC_VALUE_TEXTURES_H
#include "compiler/ir.h"

/* False when there are more than `room`. Texels lie in the arena or in the IR's images. */
bool textures_of(Arena *arena, const Ir *ir, ReferenceTexture *textures, size_t room);
#endif
