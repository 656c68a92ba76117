/* Newest-vertex bisection over half-edges. A triangle (a, b, c) is divided at the midpoint m of
 * its edge a b into (c, a, m) and (b, c, m), whose first edges, c a and b c, are bisected next.
 * All triangles at an edge are divided together, as soon as the edge is the first edge of all of
 * them; others are first divided at their own first edge. So the mesh never has a T-junction.
 *
 * The process terminates: among the shape's triangles the first edge is the longest, so a
 * triangle that has to be divided first has a longer one; and a triangle made by bisection has a
 * first edge that is older than its others, so a triangle that has to be divided first has an
 * even older one.
 *
 *     a square of two triangles, whose diagonal is the longest edge of both: both are divided
 *     there, which makes four; each has a side of the square as its first edge, and is divided
 *     alone: eight, whose first edges are the halves of the diagonals, again shared by two
 *
 * A point is represented by integer barycentric weights in the shape's triangle: so both sides
 * of an edge compute the same point, and the surface is independent of the order of divisions.
 * Source: Mitchell, A comparison of adaptive refinement techniques for elliptic problems, 1989;
 * half-edges as in Benyoub and Dupuy, Concurrent binary trees for large-scale game components,
 * 2024, whose trees begin with three triangles for each of the shape's instead. */
#include "runtime/tessellate/scene_bisection.h"
#include "compiler/base/hash_index.h"
#include "runtime/tessellate/scene_divide.h"
#include "runtime/scene/scene_places.h"
#include "runtime/tessellate/scene_growing.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* -- points */

static bool add_place(SceneBisection *b, uint32_t first)
{
    if (!scene_growing(&b->places, b->place_count + 1, &b->place_capacity, sizeof *b->places))
        return false;
    SceneBisectionPlace *place = &b->places[b->place_count++];
    place->first = first;
    memcpy(place->normal, b->vertices[first].normal, sizeof place->normal);
    return true;
}

/* Adds a vertex at a place; a place number equal to the count makes a new place. The place's
 * normal sums the normals of its vertices, except those equal to the first one's. */
static bool add_vertex(SceneBisection *b, const ShapeVertex *vertex, uint32_t place)
{
    if (!scene_growing(&b->vertices, b->vertex_count + 1, &b->vertex_capacity,
                       sizeof *b->vertices) ||
        !scene_growing(&b->place_of, b->vertex_count + 1, &b->place_of_capacity,
                       sizeof *b->place_of))
        return false;
    const uint32_t number = (uint32_t)b->vertex_count++;
    b->vertices[number] = *vertex;
    b->place_of[number] = place;
    if (place == b->place_count)
        return add_place(b, number);
    for (int component = 0; component < 3; component++)
        if (memcmp(vertex->normal, b->vertices[b->places[place].first].normal,
                   sizeof vertex->normal) != 0)
            b->places[place].normal[component] += vertex->normal[component];
    return true;
}

static bool add_vertices(SceneBisection *b)
{
    int *first = scene_places(b->shape);
    bool fine = first != NULL;
    for (int i = 0; fine && i < b->shape->vertex_count; i++)
        fine = add_vertex(b, &b->shape->vertices[i],
                          first[i] == i ? (uint32_t)b->place_count : b->place_of[first[i]]);
    free(first);
    return fine;
}

static uint32_t place_at(const SceneBisection *b, uint32_t edge, uint32_t end)
{
    return b->place_of[b->triangles[edge / 3].vertex[(edge + end) % 3]];
}

/* -- edges */

static void link(SceneBisection *b, uint32_t edge, uint32_t next)
{
    b->triangles[edge / 3].across[edge % 3] = next;
    b->triangles[next / 3].behind[next % 3] = edge;
}

/* Inserts an edge into a ring, after another edge of that ring. */
static void join(SceneBisection *b, uint32_t edge, uint32_t other)
{
    const uint32_t next = b->triangles[other / 3].across[other % 3];
    link(b, edge, next);
    link(b, other, edge);
}

