/* The LOBE rows of slots.def as a const array. */
#include "lobe_table.h"

const LobeRow lobe_table[LOBE_COUNT] = {
#define LOBE(name, doc) {#name, SLOT_##name, P_Principled_##name, doc},
#include "slots.def"
};
