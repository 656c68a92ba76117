/* matc's renderer: scenes (YAML, JSON) drawn on a GL context that the caller made. The public
 * header of libmatc_render, which contains all of libmatc (matc.h): link only one of the two.
 *
 *     MatcDocument *document;
 *     MatcScene *scene = matc_scene_read("scene.yaml", text, size, NULL, &document);
 *     MatcRendererOptions options = {.size = sizeof options, .load = load};
 *     MatcRenderer *render = scene ? matc_renderer_open(&options, error, sizeof error) : NULL;
 *     if (render && matc_renderer_set_scene(render, scene) && matc_renderer_frame(render))
 *         show(matc_renderer_texture(render));
 *     matc_renderer_close(render);
 *     matc_scene_free(scene);
 *     matc_document_free(document);
 *
 * The context is OpenGL 3.3 core or later and current on the calling thread at every call. The
 * caller owns the context: the library neither makes it, nor makes it current, nor closes it.
 * Calls expect the initial state of a context and restore it, except for bindings, the viewport,
 * and GL_UNPACK_ALIGNMENT and GL_PACK_ALIGNMENT, which are 1. The library prints nothing and
 * never exits; only running out of memory in the compiler ends the process, by abort().
 *
 * All functions check their arguments: for NULL, an index out of range, or a number that is not
 * finite, they return false, -1, 0 or NULL and change nothing. matc_renderer_error() and
 * matc_scene_error() return the reason, unless the handle itself is NULL; the find functions of
 * objects and lights return -1 without a reason. The library cannot check that a non-NULL
 * pointer has the documented number of elements, or that a handle has not been freed.
 *
 * A program keeps working with a later library of the same number, as with libmatc's. */
#ifndef MATC_RENDERER_HOST_H
#define MATC_RENDERER_HOST_H
#include "matc.h"

