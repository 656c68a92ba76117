/* Draws a material: its G-buffer on a shape, then light on the G-buffer, then the mean of the samples. A sky is one pass. */
#include "runtime/view/view.h"
#include "runtime/view/camera.h"
#include "runtime/view/resolve.h"
#include "runtime/gl/block.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "runtime/gl/message.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { UNITS_LIMIT = 32 };
#define VERSION "#version 330 core\n"

/* What one picture is made with; all zero is a valid, empty one. */
typedef struct {
    GlContext *gl;
    const ViewOptions *options;
    const ViewProgram *material;
    int samples; /* n: n x n a pixel */
    Camera camera;
    GLuint pack, light; /* programs */
    GLuint constants;   /* buffer of the material's numbers, or 0 */
    Framebuffer gbuffer, lit;
    Mesh shape, screen;
    GLuint textures[UNITS_LIMIT]; /* of the material */
} View;

static void set_numbers(View *v, GLuint program, const char *name, int lanes, const float *values)
{
    program_set(v->gl, program, &(ProgramValue){name, lanes, values});
}

static void set_number(View *v, GLuint program, const char *name, float value)
{
    set_numbers(v, program, name, 1, &value);
}

/* Text that begins with its own #version gets none in front. */
static const char *version_for(const char *text) { return strncmp(text, "#version", 8) == 0 ? "" : VERSION; }

static bool make_programs(View *v)
{
    const ViewProgram *m = v->material;
    const ViewOptions *o = v->options;
    v->pack = program_make(v->gl, &(ProgramText){
                                      .vertex = {version_for(m->vertex_text), m->vertex_text},
                                      .fragment = {version_for(m->fragment_text), m->fragment_text},
                                  });
    if (!v->pack)
        return false;
    if (o->sky)
        return true;
    v->light =
        program_make(v->gl, &(ProgramText){
                                .vertex = {VERSION, o->screen_text},
                                .fragment = {version_for(m->unpack_text), m->unpack_text, "\n#line 1\n", o->light_text},
                            });
    return v->light != 0;
}

static bool make_targets(View *v)
{
    enum { THESIS_TARGETS = 4 };
    const ViewProgram *m = v->material;
    FramebufferSpec spec = {v->options->width * v->samples, v->options->height * v->samples,
                            m->target_count ? m->target_count : THESIS_TARGETS, GL_RGBA16F, true};
    if (!v->options->sky && !(m->target_count ? framebuffer_make_of(v->gl, &spec, m->targets, &v->gbuffer)
                                              : framebuffer_make(v->gl, &spec, &v->gbuffer)))
        return false;
    spec.color_count = 1;
    spec.depth = false;
    return framebuffer_make(v->gl, &spec, &v->lit);
}

static bool make_textures(View *v)
{
    int most = v->gl->max_texture_units < UNITS_LIMIT ? v->gl->max_texture_units : UNITS_LIMIT;
    if (v->material->texture_count > most)
        return gl_fail(v->gl, "more textures than the driver's %d", most);
    for (int i = 0; i < v->material->texture_count; i++) {
        v->textures[i] = texture_make(v->gl, &v->material->textures[i].spec);
        if (!v->textures[i])
            return false;
    }
    return true;
}

/* The shape stands where it is, so local space is the world. */
static void set_spaces(View *v)
{
    Mat4 world_from_local = mat4_identity();
    Mat3 normal = mat3_normal(&world_from_local);
    Mat3 eye_from_world = mat3_from_mat4(&v->camera.eye_from_world);
    Mat3 eye_normal = mat3_multiply(&eye_from_world, &normal); /* a rotation is its own inverse transpose */
    set_numbers(v, v->pack, "matc_worldFromLocal", 16, world_from_local.m);
    set_numbers(v, v->pack, "matc_clipFromWorld", 16, v->camera.clip_from_world.m);
    set_numbers(v, v->pack, "matc_worldNormalFromLocal", 9, normal.m);
    set_numbers(v, v->pack, "matc_eyeNormalFromLocal", 9, eye_normal.m);
    set_numbers(v, v->pack, "matc_eyeFromWorld", 9, eye_from_world.m);
    set_numbers(v, v->pack, "matc_eyePosition", 3, v->camera.position);
    set_number(v, v->pack, "matc_ior", 1);
}

static void set_material(View *v)
{
    const ViewProgram *m = v->material;
    for (int i = 0; i < m->texture_count; i++) {
        texture_bind(v->gl, v->textures[i], i);
        set_number(v, v->pack, m->textures[i].name, (float)i);
    }
    for (int i = 0; i < m->uniform_count; i++)
        program_set(v->gl, v->pack, &m->uniforms[i]);
    v->gl->DeleteBuffers(1, &v->constants);
    v->constants = block_make(v->gl, v->pack, "Constants", 0, m->constants, m->constant_bytes);
}

