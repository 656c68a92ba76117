/* The pass rays, and what it shares with the passes that filter its result. */
#ifndef MATC_INDIRECT_PASS_RAYS_H
#define MATC_INDIRECT_PASS_RAYS_H
#include "runtime/frame/frame_pass.h"
#include "runtime/indirect/settings/indirect.h"

enum { INDIRECT_RAYS_MOST = 128 };

/* Traces rays; for a further bounce from light in the target open. */
void pass_rays_draw(Render *render);
void pass_rays_draw_again(Render *render);

/* -- Passes whose GLSL follows indirect_place.glsl. indirect_pass.c */

enum { INDIRECT_DEFINITIONS = 768, INDIRECT_DEPTH_UNIT = FRAMEBUFFER_COLORS, INDIRECT_FREE_UNIT };
/* The first two texts of such a pass; sets its uniforms; binds its textures. */
void indirect_define(const Render *render, int coarse, char text[INDIRECT_DEFINITIONS]);
const char *indirect_surface_text(const Render *render);
void indirect_set(const Render *render, ScreenPass *pass);
void indirect_bind(const Render *render);
/* The denoiser's radius at most, in pixels from which rays go out; 0 disables it. */
int indirect_filter_size(const Render *render, int coarse);
/* The length of a ray in world units up to which the method hybrid reads the picture. */
double indirect_near(const Render *render);

/* -- Light from all around along rays that meet nothing. indirect_around.c */

/* That light differs by direction. */
bool indirect_is_directional(const Render *render);
enum { INDIRECT_AROUND_DEFINITION = 256 };
/* Adds its GLSL. */
void indirect_around_add(const Render *render, char defined[INDIRECT_AROUND_DEFINITION],
                         ScreenPassText *text);
/* Set and bind one unit. */
void indirect_around_set(const Render *render, int unit, ScreenPass *pass);
void indirect_around_bind(const Render *render, int unit);

/* -- Opaque infinite planes, which are not in the voxels. indirect_planes.c */

enum { INDIRECT_PLANES_MOST = 16, INDIRECT_PLANES_DEFINITION = 48 };
int indirect_planes_count(const Render *render);
/* GLSL, "" without planes. */
void indirect_planes_define(const Render *render, char text[INDIRECT_PLANES_DEFINITION]);
void indirect_planes_set(const Render *render, ScreenPass *pass);

/* The row of the frame graph. */
extern const FramePass pass_rays;
#endif