#ifdef __cplusplus
extern "C" {
#endif

/* -- Scenes */

typedef struct MatcScene MatcScene;
typedef struct MatcRenderer MatcRenderer;

/* Reads a document that is a scene; build/reference/scenes.md lists its keys. Returns NULL if
 * the document has errors or no keys of a scene; *document then has the messages. The caller
 * owns the document and frees it after the scene. NULL `options` are the defaults. */
MATC_API MatcScene *matc_scene_read(const char *name, const char *text, size_t size,
                                    const MatcOptions *options, MatcDocument **document);
/* Frees a scene, after every renderer that draws it. Does nothing for NULL. */
MATC_API void matc_scene_free(MatcScene *scene);
/* Numbers of objects, including those of groups and copies, in the order of the document; of
 * lights, in the same order; of materials. */
MATC_API int matc_scene_object_count(const MatcScene *scene);
MATC_API int matc_scene_light_count(const MatcScene *scene);
MATC_API int matc_scene_material_count(const MatcScene *scene);
/* Returns the transform from an object's space to world space, by columns: matrix[4 * column +
 * row]. The identity if the object does not exist. */
MATC_API void matc_scene_matrix(const MatcScene *scene, int object, double matrix[16]);
/* Returns the reason why the last call returned false or -1. */
MATC_API const char *matc_scene_error(const MatcScene *scene);

/* -- Names: the `name:` of objects and lights, and names under `materials:` */

/* Returns the name of an object, preceded by those of its groups, such as "lamps/bulb"; NULL if
 * it has none. */
MATC_API const char *matc_scene_object_name(const MatcScene *scene, int object);
/* Returns the first object after `after` (-1: the first of all) that has the name, or is in a
 * group with the given name, such as "lamps"; -1 if none is left.
 *
 *     for (int i = -1; (i = matc_scene_find_object(scene, "lamps", i)) >= 0;)
 *         matc_scene_set_visible(scene, i, false); */
MATC_API int matc_scene_find_object(const MatcScene *scene, const char *name, int after);
MATC_API int matc_scene_find_light(const MatcScene *scene, const char *name);
/* Returns a material of the document. A material that no object uses yet is added to the scene.
 * -1 if the document has no such material. */
MATC_API int matc_scene_find_material(MatcScene *scene, const char *name);

/* -- Editing: matc_renderer_update() draws the changes; indices stay valid */

/* Triangles in memory, which are copied. Tangents are derived from normals and texture
 * coordinates, given or generated. */
typedef struct {
    size_t size;            /* sizeof(MatcMesh), as the caller was compiled */
    const float *positions; /* three numbers per vertex, each below 1e18 */
    const float *normals;   /* three numbers per vertex; NULL: smoothed normals of the faces */
    const float *texcoords; /* two numbers per vertex; NULL: longitude and latitude */
    /* Three per triangle, counterclockwise from the front; NULL: each three vertices are a
     * triangle. */
    const unsigned *indices;
    int vertex_count, index_count;
} MatcMesh;
/* Adds a mesh and returns its index, for any number of objects; -1: see matc_scene_error().
 * Fails for a scene with displaced objects. */
MATC_API int matc_scene_add_mesh(MatcScene *scene, const MatcMesh *mesh);
/* Adds an object and returns its index, which may be that of a removed object; -1 on failure.
 * The material must not displace. */
MATC_API int matc_scene_add_object(MatcScene *scene, int mesh, int material,
                                   const double world_from_local[16]);
MATC_API bool matc_scene_remove_object(MatcScene *scene, int object);
/* Shows or hides an object. A hidden object is not drawn and casts no shadows. */
MATC_API bool matc_scene_set_visible(MatcScene *scene, int object, bool visible);

/* -- Renderers */

typedef void (*MatcRendererProc)(void);
typedef struct {
    size_t size; /* sizeof(MatcRendererOptions), as the caller was compiled */
    /* Returns the address of a GL function such as "glClear"; NULL if the driver lacks it. */
    MatcRendererProc (*load)(void *user, const char *name);
    void *user; /* passed to load */
    /* compile options of all programs; NULL: the defaults */
    const MatcOptions *compile;
    /* "final", the picture (NULL), "light", "depth", or a slot such as "normal" */
    const char *view;
    int width, height; /* size of the picture; 0: the scene's size */
} MatcRendererOptions;

/* Opens a renderer. Returns NULL on failure, with the reason in `error`, which holds `capacity`
 * bytes. */
MATC_API MatcRenderer *matc_renderer_open(const MatcRendererOptions *options, char *error,
                                          size_t capacity);
/* Closes a renderer and frees all its GL objects. Does nothing for NULL. */
MATC_API void matc_renderer_close(MatcRenderer *renderer);
/* Returns the reason why the last call returned false. */
MATC_API const char *matc_renderer_error(const MatcRenderer *renderer);

/* -- Drawing a scene, and changes to it */

/* Makes the resources for drawing the scene: programs, meshes, textures, targets. Reuses those
 * of the previous scene. */
MATC_API bool matc_renderer_set_scene(MatcRenderer *renderer, MatcScene *scene);
/* Changes to the scene in use. They need no rebuild, except of meshes whose displacement
 * changes, because a material displaces by the object's position or size, or by a parameter.
 * Positions are in world space, wherever the scene lies: drawing is relative to an origin near
 * the camera. A camera that travels 1,024 times its distance from the target moves that origin,
 * which rebuilds everything. */
MATC_API bool matc_renderer_set_object(MatcRenderer *renderer, int object,
                                       const double world_from_local[16]);
MATC_API bool matc_renderer_set_camera(MatcRenderer *renderer, const double position[3],
                                       const double target[3], const double up[3]);
/* Moves and recolors a light. `position` is ignored for lights without a position; `rgb` is
 * intensity times color. */
MATC_API bool matc_renderer_set_light(MatcRenderer *renderer, int light, const double position[3],
                                      const double rgb[3]);
/* Sets the shadow technique of a light, by a keyword of `shadows:`, such as "map" or "none". A
 * change rebuilds the scene's resources. Returns false, without any change, if the light or the
 * driver does not support the technique. */
MATC_API bool matc_renderer_set_shadows(MatcRenderer *renderer, int light, const char *method);
/* Sets a parameter of a document's material, of 1 to 4 components. */
MATC_API bool matc_renderer_set_param(MatcRenderer *renderer, int material, const char *name,
                                      const float *components, int count);

/* Sets a perspective camera: angle of view over the picture's shorter side in degrees, between 0
 * and 180; distance of the near plane. */
MATC_API bool matc_renderer_set_perspective(MatcRenderer *renderer, double angle, double near);
/* Sets an orthographic camera: length shown by the picture's shorter side, and depth of the
 * view, both in world units. */
MATC_API bool matc_renderer_set_orthographic(MatcRenderer *renderer, double size, double depth);
/* Sets the time of materials in seconds. Displaced meshes keep their shape. */
MATC_API bool matc_renderer_set_time(MatcRenderer *renderer, double seconds);
/* Sets the picture's size in pixels, at most 16,384 per axis; 0: the scene's size. Rebuilds the
 * targets. Returns false and keeps the old size on failure. */
MATC_API bool matc_renderer_set_size(MatcRenderer *renderer, int width, int height);
/* Applies the changes of matc_scene_add_object(), _remove_object() and _set_visible() to the
 * scene in use. Keeps programs, textures, meshes, and the values of parameters. */
MATC_API bool matc_renderer_update(MatcRenderer *renderer);

/* -- Pictures */

/* Draws a frame and copies the picture to a framebuffer of the caller's: x, y, width and height
 * of a rectangle in pixels, from the lower left. A rectangle of another size than the picture is
 * scaled with linear filtering. 0 is the default framebuffer. Only color is written, as sRGB
 * bytes, so GL_FRAMEBUFFER_SRGB must be off. */
MATC_API bool matc_renderer_draw(MatcRenderer *renderer, unsigned framebuffer,
                                 const int rectangle[4]);
MATC_API bool matc_renderer_frame(MatcRenderer *renderer);
MATC_API int matc_renderer_width(const MatcRenderer *renderer);
MATC_API int matc_renderer_height(const MatcRenderer *renderer);
/* Returns the texture of the picture, RGBA8 in sRGB; 0 for any other view. The renderer owns the
 * texture, which is valid until the next scene. */
MATC_API unsigned matc_renderer_texture(const MatcRenderer *renderer);
/* Reads the view, four floats per pixel, rows from the bottom up: "final" is sRGB, "light" is
 * linear, "depth" is in the first component. */
MATC_API bool matc_renderer_read(MatcRenderer *renderer, float *floats);

#ifdef __cplusplus
}
#endif
#endif
