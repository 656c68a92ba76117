/* What rounding takes from a coordinate: affine chains of constants are followed back, in double, to the value they start from,
 * and GLSL computes M root + offset - p as exactly as the parts allow. */
#include "footprint.h"
#include <math.h>
#include <string.h>

enum { LANES = 3, DEEPEST = 64 };

/* One lane as offset + sum of factor[i] * lane i of the root. */
typedef struct {
    Ref root; /* 0: a constant */
    double factor[LANES], offset;
} Line;

static Line constant(double value) { return (Line){.offset = value}; }

/* A node that is nothing affine: it is what others start from. */
static Line start(Ref ref, int lane)
{
    Line line = {.root = ref};
    if (lane < LANES)
        line.factor[lane] = 1;
    return line;
}

static Line line_of(const Ir *ir, Ref ref, int lane, int depth);

static bool combined(const Line *a, const Line *b, double sign, Line *sum)
{
    if (a->root && b->root && a->root != b->root)
        return false;
    *sum = (Line){.root = a->root ? a->root : b->root, .offset = a->offset + sign * b->offset};
    for (int i = 0; i < LANES; i++)
        sum->factor[i] = a->factor[i] + sign * b->factor[i];
    return true;
}

static Line scaled(Line line, double factor)
{
    line.offset *= factor;
    for (int i = 0; i < LANES; i++)
        line.factor[i] *= factor;
    return line;
}

static int lane_in(const Ir *ir, Ref ref, int lane) { return ir_lanes(ir, ref) > 1 ? lane : 0; }

static Line sum_line(const Ir *ir, Ref ref, int lane, int depth)
{
    Ref x = ir_arg(ir, ref, 0), y = ir_arg(ir, ref, 1);
    Line a = line_of(ir, x, lane_in(ir, x, lane), depth), b = line_of(ir, y, lane_in(ir, y, lane), depth), sum;
    return combined(&a, &b, ir_is(ir, ref, OP_sub) ? -1 : 1, &sum) ? sum : start(ref, lane);
}

static Line product_line(const Ir *ir, Ref ref, int lane, int depth)
{
    Ref x = ir_arg(ir, ref, 0), y = ir_arg(ir, ref, 1);
    Line a = line_of(ir, x, lane_in(ir, x, lane), depth), b = line_of(ir, y, lane_in(ir, y, lane), depth);
    if (!a.root)
        return scaled(b, a.offset);
    return b.root ? start(ref, lane) : scaled(a, b.offset);
}

/* A matrix by its columns, all constant, times a vector. */
static Line linear_line(const Ir *ir, Ref ref, int lane, int depth)
{
    Line total = constant(0);
    for (int k = 1; k < ir_at(ir, ref)->count; k++) {
        Line factor = line_of(ir, ir_arg(ir, ref, k), lane, depth), x = line_of(ir, ir_arg(ir, ref, 0), k - 1, depth),
             sum;
        if (factor.root)
            return start(ref, lane);
        Line part = scaled(x, factor.offset);
        if (!combined(&total, &part, 1, &sum))
            return start(ref, lane);
        total = sum;
    }
    return total;
}

static Line vec_line(const Ir *ir, Ref ref, int lane, int depth)
{
    for (int i = 0; i < ir_at(ir, ref)->count; i++) {
        Ref part = ir_arg(ir, ref, i);
        if (lane < ir_lanes(ir, part))
            return line_of(ir, part, lane, depth);
        lane -= ir_lanes(ir, part);
    }
    return start(ref, lane);
}

static Line line_of(const Ir *ir, Ref ref, int lane, int depth)
{
    const IrNode *node = ir_at(ir, ref);
    if (node->op == OP_const)
        return constant(ir_numbers(ir, ref)[lane]);
    if (depth > DEEPEST)
        return start(ref, lane);
    switch (node->op) {
    case OP_add:
    case OP_sub:
        return sum_line(ir, ref, lane, depth + 1);
    case OP_mul:
        return product_line(ir, ref, lane, depth + 1);
    case OP_neg:
        return scaled(line_of(ir, ir_arg(ir, ref, 0), lane, depth + 1), -1);
    case OP_linear:
        return linear_line(ir, ref, lane, depth + 1);
    case OP_vec:
        return vec_line(ir, ref, lane, depth + 1);
    case OP_swizzle:
        return line_of(ir, ir_arg(ir, ref, 0), (int)(node->payload >> 2 * lane & 3), depth + 1);
    default:
        return start(ref, lane);
    }
}

/* Nothing rounds: a whole power of two times one lane, and no offset. */
static bool is_exact(const Line *line)
{
    int terms = 0, exponent;
    for (int i = 0; i < LANES; i++) {
        terms += line->factor[i] != 0;
        if (line->factor[i] != 0 && fabs(frexp(line->factor[i], &exponent)) != 0.5)
            return false;
    }
    return (terms == 0 || line->offset == 0) && terms <= 1;
}

/* A double as the sum of two floats, by columns: the numbers as they are written, and what they leave. */
static void put_column(Lower *l, const Line *lines, int lanes, int column, Ref *high, Ref *low)
{
    double h[4] = {0}, r[4] = {0};
    for (int i = 0; i < lanes; i++) {
        double exact = column < LANES ? lines[i].factor[column] : lines[i].offset;
        h[i] = (double)(float)exact;
        r[i] = exact - h[i];
    }
    *high = ir_const(l->ir, TYPE_vec3, h);
    *low = ir_const(l->ir, TYPE_vec3, r);
}

static Ref as_vec3(Lower *l, Ref value)
{
    static const double none[4];
    int lanes = ir_lanes(l->ir, value);
    if (lanes == 4)
        return ir_swizzle(l->ir, value, "xyz");
    return lanes == 3 ? value
                      : ir_vec(l->ir, TYPE_vec3,
                               REFS(l->ir, value, ir_const(l->ir, lanes == 2 ? TYPE_float : TYPE_vec2, none)), 2);
}

Ref rest_of(Lower *l, Ref coordinate)
{
    Line lines[LANES];
    int lanes = ir_lanes(l->ir, coordinate);
    bool exact = true;
    Ref root = 0, args[10];
    if (l->job->choice[AXIS_coordinates] != CHOICE_coordinates_long || lanes > LANES)
        return 0;
    for (int i = 0; i < lanes; i++) {
        lines[i] = line_of(l->ir, coordinate, i, 0);
        exact &= is_exact(&lines[i]);
        if (lines[i].root == coordinate || (root && lines[i].root && lines[i].root != root))
            return 0;
        root = lines[i].root ? lines[i].root : root;
    }
    if (exact || !root)
        return 0;
    args[0] = as_vec3(l, root);
    args[1] = as_vec3(l, coordinate);
    for (int column = 0; column <= LANES; column++)
        put_column(l, lines, lanes, column, &args[2 + 2 * column], &args[3 + 2 * column]);
    Ref rest = ir_call(l->ir, FN_affineRest, args, 10);
    return lanes == 3 ? rest : ir_swizzle(l->ir, rest, lanes == 2 ? "xy" : "x");
}
