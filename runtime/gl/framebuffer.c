/* Makes, binds and reads framebuffers. */
#include "runtime/gl/framebuffer.h"
#include <stdio.h>
#include <string.h>

static bool check_spec(GlContext *gl, const FramebufferSpec *spec)
{
    if (spec->width < 1 || spec->height < 1)
        return gl_fail(gl, "a framebuffer needs at least one pixel");
    if (spec->width > gl->max_texture_size || spec->height > gl->max_texture_size)
        return gl_fail(gl, "a framebuffer of %d x %d is larger than the driver's %d", spec->width,
                       spec->height, gl->max_texture_size);
    int most =
        gl->max_draw_buffers < FRAMEBUFFER_COLORS ? gl->max_draw_buffers : FRAMEBUFFER_COLORS;
    if (spec->color_count < 0 || spec->color_count > most)
        return gl_fail(gl, "%d color targets requested, the driver supports 0 to %d",
                       spec->color_count, most);
    return true;
}

static const struct {
    const char *name;
    GLenum format;
    bool words;
} known[] = {
    {"R8", GL_R8, false},
    {"DEPTH32F", GL_DEPTH_COMPONENT32F, false},
    {"DEPTH32F_STENCIL8", GL_DEPTH32F_STENCIL8, false},
    {"RGBA8", GL_RGBA8, false},
    {"RGBA16", GL_RGBA16, false},
    {"RGBA16F", GL_RGBA16F, false},
    {"RGBA32F", GL_RGBA32F, false},
    {"R32UI", GL_R32UI, true},
    {"RG32UI", GL_RG32UI, true},
    {"RGBA32UI", GL_RGBA32UI, true},
    {"RGBA16UI", GL_RGBA16UI, true},
};
enum { FORMAT_COUNT = sizeof known / sizeof *known, FORMAT_NAMES = 128 };

/* Returns a format's constant; 0: unknown. */
static GLenum format_of(const char *name)
{
    for (int i = 0; i < FORMAT_COUNT; i++)
        if (!strcmp(known[i].name, name))
            return known[i].format;
    return 0;
}

static bool is_words(GLenum format)
{
    for (int i = 0; i < FORMAT_COUNT; i++)
        if (known[i].format == format)
            return known[i].words;
    return false;
}

bool framebuffer_has_words(const Framebuffer *f, int color) { return is_words(f->formats[color]); }

/* Sets nearest filtering of the bound texture. */
static void set_nearest(const GlContext *gl)
{
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    /* makes the texture complete without mipmaps */
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

bool framebuffer_has_views(const GlContext *gl)
{
    return gl->major * 10 + gl->minor >= 43 && gl->TexStorage2D && gl->TextureView;
}

/* Makes a texture; texture views need one with immutable storage. */
static GLuint make_texture(const GlContext *gl, const FramebufferSpec *spec, GLenum format)
{
    GLuint texture = 0;
    const bool depth = format == GL_DEPTH_COMPONENT32F, stencil = format == GL_DEPTH32F_STENCIL8;
    const bool words = is_words(format);
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    set_nearest(gl);
    if (framebuffer_has_views(gl))
        gl->TexStorage2D(GL_TEXTURE_2D, 1, format, spec->width, spec->height);
    else
        gl->TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, spec->width, spec->height, 0,
                       depth     ? GL_DEPTH_COMPONENT
                       : stencil ? GL_DEPTH_STENCIL
                       : words   ? GL_RGBA_INTEGER
                                 : GL_RGBA,
                       stencil ? GL_FLOAT_32_UNSIGNED_INT_24_8_REV
                       : words ? GL_UNSIGNED_INT
                               : GL_FLOAT,
                       NULL);
    return texture;
}

/* Creates missing attachments. */
static void attach(const GlContext *gl, Framebuffer *f)
{
    gl->GenFramebuffers(1, &f->name);
    gl->BindFramebuffer(GL_FRAMEBUFFER, f->name);
    for (int i = 0; i < f->spec.color_count; i++) {
        if (!f->borrowed)
            f->colors[i] = make_texture(gl, &f->spec, f->formats[i]);
        gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + (GLenum)i, GL_TEXTURE_2D,
                                 f->colors[i], 0);
    }
    if (!f->spec.depth)
        return;
    if (!f->borrowed)
        f->depth = make_texture(gl, &f->spec, GL_DEPTH_COMPONENT32F);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER,
                             f->stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT,
                             GL_TEXTURE_2D, f->depth, 0);
}

