/* Triangles go through a light's view in double, as polygons; cells they cover are found row by row. What a shader finds in floats may be off by
 * 1e-4 of a cell: a point's place is a sum of three products, or a quotient of such, times half as many cells as a view's edge has, 512 at
 * most. So all is spread by 1/64 of a cell.
 *
 *     a triangle (0.5, 0.5), (2.5, 0.5), (0.5, 1.5) in cells: rows 0 and 1. Of row 0 it has x from 0.5 to 2.5, cells 0, 1, 2; of row 1,
 *     whose lower side meets its slope at x = 1.5, from 0.5 to 1.5: cells 0 and 1. Five entries */
#include "runtime/render/exact_lists.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    FACES = 6,
    CORNERS_MOST = 16, /* of a triangle that four planes cut: 7; where rounding makes signs alternate, 13 */
    SIZE_LEAST = 8,
    SIZE_MOST = 1024,
    COARSER_MOST = 10 /* from there to one cell */
};

static const double spread = 1.0 / 64; /* of a cell */
static const double widest = 0.5;      /* cosine: a spot with a wider cone is looked at as a point */

/* -- what a light sees */

typedef struct {
    bool placed;
    float from[3], rows[3][4];
    int faces, size;
} View;

typedef struct {
    double at[CORNERS_MOST][3];
    int count;
} Polygon;

static void add_row(const double axis[3], double scale, double shift, float row[4])
{
    for (int i = 0; i < 3; i++)
        row[i] = (float)(axis[i] * scale);
    row[3] = (float)shift;
}

/* From -1 to 1 along an axis, with some room: all triangles. */
static void fit_row(const ExactTriangles *triangles, const double axis[3], float row[4])
{
    const double room = 1.001;
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < 3 * triangles->count; i++) {
        const float *corner = triangles->corners[i / 3][i % 3];
        const double along = axis[0] * corner[0] + axis[1] * corner[1] + axis[2] * corner[2];
        low = fmin(low, along);
        high = fmax(high, along);
    }
    const double half = fmax((high - low) / 2 * room, fmax(triangles->reach * 1e-6, 1e-30));
    add_row(axis, 1 / half, triangles->count ? -(low + high) / 2 / half : 0, row);
}

/* From the world's axes to those of the first face of a cube, y, z, x. */
static void fit_cube(View *view)
{
    for (int row = 0; row < 3; row++)
        view->rows[row][row] = 1;
    view->faces = FACES;
}

static View view_of(const ExactListsSource *source, const SceneLight *light)
{
    View view = {.placed = light->kind != SCENE_Directional, .faces = 1};
    double x[3], y[3];
    for (int i = 0; i < 3; i++)
        view.from[i] =
            view.placed ? (float)(light->position[i] - source->triangles->origin[i]) : (float)-light->direction[i];
    if (light->kind == SCENE_Point || (light->kind == SCENE_Spot && light->outer_cosine <= widest)) {
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
        fit_row(source->triangles, x, view.rows[0]);
        fit_row(source->triangles, y, view.rows[1]);
    }
    return view;
}

/* As many cells as triangles, or up to four times as many: a triangle is then about a cell wide. */
static int size_for(const ExactListsSource *source, const View *view, int coarser)
{
    int size = SIZE_LEAST;
    while (size < SIZE_MOST && (double)size * size * view->faces < source->triangles->count)
        size *= 2;
    return size >> coarser > 1 ? size >> coarser : 1;
}

/* -- from triangles to polygons of a face's cells */

static void place_of(const View *view, const float corner[3], double place[3])
{
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = view->placed ? (double)corner[i] - view->from[i] : corner[i];
    for (int row = 0; row < 3; row++) {
        const float *r = view->rows[row];
        place[row] = r[0] * from[0] + r[1] * from[1] + r[2] * from[2] + r[3];
    }
}

/* From a place to the axes of a face: face 2 k looks along axis k, 2 k + 1 against it. */
static void turn(const double place[3], int face, double turned[3])
{
    const int axis = face / 2;
    turned[0] = place[(axis + 1) % 3];
    turned[1] = place[(axis + 2) % 3];
    turned[2] = face % 2 ? -place[axis] : place[axis];
}

