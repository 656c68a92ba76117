/* A picture of a material: on a preview shape (G-buffer pass, light pass, filter), or as the sky that it is. */
#ifndef MATC_VIEW_H
#define MATC_VIEW_H
#include "runtime/gl/context.h"
#include "runtime/gl/program.h"
#include "runtime/gl/shape.h"
#include "runtime/gl/texture.h"

enum {
    VIEW_TARGETS = 8,       /* of a layout at most, read as matc_gbuffer0, matc_gbuffer1, ... */
    VIEW_SIZE_LIMIT = 8192, /* greatest width and height, supersampling counted in */
    VIEW_SUPERSAMPLING_LIMIT = 8
};

typedef struct {
    ShapeKind shape;
    int width, height;       /* of the picture */
    int supersampling;       /* n: n x n samples a pixel; 0 is 4 */
    const char *screen_text; /* runtime/view/screen.glsl */
    const char *light_text;  /* runtime/view/light.glsl */
    bool sky;                /* the program is one of the pass sky: no shape, no light pass, unpack_text may be NULL */
    double azimuth;          /* the sky's picture looks there: radians from the x axis */
    GlContext *gl;           /* a core context to draw with; NULL: one of OSMesa for this picture,
                                 after which the thread has no current context */
} ViewOptions;

typedef struct {
    const char *name; /* of the sampler */
    TextureSpec spec;
} ViewTexture;

/* A material as matc emits it for GLSL 3.30. Texts may, but need not, begin with #version. */
typedef struct {
    const char *vertex_text;   /* reads the attributes of mesh.h and matc_worldFromLocal, matc_clipFromWorld, ... */
    const char *fragment_text; /* of the G-buffer pass */
    const char *unpack_text;   /* struct Surface, samplers, Surface unpackSurface(ivec2 pixel) */
    const ViewTexture *textures;
    int texture_count;
    const ProgramValue *uniforms; /* those that the program does not have are passed over */
    int uniform_count;
    int target_count; /* render targets; 0: those of the thesis' layout, four of GL_RGBA16F */
    GLenum targets[VIEW_TARGETS];
    const void *constants; /* of the block "Constants", in std140; NULL: none */
    size_t constant_bytes;
} ViewProgram;

/* Draws into rgb: 3 bytes a pixel, sRGB, row 0 is the bottom row. False: see `error`, rgb may be half done. */
bool view_render(const ViewOptions *options, const ViewProgram *program, unsigned char *rgb, char *error, size_t room);
#endif
