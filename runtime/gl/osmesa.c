/* Contexts of Mesa's offscreen software renderer. The library is loaded at run time: a program
 * that never draws runs without it, and no program links to it. */
#include "runtime/gl/backend.h"
#include "runtime/gl/message.h"
#include <GL/osmesa.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    OSMesaContext context;
    OSMesaContext (*create)(const int *attributes, OSMesaContext share);
    void (*destroy)(OSMesaContext context);
    GLboolean (*make_current)(OSMesaContext context, void *buffer, GLenum type, GLsizei width,
                              GLsizei height);
    GlProc (*get_proc)(const char *name);
    unsigned char window[4]; /* the window of one pixel that OSMesa requires; never drawn to */
} Osmesa;

/* Loads the library, or reports the loader's reason: loading may also fail because memory runs
 * out. */
static void *open_library(char *error, size_t capacity)
{
    static const char *const names[] = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        void *library = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
        if (library)
            /* the library is never closed: LLVM's destructors do not survive an unload, and
             * further dlopen calls are cheap */
            return library;
        if (i == 0)
            message_fail(error, capacity, "%s (Debian: libosmesa6)", dlerror());
    }
    return NULL;
}

/* ISO C has no cast from an object pointer to a function pointer; POSIX guarantees equal
 * representations. */
static bool find(void *library, const char *name, void *function, size_t size)
{
    void *symbol = dlsym(library, name);
    if (!symbol || size != sizeof symbol)
        return false;
    memcpy(function, &symbol, sizeof symbol);
    return true;
}

static bool find_all(Osmesa *o, void *library)
{
    return find(library, "OSMesaCreateContextAttribs", &o->create, sizeof o->create) &&
           find(library, "OSMesaDestroyContext", &o->destroy, sizeof o->destroy) &&
           find(library, "OSMesaMakeCurrent", &o->make_current, sizeof o->make_current) &&
           find(library, "OSMesaGetProcAddress", &o->get_proc, sizeof o->get_proc);
}

/* Tries the highest version first: OSMesa returns NULL for an unsupported version or profile. */
static OSMesaContext create(const Osmesa *o, bool core)
{
    static const int versions[][2] = {{4, 5}, {3, 3}, {3, 0}, {2, 1}};
    /* core profiles start at 3.2, and the emitted GLSL at 3.3 */
    for (size_t i = 0; i < (core ? 2u : 4u); i++) {
        const int attributes[] = {
            OSMESA_FORMAT,
            OSMESA_RGBA,
            OSMESA_PROFILE,
            core ? OSMESA_CORE_PROFILE : OSMESA_COMPAT_PROFILE,
            OSMESA_CONTEXT_MAJOR_VERSION,
            versions[i][0],
            OSMESA_CONTEXT_MINOR_VERSION,
            versions[i][1],
            0,
        };
        OSMesaContext context = o->create(attributes, NULL);
        if (context)
            return context;
    }
    return NULL;
}

static bool osmesa_use(void *state)
{
    Osmesa *o = state;
    return o->make_current(o->context, o->window, GL_UNSIGNED_BYTE, 1, 1) == GL_TRUE;
}

static GlProc osmesa_load(void *state, const char *name)
{
    return ((Osmesa *)state)->get_proc(name);
}

static void osmesa_close(void *state)
{
    Osmesa *o = state;
    if (o->context)
        o->destroy(o->context); /* also unbinds the context if it is current */
    free(o);
}

static bool start(Osmesa *o, bool core, char *error, size_t capacity)
{
    void *library = open_library(error, capacity);
    if (!library)
        return false;
    if (!find_all(o, library))
        return message_fail(error, capacity, "libOSMesa is older than Mesa 11.2");
    o->context = create(o, core);
    if (!o->context)
        return message_fail(error, capacity, "OSMesa has no %s context",
                            core ? "core OpenGL 3.3" : "OpenGL 2.1");
    if (!osmesa_use(o))
        return message_fail(error, capacity, "OSMesa does not make its context current");
    return true;
}

static void *osmesa_open(bool core, char *error, size_t capacity)
{
    Osmesa *o = calloc(1, sizeof *o);
    if (!o) {
        message_fail(error, capacity, "out of memory");
        return NULL;
    }
    if (start(o, core, error, capacity))
        return o;
    osmesa_close(o);
    return NULL;
}

const GlBackend gl_backend_osmesa = {osmesa_open, osmesa_use, osmesa_load, osmesa_close};