/* Keeps what has sign x (or y) <= wide z. */
static void clip(Polygon *polygon, int lane, double sign, double wide)
{
    Polygon kept = {.count = 0};
    for (int i = 0; i < polygon->count; i++) {
        const double *a = polygon->at[i], *b = polygon->at[(i + 1) % polygon->count];
        const double in = wide * a[2] - sign * a[lane], next = wide * b[2] - sign * b[lane];
        if (in >= 0)
            memcpy(kept.at[kept.count++], a, sizeof kept.at[0]);
        if ((in < 0) != (next < 0)) {
            const double t = in / (in - next);
            for (int k = 0; k < 3; k++)
                kept.at[kept.count][k] = a[k] + t * (b[k] - a[k]);
            kept.count++;
        }
    }
    *polygon = kept;
}

/* What the face has of it, in cells. Through the light itself: all of the face. */
static void to_cells(const View *view, Polygon *polygon)
{
    const double size = view->size, wide = 1 + 4 * spread / size;
    for (int plane = 0; view->placed && plane < 4 && polygon->count; plane++)
        clip(polygon, plane / 2, plane % 2 ? -1 : 1, wide);
    for (int i = 0; i < polygon->count; i++) {
        double *at = polygon->at[i];
        const double over = view->placed ? at[2] : 1;
        if (over <= 0) {
            *polygon = (Polygon){{{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}}, 4};
            return;
        }
        at[0] = (at[0] / over * 0.5 + 0.5) * size;
        at[1] = (at[1] / over * 0.5 + 0.5) * size;
    }
}

/* -- from polygons to cells */

static int cell_of(double at, int size)
{
    const double cell = floor(at);
    return cell < 0 ? 0 : cell >= size ? size - 1 : (int)cell;
}

/* Where an edge lies between two heights, it widens the range. */
static void add_edge(const double a[3], const double b[3], const double heights[2], double range[2])
{
    const double *low = a[1] <= b[1] ? a : b, *high = a[1] <= b[1] ? b : a;
    if (high[1] < heights[0] || low[1] > heights[1])
        return;
    const double rise = high[1] - low[1], slope = rise > 0 ? (high[0] - low[0]) / rise : 0;
    const double from = low[1] < heights[0] ? low[0] + slope * (heights[0] - low[1]) : low[0];
    const double to = high[1] > heights[1] ? low[0] + slope * (heights[1] - low[1]) : high[0];
    range[0] = fmin(range[0], fmin(from, to));
    range[1] = fmax(range[1], fmax(from, to));
}

/* Lists that are counted, then filled. */
typedef struct {
    const ExactListsSource *source;
    size_t *counts;  /* of each cell; when lists are filled: where the next entry goes */
    uint32_t *words; /* NULL: they are counted */
    size_t sum;
} Filler;

static void add_cells(Filler *filler, size_t row, const int cells[2], uint32_t triangle)
{
    for (int cell = cells[0]; cell <= cells[1]; cell++) {
        const size_t at = filler->counts[row + (size_t)cell]++;
        if (filler->words)
            filler->words[at] = triangle;
    }
    filler->sum += (size_t)(cells[1] - cells[0] + 1);
}

static void add_polygon(Filler *filler, const View *view, int face, const Polygon *polygon, uint32_t triangle)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < polygon->count; i++) {
        low = fmin(low, polygon->at[i][1]);
        high = fmax(high, polygon->at[i][1]);
    }
    const int last = cell_of(high + spread, view->size);
    for (int row = cell_of(low - spread, view->size); polygon->count && row <= last; row++) {
        const double heights[2] = {row - spread, row + 1 + spread};
        double range[2] = {INFINITY, -INFINITY};
        for (int i = 0; i < polygon->count; i++)
            add_edge(polygon->at[i], polygon->at[(i + 1) % polygon->count], heights, range);
        const int cells[2] = {cell_of(range[0] - spread, view->size), cell_of(range[1] + spread, view->size)};
        if (range[0] <= range[1])
            add_cells(filler, ((size_t)face * (size_t)view->size + (size_t)row) * (size_t)view->size, cells, triangle);
    }
}

static void add_triangles(Filler *filler, const View *view)
{
    const ExactTriangles *triangles = filler->source->triangles;
    double places[3][3];
    for (int t = 0; t < triangles->count && (filler->words || filler->sum <= filler->source->most); t++) {
        for (int i = 0; i < 3; i++)
            place_of(view, triangles->corners[t][i], places[i]);
        for (int face = 0; face < view->faces; face++) {
            Polygon polygon = {.count = 3};
            for (int i = 0; i < 3; i++)
                if (view->faces > 1)
                    turn(places[i], face, polygon.at[i]);
                else
                    memcpy(polygon.at[i], places[i], sizeof places[i]);
            to_cells(view, &polygon);
            add_polygon(filler, view, face, &polygon, (uint32_t)t);
        }
    }
}

