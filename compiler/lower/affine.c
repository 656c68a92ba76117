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

enum { COMPONENTS = AFFINE_COMPONENTS };
/* Bound of a factor or an offset: twice its value is still a float. */
static const double GREATEST = FLT_MAX / 4;

static Line constant(double value) { return (Line){.offset = value}; }

/* Returns the identity form: a node that is not affine is a root. Only the first three
 * components of a vec4 can be roots. */
static Line start(Ref ref, int component)
{
    Line line = {.root = ref, .closed = component >= COMPONENTS};
    if (!line.closed)
        line.factor[component] = 1;
    return line;
}

/* Computes a + sign b; false if they have different roots. */
static bool combined(const Line *a, const Line *b, double sign, Line *sum)
{
    if (a->closed || b->closed || (a->root && b->root && a->root != b->root))
        return false;
    *sum = (Line){.root = a->root ? a->root : b->root, .offset = a->offset + sign * b->offset};
    for (int i = 0; i < COMPONENTS; i++)
        sum->factor[i] = a->factor[i] + sign * b->factor[i];
    return true;
}

static Line scaled(Line line, double factor)
{
    line.offset *= factor;
    for (int i = 0; i < COMPONENTS; i++)
        line.factor[i] *= factor;
    return line;
}

/* Returns the affine form of one component; a scalar is repeated over the components of a
 * vector. */
static Line line_of(const Lower *l, Ref ref, int component)
{
    if (ir_components(l->ir, ref) == 1)
        component = 0;
    if (ir_is(l->ir, ref, OP_const))
        return constant(ir_numbers(l->ir, ref)[component]);
    return l->affine.first[ref] ? l->affine.lines[l->affine.first[ref] - 1 + (size_t)component]
                                : start(ref, component);
}

static Line sum_line(const Lower *l, Ref ref, int component)
{
    Line a = line_of(l, ir_arg(l->ir, ref, 0), component),
         b = line_of(l, ir_arg(l->ir, ref, 1), component), sum;
    return combined(&a, &b, ir_is(l->ir, ref, OP_sub) ? -1 : 1, &sum) ? sum : start(ref, component);
}

static Line product_line(const Lower *l, Ref ref, int component)
{
    Line a = line_of(l, ir_arg(l->ir, ref, 0), component),
         b = line_of(l, ir_arg(l->ir, ref, 1), component);
    if (!a.root)
        return scaled(b, a.offset);
    return b.root ? start(ref, component) : scaled(a, b.offset);
}

/* Returns the product of a matrix, given by constant columns, and a vector. */
static Line linear_line(const Lower *l, Ref ref, int component)
{
    Line total = constant(0);
    for (int k = 1; k < ir_at(l->ir, ref)->count; k++) {
        Line factor = line_of(l, ir_arg(l->ir, ref, k), component),
             x = line_of(l, ir_arg(l->ir, ref, 0), k - 1), sum;
        if (factor.root)
            return start(ref, component);
        Line part = scaled(x, factor.offset);
        if (!combined(&total, &part, 1, &sum))
            return start(ref, component);
        total = sum;
    }
    return total;
}

static Line vec_line(const Lower *l, Ref ref, int component)
{
    int own = component;
    for (int i = 0; i < ir_at(l->ir, ref)->count; i++) {
        Ref part = ir_arg(l->ir, ref, i);
        if (component < ir_components(l->ir, part))
            return line_of(l, part, component);
        component -= ir_components(l->ir, part);
    }
    return start(ref, own);
}

static Line negated_line(const Lower *l, Ref ref, int component)
{
    return scaled(line_of(l, ir_arg(l->ir, ref, 0), component), -1);
}

static Line swizzle_line(const Lower *l, Ref ref, int component)
{
    return line_of(l, ir_arg(l->ir, ref, 0),
                   (int)(ir_at(l->ir, ref)->payload >> 2 * component & 3));
}

