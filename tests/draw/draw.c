/* Creates contexts, uploads points, and draws programs at them. */
#include "draw.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 3 };
_Static_assert(sizeof(Point) == sizeof((FieldVertex){0}.input), "a point is what a vertex carries");

static bool fail(Drawer *d, const char *text)
{
    snprintf(d->error, sizeof d->error, "%s", text);
    return false;
}

static int height_of(const Drawer *d) { return d->width == GRID_WIDTH ? GRID_HEIGHT : d->width; }

/* The center of the pixel of point i in clip space, offset by `part` pixels. */
static FieldVertex vertex_of(const Drawer *d, int i, const double part[2], const Point *point)
{
    FieldVertex vertex = {.at = {(float)(2 * (i % d->width + 0.5 + part[0]) / d->width - 1),
                                 (float)(2 * (i / d->width + 0.5 + part[1]) / height_of(d) - 1), 0,
                                 1}};
    memcpy(vertex.input, point->input, sizeof vertex.input);
    return vertex;
}

/* The triangles are clockwise, so their backs are visible. */
static bool upload(Drawer *d, const Point *points)
{
    static const double middle[2] = {0, 0},
                        corner[CORNERS][2] = {{-0.3, -0.3}, {0, 0.4}, {0.3, -0.3}};
    FieldVertex *vertices = calloc((size_t)d->count * CORNERS, sizeof *vertices);
    if (!vertices)
        abort();
    for (int i = 0; i < d->count; i++)
        vertices[i] = vertex_of(d, i, middle, &points[i]);
    bool made = field_make(d->gl, vertices, d->count, GL_POINTS, &d->points);
    for (int i = 0; i < d->count * CORNERS; i++)
        vertices[i] = vertex_of(d, i / CORNERS, corner[i % CORNERS], &points[i / CORNERS]);
    made = made && field_make(d->gl, vertices, d->count * CORNERS, GL_TRIANGLES, &d->triangles);
    free(vertices);
    return made;
}

static bool open_with(Drawer *d, const Point *points, int targets, GLenum format)
{
    while (d->width * height_of(d) < d->count)
        d->width++;
    d->gl = gl_open(GL_KIND_osmesa, d->core, d->error, sizeof d->error);
    if (!d->gl)
        return false;
    const FramebufferSpec spec = {d->width, height_of(d), targets, format, false};
    d->store = store_new(d->gl);
    return (d->store && upload(d, points) && framebuffer_make(d->gl, &spec, &d->target)) ||
           fail(d, d->gl->error);
}

bool drawer_open(Drawer *d, bool core, const Point *points, int count)
{
    *d = (Drawer){.core = core, .count = count, .width = GRID_WIDTH};
    return open_with(d, points, 1, GL_RGBA32F);
}

bool drawer_open_half(Drawer *d, bool core, const Point *points, int count, int targets)
{
    *d = (Drawer){.core = core, .count = count, .width = GRID_WIDTH};
    return open_with(d, points, targets, GL_RGBA16F);
}

void drawer_close(Drawer *d)
{
    if (!d->gl)
        return;
    gl_use(d->gl);
    store_free(d->store);
    gl_close(d->gl); /* deletes its objects, too */
    *d = (Drawer){0};
}

static const double *value_of(const Graph *graph, const MatcUniform *uniform)
{
    for (int i = 0; graph && i < graph->uniform_count; i++)
        if (!strcmp(graph->uniforms[i]->name, uniform->param))
            return graph->uniforms[i]->initial;
    return uniform->initial;
}

void drawer_set_uniforms(const Shading *shading, Material *material)
{
    for (int i = 0; shading->program && i < matc_uniform_count(shading->program); i++) {
        const MatcUniform *uniform = matc_uniform(shading->program, i);
        const double *value = value_of(shading->graph, uniform);
        float numbers[4] = {0};
        for (int component = 0; component < uniform->components; component++)
            numbers[component] = (float)value[component];
        material_set(material, &(MaterialValue){uniform->name, uniform->components, numbers});
    }
    float viewer[4];
    for (int component = 0; component < 4; component++)
        viewer[component] = (float)point_viewer[component];
    material_set_number(material, "matc_ior", (float)point_ior);
    material_set_number(material, "matc_time", (float)point_time);
    material_set(material, &(MaterialValue){"matc_viewer", 4, viewer});
}

bool drawer_material(Drawer *d, const Shading *shading, Material *made)
{
    const FieldText text = {shading->target, shading->fragment, shading->library};
    gl_use(d->gl);
    if (!field_material(d->store, shading->program, &text, made))
        return fail(d, d->gl->error);
    drawer_set_uniforms(shading, made);
    return true;
}

/* Rows of the framebuffer are rows of the grid. */
static bool draw(Drawer *d, Material *material, const Field *field, const Framebuffer *target)
{
    framebuffer_clear(d->gl, target, (float[4]){-12345, -12345, -12345, -12345});
    material_use(material);
    field_draw(d->gl, field);
    return gl_check(d->gl, "drawing points") || fail(d, d->gl->error);
}

bool drawer_draw_to(Drawer *d, Material *material, bool front, const Framebuffer *target)
{
    gl_use(d->gl);
    return draw(d, material, front ? &d->points : &d->triangles, target);
}

bool drawer_fill(Drawer *d, Material *material, const Point corners[3], float *rgba)
{
    FieldVertex vertices[CORNERS] = {
        {.at = {-1, -1, 0, 1}}, {.at = {3, -1, 0, 1}}, {.at = {-1, 3, 0, 1}}};
    Field field;
    for (int i = 0; i < CORNERS; i++)
        memcpy(vertices[i].input, corners[i].input, sizeof vertices[i].input);
    gl_use(d->gl);
    bool drawn =
        (field_make(d->gl, vertices, CORNERS, GL_TRIANGLES, &field) || fail(d, d->gl->error)) &&
        draw(d, material, &field, &d->target);
    field_delete(d->gl, &field);
    return drawn && (framebuffer_read(d->gl, &d->target, 0, rgba) || fail(d, d->gl->error));
}

bool drawer_draw(Drawer *d, Material *material, bool front, float *const *rgba, int targets)
{
    bool drawn = drawer_draw_to(d, material, front, &d->target);
    for (int i = 0; drawn && i < targets; i++)
        if (!framebuffer_read(d->gl, &d->target, i, rgba[i]))
            return fail(d, d->gl->error);
    return drawn;
}
