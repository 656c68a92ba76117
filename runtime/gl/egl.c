/* EGL contexts without a window or a surface: on a GPU if available, else on any other device.
 * The library is loaded at run time. Displays belong to the whole process and are never
 * terminated, since other code may have contexts on them. */
#include "runtime/gl/backend.h"
#include "runtime/gl/message.h"
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

/* Functions of EGL 1.4: F(NAME, Name) declares eglName. */
#define EGL_FUNCTIONS(F)                                                                           \
    F(BINDAPI, BindAPI)                                                                            \
    F(CHOOSECONFIG, ChooseConfig)                                                                  \
    F(CREATECONTEXT, CreateContext)                                                                \
    F(CREATEPBUFFERSURFACE, CreatePbufferSurface)                                                  \
    F(DESTROYCONTEXT, DestroyContext)                                                              \
    F(DESTROYSURFACE, DestroySurface)                                                              \
    F(GETCURRENTCONTEXT, GetCurrentContext)                                                        \
    F(GETDISPLAY, GetDisplay)                                                                      \
    F(GETERROR, GetError)                                                                          \
    F(GETPROCADDRESS, GetProcAddress)                                                              \
    F(INITIALIZE, Initialize)                                                                      \
    F(MAKECURRENT, MakeCurrent)                                                                    \
    F(QUERYSTRING, QueryString)

enum { DEVICES = 32, SURFACE_SIDE = 16 };

typedef struct {
    EGLDisplay display;
    EGLContext context;
    EGLSurface surface; /* surface of the context; EGL_NO_SURFACE if none is needed */
    bool core;
#define F(NAME, Name) PFNEGL##NAME##PROC Name;
    EGL_FUNCTIONS(F)
#undef F
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display;
    char *error; /* the caller's buffer for the reason why the last display failed */
    size_t capacity;
} Egl;

