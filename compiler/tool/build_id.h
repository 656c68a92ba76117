/* Which build of the compiler runs. */
#ifndef MATC_BUILD_ID_H
#define MATC_BUILD_ID_H
#include "compiler/base/hash.h"

/* Hash of the version and, where the linker left one, the program's build id: output of another
 * build is never taken for ours. */
Key build_id_key(void);
#endif
