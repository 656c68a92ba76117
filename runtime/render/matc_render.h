/* matc's renderer: scenes (YAML, JSON) drawn on a GL context that the caller made. The public
 * header of libmatc_render, which has all of libmatc (matc.h) in it: link one of the two.
 *
 *     MatcDocument *document;
 *     MatcScene *scene = matc_scene_read("scene.yaml", text, size, NULL, &document);
 *     MatcRenderOptions options = {.size = sizeof options, .load = load};
 *     MatcRender *render = scene ? matc_render_open(&options, error, sizeof error) : NULL;
 *     if (render && matc_render_scene(render, scene) && matc_render_frame(render))
 *         show(matc_render_texture(render));
 *     matc_render_close(render);
 *     matc_scene_free(scene);
 *     matc_document_free(document);
 *
 * The context is OpenGL 3.3 core or later, current on the calling thread at every call, and stays
 * the caller's: it is neither made, nor made current, nor closed here. Calls expect the state that
 * a context begins with, and leave it so, but for what is bound, the viewport, and
 * GL_UNPACK_ALIGNMENT and GL_PACK_ALIGNMENT, which are 1. Nothing is printed, nothing exits; only
 * running out of memory in the compiler ends the process, by abort().
 *
 * Every function answers every call: for NULL, an index outside of what there is, or a number that
 * is not finite, it returns false, -1, 0 or NULL, and all stays as it was. matc_render_error() and
 * matc_scene_error() say why, unless the handle itself is NULL; the find functions of objects and
 * lights return -1 without a reason. What cannot be checked: that a pointer which is not NULL
 * points to as much as is said, and that a handle has not been freed.
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

/* Reads a document that is a scene; docs/reference/language.md has its keys. NULL: it has faults,
 * or no keys of a scene; *document then says which. The document is the caller's, and goes after
 * the scene. `options`: NULL is the defaults. */
MATC_API MatcScene *matc_scene_read(const char *name, const char *text, size_t size,
                                    const MatcOptions *options, MatcDocument **document);
/* After every renderer that draws it. NULL is nothing. */
MATC_API void matc_scene_free(MatcScene *scene);
/* Objects, those of groups and copies too, in the order of the document; lights likewise. */
MATC_API int matc_scene_object_count(const MatcScene *scene);
MATC_API int matc_scene_light_count(const MatcScene *scene);
MATC_API int matc_scene_material_count(const MatcScene *scene);
/* From an object's space to the world, by columns: matrix[4 * column + row]. The identity where
 * there is no such object. */
MATC_API void matc_scene_matrix(const MatcScene *scene, int object, double matrix[16]);
/* Why the last call that returned false or -1 did. */
MATC_API const char *matc_scene_error(const MatcScene *scene);

/* -- Names: the `name:` of objects and lights, names under `materials:`
 * ------------------------- */

/* The name of an object behind those of its groups, "lamps/bulb"; NULL: it has none. */
MATC_API const char *matc_scene_object_name(const MatcScene *scene, int object);
/* The first object behind `after` (-1: of all) that has a name, or lies in a group of that name,
 * "lamps"; -1: none.
 *
 *     for (int i = -1; (i = matc_scene_find_object(scene, "lamps", i)) >= 0;)
 *         matc_scene_set_visible(scene, i, false); */
MATC_API int matc_scene_find_object(const MatcScene *scene, const char *name, int after);
MATC_API int matc_scene_find_light(const MatcScene *scene, const char *name);
/* A material of the document; one that no object has yet becomes a material of the scene. -1: there
 * is none. */
MATC_API int matc_scene_find_material(MatcScene *scene, const char *name);

/* -- Editing: matc_renderer_update() draws what was changed, and indices stay as they are
 * ------- */

/* Triangles in memory, which are copied. Whether normals and coordinates are given or not, tangents
 * are derived from them. */
typedef struct {
    size_t size;            /* in bytes, of the struct that the caller was compiled with */
    const float *positions; /* three a vertex, each below 1e18 */
    const float *normals;   /* three a vertex; NULL: those of the faces, smoothed */
    const float *texcoords; /* two a vertex; NULL: longitude and latitude */
    /* three a triangle, counterclockwise from its front; NULL: each three vertices are one */
    const unsigned *indices;
    int vertex_count, index_count;
} MatcMesh;
/* The index of the mesh, for any number of objects; -1: see matc_scene_error(). A scene with
 * displaced objects takes none. */
MATC_API int matc_scene_add_mesh(MatcScene *scene, const MatcMesh *mesh);
/* The index of the object, which may be that of a removed one; -1. Its material does not
 * displace. */
MATC_API int matc_scene_add_object(MatcScene *scene, int mesh, int material,
                                   const double world_from_local[16]);
