/* Fields that several cases store in the same place, such as the normal: they are decoded once,
 * before the branch on the case.
 *
 *     case 0: normal in bits 2 to 25    case 1: the same    case 2: normal in bits 6 to 29
 *     surface.normal = ...(target0.x >> 2 & ...);
 *     if (number == 2u) surface.normal = ...(target0.x >> 6 & ...); */
#ifndef MATC_UNPACK_SHARED_H
#define MATC_UNPACK_SHARED_H
#include "compiler/ir/job.h"
#include "compiler/layout/layout.h"

typedef struct {
    /* indexed by slot and component; the first may hold all */
    Piece pieces[SLOT_COUNT][FIELD_COMPONENTS];
    bool has[SLOT_COUNT][FIELD_COMPONENTS];
} UnpackShared;

/* Finds the shared pieces of the cases that the job reads; a single case shares nothing. */
UnpackShared unpack_shared(const Job *job);
/* Returns true if some of the slot is shared, so that a case without the slot must reset it. */
bool unpack_shares(const UnpackShared *shared, Slot slot);
/* Returns true if the piece is the shared one of its slot. */
bool unpack_is_shared(const UnpackShared *shared, const Piece *piece);
/* Returns true if the case is read back. */
bool unpack_takes(const Job *job, int number);
#endif
