/* The library's public functions for renderers, which wrap renderer.h. matc_scene.c has those for
 * scenes. */
#include "runtime/renderer/matc_render.h"
#include "compiler/base/memory.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/gl/message.h"
#include "runtime/renderer/host.h"
#include "runtime/renderer/renderer.h"
#include "runtime/tessellate/scene_displace.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_origin.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct MatcRenderer {
    GlContext *gl;
    Renderer *renderer;
    Scene *scene;       /* owned by the caller */
    GLuint framebuffer; /* framebuffer for reading the picture's texture; 0: not made yet */
};

#define DEGREE 0.017453292519943295 /* a degree in radians */
enum {
    MAX_PLACE = 1 << 20, /* maximum offset of a rectangle in a framebuffer */
    MAX_SIDE = 16384     /* maximum side of a picture, the limit of `image:` in scene.def */
};

static bool is_size(int width, int height)
{
    return width >= 0 && height >= 0 && width <= MAX_SIDE && height <= MAX_SIDE;
}

/* -- renderers */

static bool check_options(const MatcRendererOptions *options, char *error, size_t capacity)
{
    const char *fault = matc_options_fault(options->compile);
    if (!options->load)
        return message_fail(error, capacity, "no function that loads is given");
    if (!is_size(options->width, options->height))
        return message_fail(error, capacity,
                            "an image must have 1 to %d pixels in each direction, not %d x %d",
                            MAX_SIDE, options->width, options->height);
    return !fault ||
           message_fail(error, capacity,
                        "MatcRendererOptions.compile: the option '%s' has an invalid value", fault);
}

static bool open_renderer(MatcRenderer *r, const MatcRendererOptions *options, char *error,
                          size_t capacity)
{
    const GlHost host = {options->load, options->user};
    MatcOptions defaults;
    matc_options_init(&defaults);
    defaults.pixels = true;
    r->gl = gl_adopt(&host, error, capacity);
    if (!r->gl)
        return false;
    r->renderer = renderer_open(
        r->gl, &(RendererOptions){.compile = options->compile ? options->compile : &defaults,
                                  .view = options->view,
                                  .width = options->width,
                                  .height = options->height,
                                  /* draws a single tile, so that a texture holds the whole
                                   * picture */
                                  .memory = SIZE_MAX});
    return r->renderer || message_fail(error, capacity, "%s", r->gl->error);
}

MatcRenderer *matc_renderer_open(const MatcRendererOptions *options, char *error, size_t capacity)
{
    MatcRendererOptions whole = {0};
    if (!options)
        return message_fail(error, capacity, "the options are NULL"), NULL;
    MatcRenderer *r = calloc(1, sizeof *r);
    if (!r)
        memory_exhausted();
    memcpy(&whole, options, options->size < sizeof whole ? options->size : sizeof whole);
    if (!options->size)
        message_fail(error, capacity,
                     "MatcRendererOptions.size is 0; it must be sizeof(MatcRendererOptions)");
    else if (check_options(&whole, error, capacity) && open_renderer(r, &whole, error, capacity))
        return r;
    matc_renderer_close(r);
    return NULL;
}

void matc_renderer_close(MatcRenderer *r)
{
    if (!r)
        return;
    renderer_close(r->renderer);
    if (r->framebuffer)
        r->gl->DeleteFramebuffers(1, &r->framebuffer);
    gl_close(r->gl);
    free(r);
}

const char *matc_renderer_error(const MatcRenderer *r)
{
    return r ? r->gl->error : "the renderer is NULL";
}

bool matc_renderer_set_scene(MatcRenderer *r, MatcScene *scene)
{
    if (!r || !scene)
        return r && gl_fail(r->gl, "the scene is NULL");
    r->scene = scene->scene;
    if (renderer_set_scene(r->renderer, r->scene))
        return true;
    r->scene = NULL;
    return false;
}

/* -- changes */

static bool has(const MatcRenderer *r, int number, int count, const char *what)
{
    if (!r || !r->scene)
        return r && gl_fail(r->gl, "no scene to change");
    return (number >= 0 && number < count) || gl_fail(r->gl, "no %s %d", what, number);
}

/* Reports whether a caller's numbers are not NULL and all finite; else sets the context's error. */
static bool are_finite(const MatcRenderer *r, const double *numbers, int count, const char *what)
{
    if (!numbers)
        return gl_fail(r->gl, "%s is NULL", what);
    for (int i = 0; i < count; i++)
        if (!isfinite(numbers[i]))
            return gl_fail(r->gl, "%s has what is no number", what);
    return true;
}

static int object_count(const MatcRenderer *r)
{
    return r && r->scene ? r->scene->object_count : 0;
}
static int light_count(const MatcRenderer *r) { return r && r->scene ? r->scene->light_count : 0; }
static int material_count(const MatcRenderer *r)
{
    return r && r->scene ? r->scene->material_count : 0;
}

