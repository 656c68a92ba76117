/* Which build of the compiler runs. */
#ifndef MATC_BUILD_ID_H
#define MATC_BUILD_ID_H
#include "compiler/base/hash.h"

/* Of the version and, where the linker left one, the program's build id: what another build made is
 * not taken for ours. */
Key build_id_key(void);
#endif
