/* Generates formulas: text of random structure from the rows of expression.def, with matching
 * widths. A term that may be large is passed through an arc tangent, so that no product of terms
 * overflows a float; points may be anywhere, so formulas read sines of them. */
#include "generate.h"
#include "grammar/expression_tables.h"
#include <stdio.h>
#include <string.h>

enum { MAX_DEPTH = 3 };

typedef struct {
    Choices *c;
    Text *out;
    int inputs; /* i0, i1, ... */
} Formulas;

static void value(Formulas *f, int width, int depth);

static void number(Formulas *f)
{
    char text[32];
    snprintf(text, sizeof text, "%.6g", generate_number(f->c, 0, 8, false));
    text_put(f->out, text);
}

static void leaf(Formulas *f, int width)
{
    enum { LEAVES = 10 };
    static const char *const leaves[5][LEAVES] = {
        [1] = {"sin(u)", "sin(v)", "cos(x)", "sin(y)", "cos(z)", "pi", "facing", "sin(w)",
               "sin(time)", "objectRandom"},
        [2] = {"cos(uv)", "N.xz", "sin(p.xy)", "vec2(.3)", "sin(uv + p.zx)", "[u, v] * 0", "V.xy",
               "vertexColor.ra", "cos(uv.yx)", "sin(P.yz)"},
        [3] = {"sin(p)", "cos(P)", "N", "sin(du)", "cos(dv)", "#c08040", "V", "vertexColor.rgb",
               "sin(p.zxy)", "cos(P.yzx)"},
        [4] = {"vec4(N, .5)", "#20406080", "sin(p).xyzx", "vec4(1)", "cos(uv).xyyx", "vec4(2)",
               "vec4(V, facing)", "vertexColor", "sin(p).zzyx", "cos(P).xxyz"}};
    const uint32_t which = choose(f->c, 8);
    if (f->inputs && which > 5)
        text_format(f->out, width == 1 ? "sin(i%d.x)" : "sin(i%d.xxxx)",
                    (int)choose(f->c, (uint32_t)f->inputs));
    else if (which == 0 && width == 1)
        number(f);
    else
        text_put(f->out, leaves[width][choose(f->c, LEAVES)]);
    if (f->inputs && which > 5 && width > 1)
        text_format(f->out, ".%.*s", width, "xyzw");
}

/* True if the value may be large although its arguments are not. */
static bool grows(const TermRow *row)
{
    static const char *const names[] = {"exp",         "exp2",  "sinh",    "cosh",
                                        "tan",         "pow",   "safepow", "divide",
                                        "inversesqrt", "remap", "bias",    "degrees"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (!strcmp(names[i], row->name))
            return true;
    return false;
}

/* Width for a letter: the term's own where the letter says so; a number may replace a vector. */
static int width_of(Formulas *f, char letter, int own)
{
    return letter == 'g' ? (chance(f->c, 1, 4) ? 1 : own) : letter == 'b' ? 0 : letter - '0';
}

static void argument(Formulas *f, const TermRow *row, int i, int own, int depth)
{
    const char letter = row->signature[i];
    if (letter == 'i')
        text_format(f->out, "%d", 1 + (int)choose(f->c, 4));
    else
        value(f, width_of(f, letter, own), depth - 1);
}

static void term(Formulas *f, Term which, int width, int depth)
{
    const TermRow *row = &term_table[which];
    const int own = term_result(row) == 'g' ? width : 1 + (int)choose(f->c, 4);
    text_put(f->out, grows(row) ? "atan(" : "(");
    if (row->callable) {
        text_format(f->out, "%s(", row->name);
        for (int i = 0; i < row->count; i++) {
            text_put(f->out, i ? ", " : "");
            argument(f, row, i, own, depth);
        }
        text_put(f->out, ")");
    } else {
        const char *symbol = term_symbol(which);
        if (row->count > 1)
            argument(f, row, 0, own, depth);
        text_format(f->out, row->count == 3 ? " ? " : " %s ", symbol);
        argument(f, row, row->count > 1, own, depth);
        if (row->count == 3) {
            text_put(f->out, " : ");
            argument(f, row, 2, own, depth);
        }
    }
    text_put(f->out, ")");
    if (term_result(row) == 'g' && width > 1)
        text_format(f->out, " * vec%d(1)", width); /* all of its arguments may be scalars */
}

/* Nested conditions end at the depth limit. */
static bool gives(const TermRow *row, int width, int depth)
{
    const char result = term_result(row);
    if (width == 0)
        return result == 'b' && (depth > 0 || row->signature[0] != 'b');
    return result == 'g' || result - '0' == width;
}

static void value(Formulas *f, int width, int depth)
{
    if (width > 0 && (depth <= 0 || chance(f->c, 1, 5))) {
        leaf(f, width);
        return;
    }
    Term may[TERM_COUNT];
    uint32_t count = 0;
    for (int i = 0; i < TERM_COUNT; i++)
        if (gives(&term_table[i], width, depth))
            may[count++] = (Term)i;
    if (count) {
        text_put(f->out, width ? "" : "(");
        term(f, may[choose(f->c, count)], width ? width : 1, depth);
        text_put(f->out, width ? "" : ")");
        return;
    }
    leaf(f, width); /* only terms that also take four components give four */
}

void generate_formula(Choices *c, Text *out, int inputs)
{
    Formulas f = {c, out, inputs};
    if (chance(c, 1, 4)) {
        text_put(out, "a = ");
        value(&f, 1, 1);
        text_put(out, "; a * ");
    }
    value(&f, 1 + (int)choose(c, 4), 1 + (int)choose(c, MAX_DEPTH));
}
