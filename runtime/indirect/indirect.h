/* Indirect light, as a scene's `indirect:` says: how it is found, and what the passes have of
 * it. */
#ifndef MATC_INDIRECT_INDIRECT_H
#define MATC_INDIRECT_INDIRECT_H
#include "runtime/frame/frame_pass.h"
#include "runtime/indirect/indirect_state.h"
#include "compiler/base/text.h"
#include "runtime/cache/cache.h"
#include "runtime/draw/screen_pass.h"
#include "runtime/frame/frame_plan.h"
#include "runtime/frame/render_options.h"

enum { INDIRECT_RAYS_MOST = 128 };

/* What may be other than when it was kept: light from other surfaces; openness, wherever it is.
 * Beside objects that moved it may be as well. */
typedef enum { INDIRECT_DOUBT_light = 1, INDIRECT_DOUBT_openness = 2 } IndirectDoubt;

/* The scene has indirect light, and the method by which it is found, never auto. indirect.c */
bool indirect_is(const Render *render);
Word indirect_method(const Render *render);
/* The view is of one of its targets; how many lanes it has, or 0. */
int indirect_view_lanes(const char *view);
/* The view has that name. */
bool indirect_shows(const Render *render, const char *view);
/* What is wrong with the view, of this scene; NULL: nothing. */
const char *indirect_lacks_view(const Render *render);
/* Light goes on from surface to surface more than once. */
bool indirect_is_repeated(const Render *render);
/* What rays find is not at once what the target open gets: it is smoothed, or not of all pixels, or
 * of several bounces. */
bool indirect_is_smoothed(const Render *render);
/* What rays meet is looked for in voxels; and sends cached radiance, not what the picture shows of
 * it. */
bool indirect_reads_voxels(const Render *render);
bool indirect_reads_radiance(const Render *render);
/* Light from all around comes by the rays that meet nothing, as it is not the same from everywhere.
 * GLSL for it; tells a pass, and binds, one unit. indirect_around.c */
bool indirect_is_directional(const Render *render);
enum { INDIRECT_AROUND_DEFINITION = 256 };
void indirect_around_add(const Render *render, char defined[INDIRECT_AROUND_DEFINITION],
                         ScreenPassText *text);
void indirect_around_set(const Render *render, int unit, ScreenPass *pass);
void indirect_around_bind(const Render *render, int unit);
/* Of a pixel for which rays go out, in those of the picture. */
int indirect_coarse(const Render *render);
/* The same while something moves, if that is more; else 0. */
int indirect_moving(const Render *render);
/* This frame's is that. */
bool indirect_moves(const Render *render);
/* To how many of these on each side what rays find is smoothed, at most; 0: it is not. */
int indirect_filter_size(const Render *render, int coarse);
/* Pixels around a tile that it has to be drawn with, so that it is as in the whole picture; -1:
 * that is drawn at once. indirect_tile.c */
int indirect_margin(const Render *render);
/* Of these, those that smoothing looks at. */
int pass_smooth_reach(const Render *render);
/* How far the method hybrid follows rays through the picture, in the world's units. */
double indirect_near(const Render *render);
/* How far rays go, in the world's units. */
double indirect_radius(const Scene *scene, const Cache *cache);

/* The camera, the tile or objects are others. */
void pass_rays_place(Render *render);
void pass_rays_draw(Render *render);
/* For one more bounce, by what is in the target open. */
void pass_rays_draw_again(Render *render);
/* Frames before count, or several sets of rays do. */
bool indirect_keeps(const Render *render);
/* Sets of rays that count. */
int indirect_most_sets(const Render *render);
/* No further rays go out. */
bool indirect_is_done(const Render *render);
/* Means over what is kept. */
GLuint indirect_kept(const Render *render);
/* Something has changed: what is kept holds where the same is seen, if frames before are to count;
 * else none of it. */
void indirect_forget(Render *render);
/* Something is another than in the frame before. What is kept holds the less: a sum of
 * IndirectDoubt. */
void indirect_doubt(Render *render, unsigned doubts);
bool pass_smooth_needed(const Render *render);
/* A pass of indirect_place.glsl: its texts' first pieces, and what it reads. indirect_pass.c */
enum { INDIRECT_DEFINITIONS = 768, INDIRECT_DEPTH_UNIT = FRAMEBUFFER_COLORS, INDIRECT_FREE_UNIT };
void indirect_define(const Render *render, int coarse, char text[INDIRECT_DEFINITIONS]);
const char *indirect_surface_text(const Render *render);
void indirect_set(const Render *render, ScreenPass *pass);
void indirect_bind(const Render *render);
/* Opaque infinite planes that rays meet where they go through voxels, as many as there may be; GLSL
 * for it, "" without any; told to a pass. indirect_planes.c */
enum { INDIRECT_PLANES_MOST = 16, INDIRECT_PLANES_DEFINITION = 48 };
int indirect_planes_count(const Render *render);
void indirect_planes_define(const Render *render, char text[INDIRECT_PLANES_DEFINITION]);
/* Lines on these, and on the method, for --stats. */
void indirect_planes_put(Text *out, const Render *render);
void indirect_planes_set(const Render *render, ScreenPass *pass);
void indirect_delete(Render *render);
/* The view shows the depth buffer as a mesh, seen from the side. */
bool pass_positions_is_view(const char *view);
/* The rows of the frame graph. */
extern const FramePass pass_positions, pass_rays, pass_history, pass_smooth, pass_spread,
    pass_combine;
#endif