MATC_API bool matc_scene_remove_object(MatcScene *scene, int object);
/* An object that is not visible casts no shadows either, and nothing of it is drawn. */
MATC_API bool matc_scene_set_visible(MatcScene *scene, int object, bool visible);

typedef void (*MatcRenderProc)(void);
typedef struct {
    size_t size; /* in bytes, of the struct that the caller was compiled with */
    /* gives "glClear", ...; NULL: the driver has none */
    MatcRenderProc (*load)(void *user, const char *name);
    void *user; /* for load */
    /* how programs compute; NULL: the defaults */
    const MatcOptions *compile;
    const char *view;  /* "shown", the picture (NULL), "light", "depth", or a slot: "normal", ... */
    int width, height; /* of the picture; 0: as the scene says */
} MatcRenderOptions;

/* NULL: `error`, of so many bytes, says why. */
MATC_API MatcRender *matc_render_open(const MatcRenderOptions *options, char *error, size_t room);
/* With all that it made on the context. NULL is nothing. */
MATC_API void matc_render_close(MatcRender *render);
/* Why the last call that returned false did. */
MATC_API const char *matc_render_error(const MatcRender *render);

/* Makes what drawing the scene takes: programs, meshes, pictures, targets. Those that the scene
 * before had are not made again. */
MATC_API bool matc_render_scene(MatcRender *render, MatcScene *scene);
/* Changes of the scene that is drawn; nothing is made for them, but meshes that are displaced
 * otherwise then: where a material displaces an object by where it is or how large, or by the
 * param. Positions are the world's, wherever the scene lies: it is drawn relative to an origin near
 * the camera. A camera that has gone 1,024 times its distance from the target takes that origin
 * with it, for which all is made again. */
MATC_API bool matc_render_move(MatcRender *render, int object, const double world_from_local[16]);
MATC_API bool matc_render_look(MatcRender *render, const double position[3], const double target[3],
                               const double up[3]);
/* `position` counts for lights that have one; `rgb` is intensity times colour. */
MATC_API bool matc_render_light(MatcRender *render, int light, const double position[3],
                                const double rgb[3]);
/* How a light casts shadows, by a word of `shadows:`, as "map" or "none". What is made of the scene
 * is made anew where that is another than before. False: the light or the driver cannot have it,
 * and all is as it was. */
MATC_API bool matc_render_shadows(MatcRender *render, int light, const char *method);
/* A param of a document's material, of 1 to 4 lanes. */
MATC_API bool matc_render_param(MatcRender *render, int material, const char *name,
                                const float *lanes, int count);

/* The angle of view over the picture's shorter side in degrees, from 0 to 180; what is nearer than
 * `near` is not drawn. */
MATC_API bool matc_renderer_set_perspective(MatcRender *render, double angle, double near);
/* The length that the picture's shorter side shows, and how far is seen, both in world units. */
MATC_API bool matc_renderer_set_orthographic(MatcRender *render, double size, double depth);
/* The time of materials in seconds. Meshes that are displaced keep their shape. */
MATC_API bool matc_renderer_set_time(MatcRender *render, double seconds);
/* The picture's size in pixels, up to 16,384 each way; 0: the scene's. Targets are made anew.
 * False: the size stays. */
MATC_API bool matc_renderer_set_size(MatcRender *render, int width, int height);
/* Takes what matc_scene_add_object(), _remove_object() and _set_visible() changed in the scene that
 * is drawn. Programs, pictures and meshes stay; params keep their values. */
MATC_API bool matc_renderer_update(MatcRender *render);

/* Draws a frame, and copies the picture to a framebuffer of the caller's: x, y, width and height of
 * a rectangle in pixels, from the lower left. Where it has another size than the picture, it is
 * scaled with linear filtering. 0 is the default framebuffer. Only color is written: the bytes of
 * sRGB, so GL_FRAMEBUFFER_SRGB is to be off. */
MATC_API bool matc_renderer_draw(MatcRender *render, unsigned framebuffer, const int rectangle[4]);
MATC_API bool matc_render_frame(MatcRender *render);
MATC_API int matc_render_width(const MatcRender *render);
MATC_API int matc_render_height(const MatcRender *render);
/* The texture of the picture, RGBA8 in sRGB; 0: the view is another. It is the renderer's, until
 * the next scene. */
MATC_API unsigned matc_render_texture(const MatcRender *render);
/* The view, four floats a pixel, rows from the bottom up: "shown" is sRGB, "light" linear, "depth"
 * in the first lane. */
MATC_API bool matc_render_read(MatcRender *render, float *floats);

#ifdef __cplusplus
}
#endif
#endif
