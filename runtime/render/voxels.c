/* Views of voxels by their names. */
#include "runtime/render/voxels.h"
#include <string.h>

/* No level has two digits: 512 voxels have ten. */
int voxels_view_level(const char *view)
{
    static const char name[] = "voxels";
    if (!view || strncmp(view, name, strlen(name)) != 0)
        return -1;
    const char *digit = view + strlen(name);
    return !*digit ? 0 : *digit >= '0' && *digit <= '9' && !digit[1] ? *digit - '0' : -1;
}
