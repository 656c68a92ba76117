/* Rays from many points through the voxels of a scene, traced by one full-screen pass, for tests
 * and benchmarks. */
#ifndef MATC_VOXEL_POINTS_H
#define MATC_VOXEL_POINTS_H
#include "runtime/frame_graph/frame.h"

enum { VOXEL_POINTS_TEXELS = 4 };

/* Texels of a point: its place in the grid's units, w 1, or 0 where there is none; two axes, and
 * the normal. Directions around the normal, z. */
typedef struct {
    int wide, high, rays;
    float (*texels)[VOXEL_POINTS_TEXELS][4];
    float (*directions)[4];
} VoxelPoints;

/* Makes points with across x across directions, one for each cell of the unit square, distributed
 * by the cosine. The texels are 0. False: memory ran out. */
bool voxel_points_make(int wide, int high, int across, VoxelPoints *made);
/* A point of the world, with its unit normal; which axes it gets. */
void voxel_points_set(const VoxelPoints *points, int number, const VoxelGrid *grid,
                      const double world[3], const double normal[3]);
void voxel_points_free(VoxelPoints *points);

/* A pass over points: behind voxel_map.glsl and voxel_ray.glsl stands GLSL of `bool pointRay(vec3
 * from, vec3 way, float far, out float count)`: whether a ray meets something, and what that
 * took. */
typedef struct {
    ScreenPass pass;
    Framebuffer target;
    GLuint textures[2];
} VoxelPointsPass;

extern const char voxel_points_ray[];
/* `off`: how far off the surface rays begin, in voxels; 0: where voxelStart says. False: see the
 * context's error. */
bool voxel_points_open(const Renderer *renderer, const VoxelPoints *points,
                       const char *const glsl[2], VoxelPointsPass *made);
/* x: the share of a point's rays, `radius` voxels long, that meet nothing; y: the mean count. */
void voxel_points_run(const Renderer *renderer, VoxelPointsPass *pass, float radius, float off);
void voxel_points_close(const Renderer *renderer, VoxelPointsPass *pass);
#endif