static bool not_displaced(const MatcRenderer *r)
{
    const SceneMaterial *of;
    const char *why = scene_displace_fault(r->scene, &of);
    return gl_fail(r->gl, "the material '%s': its displacement %s",
                   matc_material_name(of->document, of->index), why);
}

bool matc_renderer_set_object(MatcRenderer *r, int object, const double matrix[16])
{
    if (!has(r, object, object_count(r), "object") || !are_finite(r, matrix, 16, "the matrix"))
        return false;
    SceneMatrix *at = &r->scene->objects[object].world_from_local;
    const SceneMatrix before = *at;
    memcpy(at->m, matrix, sizeof *at);
    scene_origin_to(r->scene, matrix + 12, at->m + 12);
    if (r->scene->objects[object].hidden && !r->scene->displaced)
        return true;
    const SceneDisplaced meshes = scene_displace_moved(r->scene, object, 1);
    if (meshes == SCENE_DISPLACED_failed) {
        *at = before;
        return not_displaced(r);
    }
    return meshes == SCENE_DISPLACED_rebuilt ? renderer_changed_meshes(r->renderer)
                                             : renderer_changed_objects(r->renderer, object, 1);
}

bool matc_renderer_set_camera(MatcRenderer *r, const double position[3], const double target[3],
                              const double up[3])
{
    SceneCamera camera;
    double upright[3];
    if (!has(r, 0, 1, "camera") || !are_finite(r, position, 3, "the position") ||
        !are_finite(r, target, 3, "the target") || !are_finite(r, up, 3, "up"))
        return false;
    camera = r->scene->camera;
    scene_origin_to(r->scene, position, camera.position);
    scene_origin_to(r->scene, target, camera.target);
    for (int i = 0; i < 3; i++) {
        camera.back[i] = position[i] - target[i];
        upright[i] = up[i];
    }
    if (!vec3_normalize(camera.back) || !vec3_normalize(upright))
        return gl_fail(r->gl, "the vector from position to target, or up, has no direction");
    vec3_cross(upright, camera.back, camera.right);
    if (vec3_dot(camera.right, camera.right) < 1e-18 || !vec3_normalize(camera.right))
        return gl_fail(r->gl, "up, seen along the view, has no direction");
    vec3_cross(camera.back, camera.right, camera.up);
    r->scene->camera = camera;
    scene_origin_follow(r->scene, &r->scene->camera);
    return renderer_changed(r->renderer, RENDERER_CAMERA);
}

bool matc_renderer_set_light(MatcRenderer *r, int light, const double position[3],
                             const double rgb[3])
{
    if (!has(r, light, light_count(r), "light") || !are_finite(r, position, 3, "the position") ||
        !are_finite(r, rgb, 3, "the color"))
        return false;
    scene_origin_to(r->scene, position, r->scene->lights[light].position);
    memcpy(r->scene->lights[light].light, rgb, 3 * sizeof *rgb);
    return renderer_changed(r->renderer, RENDERER_LIGHTS);
}

bool matc_renderer_set_perspective(MatcRenderer *r, double angle, double near)
{
    if (!has(r, 0, 1, "camera"))
        return false;
    if (!(angle > 0 && angle < 180) || !(near > 0 && near < INFINITY))
        return gl_fail(
            r->gl,
            "a perspective camera needs an angle between 0 and 180 degrees, and near above 0");
    r->scene->camera.kind = SCENE_Perspective;
    r->scene->camera.half = tan(angle * DEGREE / 2);
    r->scene->camera.near = near;
    return renderer_changed(r->renderer, RENDERER_CAMERA);
}

bool matc_renderer_set_orthographic(MatcRenderer *r, double size, double depth)
{
    if (!has(r, 0, 1, "camera"))
        return false;
    if (!(size > 0 && size < INFINITY) || !(depth > 0 && depth < INFINITY))
        return gl_fail(r->gl, "an orthographic camera needs a size and a depth above 0");
    r->scene->camera.kind = SCENE_Orthographic;
    r->scene->camera.half = size / 2;
    r->scene->camera.depth = depth;
    return renderer_changed(r->renderer, RENDERER_CAMERA);
}

bool matc_renderer_set_time(MatcRenderer *r, double seconds)
{
    if (!has(r, 0, 1, "time"))
        return false;
    if (!isfinite(seconds))
        return gl_fail(r->gl, "the time is no number");
    r->scene->time = seconds;
    return renderer_changed(r->renderer, RENDERER_TIME);
}

bool matc_renderer_set_size(MatcRenderer *r, int width, int height)
{
    if (!r)
        return false;
    if (!is_size(width, height))
        return gl_fail(r->gl, "an image must have 1 to %d pixels in each direction, not %d x %d",
                       MAX_SIDE, width, height);
    return renderer_resize(r->renderer, width, height);
}