static bool load_library(Egl *e)
{
    void *library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        library = dlopen("libEGL.so", RTLD_NOW | RTLD_LOCAL);
    if (!library) /* the library is never closed, like OSMesa */
        return message_fail(e->error, e->capacity, "no libEGL.so.1 found (Debian: libegl1)");
    void *symbol;
#define F(NAME, Name)                                                                              \
    symbol = dlsym(library, "egl" #Name);                                                          \
    if (!symbol)                                                                                   \
        return message_fail(e->error, e->capacity,                                                 \
                            "libEGL has no egl" #Name ": it is older than EGL 1.4");               \
    memcpy(&e->Name, &symbol, sizeof symbol);
    EGL_FUNCTIONS(F)
#undef F
    return true;
}

/* Reports whether a list separated by blanks contains a whole word. */
static bool has_word(const char *list, const char *word)
{
    size_t size = strlen(word);
    for (const char *at = list; at && (at = strstr(at, word)); at += size)
        if ((at == list || at[-1] == ' ') && (at[size] == ' ' || !at[size]))
            return true;
    return false;
}

static bool fail(const Egl *e, const char *what)
{
    return message_fail(e->error, e->capacity, "EGL %s (error 0x%04X)", what,
                        (unsigned)e->GetError());
}

static bool choose_config(const Egl *e, EGLConfig *config)
{
    /* some drivers have no config with surfaces */
    static const EGLint kinds[] = {EGL_PBUFFER_BIT, 0};
    for (int i = 0; i < 2; i++) {
        const EGLint wanted[] = {EGL_SURFACE_TYPE, kinds[i], EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                 EGL_NONE};
        EGLint count = 0;
        if (e->ChooseConfig(e->display, wanted, config, 1, &count) && count > 0)
            return true;
    }
    return false;
}

/* Tries the highest version first: EGL creates no context for an unsupported version or profile. */
static bool create_context(Egl *e, EGLConfig config)
{
    static const EGLint versions[][2] = {{4, 5}, {3, 3}, {3, 0}, {2, 1}};
    for (int i = 0; i < (e->core ? 2 : 4); i++) {
        const EGLint attributes[] = {
            EGL_CONTEXT_MAJOR_VERSION,
            versions[i][0],
            EGL_CONTEXT_MINOR_VERSION,
            versions[i][1],
            EGL_CONTEXT_OPENGL_PROFILE_MASK,
            e->core ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                    : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
            EGL_NONE,
        };
        e->context = e->CreateContext(e->display, config, EGL_NO_CONTEXT, attributes);
        if (e->context != EGL_NO_CONTEXT)
            return true;
    }
    return false;
}

static bool egl_use(void *state)
{
    Egl *e = state;
    return e->BindAPI(EGL_OPENGL_API) &&
           e->MakeCurrent(e->display, e->surface, e->surface, e->context);
}

/* Makes the context current, without a surface if supported, else with a small unused one. */
static bool make_usable(Egl *e, EGLConfig config)
{
    const EGLint size[] = {EGL_WIDTH, SURFACE_SIDE, EGL_HEIGHT, SURFACE_SIDE, EGL_NONE};
    if (has_word(e->QueryString(e->display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context") &&
        egl_use(e))
        return true;
    e->surface = e->CreatePbufferSurface(e->display, config, size);
    return e->surface != EGL_NO_SURFACE && egl_use(e);
}

static void drop(Egl *e)
{
    if (e->context != EGL_NO_CONTEXT && e->GetCurrentContext() == e->context)
        e->MakeCurrent(e->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (e->surface != EGL_NO_SURFACE)
        e->DestroySurface(e->display, e->surface);
    if (e->context != EGL_NO_CONTEXT)
        e->DestroyContext(e->display, e->context);
    e->surface = EGL_NO_SURFACE;
    e->context = EGL_NO_CONTEXT;
}

static bool try_display(Egl *e, EGLDisplay display)
{
    EGLConfig config;
    e->display = display;
    if (display == EGL_NO_DISPLAY)
        return fail(e, "has no display");
    if (!e->Initialize(display, NULL, NULL))
        return fail(e, "does not initialise its display");
    if (!e->BindAPI(EGL_OPENGL_API))
        return fail(e, "has no desktop OpenGL");
    if (!choose_config(e, &config))
        return fail(e, "has no configuration for desktop OpenGL");
    if (!create_context(e, config))
        return fail(e,
                    e->core ? "has no core context of OpenGL 3.3" : "has no context of OpenGL 2.1");
    if (make_usable(e, config))
        return true;
    fail(e, "does not make its context current");
    drop(e);
    return false;
}

static GlProc egl_load(void *state, const char *name)
{
    return (GlProc)((Egl *)state)->GetProcAddress(name);
}

/* Tries all devices, hardware first. */
static bool try_devices(Egl *e)
{
    PFNEGLQUERYDEVICESEXTPROC query = (PFNEGLQUERYDEVICESEXTPROC)egl_load(e, "eglQueryDevicesEXT");
    PFNEGLQUERYDEVICESTRINGEXTPROC text =
        (PFNEGLQUERYDEVICESTRINGEXTPROC)egl_load(e, "eglQueryDeviceStringEXT");
    EGLDeviceEXT devices[DEVICES];
    EGLint count = 0;
    if (!query || !text || !query(DEVICES, devices, &count))
        return false;
    for (int software = 0; software < 2; software++)
        for (int i = 0; i < count; i++)
            if (has_word(text(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software") ==
                    software &&
                try_display(e, e->get_platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL)))
                return true;
    return false;
}

static bool start(Egl *e)
{
    if (!load_library(e))
        return false;
    /* client extensions; NULL before EGL 1.5 */
    const char *client = e->QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    e->get_platform_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)egl_load(e, "eglGetPlatformDisplayEXT");
    if (e->get_platform_display && has_word(client, "EGL_EXT_platform_device") && try_devices(e))
        return true;
    if (e->get_platform_display && has_word(client, "EGL_MESA_platform_surfaceless") &&
        try_display(
            e, e->get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL)))
        return true;
    return try_display(e, e->GetDisplay(EGL_DEFAULT_DISPLAY));
}

static void egl_close(void *state)
{
    drop(state);
    free(state);
}

static void *egl_open(bool core, char *error, size_t capacity)
{
    Egl *e = calloc(1, sizeof *e);
    if (!e) {
        message_fail(error, capacity, "out of memory");
        return NULL;
    }
    e->core = core;
    e->error = error;
    e->capacity = capacity;
    if (start(e))
        return e;
    free(e);
    return NULL;
}

const GlBackend gl_backend_egl = {egl_open, egl_use, egl_load, egl_close};
