/* The pass rays, and what it shares with the passes that filter its result. */
#ifndef MATC_INDIRECT_PASS_RAYS_H
#define MATC_INDIRECT_PASS_RAYS_H
#include "runtime/frame_graph/frame_pass.h"
#include "runtime/indirect/settings/indirect.h"

enum { INDIRECT_RAYS_MAX = 128 };

/* Traces rays; the second function those of a further bounce, from light in the target ao. */
void pass_rays_draw(Renderer *renderer);
void pass_rays_draw_again(Renderer *renderer);

/* -- Inputs of passes whose GLSL follows indirect_place.glsl. indirect_pass.c */

enum { INDIRECT_DEFINITIONS = 768, INDIRECT_DEPTH_UNIT = FRAMEBUFFER_COLORS, INDIRECT_FREE_UNIT };
/* The pass's first two texts, definitions and the surface's unpacking; its uniforms; its
 * textures. */
void indirect_define(const Renderer *renderer, int coarse, char text[INDIRECT_DEFINITIONS]);
const char *indirect_surface_text(const Renderer *renderer);
void indirect_set(const Renderer *renderer, ScreenPass *pass);
void indirect_bind(const Renderer *renderer);
/* Returns the denoiser's max radius in pixels of the ray pass; 0 disables it. */
int indirect_filter_size(const Renderer *renderer, int coarse);
/* Returns the length of a ray in world units up to which the method hybrid reads the depth
 * buffer. */
double indirect_near(const Renderer *renderer);

/* -- Ambient light that differs by direction, along rays that hit nothing. indirect_around.c */

/* Reports whether ambient light is evaluated per ray. */
bool indirect_is_directional(const Renderer *renderer);
enum { INDIRECT_AROUND_DEFINITION = 256 };
/* Adds the GLSL; `defined` must live as long as the text. */
void indirect_around_add(const Renderer *renderer, char defined[INDIRECT_AROUND_DEFINITION],
                         ScreenPassText *text);
/* Set uniforms and bind one texture unit. */
void indirect_around_set(const Renderer *renderer, int unit, ScreenPass *pass);
void indirect_around_bind(const Renderer *renderer, int unit);

/* -- Opaque infinite planes, which the voxels do not hold. indirect_planes.c */

enum { INDIRECT_PLANES_MAX = 16, INDIRECT_PLANES_DEFINITION = 48 };
int indirect_planes_count(const Renderer *renderer);
/* Writes the definition of the planes' count; "" without planes. */
void indirect_planes_define(const Renderer *renderer, char text[INDIRECT_PLANES_DEFINITION]);
void indirect_planes_set(const Renderer *renderer, ScreenPass *pass);

/* The row of the frame graph. */
extern const FramePass pass_rays;
#endif
