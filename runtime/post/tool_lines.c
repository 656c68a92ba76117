/* Builds lines in scene coordinates in double precision, transforms them to view space, and
 * rounds them there to float. */
#include "runtime/post/tool_lines.h"
#include <stdlib.h>
#include <string.h>

enum { CAPACITY = 64 };

/* gray is sRGB 0.5; yellow is for lights */
static const float grey[3] = {.2140f, .2140f, .2140f}, yellow[3] = {1, .6f, .05f};

typedef struct {
    const ViewSpace *space;
    double zero[3]; /* the world's origin */
    ToolLines *lines;
    bool full; /* memory ran out */
} Maker;

static void put(Maker *m, const double p[3], bool ground, const float color[3])
{
    const double *e = m->space->eye_from_world;
    ToolLines *lines = m->lines;
    if (lines->count == lines->capacity) {
        const int capacity = lines->capacity ? 2 * lines->capacity : CAPACITY;
        ToolVertex *grown = realloc(lines->vertices, (size_t)capacity * sizeof *grown);
        if (!grown) {
            m->full = true;
            return;
        }
        lines->vertices = grown;
        lines->capacity = capacity;
    }
    ToolVertex *vertex = &lines->vertices[lines->count++];
    for (int i = 0; i < 3; i++) {
        vertex->point[i] = (float)(e[i] * p[0] + e[4 + i] * p[1] + e[8 + i] * p[2] + e[12 + i]);
        vertex->color[i] = color[i];
    }
    vertex->point[3] = ground;
}

static void line(Maker *m, const double a[3], const double b[3], const float color[3])
{
    const bool ground = a[2] == m->zero[2] && b[2] == m->zero[2];
    put(m, a, ground, color);
    put(m, b, ground, color);
}

static void add_axes(Maker *m, double length)
{
    for (int i = 0; i < 3; i++) {
        double end[3] = {m->zero[0], m->zero[1], m->zero[2]};
        float color[3] = {.02f, .02f, .02f};
        end[i] += length;
        color[i] = i == 2 ? 1 : .7f;
        line(m, m->zero, end, color);
    }
}

/* Adds a square grid of `cells` cells from the origin to each side. */
static void add_grid(Maker *m, int cells, double step)
{
    const double side = cells * step, x = m->zero[0], y = m->zero[1], z = m->zero[2];
    for (int i = -cells; i <= cells; i++) {
        line(m, (double[]){x + i * step, y - side, z}, (double[]){x + i * step, y + side, z}, grey);
        line(m, (double[]){x - side, y + i * step, z}, (double[]){x + side, y + i * step, z}, grey);
    }
}

/* Collects the outlines of lights for LightKind.outline. */
typedef struct {
    LightLines lines; /* first member: a LightLines pointer is also an Outline pointer */
    Maker *maker;
} Outline;

static void add_line(LightLines *lines, const double from[3], const double to[3])
{
    line(((Outline *)lines)->maker, from, to, yellow);
}

static void add_lights(Maker *m, const Scene *scene)
{
    Outline outline = {{.add = add_line, .size = scene->tools.light_size}, m};
    memcpy(outline.lines.zero, m->zero, sizeof m->zero);
    for (int i = 0; i < scene->light_count; i++) {
        const LightKind *row = light_kind_of(&scene->lights[i]);
        if (row->outline)
            row->outline(&scene->lights[i], &outline.lines);
    }
}

bool tool_lines_make(const Scene *scene, const ViewSpace *space, ToolLines *made)
{
    Maker maker = {.space = space, .lines = made};
    const SceneTools *tools = &scene->tools;
    for (int i = 0; i < 3; i++)
        maker.zero[i] = 0 - scene->origin[i];
    *made = (ToolLines){0};
    if (tools->axes)
        add_axes(&maker, tools->axes_length);
    if (tools->lights)
        add_lights(&maker, scene);
    if (tools->grid)
        add_grid(&maker, tools->grid_cells, tools->grid_step);
    if (maker.full)
        tool_lines_free(made);
    return !maker.full;
}

void tool_lines_free(ToolLines *lines)
{
    free(lines->vertices);
    *lines = (ToolLines){0};
}
