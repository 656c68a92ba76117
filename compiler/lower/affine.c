/* Keeps coordinates exact far from the origin. Chains of affine operations with constants are
 * traced back, in double, to the value they start from. GLSL then computes M root + offset as an
 * integer and a fraction, each good to the last bit.
 *
 *     add(mul(sub(x, 0.5), 1000), 7.3)    the lines are x - 0.5, then 1000 x - 500, then 1000 x
 *     - 492.7
 *     GLSL gets 1000 = 1000 + 0 + 0 and 492.7 = 492.625 + 2457 / 2^15 + 1.8e-5: two parts of 12
 *     bits, and the remainder. So no product rounds, where 1000 (x - 0.5) + 7.3 in floats loses
 *     3e-5 of the fraction that a noise reads */
#include "compiler/lower/footprint.h"
#include <float.h>
#include <math.h>

enum { LANES = AFFINE_LANES };
/* Bound of a factor or an offset: twice its value is still a float. */
static const double GREATEST = FLT_MAX / 4;

static Line constant(double value) { return (Line){.offset = value}; }

/* Returns the identity form: a node that is not affine is a root. Only the first three
 * components of a vec4 can be roots. */
static Line start(Ref ref, int lane)
{
    Line line = {.root = ref, .closed = lane >= LANES};
    if (!line.closed)
        line.factor[lane] = 1;
    return line;
}

