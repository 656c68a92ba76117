/* The library's surface: what scene.h and render.h offer, for a host that sees neither. */
#include "runtime/render/matc_render.h"
#include "compiler/base/memory.h"
#include "compiler/document.h"
#include "runtime/frame/frame.h"
#include "runtime/gl/message.h"
#include "runtime/render/render.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_origin.h"
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct MatcScene {
    Scene *scene;
};

struct MatcRender {
    GlContext *gl;
    Render *render;
    Scene *scene; /* the caller's */
};

/* -- scenes */

MatcScene *matc_scene_read(const char *name, const char *text, size_t size, const MatcOptions *options,
                           MatcDocument **document)
{
    MatcOptions defaults;
    MatcScene *made = calloc(1, sizeof *made);
    if (!made)
        memory_exhausted();
    matc_options_init(&defaults);
    defaults.pixels = true;
    *document = scene_read(name, text, size, options ? options : &defaults, &made->scene);
    if (made->scene)
        return made;
    if (!matc_error_count(*document))
        diag_add(&(*document)->session, NO_SPAN, DIAG_no_scene);
    free(made);
    return NULL;
}

void matc_scene_free(MatcScene *scene)
{
    if (scene)
        scene_free(scene->scene);
    free(scene);
}

int matc_scene_object_count(const MatcScene *scene) { return scene->scene->object_count; }
int matc_scene_light_count(const MatcScene *scene) { return scene->scene->light_count; }
int matc_scene_material_count(const MatcScene *scene) { return scene->scene->material_count; }

void matc_scene_matrix(const MatcScene *scene, int object, double matrix[16])
{
    memcpy(matrix, scene->scene->objects[object].world_from_local.m, sizeof(SceneMatrix));
    scene_origin_from(scene->scene, scene->scene->objects[object].world_from_local.m + 12, matrix + 12);
}

/* -- renderers */

static bool open_render(MatcRender *r, const MatcRenderOptions *options, char *error, size_t room)
{
    const GlHost host = {options->load, options->user};
    MatcOptions defaults;
    matc_options_init(&defaults);
    defaults.pixels = true;
    r->gl = gl_adopt(&host, error, room);
    if (!r->gl)
        return false;
    r->render = render_open(r->gl, &(RenderOptions){.compile = options->compile ? options->compile : &defaults,
                                                    .view = options->view,
                                                    .width = options->width,
                                                    .height = options->height,
                                                    .memory = SIZE_MAX}); /* a texture has the whole picture */
    return r->render || message_fail(error, room, "%s", r->gl->error);
}

MatcRender *matc_render_open(const MatcRenderOptions *options, char *error, size_t room)
{
    MatcRenderOptions whole = {0};
    MatcRender *r = calloc(1, sizeof *r);
    if (!r)
        memory_exhausted();
    memcpy(&whole, options, options->size < sizeof whole ? options->size : sizeof whole);
    if (!options->size)
        message_fail(error, room, "MatcRenderOptions.size is 0: it is to be sizeof(MatcRenderOptions)");
    else if (whole.load ? open_render(r, &whole, error, room) : message_fail(error, room, "no function that loads is given"))
        return r;
    matc_render_close(r);
    return NULL;
}

void matc_render_close(MatcRender *r)
{
    if (!r)
        return;
    render_close(r->render);
    gl_close(r->gl);
    free(r);
}

const char *matc_render_error(const MatcRender *r) { return r->gl->error; }

bool matc_render_scene(MatcRender *r, MatcScene *scene)
{
    r->scene = scene->scene;
    if (render_scene(r->render, r->scene))
        return true;
    r->scene = NULL;
    return false;
}

/* -- changes */

static bool has(const MatcRender *r, int number, int count, const char *what)
{
    if (!r->scene)
        return gl_fail(r->gl, "there is no scene to change");
    return (number >= 0 && number < count) || gl_fail(r->gl, "there is no %s %d", what, number);
}

static bool not_displaced(const MatcRender *r)
{
    const SceneMaterial *of;
    const char *why = scene_displace_fault(r->scene, &of);
    return gl_fail(r->gl, "the material '%s': its displacement %s", matc_material_name(of->document, of->index), why);
}

