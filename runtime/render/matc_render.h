/* matc's renderer: scenes (YAML, JSON) drawn on a GL context that the caller made. The public header of libmatc_render, which has all of
 * libmatc (matc.h) in it: link one of the two.
 *
 *     MatcDocument *document;
 *     MatcScene *scene = matc_scene_read("scene.yaml", text, size, NULL, &document);
 *     MatcRender *render = scene ? matc_render_open(&(MatcRenderOptions){.size = sizeof(MatcRenderOptions), .load = load}, error, sizeof error) : NULL;
 *     if (render && matc_render_scene(render, scene) && matc_render_frame(render))
 *         show(matc_render_texture(render));
 *     matc_render_close(render);
 *     matc_scene_free(scene);
 *     matc_document_free(document);
 *
 * The context is OpenGL 3.3 core or later, current on the calling thread at every call, and stays the caller's: it is neither made, nor made
 * current, nor closed here. Calls expect the state that a context begins with, and leave it so, but for what is bound, the viewport, and
 * GL_UNPACK_ALIGNMENT and GL_PACK_ALIGNMENT, which are 1. Nothing is printed, nothing exits; only running out of memory in the compiler ends
 * the process, by abort().
 *
 * A program goes on working with a later library of the same number, as with libmatc's. */
#ifndef MATC_RENDER_HOST_H
#define MATC_RENDER_HOST_H
#include "matc.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct MatcScene MatcScene;
typedef struct MatcRender MatcRender;

/* Reads a document that is a scene; docs/language.md has its keys. NULL: it has faults, or no keys of a scene; *document then says which.
 * The document is the caller's, and goes after the scene. `options`: NULL is the defaults. */
MATC_API MatcScene *matc_scene_read(const char *name, const char *text, size_t size, const MatcOptions *options,
                                    MatcDocument **document);
/* After every renderer that draws it. NULL is nothing. */
MATC_API void matc_scene_free(MatcScene *scene);
/* Objects, those of groups and copies too, in the order of the document; lights likewise. */
MATC_API int matc_scene_object_count(const MatcScene *scene);
MATC_API int matc_scene_light_count(const MatcScene *scene);
MATC_API int matc_scene_material_count(const MatcScene *scene);
/* From an object's space to the world, by columns: matrix[4 * column + row]. */
MATC_API void matc_scene_matrix(const MatcScene *scene, int object, double matrix[16]);

typedef void (*MatcRenderProc)(void);
typedef struct {
    size_t size; /* in bytes, of the struct that the caller was compiled with */
    MatcRenderProc (*load)(void *user, const char *name); /* gives "glClear", ...; NULL: the driver has none */
    void *user;                                           /* for load */
    const MatcOptions *compile;                           /* how programs compute; NULL: the defaults */
    const char *view;  /* "shown", the picture (NULL), "light", "depth", or a slot: "normal", ... */
    int width, height; /* of the picture; 0: as the scene says */
} MatcRenderOptions;

/* NULL: `error`, of so many bytes, says why. */
MATC_API MatcRender *matc_render_open(const MatcRenderOptions *options, char *error, size_t room);
/* With all that it made on the context. NULL is nothing. */
MATC_API void matc_render_close(MatcRender *render);
/* Why the last call that returned false did. */
MATC_API const char *matc_render_error(const MatcRender *render);

/* Makes what drawing the scene takes: programs, meshes, pictures, targets. Those that the scene before had are not made again. */
MATC_API bool matc_render_scene(MatcRender *render, MatcScene *scene);
/* Changes of the scene that is drawn; nothing is made for them, but meshes that are displaced otherwise then: where a material displaces an object by where it is or
 * how large, or by the param. Positions are the world's, wherever the scene lies: it is drawn relative to an origin near the camera. A camera that has gone
 * 1,024 times its distance from the target takes that origin with it, for which all is made again. */
MATC_API bool matc_render_move(MatcRender *render, int object, const double world_from_local[16]);
MATC_API bool matc_render_look(MatcRender *render, const double position[3], const double target[3],
                               const double up[3]);
/* `position` counts for lights that have one; `rgb` is intensity times colour. */
MATC_API bool matc_render_light(MatcRender *render, int light, const double position[3], const double rgb[3]);
/* How a light casts shadows, by a word of `shadows:`: "none", "map", "silhouette", "hybrid", "exact". What is made of the scene is made anew where that is another than before. False:
 * the light or the driver cannot have it, and all is as it was. */
MATC_API bool matc_render_shadows(MatcRender *render, int light, const char *method);
/* A param of a document's material, of 1 to 4 lanes. */
MATC_API bool matc_render_param(MatcRender *render, int material, const char *name, const float *lanes, int count);

MATC_API bool matc_render_frame(MatcRender *render);
MATC_API int matc_render_width(const MatcRender *render);
MATC_API int matc_render_height(const MatcRender *render);
/* The texture of the picture, RGBA8 in sRGB; 0: the view is another. It is the renderer's, until the next scene. */
MATC_API unsigned matc_render_texture(const MatcRender *render);
/* The view, four floats a pixel, rows from the bottom up: "shown" is sRGB, "light" linear, "depth" in the first lane. */
MATC_API bool matc_render_read(MatcRender *render, float *floats);

#ifdef __cplusplus
}
#endif
#endif
