/* Views of voxels by name, and statistics. */
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/frame_graph/frame.h"
#include <string.h>

/* Returns the level of a view's name, which ends in a digit: 512 voxels have ten levels, 0 to 9. */
int voxels_view_level(const char *view)
{
    static const char name[] = "voxels";
    if (!view || strncmp(view, name, strlen(name)) != 0)
        return -1;
    const char *digit = view + strlen(name);
    return !*digit ? 0 : *digit >= '0' && *digit <= '9' && !digit[1] ? *digit - '0' : -1;
}

void voxels_put(Text *out, const Renderer *renderer)
{
    enum { DIGITS = 3 };
    const FrameVoxels *voxels = renderer->voxels;
    const int size = voxels->grid.size;
    int counts[VOXEL_KINDS] = {0}, cut = 0;
    for (int i = 0; i < renderer->gpu_scene.place_count; i++) {
        if (!renderer->gpu_scene.places[i].transparent)
            counts[voxel_bodies_kind(renderer, i)]++;
        cut += renderer->gpu_scene.places[i].cut >= 0;
    }
    text_format(out, "voxels    %d x %d x %d, each ", size, size, size);
    text_rounded(out, voxels->grid.edge, DIGITS);
    text_format(out, " wide\nvoxels    %d bodies, drawn in %d waves; %d surfaces",
                counts[VOXEL_body], voxels->wave_count,
                counts[VOXEL_open] + counts[VOXEL_thin] + counts[VOXEL_crossing] + cut);
    if (counts[VOXEL_open])
        text_format(out, "; %d of these are not closed", counts[VOXEL_open]);
    if (counts[VOXEL_thin])
        text_format(out, "; %d are thinner than 1.5 voxels", counts[VOXEL_thin]);
    if (counts[VOXEL_crossing])
        text_format(out, "; %d cross more bodies than can be told apart", counts[VOXEL_crossing]);
    if (cut)
        text_format(out, "; %d are cut out", cut);
    text_put(out, "\n");
}
