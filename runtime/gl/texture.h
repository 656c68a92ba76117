/* Two-dimensional textures of bytes or floats. */
#ifndef MATC_GL_TEXTURE_H
#define MATC_GL_TEXTURE_H
#include "runtime/gl/context.h"
#include <stdint.h>

/* Texels by rows, row 0 at the bottom (v = 0), rows not padded. Exactly one of bytes, words and
 * floats is set. */
typedef struct {
    int width, height;
    int components;       /* number of components, 1 or 4 */
    const uint8_t *bytes; /* texels of R8 and RGBA8: value = byte / 255 */
    const float *floats;  /* texels of R32F and RGBA32F */
    bool linear;          /* true: linear filter; false: nearest */
    /* Wrap mode outside the edges; a border is 0 in all components; 0: clamp to edge. */
    GLint wrap;
    bool mipmaps; /* generates mipmaps, with trilinear filtering */
    /* Max samples along a footprint's longer side, up to the driver's limit; 0 or 1: isotropic. */
    int anisotropy;
    const uint16_t *words; /* texels of RGBA16: value = word / 65535 */
    /* Internal format, if several could hold the texels, such as SRGB8_ALPHA8; 0: the one named
     * above. */
    GLint format;
} TextureSpec;

/* Returns OpenGL's constant of a format's name; 0: unknown. */
GLint texture_format(const char *name);

/* Returns the wrap mode of "repeat", "mirrored_repeat", "clamp_to_edge", "clamp_to_border"; 0:
 * unknown. */
GLint texture_wrap(const char *name);

/* Checks the size and components of a spec; see gl->error on false. */
bool texture_check(GlContext *gl, const TextureSpec *spec);

/* Makes a texture and leaves it bound to the active unit. Returns 0 on failure; see gl->error.
 * Delete with gl->DeleteTextures. */
GLuint texture_make(GlContext *gl, const TextureSpec *spec);

/* Replaces the floats of a texture of equal size, and leaves it bound to the active unit. */
void texture_rewrite(const GlContext *gl, GLuint texture, const TextureSpec *spec);

/* Binds a texture to a unit, the value of its sampler uniform. */
void texture_bind(const GlContext *gl, GLuint texture, int unit);
#endif
