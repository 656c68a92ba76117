/* Rays from many points through the voxels of a scene, traced by one full-screen pass, for tests
 * and benchmarks. */
#ifndef MATC_VOXEL_POINTS_H
#define MATC_VOXEL_POINTS_H
#include "runtime/frame_graph/frame.h"

enum { VOXEL_POINTS_TEXELS = 4 };

/* Texels of a point: its position in grid units, with w 1, or 0 for no point; two tangents, and
 * the normal. Directions are relative to the normal, z. */
typedef struct {
    int wide, high, rays;
    float (*texels)[VOXEL_POINTS_TEXELS][4];
    float (*directions)[4];
} VoxelPoints;

/* Makes wide x high points and across x across cosine-weighted directions, one for each cell of
 * the unit square. The texels are 0. Returns false if memory ran out. */
bool voxel_points_make(int wide, int high, int across, VoxelPoints *made);
/* Sets a point by its world position and unit normal; chooses its tangents. */
void voxel_points_set(const VoxelPoints *points, int number, const VoxelGrid *grid,
                      const double world[3], const double normal[3]);
void voxel_points_free(VoxelPoints *points);

/* A pass over points: voxel_map.glsl and voxel_ray.glsl are followed by GLSL of `bool
 * pointRay(vec3 from, vec3 way, float far, out float count)`, which returns true for a hit and
 * counts the steps. */
typedef struct {
    ScreenPass pass;
    Framebuffer target;
    GLuint textures[2];
} VoxelPointsPass;

extern const char voxel_points_ray[];
/* `off`: start offset of rays from the surface, in voxels; 0: that of voxelStart. Returns false
 * with a message in the context's error. */
bool voxel_points_open(const Renderer *renderer, const VoxelPoints *points,
                       const char *const glsl[2], VoxelPointsPass *made);
/* Result x: the share of a point's rays, `radius` voxels long, that miss; y: the mean count. */
void voxel_points_run(const Renderer *renderer, VoxelPointsPass *pass, float radius, float off);
void voxel_points_close(const Renderer *renderer, VoxelPointsPass *pass);
#endif
