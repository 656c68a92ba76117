/* The LOBE rows of slots.def. */
#ifndef MATC_LOBE_TABLE_H
#define MATC_LOBE_TABLE_H
#include "tables.h"

/* Lobes of Principled that most surfaces lack. */
typedef enum {
#define LOBE(slot, param, doc) LOBE_##slot,
#include "slots.def"
    LOBE_COUNT
} Lobe;
typedef struct {
    const char *name;
    Slot slot;
    int param; /* weight of the lobe, a parameter of Principled */
    const char *doc;
} LobeRow;
extern const LobeRow lobe_table[LOBE_COUNT];
/* Flags of lobes follow the flags 1 << Model. */
#define MODEL_LOBE(lobe) (1u << (MODEL_COUNT + (lobe)))
/* Flag of a surface that may emit light. */
#define MODEL_EMITS MODEL_LOBE(LOBE_COUNT)
/* Flag of a surface whose normal may come from a map. */
#define MODEL_RELIEF MODEL_LOBE(LOBE_COUNT + 1)
#endif
