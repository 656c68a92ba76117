/* The row of plain shadow maps, which have all that this folder's shared code does. */
#include "runtime/shadow/shadow_method.h"

extern const ShadowMethod shadow_map;
const ShadowMethod shadow_map = {.word = WORD_Shadows_map};
