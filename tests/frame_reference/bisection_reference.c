/* Bisects a mesh as bisect.glsl specifies, without its GPU techniques: scene_bisection.c splits
 * triangles, matc_move displaces points, numbers are doubles. */
#include "tests/frame_reference/bisection_reference.h"
#include "tests/frame_reference/bisection_seen.h"
#include "runtime/tessellate/scene_bisection.h"
#include "runtime/scene/scene_matrix.h"
#include "tests/test.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const Scene *scene;
    const ScenePatches *patches;
    const MatcOptions *options;
    Shape shape;
    SceneMatrix inverse;
    SceneBisection b;
    /* deviation of each triangle, or the smaller one of a triangle that contained it */
    double *own;
    double (*ranges)[2]
                    /* max displacement of points along the world axes, in steps of 1/127.5 of
                     * the global maximum; by base, and by triangle number */
                    [3];
    int *first; /* for each base: the corner that is corner a */
    int even, coarse, ranged;
    bool closed;
} Reference;

/* Computes displaced points of a base, in the world. */
static void move(const Reference *r, int base, int count, double (*weights)[3], double (*to)[3])
{
    const SceneMaterial *of = &r->scene->materials[r->patches->material];
    const double *m = r->patches->world_from_local.m;
    MatcPoint points[64];
    assert_true(count <= 64);
    for (int i = 0; i < count; i++) {
        double v[14] = {0}, length = 0;
        for (int k = 0; k < 3; k++) {
            const ShapeVertex *corner = &r->shape.vertices[r->shape.indices[3 * base + k]];
            const float *components = (const float *)corner;
            for (int component = 0; component < 14; component++)
                v[component] += weights[i][k] * (double)components[component];
        }
        for (int k = 0; k < 3; k++)
            length += v[3 + k] * v[3 + k];
        points[i] = (MatcPoint){.uv = {v[6], v[7]}};
        for (int k = 0; k < 3; k++) {
            points[i].local[k] = v[k];
            points[i].local_u[k] = v[8 + k];
            points[i].local_v[k] = v[11 + k];
            points[i].position[k] = m[12 + k];
            for (int component = 0; component < 3; component++) {
                points[i].position[k] += m[4 * component + k] * v[component];
                points[i].tangent_u[k] += m[4 * component + k] * v[8 + component];
                points[i].tangent_v[k] += m[4 * component + k] * v[11 + component];
                points[i].normal[k] +=
                    r->inverse.m[4 * k + component] * v[3 + component] / sqrt(length);
            }
        }
    }
    assert_true(matc_move(of->document, of->index, r->options, points, count));
    for (int i = 0; i < count; i++)
        memcpy(to[i], points[i].position, sizeof to[i]);
}

typedef struct {
    int base;
    double w[3][3], p[3][3]; /* corners as weights of the base, and their displaced positions */
} Triangle;

/* Mean squared distance of a part from the plane, by the part's corners within the triangle. */
static double part_deviates(const Reference *r, const Triangle *t, double (*inside)[3])
{
    const double(*p)[3] = t->p;
    static const double points[4][3] = {{2, 1, 3}, {4, 1, 1}, {1, 2, 3}, {1, 4, 1}};
    double at[4][3] = {{0}}, mixed[4][3] = {{0}}, to[4][3], sum = 0;
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            for (int corner = 0; corner < 3; corner++) {
                const double share = points[i][k] / 6 * inside[k][corner];
                for (int component = 0; component < 3; component++) {
                    at[i][component] += share * t->w[corner][component];
                    mixed[i][component] += share * p[corner][component];
                }
            }
    move(r, t->base, 4, at, to);
    double edge[2][3], normal[3], square = 0;
    for (int i = 0; i < 6; i++)
        edge[i / 3][i % 3] = p[1 + i / 3][i % 3] - p[0][i % 3];
    for (int i = 0; i < 3; i++) {
        normal[i] = edge[0][(i + 1) % 3] * edge[1][(i + 2) % 3] -
                    edge[0][(i + 2) % 3] * edge[1][(i + 1) % 3];
        square += normal[i] * normal[i];
    }
    for (int i = 0; i < 4; i++) {
        double away = 0;
        for (int k = 0; k < 3; k++)
            away += (to[i][k] - mixed[i][k]) * normal[k];
        sum += away * away / square;
    }
    return sum / 4;
}

static double worst_part(const Reference *r, const Triangle *t, double (*inside)[3], int deeper)
{
    double one[3][3], two[3][3];
    if (!deeper)
        return part_deviates(r, t, inside);
    for (int i = 0; i < 3; i++) {
        one[0][i] = two[1][i] = inside[2][i];
        one[1][i] = inside[0][i];
        two[0][i] = inside[1][i];
        one[2][i] = two[2][i] = (inside[0][i] + inside[1][i]) / 2;
    }
    return fmax(worst_part(r, t, one, deeper - 1), worst_part(r, t, two, deeper - 1));
}