/* Changes the number of an edge from `from` to `to` in its ring; `was` is the triangle before
 * its division. */
static void renumber(SceneBisection *b, const SceneBisectionTriangle *was, int edge, uint32_t from,
                     uint32_t to)
{
    const bool is_alone = was->across[edge] == from;
    link(b, is_alone ? to : was->behind[edge], to);
    link(b, to, is_alone ? to : was->across[edge]);
}

static double length_of(const SceneBisection *b, const uint32_t vertex[2])
{
    const float *p = b->vertices[vertex[0]].position, *q = b->vertices[vertex[1]].position;
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += ((double)p[i] - q[i]) * ((double)p[i] - q[i]);
    return sum;
}

/* Compares lengths; orders equally long edges by the places of their ends, consistently for all
 * triangles. */
static bool is_longer(const SceneBisection *b, const uint32_t x[2], const uint32_t y[2])
{
    const double by_x = length_of(b, x), by_y = length_of(b, y);
    const uint32_t ends[2][2] = {{b->place_of[x[0]], b->place_of[x[1]]},
                                 {b->place_of[y[0]], b->place_of[y[1]]}};
    const uint32_t least[2] = {ends[0][0] < ends[0][1] ? ends[0][0] : ends[0][1],
                               ends[1][0] < ends[1][1] ? ends[1][0] : ends[1][1]};
    if (by_x != by_y)
        return by_x > by_y;
    return least[0] != least[1] ? least[0] < least[1]
                                : ends[0][0] + ends[0][1] < ends[1][0] + ends[1][1];
}

static bool add_triangle(SceneBisection *b, int base)
{
    const uint32_t *corner = &b->shape->indices[3 * (size_t)base];
    int first = 0;
    for (int i = 0; i < 3; i++)
        if (b->place_of[corner[i]] == b->place_of[corner[(i + 1) % 3]])
            return true; /* degenerate */
    for (int i = 1; i < 3; i++)
        if (is_longer(b, (uint32_t[]){corner[i], corner[(i + 1) % 3]},
                      (uint32_t[]){corner[first], corner[(first + 1) % 3]}))
            first = i;
    if (!scene_growing(&b->triangles, b->count + 1, &b->capacity, sizeof *b->triangles))
        return false;
    SceneBisectionTriangle *made = &b->triangles[b->count++];
    *made = (SceneBisectionTriangle){.base = base};
    for (int i = 0; i < 3; i++) {
        made->vertex[i] = corner[(first + i) % 3];
        made->weights[i][(first + i) % 3] = SCENE_BISECTION_PARTS;
    }
    return true;
}

static uint32_t hash_of(uint32_t a, uint32_t b)
{
    return ((a < b ? a : b) * 0x9E3779B1u ^ (a < b ? b : a) * 0x85EBCA77u) * 0xC2B2AE3Du;
}

/* Builds the rings: edges between the same two places are in one ring. */
static void find_rings(SceneBisection *b)
{
    HashIndex index = {0};
    for (uint32_t edge = 0; edge < 3 * b->count; edge++) {
        const uint32_t from = place_at(b, edge, 0), to = place_at(b, edge, 1),
                       hash = hash_of(from, to);
        HashProbe probe = hash_probe(&index, hash);
        bool known = false;
        while (!known && hash_probe_next(&probe)) {
            const uint32_t x = place_at(b, probe.number, 0), y = place_at(b, probe.number, 1);
            known = (x == from && y == to) || (x == to && y == from);
        }
        if (known)
            join(b, edge, probe.number);
        else
            link(b, edge, edge);
        if (!known)
            hash_index_add(NULL, &index, hash, edge);
    }
    hash_index_free(&index);
}