/* Lists the formats for messages, such as "RG32UI R32UI, and depth DEPTH32F". */
static void name_formats(const Framebuffer *f, char names[FORMAT_NAMES])
{
    size_t size = 0;
    *names = 0;
    for (int i = 0; i < f->spec.color_count; i++)
        for (int k = 0; k < FORMAT_COUNT; k++)
            if (known[k].format == f->formats[i])
                size += (size_t)snprintf(names + size, FORMAT_NAMES - size, "%s%s", i ? " " : "",
                                         known[k].name);
    if (f->spec.depth)
        snprintf(names + size, FORMAT_NAMES - size, "%s",
                 size ? ", and depth DEPTH32F" : "depth DEPTH32F");
}

static bool check_complete(GlContext *gl, const Framebuffer *f)
{
    char names[FORMAT_NAMES];
    GLenum status = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
    name_formats(f, names);
    switch (status) {
    case GL_FRAMEBUFFER_COMPLETE:
        return true;
    case GL_FRAMEBUFFER_UNSUPPORTED:
        return gl_fail(gl, "the driver cannot draw to these formats together: %s", names);
    case GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT:
        return gl_fail(gl, "the driver cannot draw to one of these formats: %s", names);
    case GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT:
        return gl_fail(gl, "a framebuffer needs a color target or depth");
    default:
        return gl_fail(gl, "a framebuffer is incomplete: 0x%04X", status);
    }
}

/* Makes a framebuffer of a checked spec; borrowed textures are already set. */
static bool make_of(GlContext *gl, const FramebufferSpec *spec, const GLenum *formats,
                    Framebuffer *made)
{
    made->spec = *spec;
    memcpy(made->formats, formats, sizeof *formats * (size_t)spec->color_count);
    attach(gl, made);
    /* sets the draw buffers first: GL 3 counts missing draw buffers as incomplete */
    framebuffer_use(gl, made);
    if (gl_check(gl, "making a framebuffer") && check_complete(gl, made))
        return true;
    framebuffer_delete(gl, made);
    return false;
}

bool framebuffer_make(GlContext *gl, const FramebufferSpec *spec, Framebuffer *made)
{
    GLenum formats[FRAMEBUFFER_COLORS];
    memset(made, 0, sizeof *made);
    for (int i = 0; i < FRAMEBUFFER_COLORS; i++)
        formats[i] = spec->color_format;
    return check_spec(gl, spec) && make_of(gl, spec, formats, made);
}

bool framebuffer_make_named(GlContext *gl, const FramebufferSpec *spec, const char *const *names,
                            Framebuffer *made)
{
    GLenum formats[FRAMEBUFFER_COLORS] = {0};
    memset(made, 0, sizeof *made);
    if (!check_spec(gl, spec))
        return false;
    for (int i = 0; i < spec->color_count; i++) {
        formats[i] = format_of(names[i]);
        if (!formats[i])
            return gl_fail(gl, "no render target can be '%s' here", names[i]);
    }
    return make_of(gl, spec, formats, made);
}

bool framebuffer_make_around(GlContext *gl, const FramebufferSpec *spec,
                             const FramebufferTextures *textures, Framebuffer *made)
{
    GLenum formats[FRAMEBUFFER_COLORS] = {0};
    memset(made, 0, sizeof *made);
    if (!check_spec(gl, spec))
        return false;
    for (int i = 0; i < spec->color_count; i++)
        formats[i] = format_of(textures->formats[i]);
    memcpy(made->colors, textures->colors, sizeof made->colors);
    made->depth = textures->depth;
    made->stencil = textures->stencil;
    made->borrowed = true;
    return make_of(gl, spec, formats, made);
}

GLuint framebuffer_target(GlContext *gl, const TargetSpec *spec)
{
    const FramebufferSpec size = {.width = spec->width, .height = spec->height};
    const GLenum format = format_of(spec->format);
    if (!check_spec(gl, &size))
        return 0;
    if (!format)
        return gl_fail(gl, "no render target can be '%s' here", spec->format), 0;
    GLuint texture = make_texture(gl, &size, format);
    if (gl_check(gl, "making a render target"))
        return texture;
    gl->DeleteTextures(1, &texture);
    return 0;
}

