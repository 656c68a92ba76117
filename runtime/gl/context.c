/* Opens or adopts contexts and loads their functions. */
#include "runtime/gl/context.h"
#include "runtime/gl/backend.h"
#include "runtime/gl/message.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const GlBackend *const backends[GL_KIND_count] = {
#ifdef MATC_TESTS_BY_EGL /* tests run on a GPU instead of OSMesa: tests/bench/device.sh */
    [GL_KIND_osmesa] = &gl_backend_egl,
#else
    [GL_KIND_osmesa] = &gl_backend_osmesa,
#endif
    [GL_KIND_egl] = &gl_backend_egl,
};

static const char *const kind_names[GL_KIND_count] = {
    [GL_KIND_osmesa] = "osmesa", [GL_KIND_egl] = "egl"};

const char *gl_kind_name(GlKind kind)
{
    return (unsigned)kind < GL_KIND_count ? kind_names[kind] : "?";
}

bool gl_kind_find(const char *name, GlKind *kind)
{
    for (int i = 0; i < GL_KIND_count; i++)
        if (!strcmp(name, kind_names[i])) {
            *kind = (GlKind)i;
            return true;
        }
    return false;
}

/* The host's context is current already, and remains the host's. */
static bool host_use(void *state) { return state != NULL; }

static GlProc host_load(void *state, const char *name)
{
    const GlHost *host = state;
    return host->load(host->user, name);
}

static const GlBackend of_host = {NULL, host_use, host_load, free};

static const GlBackend *backend_of(const GlContext *gl)
{
    return gl->kind == GL_KIND_host ? &of_host : backends[gl->kind];
}

static bool load(GlContext *gl)
{
    const GlBackend *backend = backend_of(gl);
#define F(NAME, Name)                                                                              \
    gl->Name = (PFNGL##NAME##PROC)backend->load(gl->state, "gl" #Name);                            \
    if (!gl->Name)                                                                                 \
        return gl_fail(gl, "the driver has no gl" #Name);
    GL_FUNCTIONS(F)
#undef F
#define F(NAME, Name) gl->Name = (PFNGL##NAME##PROC)backend->load(gl->state, "gl" #Name);
    GL_OPTIONAL_FUNCTIONS(F)
#undef F
    return true;
}

static const char *string(const GlContext *gl, GLenum name)
{
    const GLubyte *text = gl->GetString(name);
    return text ? (const char *)text : "?";
}

static bool is_software(const char *renderer)
{
    return strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe") ||
           strstr(renderer, "swrast") || strstr(renderer, "Software Rasterizer");
}

/* Returns the max anisotropy. A driver without the extension raises an error, which is cleared.
 * Mesa's software samplers are excluded: with anisotropy they blur magnified textures. */
static int greatest_anisotropy(const GlContext *gl)
{
    GLint most = 1;
    if (!gl->hardware)
        return 1;
    gl->GetIntegerv(GL_MAX_TEXTURE_MAX_ANISOTROPY, &most);
    return gl->GetError() == GL_NO_ERROR && most > 1 ? most : 1;
}

static void describe(GlContext *gl)
{
    gl->version = string(gl, GL_VERSION);
    gl->renderer = string(gl, GL_RENDERER);
    gl->language = string(gl, GL_SHADING_LANGUAGE_VERSION);
    gl->hardware = !is_software(gl->renderer);
    if (sscanf(gl->version, "%d.%d", &gl->major, &gl->minor) != 2)
        gl->major = gl->minor = 0; /* also resets the version for "OpenGL ES 3.2" */
    gl->GetIntegerv(GL_MAX_TEXTURE_SIZE, &gl->max_texture_size);
    gl->GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &gl->max_texture_units);
    gl->GetIntegerv(GL_MAX_DRAW_BUFFERS, &gl->max_draw_buffers);
    gl->max_anisotropy = greatest_anisotropy(gl);
}

/* Pixel rows of bytes or single floats are not padded, neither for upload nor for download. */
static void set_defaults(const GlContext *gl)
{
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
}

/* Loads the functions; the backend's state exists. */
static bool start(GlContext *gl)
{
    if (!load(gl))
        return false;
    describe(gl);
    set_defaults(gl);
    return gl_check(gl, "opening the context");
}

GlContext *gl_open(GlKind kind, bool core, char *error, size_t capacity)
{
    if ((unsigned)kind >= GL_KIND_count) {
        message_fail(error, capacity, "unknown kind of GL context");
        return NULL;
    }
    GlContext *gl = calloc(1, sizeof *gl);
    if (!gl) {
        message_fail(error, capacity, "out of memory");
        return NULL;
    }
    gl->kind = kind;
    gl->core = core;
    gl->state = backends[kind]->open(core, gl->error, sizeof gl->error);
    if (gl->state && start(gl))
        return gl;
    message_fail(error, capacity, "%s", gl->error);
    gl_close(gl);
    return NULL;
}

GlContext *gl_adopt(const GlHost *host, char *error, size_t capacity)
{
    GlContext *gl = calloc(1, sizeof *gl);
    GlHost *state = malloc(sizeof *state);
    if (!gl || !state) {
        message_fail(error, capacity, "out of memory");
        free(gl);
        free(state);
        return NULL;
    }
    *state = *host;
    gl->kind = GL_KIND_host;
    gl->core = true;
    gl->state = state;
    if (start(gl) && (gl->major * 10 + gl->minor >= 33 ||
                      gl_fail(gl, "the context has OpenGL %d.%d, not 3.3", gl->major, gl->minor)))
        return gl;
    message_fail(error, capacity, "%s", gl->error);
    gl_close(gl);
    return NULL;
}

bool gl_use(GlContext *gl)
{
    return backend_of(gl)->use(gl->state) || gl_fail(gl, "the context cannot be made current");
}

void gl_close(GlContext *gl)
{
    if (!gl)
        return;
    if (gl->state)
        backend_of(gl)->close(gl->state);
    free(gl);
}

bool gl_fail(GlContext *gl, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(gl->error, sizeof gl->error, format, arguments);
    va_end(arguments);
    return false;
}

static const char *error_name(GLenum error)
{
    switch (error) {
    case GL_INVALID_ENUM:
        return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
        return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
        return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
        return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
        return "GL_OUT_OF_MEMORY";
    default:
        return "an unknown GL error";
    }
}

bool gl_check(GlContext *gl, const char *doing)
{
    GLenum first = gl->GetError();
    if (first == GL_NO_ERROR)
        return true;
    for (int i = 0; i < 16 && gl->GetError() != GL_NO_ERROR; i++) {
    } /* limits the number of reads: a lost context reports errors forever */
    return gl_fail(gl, "%s: %s", doing, error_name(first));
}
