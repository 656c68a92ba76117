/* Identifies the build of the running compiler. */
#ifndef MATC_BUILD_ID_H
#define MATC_BUILD_ID_H
#include "compiler/base/hash.h"

/* Returns a hash of the version and, if present, the program's build id, so that cached output
 * of another build is never used. */
Key build_id_key(void);
#endif
