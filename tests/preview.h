/* The preview's pictures in memory, its cameras from their definition, and rays through pixels. */
#ifndef TESTS_PREVIEW_H
#define TESTS_PREVIEW_H
#include "compiler/matc.h"
#include "runtime/viewer/material_picture.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define RADIANS (M_PI / 180)
typedef struct {
    double at[3];
} Vector;

static inline double dot(Vector a, Vector b)
{
    return a.at[0] * b.at[0] + a.at[1] * b.at[1] + a.at[2] * b.at[2];
}
static inline Vector scaled(Vector a, double factor)
{
    return (Vector){{a.at[0] * factor, a.at[1] * factor, a.at[2] * factor}};
}
static inline Vector added(Vector a, Vector b)
{
    return (Vector){{a.at[0] + b.at[0], a.at[1] + b.at[1], a.at[2] + b.at[2]}};
}
static inline Vector unit(Vector a) { return scaled(a, 1 / sqrt(dot(a, a))); }

static inline Vector cross(Vector a, Vector b)
{
    const double *p = a.at, *q = b.at;
    return (Vector){
        {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]}};
}

static inline Vector from_angles(double azimuth, double elevation)
{
    return (Vector){{cos(azimuth) * cos(elevation), sin(azimuth) * cos(elevation), sin(elevation)}};
}

/* Position and axes of the camera in the world: right, up, toward the viewer. The world's z is
 * up. */
typedef struct {
    Vector position, right, up, back;
    double tangent; /* tangent of half the angle of the shorter side */
    int width, height;
} View;

static inline View look(Vector position, Vector back, double half_angle, int width, int height)
{
    View view = {.position = position,
                 .back = back,
                 .tangent = tan(half_angle),
                 .width = width,
                 .height = height};
    view.right = unit(cross((Vector){{0, 0, 1}}, back));
    view.up = cross(back, view.right);
    return view;
}

/* Ray through a pixel's center; row 0 is the lowest. */
static inline Vector ray_of(const View *view, int x, int y)
{
    int shorter = view->width < view->height ? view->width : view->height;
    double right = (2 * x + 1 - view->width) * view->tangent / shorter;
    double up = (2 * y + 1 - view->height) * view->tangent / shorter;
    return unit(
        added(added(scaled(view->right, right), scaled(view->up, up)), scaled(view->back, -1)));
}

/* Converts a linear value to a byte as matview does. */
static inline double byte_of(double linear)
{
    double c = fmin(fmax(linear, 0), 1);
    return 255 * (c <= .0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - .055);
}

typedef struct {
    MatcDocument *document;
    MatcOptions options;
    View view;
    unsigned char *rgb;
} Drawn;

/* Draws the document's only material into rgb, with a separate context. Fails on any message. */
static inline void draw_pixels(MatcDocument *document, const MaterialPictureOptions *options,
                               unsigned char *rgb)
{
    char error[512] = "";
    MaterialReport reported = {0};
    GlContext *gl = gl_open(GL_KIND_osmesa, true, error, sizeof error);
    assert_non_null(gl);
    assert_int_equal(matc_material_count(document), 1);
    MaterialPictures *pictures = material_pictures_open(gl, options);
    const bool shown = pictures && material_pictures_show(pictures, document, 0, &reported);
    if (!shown || *reported.diagnostics ||
        !scene_pictures_pixels(material_pictures_of(pictures), rgb))
        fail_msg("%s%s%s", reported.diagnostics ? reported.diagnostics : "", reported.error,
                 gl->error);
    free(reported.diagnostics);
    material_pictures_close(pictures);
    gl_close(gl);
}

/* Material and program of a preview. */
typedef struct {
    const char *text, *pass, *normals, *slot;
} Subject;

/* Draws with one sample per pixel, at its center. */
static inline Drawn draw_subject(const Subject *subject, int width, int height)
{
    const char *text = subject->text;
    Drawn p = {.rgb = malloc((size_t)width * (size_t)height * 3)};
    matc_options_init(&p.options);
    p.options.pass = subject->pass;
    p.options.layout = "integer";
    p.options.normals = subject->normals;
    p.document = matc_read("preview.yaml", text, strlen(text), &p.options);
    const MaterialPictureOptions options = {
        .pictures = {.renderer = {.compile = &p.options, .samples = 1}},
        .preview = {.shape = SHAPE_sphere,
                    .width = width,
                    .height = height,
                    .sky = !strcmp(subject->pass, "sky")},
        .slot = subject->slot};
    draw_pixels(p.document, &options, p.rgb);
    return p;
}

static inline Drawn draw_slot(const char *text, const char *pass, const char *slot, int width,
                              int height)
{
    return draw_subject(&(Subject){text, pass, NULL, slot}, width, height);
}

static inline Drawn draw(const char *text, const char *pass, int width, int height)
{
    return draw_slot(text, pass, NULL, width, height);
}

static inline void discard(Drawn *p)
{
    matc_document_free(p->document);
    free(p->rgb);
}
#endif
