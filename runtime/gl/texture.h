/* Two-dimensional textures of bytes or floats. */
#ifndef MATC_GL_TEXTURE_H
#define MATC_GL_TEXTURE_H
#include "runtime/gl/context.h"
#include <stdint.h>

/* Texels row by row, row 0 is the bottom row (v = 0), rows not padded. One of bytes, words and
 * floats is set. */
typedef struct {
    int width, height;
    int lanes;            /* 1 or 4 */
    const uint8_t *bytes; /* a byte over 255 is the value: R8, RGBA8 */
    const float *floats;  /* R32F, RGBA32F */
    bool linear;          /* filter; false: nearest */
    /* beyond the edges; a border is 0 in all lanes; 0: the texel at the edge */
    GLint wrap;
    bool mipmaps; /* make them, and filter linearly in and between them */
    /* samples along a footprint's longer side, at most; as many as the driver can, 0 or 1: one */
    int anisotropy;
    const uint16_t *words; /* a word over 65535 is the value: RGBA16 */
    /* the internal one, where several can hold the numbers: SRGB8_ALPHA8; 0: as said above */
    GLint format;
} TextureSpec;

/* OpenGL's number of a format's name; 0: unknown. */
GLint texture_format(const char *name);

/* Wrap mode of "repeat", "mirrored_repeat", "clamp_to_edge", "clamp_to_border"; 0: unknown. */
GLint texture_wrap(const char *name);

/* The spec can be one. */
bool texture_check(GlContext *gl, const TextureSpec *spec);

/* The texture stays bound to the active unit. 0: see gl->error. Delete with gl->DeleteTextures. */
GLuint texture_make(GlContext *gl, const TextureSpec *spec);

/* Other floats for such a texture, which was made of as many. It stays bound to the active unit. */
void texture_rewrite(const GlContext *gl, GLuint texture, const TextureSpec *spec);

/* Binds a texture to a unit, for the sampler uniform of that number. */
void texture_bind(const GlContext *gl, GLuint texture, int unit);
#endif