bool scene_bisection_begin(const Shape *shape, SceneBisection *made)
{
    *made = (SceneBisection){.shape = shape};
    bool fine = add_vertices(made);
    for (int i = 0; fine && i < shape->index_count / 3; i++)
        fine = add_triangle(made, i);
    if (fine)
        find_rings(made);
    else
        scene_bisection_end(made);
    return fine;
}

void scene_bisection_end(SceneBisection *b)
{
    free(b->triangles);
    free(b->vertices);
    free(b->place_of);
    free(b->places);
    free(b->ring);
    free(b->waiting);
    *b = (SceneBisection){0};
}

/* -- bisection */

enum {
    ALIKE = 4 /* earlier edges of a ring that are searched for equal ends */
};

static bool same_ends(const SceneBisectionTriangle *x, const SceneBisectionTriangle *y)
{
    return (x->vertex[0] == y->vertex[0] && x->vertex[1] == y->vertex[1]) ||
           (x->vertex[0] == y->vertex[1] && x->vertex[1] == y->vertex[0]);
}

/* Returns the vertex at the midpoint of the first edge of the ring's i-th triangle; `middle` has
 * those of earlier ones, which are reused for equal ends. UINT32_MAX: out of memory. */
static uint32_t middle_vertex(SceneBisection *b, size_t i, uint32_t place,
                              const uint32_t middle[ALIKE])
{
    const SceneBisectionTriangle *t = &b->triangles[b->ring[i] / 3];
    int weights[3];
    for (size_t k = i > ALIKE ? i - ALIKE : 0; k < i; k++)
        if (same_ends(&b->triangles[b->ring[k] / 3], t))
            return middle[k % ALIKE];
    for (int k = 0; k < 3; k++)
        weights[k] = (t->weights[0][k] + t->weights[1][k]) / 2;
    const ShapeVertex vertex =
        scene_divide_point(b->shape, t->base, weights, SCENE_BISECTION_PARTS);
    return add_vertex(b, &vertex, place) ? (uint32_t)b->vertex_count - 1 : UINT32_MAX;
}

/* Divides a triangle: (a, b, c) becomes (c, a, m), and (b, c, m) is added. The array has
 * capacity for it. */
static void divide(SceneBisection *b, uint32_t triangle, uint32_t middle)
{
    const SceneBisectionTriangle was = b->triangles[triangle];
    const uint32_t made = (uint32_t)b->count++;
    SceneBisectionTriangle *one = &b->triangles[triangle], *two = &b->triangles[made];
    *two = was;
    one->depth = two->depth = was.depth + 1;
    for (int i = 0; i < 2; i++) {
        one->vertex[i] = was.vertex[(i + 2) % 3];
        two->vertex[i] = was.vertex[i + 1];
        memcpy(one->weights[i], was.weights[(i + 2) % 3], sizeof one->weights[i]);
        memcpy(two->weights[i], was.weights[i + 1], sizeof two->weights[i]);
    }
    one->vertex[2] = two->vertex[2] = middle;
    for (int k = 0; k < 3; k++)
        one->weights[2][k] = two->weights[2][k] = (was.weights[0][k] + was.weights[1][k]) / 2;
    renumber(b, &was, 2, 3 * triangle + 2, 3 * triangle);
    renumber(b, &was, 1, 3 * triangle + 1, 3 * made);
    link(b, 3 * triangle + 2, 3 * made + 1); /* link m to c in both directions */
    link(b, 3 * made + 1, 3 * triangle + 2);
}

/* Links the halves of a divided edge: those at either end of the edge form a ring. b->ring
 * alternates between a triangle and the one added by its division. */
static void link_halves(SceneBisection *b, size_t count)
{
    uint32_t last[2] = {UINT32_MAX, UINT32_MAX}, end = UINT32_MAX;
    for (size_t i = 0; i < count; i += 2) {
        /* half-edges at a and at b */
        const uint32_t halves[2] = {3 * b->ring[i] + 1, 3 * b->ring[i + 1] + 2};
        const uint32_t at = place_at(b, halves[0], 0);
        end = i ? end : at;
        for (int k = 0; k < 2; k++) {
            uint32_t *other = &last[(at == end) ^ k];
            if (*other == UINT32_MAX)
                link(b, halves[k], halves[k]);
            else
                join(b, halves[k], *other);
            *other = halves[k];
        }
    }
}

