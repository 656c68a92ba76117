#include "compiler/library/reference.h"

REFERENCE(wood)
{
    (void)context;
    result[0] = hypot(args[0], args[1]);
}
