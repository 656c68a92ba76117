/* Points from a fixed stream of choices. */
#include "field.h"
#include "choices.h"
#include <string.h>

/* The largest number is the documented bound of coordinates. */
static const float specials[] = {
    0,     -0.f, 1e-40f, -1e-40f, 1e-8f,     -1e-8f,       1,     -1,     1e4f,
    -1e4f, 1e6f, -1e6f,  1e8f,    -1e8f,     1.17549e-38f, 0.25f, 65536,  -65536,
    1e-4f, 1e3f, 1e5f,   -1e5f,   16777216., 99999999.f,   -0.5f, 1e-30f, 8388607.5f};

static float border(Choices *c)
{
    float at = (float)choose(c, 17) / 4 - 2;
    return (float[]){at, nextafterf(at, -INFINITY), nextafterf(at, INFINITY)}[choose(c, 3)];
}

static float coordinate(Choices *c, bool hostile)
{
    uint32_t kind = hostile ? choose(c, 4) : 0;
    if (kind == 1)
        return specials[choose(c, sizeof specials / sizeof *specials)];
    if (kind == 2)
        return border(c);
    if (kind == 3) /* any size from 1e-8 to 1e8 */
        return (float)((chance(c, 1, 2) ? -1 : 1) * pow(10, 16 * choose_part(c) - 8));
    return (float)(4 * choose_part(c) - 2);
}

static void direction(Choices *c, float v[3], float length)
{
    double z = 2 * choose_part(c) - 1, angle = 2 * M_PI * choose_part(c), r = sqrt(1 - z * z);
    v[0] = (float)(length * r * cos(angle));
    v[1] = (float)(length * r * sin(angle));
    v[2] = (float)(length * z);
}

/* A normal and two tangents, often degenerate at a hostile point. */
static void frame(Choices *c, Point *p, bool hostile)
{
    static const float lengths[] = {1, 0.25f, 7, 0, 1e-30f, 1e-8f, 1e4f, 1e-40f};
    for (Input i = INPUT_N; i <= INPUT_DV; i++)
        direction(c, p->input[i], lengths[choose(c, hostile ? 8 : 3)]);
    if (hostile && chance(c, 1, 8))
        memcpy(p->input[INPUT_DU], p->input[INPUT_N], sizeof p->input[0]);
    if (hostile && chance(c, 1, 8))
        memcpy(p->input[INPUT_DV], p->input[INPUT_DU], sizeof p->input[0]);
    memcpy(p->input[INPUT_eyeN], p->input[INPUT_N], sizeof p->input[0]);
}

/* Derivatives of the local position by u and v: rarely zero, and never so small that differences
 * of the position lose them. */
static void local_tangents(Choices *c, Point *p, bool hostile)
{
    static const float lengths[] = {1, 0.25f, 2, 0, 0.01f, 100};
    for (Input i = INPUT_XU; i <= INPUT_XV; i++)
        direction(c, p->input[i], lengths[choose(c, hostile ? 6 : 3)]);
}

static void make_point(Choices *c, Point *p)
{
    static const Input inputs[] = {INPUT_U, INPUT_X, INPUT_P};
    uint32_t temper = choose(c, 4);
    memset(p, 0, sizeof *p);
    for (int i = 0; i < 3; i++)
        for (int component = 0; component < (i ? 3 : 2); component++)
            p->input[inputs[i]][component] =
                coordinate(c, temper > 1 || (temper == 1 && component == 0));
    frame(c, p, temper > 1);
    direction(c, p->input[INPUT_ray], 1);
    if (chance(c, 1, 8))
        p->input[INPUT_ray][choose(c, 3)] = 0;
    local_tangents(c, p, temper > 1);
}

void hostile_points(Point points[FIELD_COUNT])
{
    static const uint64_t seed = 20;
    for (int i = 0; i < FIELD_COUNT; i++) {
        Choices c;
        choices_random(&c, seed, (uint64_t)i);
        make_point(&c, &points[i]);
    }
}
