/* The LOBE rows of slots.def. */
#ifndef MATC_LOBE_TABLE_H
#define MATC_LOBE_TABLE_H
#include "tables.h"

/* Parts of Principled that most surfaces lack. */
typedef enum {
#define LOBE(slot, param, doc) LOBE_##slot,
#include "slots.def"
    LOBE_COUNT
} Lobe;
typedef struct {
    const char *name;
    Slot slot;
    int param; /* of Principled: its weight */
    const char *doc;
} LobeRow;
extern const LobeRow lobe_table[LOBE_COUNT];
/* Bits of models, 1 << Model, go on with lobes. */
#define MODEL_LOBE(lobe) (1u << (MODEL_COUNT + (lobe)))
/* And one for a surface that may send light of its own. */
#define MODEL_EMITS MODEL_LOBE(LOBE_COUNT)
/* And one where a map may give its normal. */
#define MODEL_RELIEF MODEL_LOBE(LOBE_COUNT + 1)
#endif