GLuint framebuffer_view(GlContext *gl, GLuint target, const char *format)
{
    GLuint view = 0;
    gl->GenTextures(1, &view);
    gl->TextureView(view, GL_TEXTURE_2D, target, format_of(format), 0, 1, 0, 1);
    gl->BindTexture(GL_TEXTURE_2D, view);
    set_nearest(gl);
    if (gl_check(gl, "making a view of a render target"))
        return view;
    gl->DeleteTextures(1, &view);
    return 0;
}

void framebuffer_use(const GlContext *gl, const Framebuffer *framebuffer)
{
    static const GLenum none = GL_NONE;
    GLenum targets[FRAMEBUFFER_COLORS];
    for (int i = 0; i < FRAMEBUFFER_COLORS; i++)
        targets[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
    int count = framebuffer->spec.color_count;
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer->name);
    gl->DrawBuffers(count ? count : 1, count ? targets : &none);
    gl->ReadBuffer(count ? GL_COLOR_ATTACHMENT0 : GL_NONE);
    gl->Viewport(0, 0, framebuffer->spec.width, framebuffer->spec.height);
}

void framebuffer_clear(const GlContext *gl, const Framebuffer *framebuffer, const float color[4])
{
    static const GLuint zero[4];
    framebuffer_use(gl, framebuffer);
    for (int i = 0; i < framebuffer->spec.color_count; i++)
        if (framebuffer_has_words(framebuffer, i))
            gl->ClearBufferuiv(GL_COLOR, i, zero);
        else
            gl->ClearBufferfv(GL_COLOR, i, color);
    if (framebuffer->spec.depth)
        gl->ClearBufferfv(GL_DEPTH, 0, &(float){1});
}

static bool inside(const FramebufferSpec *spec, const FramebufferPart *part)
{
    return part->color >= 0 && part->color < spec->color_count && part->x >= 0 &&
           part->width >= 0 && part->width <= spec->width - part->x && part->y >= 0 &&
           part->height >= 0 && part->height <= spec->height - part->y;
}

bool framebuffer_read_part(GlContext *gl, const Framebuffer *framebuffer,
                           const FramebufferPart *part, float *rgba)
{
    if (!inside(&framebuffer->spec, part))
        return gl_fail(gl, "reading outside of a framebuffer");
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer->name);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0 + (GLenum)part->color);
    gl->ReadPixels(part->x, part->y, part->width, part->height, GL_RGBA, GL_FLOAT, rgba);
    return gl_check(gl, "reading a framebuffer");
}

bool framebuffer_read(GlContext *gl, const Framebuffer *framebuffer, int color, float *rgba)
{
    const FramebufferSpec *spec = &framebuffer->spec;
    return framebuffer_read_part(gl, framebuffer,
                                 &(FramebufferPart){color, 0, 0, spec->width, spec->height}, rgba);
}

bool framebuffer_read_words(GlContext *gl, const Framebuffer *framebuffer, int color, GLuint *rgba)
{
    const FramebufferSpec *spec = &framebuffer->spec;
    if (color < 0 || color >= spec->color_count || !framebuffer_has_words(framebuffer, color))
        return gl_fail(gl, "not a target of integers");
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer->name);
    gl->ReadBuffer(GL_COLOR_ATTACHMENT0 + (GLenum)color);
    gl->ReadPixels(0, 0, spec->width, spec->height, GL_RGBA_INTEGER, GL_UNSIGNED_INT, rgba);
    return gl_check(gl, "reading a framebuffer");
}

void framebuffer_delete(const GlContext *gl, Framebuffer *framebuffer)
{
    gl->DeleteFramebuffers(1, &framebuffer->name); /* GL ignores the name 0 */
    if (!framebuffer->borrowed) {
        gl->DeleteTextures(FRAMEBUFFER_COLORS, framebuffer->colors);
        gl->DeleteTextures(1, &framebuffer->depth);
    }
    memset(framebuffer, 0, sizeof *framebuffer);
}
