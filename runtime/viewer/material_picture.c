/* Draws the preview scenes of materials one after the other, and sets params by their document
 * names. */
#include "runtime/viewer/material_picture.h"
#include "compiler/base/memory.h"
#include "runtime/gl/message.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct MaterialPictures {
    GlContext *gl;
    MaterialPictureOptions options;
    MatcOptions compile;
    ScenePictures *pictures;
    /* the current preview and its predecessor, which the renderer uses until the scene changes */
    Preview previews[2];
    int shown;
};

static const MatcUniform *find_uniform(const MatcProgram *program, const char *param)
{
    for (int i = 0; i < matc_uniform_count(program); i++)
        if (!strcmp(matc_uniform(program, i)->param, param))
            return matc_uniform(program, i);
    return NULL;
}

/* Reports an unknown param and lists the material's params. */
static bool fail_unknown(const MatcProgram *program, const char *name, char *error, size_t capacity)
{
    size_t size =
        (size_t)snprintf(error, capacity, "--param: the material has no param '%s'%s", name,
                         matc_uniform_count(program) ? "; it has" : " and no other");
    for (int i = 0; i < matc_uniform_count(program) && size < capacity; i++)
        size += (size_t)snprintf(error + size, capacity - size, "%s %s", i ? "," : "",
                                 matc_uniform(program, i)->param);
    return false;
}

static bool set_param(MaterialPictures *p, const MatcProgram *program, int number,
                      MaterialReport *reported)
{
    const size_t capacity = sizeof reported->error;
    Param param = p->options.params[number];
    const MatcUniform *uniform = find_uniform(program, param.name);
    const Preview *preview = &p->previews[p->shown];
    if (!uniform)
        return fail_unknown(program, param.name, reported->error, capacity);
    if (!param_fit(&param, uniform->components))
        return message_fail(reported->error, capacity, "--param: '%s' takes %d numbers, not %d",
                            uniform->param, uniform->components, param.components);
    return scene_pictures_param(p->pictures, uniform->name,
                                param.values[param_colors(preview->material.document)],
                                uniform->components) ||
           message_fail(reported->error, capacity, "%s", p->gl->error);
}

static MatcProgram *compile(const MaterialPictures *p, unsigned outputs)
{
    const SceneMaterial *material = &p->previews[p->shown].material;
    MatcOptions options = p->compile;
    options.pass = p->options.preview.sky ? "sky" : "gbuffer";
    options.validate = false;
    return matc_compile(material->document, material->index, outputs, &options);
}

static bool set_params(MaterialPictures *p, MaterialReport *reported)
{
    if (!p->options.param_count)
        return true;
    MatcProgram *program = compile(p, MATC_KEY);
    bool fine = true;
    for (int i = 0; fine && i < p->options.param_count; i++)
        fine = set_param(p, program, i, reported);
    matc_program_free(program);
    return fine;
}

/* Reports a failure: compiler diagnostics if the program has errors, else the GL error. */
static bool fail(const MaterialPictures *p, MaterialReport *reported)
{
    MatcProgram *program = compile(p, MATC_FRAGMENT);
    if (!matc_ok(program))
        reported->diagnostics =
            memory_checked(strdup(matc_program_diagnostics(program, MATC_TEXT)));
    else
        snprintf(reported->error, sizeof reported->error, "%s", p->gl->error);
    matc_program_free(program);
    return false;
}

bool material_pictures_show(MaterialPictures *p, MatcDocument *document, int material,
                            MaterialReport *reported)
{
    *reported = (MaterialReport){0};
    p->shown = !p->shown;
    Preview *preview = &p->previews[p->shown];
    preview_free(preview);
    if (!preview_make(&p->options.preview, (SceneMaterial){document, material}, &p->compile,
                      preview))
        return message_fail(reported->error, sizeof reported->error, "out of memory");
    preview->scene.tools.grid = p->options.tools.grid;
    preview->scene.tools.axes = p->options.tools.axes;
    preview->scene.tools.lights = p->options.tools.lights;
    if (!scene_pictures_show(p->pictures, &preview->scene))
        return fail(p, reported);
    reported->diagnostics = scene_pictures_diagnostics(p->pictures);
    return set_params(p, reported);
}

ScenePictures *material_pictures_of(MaterialPictures *p) { return p->pictures; }

MaterialPictures *material_pictures_open(GlContext *gl, const MaterialPictureOptions *options)
{
    MaterialPictures *made = calloc(1, sizeof *made);
    if (!made)
        return gl_fail(gl, "out of memory"), NULL;
    *made = (MaterialPictures){
        .gl = gl, .options = *options, .compile = *options->pictures.renderer.compile};
    ScenePictureOptions how = options->pictures;
    how.renderer.compile = &made->compile;
    how.renderer.width = options->preview.width;
    how.renderer.height = options->preview.height;
    if (!made->compile.layout && !made->compile.custom)
        /* matc's default layout, not the smallest that fits the material */
        made->compile.layout = options->slot ? "integer" : "compact";
    if (options->slot) {
        how.look = slot_look_find(options->slot);
        how.renderer.view = options->slot;
        how.renderer.opaque = true;
    }
    made->pictures = scene_pictures_open(gl, &how);
    if (made->pictures)
        return made;
    material_pictures_close(made);
    return NULL;
}

void material_pictures_close(MaterialPictures *p)
{
    if (!p)
        return;
    scene_pictures_close(p->pictures);
    for (int i = 0; i < 2; i++)
        preview_free(&p->previews[i]);
    free(p);
}
