#include "matc.h"
#include <string.h>
#include <stdlib.h>
char *matc_schema(void) { return strdup(""); }
char *matc_list(void) { return strdup(""); }
char *matc_explain(const char *name)
{
    (void)name;
    return NULL;
}
