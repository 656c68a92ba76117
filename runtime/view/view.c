/* Draws a material: its G-buffer on a shape, then light on the G-buffer, then the mean of the samples. A sky is one pass. */
#include "runtime/view/view.h"
#include "runtime/view/camera.h"
#include "runtime/view/pixels.h"
#include "runtime/view/slot.h"
#include "runtime/gl/mesh.h"
#include "runtime/gl/message.h"
#include "runtime/gl/screen.h"
#include "runtime/render/spaces.h"
#include "runtime/render/surface_model.h"
#include "runtime/render/targets.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define VERSION "#version 330 core\n"

/* What one picture is made with; all zero is a valid, empty one. */
typedef struct {
    GlContext *gl;
    Store *store;
    const ViewOptions *options;
    MatcProgram *program;
    int samples; /* n: n x n a pixel */
    Camera camera;
    Material pack, light;
    Framebuffer gbuffer, lit;
    Mesh shape;
    Screen screen;
} View;

static void set_numbers(Material *material, const char *name, int lanes, const float *values)
{
    material_set(material, &(MaterialValue){name, lanes, values});
}

/* Text that begins with its own #version gets none in front. */
static const char *version_for(const char *text) { return strncmp(text, "#version", 8) == 0 ? "" : VERSION; }

/* The light stands in eye space: where the G-buffer has the world's normals, they are turned as they are read. */
static const char turned_normals[] = "\n#ifdef SURFACE_NORMALS_world\n"
                                     "uniform mat3 light_eyeFromWorld;\n"
                                     "Surface unpackTurned(ivec2 pixel) {\n"
                                     "    Surface s = unpackSurface(pixel);\n"
                                     "    s.normal = light_eyeFromWorld * s.normal;\n"
                                     "    return s;\n"
                                     "}\n"
                                     "#define unpackSurface unpackTurned\n"
                                     "#endif\n";

/* Behind the text that unpacks the G-buffer: the light, or a slot as it is. */
static bool make_light(View *v)
{
    enum { DEFINE_ROOM = 128 };
    const ViewOptions *o = v->options;
    const char *unpack = matc_output(v->program, MATC_UNPACK, NULL);
    const SlotLook *look = o->slot ? slot_look_find(o->slot) : NULL;
    char define[DEFINE_ROOM] = "\n";
    if (look)
        snprintf(define, sizeof define, "\n#define SLOT_SHOWN (%s)\n", look->shown);
    const ProgramText text = {.vertex = {VERSION, o->screen_text},
                              .fragment = {version_for(unpack), unpack, turned_normals, define,
                                           look ? "" : surface_model_phong.text, "\n#line 1\n",
                                           look ? o->slot_text : o->light_text}};
    return material_make(v->store, NULL, &text, &v->light);
}

static bool make_programs(View *v)
{
    const ViewOptions *o = v->options;
    if (!material_make(v->store, v->program, &(ProgramText){0}, &v->pack))
        return false;
    for (int i = 0; i < o->value_count; i++)
        material_set(&v->pack, &o->values[i]);
    return o->sky || make_light(v);
}

static bool make_targets(View *v)
{
    FramebufferSpec spec = {v->options->width * v->samples, v->options->height * v->samples, 1, GL_RGBA16F, true};
    if (!v->options->sky && !targets_make(v->gl, v->program, &spec, &v->gbuffer))
        return false;
    spec.depth = false;
    return framebuffer_make(v->gl, &spec, &v->lit);
}

/* The shape stands where it is, so local space is the world. */
static void set_spaces(View *v)
{
    const Camera *c = &v->camera;
    Spaces spaces = {
        .world_from_local = mat4_identity(), .eye_from_world = c->eye_from_world, .clip_from_eye = c->clip_from_eye};
    memcpy(spaces.eye, c->position, sizeof spaces.eye);
    spaces_set(&spaces, &v->pack);
}

static bool draw_gbuffer(View *v)
{
    GlContext *gl = v->gl;
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LESS);
    framebuffer_clear(gl, &v->gbuffer, (float[4]){0});
    set_spaces(v);
    material_use(&v->pack);
    mesh_draw(gl, &v->shape);
    gl->Disable(GL_DEPTH_TEST);
    return gl_check(gl, "drawing the G-buffer");
}

static bool draw_light(View *v)
{
    const int depth_unit = v->gbuffer.spec.color_count; /* after the targets */
    const float size[2] = {(float)v->lit.spec.width, (float)v->lit.spec.height};
    framebuffer_use(v->gl, &v->lit);
    set_numbers(&v->light, "light_eyeFromClip", 16, v->camera.eye_from_clip.m);
    set_numbers(&v->light, "light_up", 3, &v->camera.eye_from_world.m[8]); /* the image of the z axis */
    set_numbers(&v->light, "light_size", 2, size);
    material_set_number(&v->light, "light_depth", (float)depth_unit);
    set_numbers(&v->light, "light_eyeFromWorld", 9, mat3_from_mat4(&v->camera.eye_from_world).m);
    targets_read(&v->gbuffer, &v->light);
    texture_bind(v->gl, v->gbuffer.depth, depth_unit);
    screen_draw(v->gl, &v->screen);
    return gl_check(v->gl, "lighting the G-buffer");
}