static double deviation(const Reference *r, uint32_t triangle)
{
    const SceneBisectionTriangle *t = &r->b.triangles[triangle];
    Triangle of = {.base = t->base};
    double inside[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (t->depth < r->coarse)
        return INFINITY;
    for (int i = 0; i < 9; i++)
        of.w[i / 3][i % 3] = (double)t->weights[i / 3][i % 3] / SCENE_BISECTION_PARTS;
    move(r, of.base, 3, of.w, of.p);
    const double square = worst_part(r, &of, inside, t->depth < r->even ? r->even - t->depth : 0);
    return square > 0 ? exp2(rint(8 * log2(sqrt(square))) / 8) : 0;
}

static void divided(void *user, uint32_t triangle, uint32_t made)
{
    Reference *r = user;
    const double was = r->own[triangle];
    r->own[triangle] = fmin(was, deviation(r, triangle));
    r->own[made] = fmin(was, deviation(r, made));
}

static double reach_of(const Reference *r, int component)
{
    double reach = 0;
    for (int axis = 0; axis < 3; axis++)
        reach +=
            fabs(r->patches->world_from_local.m[4 * axis + component]) * r->patches->reach[axis];
    return reach;
}

/* Finds the displacement range of a triangle number, with corners `w`, and of all triangles
 * within. */
static void find_range(Reference *r, int base, uint32_t number, double (*w)[3])
{
    double(*range)[3] = r->ranges[((uint32_t)base << (r->ranged + 1)) + number];
    if (number >> r->ranged) {
        enum { STEPS = 8 };
        double at[64][3] = {{0}}, to[64][3];
        int count = 0;
        for (int i = 0; i <= STEPS; i++)
            for (int k = 0; k <= STEPS - i; k++, count++)
                for (int component = 0; component < 3; component++)
                    at[count][component] = (w[0][component] * i + w[1][component] * k +
                                            w[2][component] * (STEPS - i - k)) /
                                           STEPS;
        move(r, base, count, at, to);
        for (int component = 0; component < 3; component++) {
            range[0][component] = INFINITY;
            range[1][component] = -INFINITY;
            for (int i = 0; i < count; i++) {
                double from = r->patches->world_from_local.m[12 + component];
                for (int k = 0; k < 9; k++)
                    from += at[i][k / 3] * r->patches->world_from_local.m[4 * (k % 3) + component] *
                            (double)r->shape.vertices[r->shape.indices[3 * base + k / 3]]
                                .position[k % 3];
                const double step =
                    (to[i][component] - from) / fmax(reach_of(r, component), 1e-30) * 127.5;
                range[0][component] =
                    fmin(range[0][component], fmax(floor(step + 127.5) - 127.5, -127.5));
                range[1][component] =
                    fmax(range[1][component], fmin(ceil(step + 127.5) - 127.5, 127.5));
            }
        }
        return;
    }
    double halves[2][3][3];
    for (int i = 0; i < 3; i++) {
        halves[0][0][i] = halves[1][1][i] = w[2][i];
        halves[0][1][i] = w[0][i];
        halves[1][0][i] = w[1][i];
        halves[0][2][i] = halves[1][2][i] = (w[0][i] + w[1][i]) / 2;
    }
    for (uint32_t k = 0; k < 2; k++)
        find_range(r, base, 2 * number + k, halves[k]);
    for (int component = 0; component < 3; component++) {
        double(*one)[2][3] = &r->ranges[((uint32_t)base << (r->ranged + 1)) + 2 * number];
        range[0][component] = fmin(one[0][0][component], one[1][0][component]);
        range[1][component] = fmax(one[0][1][component], one[1][1][component]);
    }
}

/* A triangle's number: the path of halves that leads to it. Computed from its centroid in
 * weights, so that the order of its corners does not matter. */
static uint64_t leaf_of(const SceneBisectionTriangle *t, int first)
{
    int64_t w[3];
    uint64_t number = 1;
    for (int i = 0; i < 3; i++)
        w[i] = (int64_t)t->weights[0][(first + i) % 3] + t->weights[1][(first + i) % 3] +
               t->weights[2][(first + i) % 3];
    for (int depth = 0; depth < t->depth; depth++) {
        const int64_t x = w[0], y = w[1], z = w[2];
        const bool second = y > x;
        number = 2 * number + second;
        w[0] = second ? y - x : z;
        w[1] = second ? z : x - y;
        w[2] = second ? 2 * x : 2 * y;
    }
    return (uint64_t)t->base << 32 | number;
}

/* Pixels per unit of length, for the nearest point that the triangle's box, or its shadow,
 * requires; one eighth if invisible. */
static double pixels_of(const Reference *r, uint32_t triangle)
{
    const SceneBisectionTriangle *t = &r->b.triangles[triangle];
    const double *m = r->patches->world_from_local.m;
    const uint32_t number = (uint32_t)leaf_of(t, r->first[t->base]);
    double(*range)[3] = r->ranges[((uint32_t)t->base << (r->ranged + 1)) +
                                  (number >> (t->depth > r->ranged ? t->depth - r->ranged : 0))];
    double at[3][3], normal[3][3];
    BisectionBox box = {.normal = (const double(*)[3])normal, .closed = r->closed};
    double *low = box.low, *high = box.high;
    for (int corner = 0; corner < 3; corner++)
        for (int i = 0; i < 3; i++) {
            at[corner][i] = m[12 + i];
            normal[corner][i] = 0;
            for (int k = 0; k < 3; k++) {
                const ShapeVertex *v = &r->shape.vertices[r->shape.indices[3 * t->base + k]];
                const double share = (double)t->weights[corner][k] / SCENE_BISECTION_PARTS;
                for (int component = 0; component < 3; component++) {
                    at[corner][i] += share * m[4 * component + i] * (double)v->position[component];
                    normal[corner][i] +=
                        share * r->inverse.m[4 * i + component] * (double)v->normal[component];
                }
            }
        }
    for (int i = 0; i < 3; i++) {
        const double step = reach_of(r, i) / 127.5;
        low[i] = fmin(fmin(at[0][i], at[1][i]), at[2][i]) + step * range[0][i];
        high[i] = fmax(fmax(at[0][i], at[1][i]), at[2][i]) + step * range[1][i];
    }
    for (int k = 0; k < 3; k++) {
        double of[3] = {0};
        for (int i = 0; i < 9; i++)
            of[i / 3] += r->inverse.m[4 * (i / 3) + i % 3] *
                         (double)r->shape.vertices[r->shape.indices[3 * t->base + k]].normal[i % 3];
        box.longest = fmax(box.longest, sqrt(vec3_dot(of, of)));
    }
    return r->scene->width / 2. / r->scene->camera.half / bisection_seen_far(r->scene, &box);
}

static int log_of(int count)
{
    int bits = 0;
    while (1 << bits < count)
        bits++;
    return bits;
}

static void refine(Reference *r, double pixels)
{
    bool changed = true;
    while (changed) {
        const size_t count = r->b.count;
        changed = false;
        for (uint32_t i = 0; i < count; i++)
            if (r->b.triangles[i].depth < r->coarse || r->own[i] * pixels_of(r, i) > pixels) {
                assert_true(scene_bisection_split(&r->b, i));
                changed = true;
            }
    }
}

uint64_t *bisection_reference(const BisectionReference *of, int *count)
{
    const ScenePatches *patches = of->scene->meshes[of->scene->objects[0].mesh].patches;
    const int bases = patches->count, even = log_of(patches->triangles / 8) - log_of(bases);
    Reference r = {.scene = of->scene,
                   .patches = patches,
                   .options = of->options,
                   .shape = {.vertices = patches->rows,
                             .vertex_count = patches->row_count,
                             .index_count = 3 * bases},
                   .own = malloc(16 * (size_t)patches->triangles * sizeof *r.own),
                   .even = even < 0 ? 0 : even,
                   .coarse = even > 6 ? even - 6 : 0,
                   .closed = of->closed};
    r.shape.indices = malloc((size_t)r.shape.index_count * sizeof *r.shape.indices);
    for (int i = 0; i < 3 * bases; i++)
        r.shape.indices[i] = patches->at[i / 3].own[i % 3];
    assert_true(scene_matrix_invert(&patches->world_from_local, &r.inverse) &&
                scene_bisection_begin(&r.shape, &r.b));
    r.b.divided = divided;
    r.b.user = &r;
    int *first = r.first = malloc((size_t)bases * sizeof *first);
    r.ranged = r.even > 4 ? r.even - 4 : 0;
    r.ranges = malloc(((size_t)bases << (r.ranged + 1)) * sizeof *r.ranges);
    for (int i = 0; i < bases; i++) {
        double w[3][3];
        for (int k = 0; k < 9; k++)
            w[k / 3][k % 3] =
                (double)r.b.triangles[i].weights[k / 3][k % 3] / SCENE_BISECTION_PARTS;
        find_range(&r, i, 1, w);
        first[i] = r.b.triangles[i].weights[0][1] ? 1 : r.b.triangles[i].weights[0][2] ? 2 : 0;
        r.own[i] = deviation(&r, (uint32_t)i);
    }
    refine(&r, patches->pixels);
    *count = (int)r.b.count;
    uint64_t *leaves = malloc(r.b.count * sizeof *leaves);
    for (size_t i = 0; i < r.b.count; i++)
        leaves[i] = leaf_of(&r.b.triangles[i], first[r.b.triangles[i].base]);
    scene_bisection_end(&r.b);
    free(first);
    free(r.ranges);
    free(r.shape.indices);
    free(r.own);
    return leaves;
}