/* Divides all triangles at an edge, which is the first edge of each of them. */
static bool divide_ring(SceneBisection *b, uint32_t edge)
{
    size_t count = 0;
    uint32_t middle[ALIKE];
    const uint32_t place = (uint32_t)b->place_count;
    uint32_t next = edge;
    do {
        if (!scene_growing(&b->ring, 2 * count + 2, &b->ring_capacity, sizeof *b->ring))
            return false;
        b->ring[count++] = next;
        next = b->triangles[next / 3].across[0];
    } while (next != edge);
    if (!scene_growing(&b->triangles, b->count + count, &b->capacity, sizeof *b->triangles))
        return false;
    uint32_t *vertices = b->ring + count; /* scratch memory after the ring's edges */
    for (size_t i = 0; i < count; i++) {
        vertices[i] = middle[i % ALIKE] = middle_vertex(b, i, place, middle);
        if (vertices[i] == UINT32_MAX)
            return false;
    }
    const size_t first = b->count;
    for (size_t i = 0; i < count; i++)
        divide(b, b->ring[i] / 3, vertices[i]);
    for (size_t i = count; i--;) { /* copies backward, so that no unread element is overwritten */
        const uint32_t triangle = b->ring[i] / 3;
        b->ring[2 * i + 1] = (uint32_t)(first + i);
        b->ring[2 * i] = triangle;
    }
    link_halves(b, 2 * count);
    for (size_t i = 0; b->divided && i < count; i++)
        b->divided(b->user, b->ring[2 * i], b->ring[2 * i + 1]);
    return true;
}

static bool wait(SceneBisection *b, size_t *count, uint32_t triangle)
{
    if (!scene_growing(&b->waiting, *count + 2, &b->waiting_capacity, sizeof *b->waiting))
        return false;
    b->waiting[(*count)++] = triangle;
    b->waiting[(*count)++] = (uint32_t)b->triangles[triangle].depth;
    return true;
}

/* Pushes the triangles at the same edge that have another first edge: they are divided first.
 * False: out of memory. */
static bool wait_for_others(SceneBisection *b, size_t *count, uint32_t triangle)
{
    for (uint32_t edge = b->triangles[triangle].across[0]; edge != 3 * triangle;
         edge = b->triangles[edge / 3].across[edge % 3])
        if (edge % 3 && !wait(b, count, edge / 3))
            return false;
    return true;
}

bool scene_bisection_split(SceneBisection *b, uint32_t triangle)
{
    size_t count = 0;
    bool fine = wait(b, &count, triangle);
    while (fine && count) {
        const uint32_t last = b->waiting[count - 2];
        const size_t before = count;
        if ((uint32_t)b->triangles[last].depth != b->waiting[count - 1])
            count -= 2; /* the triangle was divided together with another one */
        else if ((fine = wait_for_others(b, &count, last)) && count == before)
            fine = divide_ring(b, 3 * last);
    }
    return fine;
}

/* -- Triangles as a shape */

/* Triangles are ordered along a space-filling curve of their base: interleaved bits of their
 * centers' weights (Morton, 1966), so that consecutive triangles share vertices. Vertices are in
 * the order of their first use. */

typedef struct {
    int base;
    uint32_t triangle;
    uint64_t along;
} Order;

/* Spreads the bits of x to its even positions. */
static uint64_t spread(uint64_t x)
{
    static const uint64_t masks[] = {0x0000FFFF0000FFFF, 0x00FF00FF00FF00FF, 0x0F0F0F0F0F0F0F0F,
                                     0x3333333333333333, 0x5555555555555555};
    for (int i = 0; i < 5; i++)
        x = (x | x << (16 >> i)) & masks[i];
    return x;
}