static bool draw_sky(View *v)
{
    framebuffer_use(v->gl, &v->lit);
    set_spaces(v);
    material_use(&v->pack);
    screen_draw(v->gl, &v->screen);
    return gl_check(v->gl, "drawing the sky");
}

/* A sky's radiance has no upper end; film has. All lanes by one factor, so that bright parts keep their colour. */
static void expose(float *rgba, size_t texels)
{
    const float exposure = 0.9f;
    for (float *end = rgba + 4 * texels; rgba < end; rgba += 4) {
        float greatest = fmaxf(fmaxf(rgba[0], rgba[1]), fmaxf(rgba[2], 1e-6f));
        float factor = (1 - expf(-exposure * greatest)) / greatest;
        for (int lane = 0; lane < 3; lane++)
            rgba[lane] *= factor;
    }
}

/* Row by row: the samples of a whole picture are sixteen times and more its size. */
static bool read_picture(View *v, float *samples, unsigned char *rgb)
{
    FramebufferPart part = {.width = v->lit.spec.width, .height = v->samples};
    const bool encoded = !v->options->slot || slot_look_find(v->options->slot)->encoded;
    for (int y = 0; y < v->options->height; y++) {
        part.y = y * v->samples;
        if (!framebuffer_read_part(v->gl, &v->lit, &part, samples))
            return false;
        if (v->options->sky)
            expose(samples, (size_t)part.width * (size_t)part.height);
        pixels_row(samples, v->options->width, v->samples, encoded, rgb + (size_t)y * (size_t)v->options->width * 3);
    }
    return true;
}

static bool resolve(View *v, unsigned char *rgb)
{
    size_t count = (size_t)v->lit.spec.width * (size_t)v->samples * 4;
    float *samples = malloc(count * sizeof *samples);
    if (!samples)
        return gl_fail(v->gl, "out of memory");
    bool done = read_picture(v, samples, rgb);
    free(samples);
    return done;
}

static bool make_mesh(View *v)
{
    const ViewOptions *o = v->options;
    return o->mesh ? mesh_make_of(v->gl, o->mesh, &v->shape) : mesh_make(v->gl, o->shape, &v->shape);
}

static bool draw(View *v, unsigned char *rgb)
{
    const ViewOptions *o = v->options;
    const Viewpoint viewpoint = o->camera ? *o->camera : camera_viewpoint_for(o->shape);
    v->camera = o->sky ? camera_for_sky(o->azimuth, o->width, o->height) : camera_at(&viewpoint, o->width, o->height);
    return make_programs(v) && screen_make(v->gl, &v->screen) && make_targets(v) &&
           (o->sky ? draw_sky(v) : make_mesh(v) && draw_gbuffer(v) && draw_light(v)) && resolve(v, rgb);
}

/* Leaves a caller's context as clean as it was. */
static void discard(View *v)
{
    GlContext *gl = v->gl;
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    material_delete(&v->pack);
    material_delete(&v->light);
    framebuffer_delete(gl, &v->gbuffer);
    framebuffer_delete(gl, &v->lit);
    mesh_delete(gl, &v->shape);
    screen_delete(gl, &v->screen);
    store_free(v->store);
    gl->ActiveTexture(GL_TEXTURE0);
}

/* What the unpacking text promises to a light pass. */
static bool holds_slot(const char *unpack, const char *slot)
{
    char promise[64];
    snprintf(promise, sizeof promise, "#define SURFACE_HAS_%s\n", slot);
    return slot_look_find(slot) && strstr(unpack, promise);
}

static const char *find_fault(const ViewOptions *o, MatcProgram *p, int samples)
{
    if (!matc_output(p, MATC_VERTEX, NULL) || !matc_output(p, MATC_FRAGMENT, NULL) ||
        (!matc_output(p, MATC_UNPACK, NULL) && !o->sky))
        return "the material's program lacks a text";
    if ((!o->screen_text || !(o->slot ? o->slot_text : o->light_text)) && !o->sky)
        return "the light pass lacks a text";
    if (o->slot && (o->sky || !holds_slot(matc_output(p, MATC_UNPACK, NULL), o->slot)))
        return "the layout does not store that slot; --layout=integer stores all of them";
    if ((unsigned)o->shape >= SHAPE_count)
        return "unknown shape";
    if (samples < 1 || samples > VIEW_SUPERSAMPLING_LIMIT)
        return "supersampling is 1 to 8";
    if (o->width < 1 || o->height < 1)
        return "a picture needs at least one pixel";
    if (o->width > VIEW_SIZE_LIMIT / samples || o->height > VIEW_SIZE_LIMIT / samples)
        return "the picture with its supersampling is larger than 8192 pixels";
    return NULL;
}

bool view_render(const ViewOptions *options, MatcProgram *program, unsigned char *rgb, char *error, size_t room)
{
    int samples = options->supersampling ? options->supersampling : 4;
    const char *fault = find_fault(options, program, samples);
    if (fault)
        return message_fail(error, room, "%s", fault);
    View view = {.options = options, .program = program, .samples = samples};
    view.gl = options->gl ? options->gl : gl_open(GL_KIND_osmesa, true, error, room);
    if (!view.gl)
        return false;
    view.store = store_new(view.gl);
    bool done = view.store && draw(&view, rgb);
    if (!done)
        message_fail(error, room, "%s", view.gl->error);
    discard(&view);
    if (!options->gl)
        gl_close(view.gl);
    return done;
}
