/* Makes textures from texels. */
#include "runtime/gl/texture.h"
#include <string.h>

GLint texture_format(const char *name)
{
    static const struct {
        const char *name;
        GLint format;
    } rows[] = {{"R8", GL_R8},          {"R32F", GL_R32F},
                {"RGBA8", GL_RGBA8},    {"SRGB8_ALPHA8", GL_SRGB8_ALPHA8},
                {"RGBA16", GL_RGBA16},  {"RGBA16F", GL_RGBA16F},
                {"RGBA32F", GL_RGBA32F}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (!strcmp(rows[i].name, name))
            return rows[i].format;
    return 0;
}

GLint texture_wrap(const char *name)
{
    static const struct {
        const char *name;
        GLint wrap;
    } rows[] = {{"repeat", GL_REPEAT},
                {"mirrored_repeat", GL_MIRRORED_REPEAT},
                {"clamp_to_edge", GL_CLAMP_TO_EDGE},
                {"clamp_to_border", GL_CLAMP_TO_BORDER}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (!strcmp(rows[i].name, name))
            return rows[i].wrap;
    return 0;
}

bool texture_check(GlContext *gl, const TextureSpec *spec)
{
    if (spec->width < 1 || spec->height < 1)
        return gl_fail(gl, "a texture needs at least one texel");
    if (spec->width > gl->max_texture_size || spec->height > gl->max_texture_size)
        return gl_fail(gl, "a texture of %d x %d is larger than the driver's %d", spec->width,
                       spec->height, gl->max_texture_size);
    if (spec->components != 1 && spec->components != 4)
        return gl_fail(gl, "a texture has 1 or 4 components, not %d", spec->components);
    if (!!spec->bytes + !!spec->floats + !!spec->words != 1)
        return gl_fail(gl, "a texture is of bytes, of words or of floats");
    return true;
}

static void set_parameters(const GlContext *gl, const TextureSpec *spec)
{
    GLint filter = spec->linear ? GL_LINEAR : GL_NEAREST;
    GLint wrap = spec->wrap ? spec->wrap : GL_CLAMP_TO_EDGE;
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                      spec->mipmaps ? GL_LINEAR_MIPMAP_LINEAR : filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, spec->mipmaps ? GL_LINEAR : filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    if (spec->anisotropy > 1 && gl->max_anisotropy > 1)
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY,
                          spec->anisotropy < gl->max_anisotropy ? spec->anisotropy
                                                                : gl->max_anisotropy);
    if (!spec->mipmaps)
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

static void upload(const GlContext *gl, const TextureSpec *spec)
{
    static const GLint formats[2][2] = {{GL_R32F, GL_R8}, {GL_RGBA32F, GL_RGBA8}};
    GLint internal = formats[spec->components == 4][spec->bytes != NULL];
    GLenum format = spec->components == 4 ? GL_RGBA : GL_RED;
    GLenum type = spec->bytes ? GL_UNSIGNED_BYTE : spec->words ? GL_UNSIGNED_SHORT : GL_FLOAT;
    const void *texels = spec->bytes   ? (const void *)spec->bytes
                         : spec->words ? (const void *)spec->words
                                       : spec->floats;
    if (spec->format || spec->words)
        internal = spec->format ? spec->format : GL_RGBA16;
    gl->TexImage2D(GL_TEXTURE_2D, 0, internal, spec->width, spec->height, 0, format, type, texels);
}

GLuint texture_make(GlContext *gl, const TextureSpec *spec)
{
    if (!texture_check(gl, spec))
        return 0;
    GLuint texture = 0;
    gl->GenTextures(1, &texture);
    gl->BindTexture(GL_TEXTURE_2D, texture);
    set_parameters(gl, spec);
    upload(gl, spec);
    if (spec->mipmaps)
        gl->GenerateMipmap(GL_TEXTURE_2D);
    if (gl_check(gl, "making a texture"))
        return texture;
    gl->DeleteTextures(1, &texture);
    return 0;
}

void texture_rewrite(const GlContext *gl, GLuint texture, const TextureSpec *spec)
{
    gl->BindTexture(GL_TEXTURE_2D, texture);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, spec->width, spec->height,
                      spec->components == 4 ? GL_RGBA : GL_RED, GL_FLOAT, spec->floats);
}

void texture_bind(const GlContext *gl, GLuint texture, int unit)
{
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    gl->BindTexture(GL_TEXTURE_2D, texture);
}