bool matc_renderer_update(MatcRenderer *r)
{
    return has(r, 0, 1, "scene") && renderer_changed_meshes(r->renderer);
}

static bool find_method(const char *name, Keyword *made)
{
    for (int i = 0; i < WORD_COUNT; i++)
        if (scene_shadows_name((Keyword)i) && !strcmp(scene_shadows_name((Keyword)i), name)) {
            *made = (Keyword)i;
            return true;
        }
    return false;
}

bool matc_renderer_set_shadows(MatcRenderer *r, int light, const char *method)
{
    char why[sizeof r->gl->error];
    if (!has(r, light, light_count(r), "light"))
        return false;
    SceneLight *of = &r->scene->lights[light];
    const Keyword before = of->shadows;
    Keyword word;
    if (!method || !find_method(method, &word) || !scene_light_takes(of, word))
        return gl_fail(r->gl, "the light %d cannot have shadows '%s'", light, method ? method : "");
    of->shadows = word;
    if (renderer_changed(r->renderer, RENDERER_LIGHTS))
        return true;
    snprintf(why, sizeof why, "%s", r->gl->error);
    of->shadows = before;
    renderer_rebuild(r->renderer, r->scene);
    return gl_fail(r->gl, "%s", why);
}

bool matc_renderer_set_param(MatcRenderer *r, int material, const char *name,
                             const float *components, int count)
{
    enum { COMPONENTS = 4 };
    double values[COMPONENTS] = {0};
    if (!has(r, material, material_count(r), "material"))
        return false;
    if (!name || !components || count < 1 || count > COMPONENTS)
        return gl_fail(r->gl, "a param needs a name and 1 to %d components", COMPONENTS);
    for (int i = 0; i < count; i++)
        values[i] = (double)components[i];
    if (!are_finite(r, values, count, "the param"))
        return false;
    const SceneDisplaced meshes = scene_displace_param(r->scene, material, name, values, count);
    if (meshes == SCENE_DISPLACED_failed)
        return not_displaced(r);
    const bool drawn = renderer_param(r->renderer, material, name, components, count);
    return meshes == SCENE_DISPLACED_rebuilt ? renderer_changed_meshes(r->renderer)
                                             : drawn || meshes == SCENE_DISPLACED_same;
}

/* -- frames */

bool matc_renderer_frame(MatcRenderer *r) { return r && renderer_frame(r->renderer); }
int matc_renderer_width(const MatcRenderer *r) { return r ? renderer_width(r->renderer) : 0; }
int matc_renderer_height(const MatcRenderer *r) { return r ? renderer_height(r->renderer) : 0; }
unsigned matc_renderer_texture(const MatcRenderer *r)
{
    return r && r->scene ? frame_texture(r->renderer, FRAME_TARGET_final, 0) : 0;
}

static bool is_rectangle(const int rectangle[4])
{
    return rectangle[2] > 0 && rectangle[3] > 0 && rectangle[0] > -MAX_PLACE &&
           rectangle[0] < MAX_PLACE && rectangle[1] > -MAX_PLACE && rectangle[1] < MAX_PLACE &&
           rectangle[2] < MAX_PLACE && rectangle[3] < MAX_PLACE;
}

bool matc_renderer_draw(MatcRenderer *r, unsigned framebuffer, const int rectangle[4])
{
    if (!r)
        return false;
    GlContext *gl = r->gl;
    if (!rectangle || !is_rectangle(rectangle))
        return gl_fail(gl, "the rectangle to draw to is empty, or has no place in a framebuffer");
    const unsigned picture = r->scene ? matc_renderer_texture(r) : 0;
    if (r->scene && !picture)
        return gl_fail(gl, "only the view `final` can be drawn to a framebuffer");
    if (!renderer_frame(r->renderer))
        return false;
    if (!r->framebuffer)
        gl->GenFramebuffers(1, &r->framebuffer);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, r->framebuffer);
    gl->FramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                             matc_renderer_texture(r), 0);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    gl->BlitFramebuffer(
        0, 0, renderer_width(r->renderer), renderer_height(r->renderer), rectangle[0], rectangle[1],
        rectangle[0] + rectangle[2], rectangle[1] + rectangle[3], GL_COLOR_BUFFER_BIT,
        rectangle[2] == renderer_width(r->renderer) && rectangle[3] == renderer_height(r->renderer)
            ? GL_NEAREST
            : GL_LINEAR);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    return gl_check(gl, "drawing to a framebuffer");
}

bool matc_renderer_read(MatcRenderer *r, float *rgba)
{
    if (!r || !rgba)
        return r && gl_fail(r->gl, "the pointer to the image is NULL");
    return renderer_read(r->renderer, rgba);
}
