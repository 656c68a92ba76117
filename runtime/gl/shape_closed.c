/* Tests whether a mesh is watertight. An edge is a hash of its end positions, 64 random bits.
 * Edges that occur an even number of times cancel in an exclusive or; edges that occur equally
 * often in both directions cancel in a signed sum. So the test needs no table of edges.
 *
 *     A tetrahedron's six edges: each has two triangles, both sums are 0. Without one triangle,
 *         its three edges remain; with one flipped, the exclusive or is 0, and the signed sum is
 *         twice its three edges. */
#include "runtime/gl/shape.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Finalizer of SplitMix64: each bit of the result depends on each bit of the argument. */
static uint64_t mix(uint64_t x)
{
    x = (x ^ x >> 30) * 0xBF58476D1CE4E5B9u;
    x = (x ^ x >> 27) * 0x94D049BB133111EBu;
    return x ^ x >> 31;
}

static uint64_t place_number(const float position[3])
{
    uint64_t number = 0x9E3779B97F4A7C15u;
    for (int i = 0; i < 3; i++) {
        const float component = position[i] == 0 ? 0 : position[i]; /* -0 equals 0 */
        uint32_t bits;
        memcpy(&bits, &component, sizeof bits);
        number = mix(number + bits);
    }
    return number;
}

/* Position hashes of all vertices, and connected parts as a union-find forest: a vertex's owner
 * is one of lower number, or, for the first of a part, the vertex itself. */
typedef struct {
    uint64_t *places;
    int *owners;
    double (*sums)[4]; /* per part: sum of its positions, and their number */
} Parts;

/* Classifies a mesh by its edges; edges of zero length are ignored. */
static ShapeBody look_at_edges(const Shape *shape, const uint64_t *places)
{
    uint64_t odd = 0, turned = 0;
    for (int i = 0; i < shape->index_count; i++) {
        const int next = i % 3 == 2 ? i - 2 : i + 1;
        const uint64_t from = places[shape->indices[i]], to = places[shape->indices[next]];
        const uint64_t edge = from == to ? 0 : mix(from + to);
        odd ^= edge;
        turned += from < to ? edge : -edge;
    }
    return odd ? SHAPE_BODY_none : turned ? SHAPE_BODY_closed : SHAPE_BODY_solid;
}

/* Finds the root of a vertex's part, with path compression. */
static int part_of(int *owners, int vertex)
{
    while (owners[vertex] != vertex) {
        owners[vertex] = owners[owners[vertex]];
        vertex = owners[vertex];
    }
    return vertex;
}

static void join(int *owners, int a, int b)
{
    const int x = part_of(owners, a), y = part_of(owners, b);
    owners[x > y ? x : y] = x > y ? y : x;
}

/* Merges vertices at equal positions: each gets the first one as owner, found in a hash table
 * whose slot is given by the lowest bits of the position's hash. */
static bool join_places(const Shape *shape, Parts *parts)
{
    size_t mask = 1;
    while (mask < 2 * (size_t)shape->vertex_count)
        mask = 2 * mask + 1;
    int *firsts = calloc(mask + 1, sizeof *firsts); /* hash table of index + 1; 0: free */
    for (int i = 0; firsts && i < shape->vertex_count; i++) {
        size_t slot = parts->places[i] & mask;
        while (firsts[slot] && parts->places[firsts[slot] - 1] != parts->places[i])
            slot = (slot + 1) & mask;
        firsts[slot] = firsts[slot] ? firsts[slot] : i + 1;
        parts->owners[i] = firsts[slot] - 1;
    }
    const bool done = firsts != NULL;
    free(firsts);
    return done;
}

/* Six times the volume of the tetrahedron that three edges span from one point. */
static double volume_of(double v[3][3])
{
    return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
           v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
           v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
}

/* Reports whether all triangles of each part face away from the mean of its positions. Then no
 * ray from outside hits a back face first: on the half line from the mean through a point, the
 * number of triangles farther than the point equals the part's winding number there, which is
 * never negative. */
static bool all_face_outwards(const Shape *shape, Parts *parts)
{
    /* tolerance for degenerate triangles, relative to the product of the edges' lengths */
    const double rounding = 1e-6;
    if (!join_places(shape, parts))
        return false;
    for (int i = 0; i < shape->index_count; i++)
        join(parts->owners, (int)shape->indices[i], (int)shape->indices[i - i % 3]);
    for (int i = 0; i < shape->vertex_count; i++) {
        double *sum = parts->sums[part_of(parts->owners, i)];
        for (int k = 0; k < 3; k++)
            sum[k] += shape->vertices[i].position[k];
        sum[3]++;
    }
    bool outwards = true;
    for (int i = 0; outwards && i < shape->index_count; i += 3) {
        const double *sum = parts->sums[part_of(parts->owners, (int)shape->indices[i])];
        double v[3][3], extent = 1;
        for (int c = 0; c < 3; c++) {
            double square = 0;
            for (int k = 0; k < 3; k++) {
                v[c][k] = shape->vertices[shape->indices[i + c]].position[k] - sum[k] / sum[3];
                square += v[c][k] * v[c][k];
            }
            extent *= sqrt(square);
        }
        outwards = volume_of(v) >= -rounding * extent;
    }
    return outwards;
}

ShapeBody shape_body(const Shape *shape)
{
    const size_t count = (size_t)shape->vertex_count + 1;
    Parts parts = {malloc(count * sizeof *parts.places), malloc(count * sizeof *parts.owners),
                   calloc(count, sizeof *parts.sums)};
    ShapeBody body = SHAPE_BODY_none;
    if (parts.places && parts.owners && parts.sums) {
        for (int i = 0; i < shape->vertex_count; i++)
            parts.places[i] = place_number(shape->vertices[i].position);
        body = look_at_edges(shape, parts.places);
        if (body == SHAPE_BODY_solid && !all_face_outwards(shape, &parts))
            body = SHAPE_BODY_closed;
    }
    free(parts.places);
    free(parts.owners);
    free(parts.sums);
    return body;
}
