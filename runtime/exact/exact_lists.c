/* Views of lights for exact shadows, and their headers. */
#include "runtime/exact/exact_lists.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FACES = 6, MIN_CELLS_SIDE = 8, MAX_CELLS_SIDE = MIN_CELLS_SIDE << 7 };

typedef struct {
    bool placed;
    float from[3], rows[3][4];
    int faces, size;
} View;

static void add_row(const double axis[3], double scale, double shift, float row[4])
{
    for (int i = 0; i < 3; i++)
        row[i] = (float)(axis[i] * scale);
    row[3] = (float)shift;
}

/* Enlarges a range by a box's extent along an axis, relative to the triangles' origin. */
static void reach_along(const ExactTriangles *triangles, const ExactBox *box, const double axis[3],
                        double range[2])
{
    double middle = 0, half = 0;
    for (int i = 0; i < 3; i++) {
        middle += axis[i] * ((box->low[i] + box->high[i]) / 2 - triangles->origin[i]);
        half += fabs(axis[i]) * (box->high[i] - box->low[i]) / 2;
    }
    range[0] = fmin(range[0], middle - half);
    range[1] = fmax(range[1], middle + half);
}

/* Sets the row that maps all triangles to -1 ... 1 along an axis, with a margin. */
static void fit_row(const ExactTriangles *triangles, const double axis[3], float row[4])
{
    const double margin = 1.001;
    double range[2] = {INFINITY, -INFINITY};
    for (int i = 0; i < triangles->object_count; i++)
        if (triangles->objects[i].count)
            reach_along(triangles, &triangles->objects[i].box, axis, range);
    const double half =
        fmax((range[1] - range[0]) / 2 * margin, fmax(triangles->reach * 1e-6, 1e-30));
    add_row(axis, 1 / half, triangles->count ? -(range[0] + range[1]) / 2 / half : 0, row);
}

/* Sets the transform from the world's axes to those of the first face of a cube, y, z, x. */
static void fit_cube(View *view)
{
    for (int row = 0; row < 3; row++)
        view->rows[row][row] = 1;
    view->faces = FACES;
}

static View view_of(const ExactTriangles *triangles, const SceneLight *light)
{
    View view = {.placed = light_from(light) != LIGHT_FROM_afar, .faces = 1};
    double x[3], y[3];
    for (int i = 0; i < 3; i++)
        view.from[i] = view.placed ? (float)(light->position[i] - triangles->origin[i])
                                   : (float)-light->direction[i];
    if (light_kind_is_wide(light)) {
        fit_cube(&view);
        return view;
    }
    scene_vector_axes(light->direction, x, y);
    if (view.placed) {
        const double cosine = light->outer_cosine,
                     half = fmax(sqrt(fmax(1 - cosine * cosine, 0)) / cosine * 1.01, 1e-4);
        add_row(x, 1 / half, 0, view.rows[0]);
        add_row(y, 1 / half, 0, view.rows[1]);
        add_row(light->direction, 1, 0, view.rows[2]);
    } else {
        fit_row(triangles, x, view.rows[0]);
        fit_row(triangles, y, view.rows[1]);
    }
    return view;
}

/* Returns the number of cells per edge: as many cells as triangles, or up to four times as many,
 * so that a triangle is about as wide as a cell. In a point light's view most triangles may be
 * far away and in few cells, so the number is quadrupled. */
static int size_for(const ExactTriangles *triangles, const View *view, int coarser)
{
    const double wanted = (view->placed ? 4.0 : 1.0) * triangles->count;
    int size = MIN_CELLS_SIDE;
    while (size < MAX_CELLS_SIDE && (double)size * size * view->faces < wanted)
        size *= 2;
    return size >> coarser > 1 ? size >> coarser : 1;
}

static void put_head(const View *view, size_t cells, uint32_t *head)
{
    const float placed = view->placed;
    memcpy(head + EXACT_LISTS_FROM, view->from, sizeof view->from);
    memcpy(head + EXACT_LISTS_PLACED, &placed, sizeof placed);
    memcpy(head + EXACT_LISTS_ROWS, view->rows, sizeof view->rows);
    head[EXACT_LISTS_VIEWS] = (uint32_t)view->faces;
    head[EXACT_LISTS_SIZE] = (uint32_t)view->size;
    head[EXACT_LISTS_CELLS] = (uint32_t)cells;
}

bool exact_lists_make(const Scene *scene, const ExactTriangles *triangles, int coarser,
                      ExactLists *made)
{
    *made = (ExactLists){.cells = 0};
    for (int i = 0; i < scene->light_count; i++)
        made->light_count += exact_lists_wanted(&scene->lights[i]);
    const size_t words = (size_t)made->light_count * EXACT_LISTS_HEAD;
    made->heads = malloc(words * sizeof *made->heads + 1);
    uint32_t *head = made->heads;
    for (int i = 0; head && i < scene->light_count; i++) {
        if (!exact_lists_wanted(&scene->lights[i]))
            continue;
        View view = view_of(triangles, &scene->lights[i]);
        view.size = size_for(triangles, &view, coarser);
        put_head(&view, words + EXACT_LISTS_PAIR * made->cells, head);
        made->cells += (size_t)view.size * (size_t)view.size * (size_t)view.faces;
        head += EXACT_LISTS_HEAD;
    }
    if (!made->heads)
        exact_lists_free(made);
    return made->heads;
}

void exact_lists_free(ExactLists *lists)
{
    free(lists->heads);
    *lists = (ExactLists){.cells = 0};
}

bool exact_lists_wanted(const SceneLight *light) { return light->shadows == KEYWORD_Shadows_exact; }
