/* The LOBE rows of slots.def as a const array. */
#include "lobe_table.h"

const LobeRow lobe_table[LOBE_COUNT] = {
#define LOBE(slot, param, doc) {#slot, SLOT_##slot, P_Principled_##param, doc},
#include "slots.def"
};