/* Returns the affine form of a new node from those of its operands: the AFFINE lines of ops.def. */
static Line new_line(const Lower *l, Ref ref, int component)
{
    switch (ir_at(l->ir, ref)->op) {
#define AFFINE(name, function)                                                                     \
    case OP_##name:                                                                                \
        return function(l, ref, component);
#include "grammar/ops.def"
    default:
        return start(ref, component);
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

/* Returns true if a form is finite. Products that overflow a float are not followed. */
static bool is_finite(const Line *line)
{
    double greatest = fabs(line->offset);
    for (int i = 0; i < COMPONENTS; i++)
        greatest = fmax(greatest, fabs(line->factor[i]));
    return greatest <= GREATEST && !isnan(line->offset);
}

/* Finds the affine forms of all nodes up to `last` that have none yet. Operands have lower
 * numbers, so their forms are known. */
static void follow(Lower *l, Ref last)
{
    Affine *affine = &l->affine;
    affine->first = arena_reach(l->session->arena, affine->first, last, &affine->first_capacity,
                                sizeof *affine->first);
    for (; affine->done <= last; affine->done++) {
        Ref ref = affine->done;
        if (!is_affine(ir_at(l->ir, ref)))
            continue;
        uint32_t first = (uint32_t)affine->count + 1;
        for (int component = 0; component < ir_components(l->ir, ref); component++) {
            Line line = new_line(l, ref, component);
            if ((line.closed && line.root != ref) || !is_finite(&line))
                line = start(ref, component);
            ARENA_PUSH(l->session->arena, affine->lines, affine->count, affine->capacity, line);
        }
        affine->first[ref] = first;
    }
}

/* Returns true if evaluating the form rounds nothing: one component times a power of two,
 * without an offset. */
static bool is_exact(const Line *line)
{
    int terms = 0, exponent;
    for (int i = 0; i < COMPONENTS; i++) {
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
    Line line[COMPONENTS];
    int components;
    double scale;
} Lines;

/* Splits a column, or the offset, into three vectors that add up to it: two of 12 bits, and the
 * remainder. */
static void put_column(Lower *l, const Lines *lines, int column, Ref parts[3])
{
    double value[3][4] = {{0}};
    for (int i = 0; i < lines->components; i++) {
        const Line *line = &lines->line[i];
        double exact = lines->scale * (column < COMPONENTS ? line->factor[column] : line->offset);
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
    int components = ir_components(ir, value);
    if (components == 4)
        return build_swizzle(ir, value, "xyz");
    if (components == 3)
        return value;
    Ref rest = ir_const(ir, components == 2 ? TYPE_float : TYPE_vec2, none);
    return build_vec(ir, TYPE_vec3, value, rest);
}

/* Finds affine forms of the components with one common root. Returns false if nothing is gained. */
static bool lines_of(Lower *l, Ref coordinate, Line lines[COMPONENTS], Ref *root)
{
    int components = ir_components(l->ir, coordinate);
    bool exact = true;
    *root = 0;
    if (l->job->choice[AXIS_coordinates] != CHOICE_coordinates_long || components > COMPONENTS)
        return false;
    follow(l, coordinate);
    for (int i = 0; i < components; i++) {
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
    static const char *const components_of[] = {"", "x", "xy"};
    Ref root, args[1 + 3 * (COMPONENTS + 1)];
    const int components = ir_components(ir, coordinate);
    Lines lines = {.components = components, .scale = scale};
    if (!lines_of(l, coordinate, lines.line, &root))
        return false;
    args[0] = as_vec3(l, root);
    for (int column = 0; column <= COMPONENTS; column++)
        put_column(l, &lines, column, &args[1 + 3 * column]);
    parts->whole = build_call_of(ir, FN_affineWhole, args, 1 + 3 * (COMPONENTS + 1));
    parts->fraction = build_call_of(ir, FN_affineFraction, args, 1 + 3 * (COMPONENTS + 1));
    if (components < COMPONENTS) {
        parts->whole = build_swizzle(ir, parts->whole, components_of[components]);
        parts->fraction = build_swizzle(ir, parts->fraction, components_of[components]);
    }
    /* the derivatives of the whole part equal those of the coordinate */
    for (int d = 0; d < DIRECTION_COUNT; d++) {
        Ref slope = slope_of(l, coordinate, (Direction)d);
        slope_set(l, parts->whole, (Direction)d,
                  slope && scale != 1 ? build_scale(ir, slope, scale) : slope);
        slope_set(l, parts->fraction, (Direction)d, 0);
    }
    return true;
}