static bool draw_gbuffer(View *v)
{
    GlContext *gl = v->gl;
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LESS);
    framebuffer_clear(gl, &v->gbuffer, (float[4]){0});
    set_spaces(v);
    set_material(v);
    gl->UseProgram(v->pack);
    mesh_draw(gl, &v->shape);
    gl->Disable(GL_DEPTH_TEST);
    return gl_check(gl, "drawing the G-buffer");
}

static void bind_gbuffer(View *v)
{
    int count = v->gbuffer.spec.color_count;
    for (int i = 0; i < count; i++) {
        char name[] = "matc_gbuffer0";
        name[sizeof name - 2] = (char)('0' + i);
        texture_bind(v->gl, v->gbuffer.colors[i], i);
        set_number(v, v->light, name, (float)i);
    }
    texture_bind(v->gl, v->gbuffer.depth, count);
    set_number(v, v->light, "light_depth", (float)count);
}

static bool draw_light(View *v)
{
    const float size[2] = {(float)v->lit.spec.width, (float)v->lit.spec.height};
    framebuffer_use(v->gl, &v->lit);
    bind_gbuffer(v);
    set_numbers(v, v->light, "light_eyeFromClip", 16, v->camera.eye_from_clip.m);
    set_numbers(v, v->light, "light_up", 3, &v->camera.eye_from_world.m[8]); /* the image of the z axis */
    set_numbers(v, v->light, "light_size", 2, size);
    v->gl->UseProgram(v->light);
    mesh_draw_screen(v->gl, &v->screen);
    return gl_check(v->gl, "lighting the G-buffer");
}

static bool draw_sky(View *v)
{
    Mat4 world_from_clip;
    mat4_inverse(&v->camera.clip_from_world, &world_from_clip); /* never singular */
    framebuffer_use(v->gl, &v->lit);
    set_numbers(v, v->pack, "matc_worldFromClip", 16, world_from_clip.m);
    set_numbers(v, v->pack, "matc_eyePosition", 3, v->camera.position);
    set_material(v);
    v->gl->UseProgram(v->pack);
    mesh_draw_screen(v->gl, &v->screen);
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
    for (int y = 0; y < v->options->height; y++) {
        part.y = y * v->samples;
        if (!framebuffer_read_part(v->gl, &v->lit, &part, samples))
            return false;
        if (v->options->sky)
            expose(samples, (size_t)part.width * (size_t)part.height);
        resolve_row(samples, v->options->width, v->samples, rgb + (size_t)y * (size_t)v->options->width * 3);
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

static bool draw(View *v, unsigned char *rgb)
{
    const ViewOptions *o = v->options;
    v->camera = o->sky ? camera_for_sky(o->azimuth, o->width, o->height) : camera_for(o->shape, o->width, o->height);
    return make_programs(v) && mesh_make_empty(v->gl, &v->screen) && make_targets(v) && make_textures(v) &&
           (o->sky ? draw_sky(v) : mesh_make(v->gl, o->shape, &v->shape) && draw_gbuffer(v) && draw_light(v)) &&
           resolve(v, rgb);
}

/* Leaves a caller's context as clean as it was. */
static void discard(View *v)
{
    GlContext *gl = v->gl;
    gl->UseProgram(0);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl->DeleteProgram(v->pack);
    gl->DeleteProgram(v->light);
    framebuffer_delete(gl, &v->gbuffer);
    framebuffer_delete(gl, &v->lit);
    mesh_delete(gl, &v->shape);
    mesh_delete(gl, &v->screen);
    gl->DeleteBuffers(1, &v->constants);
    gl->DeleteTextures(UNITS_LIMIT, v->textures);
    gl->ActiveTexture(GL_TEXTURE0);
}

static const char *find_fault(const ViewOptions *o, const ViewProgram *p, int samples)
{
    if (!p->vertex_text || !p->fragment_text || (!p->unpack_text && !o->sky))
        return "the material's program lacks a text";
    if ((!o->screen_text || !o->light_text) && !o->sky)
        return "the light pass lacks a text";
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

bool view_render(const ViewOptions *options, const ViewProgram *program, unsigned char *rgb, char *error, size_t room)
{
    int samples = options->supersampling ? options->supersampling : 4;
    const char *fault = find_fault(options, program, samples);
    if (fault)
        return message_fail(error, room, "%s", fault);
    View view = {.options = options, .material = program, .samples = samples};
    view.gl = options->gl ? options->gl : gl_open(GL_KIND_osmesa, true, error, room);
    if (!view.gl)
        return false;
    bool done = draw(&view, rgb);
    if (!done)
        message_fail(error, room, "%s", view.gl->error);
    discard(&view);
    if (!options->gl)
        gl_close(view.gl);
    return done;
}