/* Computes a + sign b; false if they have different roots. */
static bool combined(const Line *a, const Line *b, double sign, Line *sum)
{
    if (a->closed || b->closed || (a->root && b->root && a->root != b->root))
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

/* Returns the affine form of one component; a scalar is repeated over the components of a
 * vector. */
static Line line_of(const Lower *l, Ref ref, int lane)
{
    if (ir_lanes(l->ir, ref) == 1)
        lane = 0;
    if (ir_is(l->ir, ref, OP_const))
        return constant(ir_numbers(l->ir, ref)[lane]);
    return l->affine.first[ref] ? l->affine.lines[l->affine.first[ref] - 1 + (size_t)lane]
                                : start(ref, lane);
}

static Line sum_line(const Lower *l, Ref ref, int lane)
{
    Line a = line_of(l, ir_arg(l->ir, ref, 0), lane), b = line_of(l, ir_arg(l->ir, ref, 1), lane),
         sum;
    return combined(&a, &b, ir_is(l->ir, ref, OP_sub) ? -1 : 1, &sum) ? sum : start(ref, lane);
}

static Line product_line(const Lower *l, Ref ref, int lane)
{
    Line a = line_of(l, ir_arg(l->ir, ref, 0), lane), b = line_of(l, ir_arg(l->ir, ref, 1), lane);
    if (!a.root)
        return scaled(b, a.offset);
    return b.root ? start(ref, lane) : scaled(a, b.offset);
}

/* Returns the product of a matrix, given by constant columns, and a vector. */
static Line linear_line(const Lower *l, Ref ref, int lane)
{
    Line total = constant(0);
    for (int k = 1; k < ir_at(l->ir, ref)->count; k++) {
        Line factor = line_of(l, ir_arg(l->ir, ref, k), lane),
             x = line_of(l, ir_arg(l->ir, ref, 0), k - 1), sum;
        if (factor.root)
            return start(ref, lane);
        Line part = scaled(x, factor.offset);
        if (!combined(&total, &part, 1, &sum))
            return start(ref, lane);
        total = sum;
    }
    return total;
}

static Line vec_line(const Lower *l, Ref ref, int lane)
{
    int own = lane;
    for (int i = 0; i < ir_at(l->ir, ref)->count; i++) {
        Ref part = ir_arg(l->ir, ref, i);
        if (lane < ir_lanes(l->ir, part))
            return line_of(l, part, lane);
        lane -= ir_lanes(l->ir, part);
    }
    return start(ref, own);
}

static Line negated_line(const Lower *l, Ref ref, int lane)
{
    return scaled(line_of(l, ir_arg(l->ir, ref, 0), lane), -1);
}

static Line swizzle_line(const Lower *l, Ref ref, int lane)
{
    return line_of(l, ir_arg(l->ir, ref, 0), (int)(ir_at(l->ir, ref)->payload >> 2 * lane & 3));
}

/* Returns the affine form of a new node from those of its operands: the AFFINE lines of ops.def. */
static Line new_line(const Lower *l, Ref ref, int lane)
{
    switch (ir_at(l->ir, ref)->op) {
#define AFFINE(name, function)                                                                     \
    case OP_##name:                                                                                \
        return function(l, ref, lane);
#include "grammar/ops.def"
    default:
        return start(ref, lane);
    }
}

static bool is_affine(const IrNode *node)
{
    switch (node->op) {
#define AFFINE(name, function) case OP_##name:
#include "grammar/ops.def"
        return node->type >= TYPE_float && node->type <= TYPE_vec4;
    default:
        return false;
    }
}

/* Products that overflow a float are not followed. */
static bool is_finite(const Line *line)
{
    double greatest = fabs(line->offset);
    for (int i = 0; i < LANES; i++)
        greatest = fmax(greatest, fabs(line->factor[i]));
    return greatest <= GREATEST && !isnan(line->offset);
}

/* Finds the affine forms of all nodes up to `last` that have none yet. Operands have lower
 * numbers, so their forms are known. */
static void follow(Lower *l, Ref last)
{
    Affine *affine = &l->affine;
    affine->first = arena_reach(l->session->arena, affine->first, last, &affine->first_room,
                                sizeof *affine->first);
    for (; affine->done <= last; affine->done++) {
        Ref ref = affine->done;
        if (!is_affine(ir_at(l->ir, ref)))
            continue;
        uint32_t first = (uint32_t)affine->count + 1;
        for (int lane = 0; lane < ir_lanes(l->ir, ref); lane++) {
            Line line = new_line(l, ref, lane);
            if ((line.closed && line.root != ref) || !is_finite(&line))
                line = start(ref, lane);
            ARENA_PUSH(l->session->arena, affine->lines, affine->count, affine->room, line);
        }
        affine->first[ref] = first;
    }
}

/* Returns true if evaluating the form rounds nothing: one component times a power of two,
 * without an offset. */
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

/* Truncates a number to the upper 12 bits of its mantissa. */
static double upper_bits(double x)
{
    enum { BITS = 12 };
    int exponent;
    double mantissa = frexp(x, &exponent);
    return ldexp(trunc(ldexp(mantissa, BITS)), exponent - BITS);
}

/* A coordinate as affine forms of one root, one per component, to be multiplied by `scale`. */
typedef struct {
    Line line[LANES];
    int lanes;
    double scale;
} Lines;

/* Splits a column, or the offset, into three vectors that add up to it: two of 12 bits, and the
 * remainder. */
static void put_column(Lower *l, const Lines *lines, int column, Ref parts[3])
{
    double value[3][4] = {{0}};
    for (int i = 0; i < lines->lanes; i++) {
        const Line *line = &lines->line[i];
        double exact = lines->scale * (column < LANES ? line->factor[column] : line->offset);
        value[0][i] = upper_bits(exact);
        value[1][i] = upper_bits(exact - value[0][i]);
        value[2][i] = exact - value[0][i] - value[1][i];
    }
    for (int part = 0; part < 3; part++)
        parts[part] = ir_const(l->ir, TYPE_vec3, value[part]);
}

static Ref as_vec3(Lower *l, Ref value)
{
    Ir *ir = l->ir;
    static const double none[4];
    int lanes = ir_lanes(ir, value);
    if (lanes == 4)
        return build_swizzle(ir, value, "xyz");
    if (lanes == 3)
        return value;
    Ref rest = ir_const(ir, lanes == 2 ? TYPE_float : TYPE_vec2, none);
    return build_vec(ir, TYPE_vec3, value, rest);
}

/* Finds affine forms of the components with one common root. Returns false if nothing is gained. */
static bool lines_of(Lower *l, Ref coordinate, Line lines[LANES], Ref *root)
{
    int lanes = ir_lanes(l->ir, coordinate);
    bool exact = true;
    *root = 0;
    if (l->job->choice[AXIS_coordinates] != CHOICE_coordinates_long || lanes > LANES)
        return false;
    follow(l, coordinate);
    for (int i = 0; i < lanes; i++) {
        lines[i] = line_of(l, coordinate, i);
        exact &= is_exact(&lines[i]);
        if (lines[i].root == coordinate || (*root && lines[i].root && lines[i].root != *root))
            return false;
        *root = lines[i].root ? lines[i].root : *root;
    }
    return !exact && *root;
}

bool affine_coordinate(Lower *l, Ref coordinate, double scale, LongCoordinate *parts)
{
    Ir *ir = l->ir;
    static const char *const lanes_of[] = {"", "x", "xy"};
    Ref root, args[1 + 3 * (LANES + 1)];
    const int lanes = ir_lanes(ir, coordinate);
    Lines lines = {.lanes = lanes, .scale = scale};
    if (!lines_of(l, coordinate, lines.line, &root))
        return false;
    args[0] = as_vec3(l, root);
    for (int column = 0; column <= LANES; column++)
        put_column(l, &lines, column, &args[1 + 3 * column]);
    parts->whole = build_call_of(ir, FN_affineWhole, args, 1 + 3 * (LANES + 1));
    parts->fraction = build_call_of(ir, FN_affineFraction, args, 1 + 3 * (LANES + 1));
    if (lanes < LANES) {
        parts->whole = build_swizzle(ir, parts->whole, lanes_of[lanes]);
        parts->fraction = build_swizzle(ir, parts->fraction, lanes_of[lanes]);
    }
    for (int d = 0; d < DIRECTION_COUNT; d++) { /* the whole part changes as the coordinate does */
        Ref slope = slope_of(l, coordinate, (Direction)d);
        slope_set(l, parts->whole, (Direction)d,
                  slope && scale != 1 ? build_scale(ir, slope, scale) : slope);
        slope_set(l, parts->fraction, (Direction)d, 0);
    }
    return true;
}
