/* Renders SVG to PNG with librsvg. The library is loaded by dlopen, so the program does not link
 * to it. */
#include "runtime/autotune/plot.h"
#include "runtime/gl/message.h"
#include <dlfcn.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { CAIRO_ARGB32 = 0, CAIRO_SUCCESS = 0 };
typedef struct {
    double x, y, width, height;
} RsvgRectangle;

/* The called functions; GObject and cairo handles are opaque pointers. */
typedef struct {
    void *(*handle_new)(const uint8_t *data, size_t size, void **error);
    int (*handle_size)(void *handle, double *width, double *height);
    int (*handle_render)(void *handle, void *cairo, const RsvgRectangle *viewport, void **error);
    void (*unref)(void *object);
    void *(*surface_new)(int format, int width, int height);
    void *(*cairo_new)(void *surface);
    void (*cairo_free)(void *cairo);
    int (*surface_write)(void *surface, const char *path);
    void (*surface_free)(void *surface);
} Library;

static bool find(void *library, const char *name, void *function)
{
    void *symbol = library ? dlsym(library, name) : NULL;
    memcpy(function, &symbol, sizeof symbol);
    return symbol != NULL;
}

/* Loads librsvg. Functions of its dependencies cairo and glib are found through the same handle. */
static bool load(Library *l)
{
    void *rsvg = dlopen("librsvg-2.so.2", RTLD_NOW | RTLD_LOCAL);
    return find(rsvg, "rsvg_handle_new_from_data", &l->handle_new) &&
           find(rsvg, "rsvg_handle_get_intrinsic_size_in_pixels", &l->handle_size) &&
           find(rsvg, "rsvg_handle_render_document", &l->handle_render) &&
           find(rsvg, "g_object_unref", &l->unref) &&
           find(rsvg, "cairo_image_surface_create", &l->surface_new) &&
           find(rsvg, "cairo_create", &l->cairo_new) &&
           find(rsvg, "cairo_destroy", &l->cairo_free) &&
           find(rsvg, "cairo_surface_write_to_png", &l->surface_write) &&
           find(rsvg, "cairo_surface_destroy", &l->surface_free);
}

/* A plot loaded by librsvg, and its output parameters. */
typedef struct {
    const Library *library;
    void *handle;
    double scale;
    const char *path;
} Drawing;

static bool write(const Drawing *drawing, char *error, size_t capacity)
{
    const Library *l = drawing->library;
    double width = 0, height = 0;
    if (!l->handle_size(drawing->handle, &width, &height))
        return message_fail(error, capacity, "librsvg finds no size in the plot");
    const RsvgRectangle all = {0, 0, ceil(width * drawing->scale), ceil(height * drawing->scale)};
    void *surface = l->surface_new(CAIRO_ARGB32, (int)all.width, (int)all.height),
         *cairo = l->cairo_new(surface);
    bool drawn = l->handle_render(drawing->handle, cairo, &all, NULL);
    l->cairo_free(cairo);
    bool written = drawn && l->surface_write(surface, drawing->path) == CAIRO_SUCCESS;
    l->surface_free(surface);
    return written || message_fail(error, capacity, "%s: the plot cannot be %s", drawing->path,
                                   drawn ? "written" : "drawn");
}

bool plot_png(const char *svg, double scale, const char *path, char *error, size_t capacity)
{
    Library library;
    if (!load(&library))
        return message_fail(error, capacity, "no librsvg-2.so.2 found (Debian: librsvg2-2)");
    void *handle = library.handle_new((const uint8_t *)svg, strlen(svg), NULL);
    if (!handle)
        return message_fail(error, capacity, "librsvg does not read the plot");
    bool done = write(&(Drawing){&library, handle, scale, path}, error, capacity);
    library.unref(handle);
    return done;
}