/* -- the lists of all lights */

static size_t cells_of(const View *view) { return (size_t)view->size * (size_t)view->size * (size_t)view->faces; }

static void put_head(const View *view, uint32_t cells, uint32_t *head)
{
    const float placed = view->placed;
    memcpy(head + EXACT_LISTS_FROM, view->from, sizeof view->from);
    memcpy(head + EXACT_LISTS_PLACED, &placed, sizeof placed);
    memcpy(head + EXACT_LISTS_ROWS, view->rows, sizeof view->rows);
    head[EXACT_LISTS_VIEWS] = (uint32_t)view->faces;
    head[EXACT_LISTS_SIZE] = (uint32_t)view->size;
    head[EXACT_LISTS_CELLS] = cells;
}

/* Room for so many words more. */
static bool grow(ExactLists *made, size_t more)
{
    uint32_t *words = realloc(made->words, (made->count + more) * sizeof *words);
    made->words = words ? words : made->words;
    made->count += words ? more : 0;
    return words;
}

/* Counts become the words where lists begin. */
static void put_begins(ExactLists *made, size_t *counts, size_t cells, size_t first)
{
    size_t next = first + cells + 1;
    for (size_t i = 0; i <= cells; i++) {
        const size_t count = i < cells ? counts[i] : 0;
        made->longest = made->longest > count ? made->longest : count;
        made->words[first + i] = (uint32_t)next;
        counts[i] = next;
        next += count;
    }
}

typedef enum { DONE, TOO_MUCH, NO_MEMORY } Outcome;

static Outcome add_light(const ExactListsSource *source, const View *view, int head, ExactLists *made)
{
    const size_t cells = cells_of(view), before = made->count;
    Filler filler = {source, calloc(cells + 1, sizeof *filler.counts), NULL, before + cells + 1};
    if (!filler.counts)
        return NO_MEMORY;
    add_triangles(&filler, view);
    Outcome outcome = filler.sum > source->most ? TOO_MUCH : grow(made, filler.sum - before) ? DONE : NO_MEMORY;
    if (outcome == DONE) {
        put_begins(made, filler.counts, cells, before);
        filler.words = made->words;
        add_triangles(&filler, view);
        put_head(view, (uint32_t)before, made->words + (size_t)head * EXACT_LISTS_HEAD);
    } else if (outcome == TOO_MUCH) {
        made->count = filler.sum;
    }
    free(filler.counts);
    return outcome;
}

static Outcome add_lights(const ExactListsSource *source, ExactLists *made)
{
    Outcome outcome = made->light_count && !grow(made, (size_t)made->light_count * EXACT_LISTS_HEAD) ? NO_MEMORY : DONE;
    made->longest = 0;
    for (int i = 0; outcome == DONE && i < source->scene->light_count; i++) {
        if (made->heads[i] < 0)
            continue;
        View view = view_of(source, &source->scene->lights[i]);
        view.size = size_for(source, &view, made->coarsened);
        outcome = add_light(source, &view, made->heads[i], made);
    }
    return outcome;
}

static bool number_lights(const Scene *scene, ExactLists *made)
{
    made->heads = malloc((size_t)scene->light_count * sizeof *made->heads + 1);
    for (int i = 0; made->heads && i < scene->light_count; i++)
        made->heads[i] = exact_lists_wanted(&scene->lights[i]) ? made->light_count++ : -1;
    return made->heads;
}

bool exact_lists_make(const ExactListsSource *source, ExactLists *made)
{
    Outcome outcome = TOO_MUCH;
    *made = (ExactLists){.coarsened = -1};
    bool done = number_lights(source->scene, made);
    while (done && outcome == TOO_MUCH && made->coarsened < COARSER_MOST) {
        made->count = 0;
        made->coarsened++;
        outcome = add_lights(source, made);
    }
    const size_t needed = outcome == TOO_MUCH ? made->count : 0;
    done = done && outcome == DONE;
    if (!done) {
        exact_lists_free(made);
        made->count = needed;
    }
    return done;
}

void exact_lists_free(ExactLists *lists)
{
    free(lists->words);
    free(lists->heads);
    *lists = (ExactLists){.count = 0};
}

bool exact_lists_wanted(const SceneLight *light) { return light->shadows == WORD_Shadows_exact; }
