/* Fields that many of the cases read back have in one place, such as the normal: they stand
 * once, before it is known which case it is.
 *
 *     case 0: normal in bits 2 to 25    case 1: normal there, too    case 2: normal in bits 6 to 29
 *     surface.normal = ...(target0.x >> 2 & ...);
 *     if (number == 2u) surface.normal = ...(target0.x >> 6 & ...); */
#ifndef MATC_UNPACK_SHARED_H
#define MATC_UNPACK_SHARED_H
#include "compiler/ir/job.h"
#include "compiler/layout/layout.h"

typedef struct {
    Piece pieces[SLOT_COUNT][FIELD_LANES]; /* by slot and lane, or as the first one all lanes */
    bool has[SLOT_COUNT][FIELD_LANES];
} UnpackShared;

/* Applies to the cases that the job takes; nothing is shared where that is one alone. */
UnpackShared unpack_shared(const Job *job);
/* Some of the slot is shared, so that a case without it has to say what it is. */
bool unpack_shares(const UnpackShared *shared, Slot slot);
/* The piece is what the cases share of its slot. */
bool unpack_is_shared(const UnpackShared *shared, const Piece *piece);
/* The case is read back. */
bool unpack_takes(const Job *job, int number);
#endif
