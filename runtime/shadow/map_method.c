/* The row of plain shadow maps, which need only this folder's shared code. */
#include "runtime/shadow/shadow_method.h"

extern const ShadowMethod shadow_map;
const ShadowMethod shadow_map = {.word = KEYWORD_Shadows_map};
