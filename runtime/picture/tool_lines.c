/* Lines in the scene's coordinates, in double, which go to the eye's space and are rounded
 * there. */
#include "runtime/picture/tool_lines.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

enum { ROOM = 64, AROUND = 32 /* steps of a circle */, EDGES = 4 /* of a cone */ };

/* sRGB 0.5; and that of lights */
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
    if (lines->count == lines->room) {
        const int room = lines->room ? 2 * lines->room : ROOM;
        ToolVertex *grown = realloc(lines->vertices, (size_t)room * sizeof *grown);
        if (!grown) {
            m->full = true;
            return;
        }
        lines->vertices = grown;
        lines->room = room;
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

/* The square of so many cells from the origin to each side. */
static void add_grid(Maker *m, int cells, double step)
{
    const double side = cells * step, x = m->zero[0], y = m->zero[1], z = m->zero[2];
    for (int i = -cells; i <= cells; i++) {
        line(m, (double[]){x + i * step, y - side, z}, (double[]){x + i * step, y + side, z}, grey);
        line(m, (double[]){x - side, y + i * step, z}, (double[]){x + side, y + i * step, z}, grey);
    }
}

/* The point at that angle from the light's axis and around it, at a distance. */
static void around(const SceneLight *light, const double angles[2], double distance, double out[3])
{
    const double *d = light->direction, x[3] = {fabs(d[0]) < .9, fabs(d[0]) >= .9, 0};
    double u[3], v[3];
    scene_vector_cross(d, x, u);
    scene_vector_normalize(u);
    scene_vector_cross(d, u, v);
    for (int i = 0; i < 3; i++)
        out[i] = light->position[i] +
                 distance * (cos(angles[0]) * d[i] +
                             sin(angles[0]) * (cos(angles[1]) * u[i] + sin(angles[1]) * v[i]));
}

/* Three lines that cross at the light. */
static void add_point(Maker *m, const SceneLight *light, double size)
{
    for (int i = 0; i < 3; i++) {
        double ends[2][3];
        for (int k = 0; k < 2; k++) {
            memcpy(ends[k], light->position, sizeof ends[k]);
            ends[k][i] += (k - .5) * size;
        }
        line(m, ends[0], ends[1], yellow);
    }
}

/* Its outer cone: edges as long as `size`, and the circle through their ends. */
static void add_spot(Maker *m, const SceneLight *light, double size)
{
    const double angle = acos(light->outer_cosine);
    for (int i = 0; i < AROUND; i++) {
        double ends[2][3];
        for (int k = 0; k < 2; k++)
            around(light, (double[]){angle, 2 * PI * (i + k) / AROUND}, size, ends[k]);
        line(m, ends[0], ends[1], yellow);
        if (i % (AROUND / EDGES) == 0)
            line(m, light->position, ends[0], yellow);
    }
}

/* An arrow that ends at the origin: such a light has no place. */
static void add_directional(Maker *m, const SceneLight *light, double size)
{
    SceneLight tip = {
        .direction = {-light->direction[0], -light->direction[1], -light->direction[2]}};
    memcpy(tip.position, m->zero, sizeof tip.position);
    double end[3];
    around(&tip, (double[]){0, 0}, 4 * size, end);
    line(m, end, tip.position, yellow);
    for (int i = 0; i < EDGES; i++) {
        around(&tip, (double[]){PI / 8, 2 * PI * i / EDGES}, size, end);
        line(m, end, tip.position, yellow);
    }
}

/* Its outline, and from its middle a line to where it shines. */
static void add_area(Maker *m, const SceneLight *light, double size)
{
    const double *u = light->edges[0], *v = light->edges[1], *p = light->position;
    double corners[4][3], middle[3], normal[3], end[3];
    scene_vector_cross(u, v, normal);
    scene_vector_normalize(normal);
    for (int i = 0; i < 3; i++) {
        corners[0][i] = p[i];
        corners[1][i] = p[i] + u[i];
        corners[2][i] = p[i] + u[i] + v[i];
        corners[3][i] = p[i] + v[i];
        middle[i] = p[i] + (u[i] + v[i]) / 2;
        end[i] = middle[i] + size * normal[i];
    }
    for (int k = 0; k < 4; k++)
        line(m, corners[k], corners[(k + 1) % 4], yellow);
    line(m, middle, end, yellow);
}

static void add_light(Maker *m, const SceneLight *light, double size)
{
    if (light->kind == SCENE_Point)
        add_point(m, light, size);
    else if (light->kind == SCENE_Spot)
        add_spot(m, light, size);
    else if (light->kind == SCENE_Directional)
        add_directional(m, light, size);
    else if (light->kind == SCENE_Area)
        add_area(m, light, size);
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
    for (int i = 0; tools->lights && i < scene->light_count; i++)
        add_light(&maker, &scene->lights[i], tools->light_size);
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