static int compare(const void *a, const void *b)
{
    const Order *x = a, *y = b;
    if (x->base != y->base)
        return x->base < y->base ? -1 : 1;
    if (x->along != y->along)
        return x->along < y->along ? -1 : 1;
    return x->triangle < y->triangle ? -1 : 1;
}

static Order *find_order(const SceneBisection *b)
{
    Order *order = malloc((b->count + 1) * sizeof *order);
    for (size_t i = 0; order && i < b->count; i++) {
        const SceneBisectionTriangle *t = &b->triangles[i];
        uint64_t middle[2] = {0};
        for (int corner = 0; corner < 3; corner++)
            for (int component = 0; component < 2; component++)
                middle[component] += (uint64_t)t->weights[corner][component];
        order[i] = (Order){t->base, (uint32_t)i, spread(middle[0]) | spread(middle[1]) << 1};
    }
    if (order)
        qsort(order, b->count, sizeof *order, compare);
    return order;
}

static void put(const SceneBisection *b, const double (*to)[3], uint32_t vertex, Shape *made)
{
    ShapeVertex *next = &made->vertices[made->vertex_count];
    *next = b->vertices[vertex];
    memcpy(made->base[made->vertex_count], next->position, sizeof *made->base);
    for (int component = 0; component < 3; component++)
        next->position[component] = (float)to[b->place_of[vertex]][component];
    made->vertex_count++;
}

bool scene_bisection_shape(const SceneBisection *b, const double (*to)[3], Shape *made)
{
    Order *order = find_order(b);
    /* indexed by vertex: its new number, from 1; 0: unused */
    uint32_t *number = calloc(b->vertex_count + 1, sizeof *number);
    *made = (Shape){.vertices = calloc(b->vertex_count + 1, sizeof *made->vertices),
                    .indices = calloc(3 * b->count + 1, sizeof *made->indices),
                    .base = calloc(b->vertex_count + 1, sizeof *made->base)};
    const bool fine = order && number && made->vertices && made->indices && made->base;
    for (size_t i = 0; fine && i < b->count; i++)
        for (int corner = 0; corner < 3; corner++) {
            const uint32_t vertex = b->triangles[order[i].triangle].vertex[corner];
            if (!number[vertex]) {
                put(b, to, vertex, made);
                number[vertex] = (uint32_t)made->vertex_count;
            }
            made->indices[made->index_count++] = number[vertex] - 1;
        }
    free(order);
    free(number);
    if (!fine)
        shape_free(made);
    return fine;
}

double scene_bisection_turn(const int a[3], const int b[3], const int c[3])
{
    return (double)(b[0] - a[0]) * (c[1] - a[1]) - (double)(b[1] - a[1]) * (c[0] - a[0]);
}

static double base_area(const SceneBisection *b, int base)
{
    const uint32_t *index = &b->shape->indices[3 * (size_t)base];
    double e[2][3], sum = 0;
    for (int i = 0; i < 2; i++)
        for (int component = 0; component < 3; component++)
            e[i][component] = (double)b->shape->vertices[index[i + 1]].position[component] -
                              b->shape->vertices[index[0]].position[component];
    for (int i = 0; i < 3; i++) {
        const double x =
            e[0][(i + 1) % 3] * e[1][(i + 2) % 3] - e[0][(i + 2) % 3] * e[1][(i + 1) % 3];
        sum += x * x;
    }
    return sqrt(sum) / 2;
}

double scene_bisection_area(const SceneBisection *b, uint32_t triangle)
{
    const SceneBisectionTriangle *t = &b->triangles[triangle];
    const double parts = SCENE_BISECTION_PARTS;
    return base_area(b, t->base) *
           fabs(scene_bisection_turn(t->weights[0], t->weights[1], t->weights[2])) /
           (parts * parts);
}
