/* Triangles go along a curve that fills their base triangle: digits of the weights of their middle,
 * by turns (Morton, 1966), so that those that follow each other share vertices, which come in the
 * order of their first use. */
#include "runtime/tessellate/scene_bisection.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    int base;
    uint32_t triangle;
    uint64_t along;
} Order;

/* Bits of x to the even places. */
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
            for (int lane = 0; lane < 2; lane++)
                middle[lane] += (uint64_t)t->weights[corner][lane];
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
    for (int lane = 0; lane < 3; lane++)
        next->position[lane] = (float)to[b->place_of[vertex]][lane];
    made->vertex_count++;
}

bool scene_bisection_shape(const SceneBisection *b, const double (*to)[3], Shape *made)
{
    Order *order = find_order(b);
    uint32_t *number = calloc(b->vertex_count + 1, sizeof *number); /* from 1 */
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
        for (int lane = 0; lane < 3; lane++)
            e[i][lane] = (double)b->shape->vertices[index[i + 1]].position[lane] -
                         b->shape->vertices[index[0]].position[lane];
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