bool matc_render_move(MatcRender *r, int object, const double matrix[16])
{
    if (!has(r, object, r->scene ? r->scene->object_count : 0, "object"))
        return false;
    for (int i = 0; i < 16; i++)
        if (!isfinite(matrix[i]))
            return gl_fail(r->gl, "the matrix has what is no number");
    SceneMatrix *at = &r->scene->objects[object].world_from_local;
    const SceneMatrix before = *at;
    memcpy(at->m, matrix, sizeof *at);
    scene_origin_to(r->scene, matrix + 12, at->m + 12);
    const SceneDisplaced meshes = scene_displace_moved(r->scene, object, 1);
    if (meshes == SCENE_DISPLACED_failed) {
        *at = before;
        return not_displaced(r);
    }
    return meshes == SCENE_DISPLACED_anew ? render_changed_meshes(r->render)
                                          : render_changed_objects(r->render, object, 1);
}

bool matc_render_look(MatcRender *r, const double position[3], const double target[3], const double up[3])
{
    SceneCamera camera;
    double upright[3];
    if (!has(r, 0, 1, "camera"))
        return false;
    camera = r->scene->camera;
    scene_origin_to(r->scene, position, camera.position);
    scene_origin_to(r->scene, target, camera.target);
    for (int i = 0; i < 3; i++) {
        camera.back[i] = position[i] - target[i];
        upright[i] = up[i];
    }
    if (!scene_vector_normalize(camera.back) || !scene_vector_normalize(upright))
        return gl_fail(r->gl, "the way from position to target, or up, has no direction");
    scene_vector_cross(upright, camera.back, camera.right);
    if (scene_vector_dot(camera.right, camera.right) < 1e-18 || !scene_vector_normalize(camera.right))
        return gl_fail(r->gl, "up, seen along the view, has no direction");
    scene_vector_cross(camera.back, camera.right, camera.up);
    r->scene->camera = camera;
    scene_origin_follow(r->scene, &r->scene->camera);
    return render_changed(r->render, RENDER_CAMERA);
}

bool matc_render_light(MatcRender *r, int light, const double position[3], const double rgb[3])
{
    if (!has(r, light, r->scene ? r->scene->light_count : 0, "light"))
        return false;
    scene_origin_to(r->scene, position, r->scene->lights[light].position);
    memcpy(r->scene->lights[light].light, rgb, 3 * sizeof *rgb);
    return render_changed(r->render, RENDER_LIGHTS);
}

static bool find_method(const char *name, Word *made)
{
    for (int i = 0; i < WORD_COUNT; i++)
        if (scene_shadows_name((Word)i) && !strcmp(scene_shadows_name((Word)i), name)) {
            *made = (Word)i;
            return true;
        }
    return false;
}

bool matc_render_shadows(MatcRender *r, int light, const char *method)
{
    char why[sizeof r->gl->error];
    if (!has(r, light, r->scene ? r->scene->light_count : 0, "light"))
        return false;
    SceneLight *of = &r->scene->lights[light];
    const Word before = of->shadows;
    Word word;
    if (!method || !find_method(method, &word) || !scene_light_takes(of, word))
        return gl_fail(r->gl, "the light %d cannot have shadows '%s'", light, method ? method : "");
    of->shadows = word;
    if (render_changed(r->render, RENDER_LIGHTS))
        return true;
    snprintf(why, sizeof why, "%s", r->gl->error);
    of->shadows = before;
    render_again(r->render, r->scene);
    return gl_fail(r->gl, "%s", why);
}

bool matc_render_param(MatcRender *r, int material, const char *name, const float *lanes, int count)
{
    double values[4] = {0};
    if (!has(r, material, r->scene ? r->scene->material_count : 0, "material"))
        return false;
    for (int i = 0; i < count && i < 4; i++)
        values[i] = (double)lanes[i];
    const SceneDisplaced meshes = scene_displace_param(r->scene, material, name, values, count);
    if (meshes == SCENE_DISPLACED_failed)
        return not_displaced(r);
    const bool drawn = render_param(r->render, material, name, lanes, count);
    return meshes == SCENE_DISPLACED_anew ? render_changed_meshes(r->render) : drawn || meshes == SCENE_DISPLACED_same;
}

/* -- frames */

bool matc_render_frame(MatcRender *r) { return render_frame(r->render); }
int matc_render_width(const MatcRender *r) { return render_width(r->render); }
int matc_render_height(const MatcRender *r) { return render_height(r->render); }
unsigned matc_render_texture(const MatcRender *r) { return frame_texture(r->render, FRAME_TARGET_shown, 0); }
bool matc_render_read(MatcRender *r, float *rgba) { return render_read(r->render, rgba); }
