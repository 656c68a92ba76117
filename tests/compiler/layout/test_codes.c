/* Every code of every encoding, exactly: decoded by the library's GLSL, encoded, and stored in a
 * real target of half floats or integers, it is unchanged, and equals the C reference's code. */
/* ctest: alone */
#include "tests/test.h"
#include "compiler/library/normal.h"
#include "compiler/library/pack.h"
#include "compiler/library/reference.h"
#include "tests/draw/canvas.h"
#include "tests/value/half.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 256, TEXELS = SIDE * SIDE };

typedef struct {
    Canvas canvas;
    float floats[TEXELS][4];
    GLuint words[TEXELS][4];
} Fixture;

static int set_up(void **state)
{
    Fixture *f = calloc(1, sizeof *f);
    *state = f;
    if (canvas_open(&f->canvas, SIDE))
        return 0;
    print_error("%s\n", f->canvas.error);
    return -1;
}

static int tear_down(void **state)
{
    Fixture *f = *state;
    canvas_close(&f->canvas);
    free(f);
    return 0;
}

static void draw(Fixture *f, const Drawing *drawing, const Framebuffer *target)
{
    if (!canvas_draw(&f->canvas, drawing, target))
        fail_msg("%s", f->canvas.error);
}

static void read_floats(Fixture *f, const Framebuffer *target)
{
    assert_true(framebuffer_read(f->canvas.gl, target, 0, &f->floats[0][0]));
}

static void read_words(Fixture *f)
{
    assert_true(framebuffer_read_words(f->canvas.gl, &f->canvas.words, 0, &f->words[0][0]));
}

/* A word is decoded into a target of floats, and that is encoded into a target of words. */
static void draw_there_and_back(Fixture *f, const char *decode, const char *encode, unsigned first)
{
    char functions[128];
    snprintf(functions, sizeof functions, "%.*s", (int)strcspn(decode, "("), decode);
    char value[256];
    bool vector = strstr(functions, "octahedral") || strstr(functions, "shared") ||
                  strstr(functions, "sphere");
    snprintf(value, sizeof value, vector ? "vec4(%s, 0.0)" : "vec4(%s)", decode);
    draw(f, &(Drawing){.functions = functions, .expression = value, .first = first},
         &f->canvas.floats);
    snprintf(functions, sizeof functions, "%.*s", (int)strcspn(encode, "("), encode);
    snprintf(value, sizeof value, "uvec4(%s)", encode);
    draw(f, &(Drawing){.functions = functions, .expression = value, .source = &f->canvas.floats},
         &f->canvas.words);
    read_words(f);
}

/* All codes of a field of one number, at every width that it can have. */
static void every_code_of(Fixture *f, const char *name, int least, int most)
{
    char decode[64], encode[64];
    for (int bits = least; bits <= most; bits++) {
        unsigned count = 1u << bits;
        snprintf(decode, sizeof decode, "%sFromBits(index & %uu, %d)", name, count - 1, bits);
        snprintf(encode, sizeof encode, "%sBits(t.x, %d)", name, bits);
        draw_there_and_back(f, decode, encode, 0);
        for (unsigned i = 0; i < TEXELS; i++)
            if (f->words[i][0] != (i & (count - 1)))
                fail_msg("%s %d: code %u comes back as %u", name, bits, i & (count - 1),
                         f->words[i][0]);
    }
}

static void every_number_code_survives(void **state)
{
    every_code_of(*state, "unorm", 1, 16);
    every_code_of(*state, "root", 2, 16);
    every_code_of(*state, "logarithm", 4, 16);
}

static bool is_finite_half(unsigned code) { return (code & 0x7C00) != 0x7C00; }

static void every_half_survives(void **state)
{
    Fixture *f = *state;
    draw_there_and_back(f, "halfFromBits(index)", "halfBits(t.x)", 0);
    read_floats(f, &f->canvas.floats);
    for (unsigned i = 0; i < TEXELS; i++) {
        if (!is_finite_half(i))
            continue;
        assert_true(f->floats[i][0] == pack_half_value((uint16_t)i));
        if (f->words[i][0] != i && i != 0x8000) /* -0 is stored as 0 */
            fail_msg("half %04x comes back as %04x", i, f->words[i][0]);
    }
}

/* Around every half float: itself, the tie above it, and the floats beside the tie. */
static void halves_are_rounded_as_the_reference(void **state)
{
    Fixture *f = *state;
    static float numbers[TEXELS][4];
    for (unsigned i = 0; i < TEXELS; i++) {
        double v = is_finite_half(i) ? pack_half_value((uint16_t)i) : (i & 0x8000 ? -1e6 : 1e30);
        double tie = v + (v < 0 ? -.5 : .5) * half_step(v);
        if (v == 0)
            tie = ldexp(i ? -1 : 1, -25);
        numbers[i][0] = (float)v;
        numbers[i][1] = (float)tie;
        numbers[i][2] = nextafterf((float)tie, INFINITY);
        numbers[i][3] = nextafterf((float)tie, -INFINITY);
    }
    GLuint source = texture_make(
        f->canvas.gl,
        &(TextureSpec){.width = SIDE, .height = SIDE, .components = 4, .floats = &numbers[0][0]});
    draw(f,
         &(Drawing){.functions = "halfBits",
                    .expression =
                        "uvec4(halfBits(t.x), halfBits(t.y), halfBits(t.z), halfBits(t.w))",
                    .texture = source},
         &f->canvas.words);
    read_words(f);
    f->canvas.gl->DeleteTextures(1, &source);
    for (unsigned i = 0; i < TEXELS; i++)
        for (int component = 0; component < 4; component++) {
            unsigned want = pack_half_bits(numbers[i][component]), got = f->words[i][component];
            if (got != want && (got | want) != 0x8000) /* either zero */
                fail_msg("%.9g is stored as %04x, should be %04x", numbers[i][component], got,
                         want);
        }
}

/* The value that a code stands for is kept; several codes may stand for one. */
static void every_shared_exponent_survives(void **state)
{
    Fixture *f = *state;
    static float before[TEXELS][4];
    const unsigned step = 65521; /* a prime: the codes that are drawn lie all over */
    for (int bits = 4; bits <= 9; bits++)
        for (int part = 0; part < 8; part++) {
            char decode[96], encode[64];
            unsigned long mask = (1ul << (3 * bits + 5)) - 1;
            snprintf(decode, sizeof decode, "sharedExponentFromBits(index * %uu & %luu, %d)", step,
                     mask, bits);
            snprintf(encode, sizeof encode, "sharedExponentBits(t.xyz, %d)", bits);
            draw_there_and_back(f, decode, encode, (unsigned)part * TEXELS);
            read_floats(f, &f->canvas.floats);
            memcpy(before, f->floats, sizeof before);
            snprintf(decode, sizeof decode, "vec4(sharedExponentFromBits(w.x, %d), 0.0)", bits);
            draw(f,
                 &(Drawing){.functions = "sharedExponentFromBits",
                            .expression = decode,
                            .source = &f->canvas.words},
                 &f->canvas.floats);
            read_floats(f, &f->canvas.floats);
            for (unsigned i = 0; i < TEXELS; i++)
                for (int component = 0; component < 3; component++)
                    if (f->floats[i][component] != before[i][component])
                        fail_msg("%d bits: %.9g comes back as %.9g", bits, before[i][component],
                                 f->floats[i][component]);
        }
}

/* The border of the square is folded: there, two codes are one direction. */
static bool is_on_border(unsigned x, unsigned y, unsigned last)
{
    return x == 0 || y == 0 || x == last || y == last;
}

static void compare_octahedral(const Fixture *f, unsigned long first, int bits)
{
    unsigned last = (1u << bits) - 2, mask = (1u << bits) - 1;
    for (unsigned i = 0; i < TEXELS; i++) {
        unsigned code = (unsigned)(first + i), x = code & mask, y = code >> bits & mask,
                 got = f->words[i][0];
        if (x > last || y > last || got == code)
            continue;
        double a[3], b[3];
        normal_octahedral_decode((int[2]){(int)x, (int)y}, octahedral_levels(bits), a);
        normal_octahedral_decode((int[2]){(int)(got & mask), (int)(got >> bits)},
                                 octahedral_levels(bits), b);
        if (!is_on_border(x, y, last) || normal_angle(a, b) > 1e-5)
            fail_msg("%d bits: code %u %u comes back as %u %u", bits, x, y, got & mask,
                     got >> bits);
    }
}

/* All codes to 11 bits a coordinate; of 12 and 16 every so many-th run. */
static void every_octahedral_code_survives(void **state)
{
    Fixture *f = *state;
    const int widths[] = {2, 3, 4, 6, 8, 10, 12, 14, 16};
    for (size_t k = 0; k < sizeof widths / sizeof *widths; k++) {
        int bits = widths[k];
        char decode[64], encode[64];
        unsigned long count = 1ul << 2 * bits, runs = (count + TEXELS - 1) / TEXELS,
                      step = runs > 256 ? runs / 256 : 1;
        snprintf(decode, sizeof decode, "octahedralFromBits(index & %luu, %d)", count - 1, bits);
        snprintf(encode, sizeof encode, "octahedralBits(t.xyz, %d)", bits);
        for (unsigned long run = 0; run < runs; run += step) {
            draw_there_and_back(f, decode, encode, (unsigned)(run * TEXELS));
            if (runs > 1)
                compare_octahedral(f, run * TEXELS, bits);
            for (unsigned i = 0; runs == 1 && i < count; i++)
                assert_true(f->words[i][0] < count);
        }
    }
}

/* Two numbers of a half float: the code of the reference, one that no special half has, and the
 * same numbers back. */
static void check_pairs(Fixture *f, const char *pack, const char *unpack, int width, int height)
{
    char text[256], functions[64];
    snprintf(functions, sizeof functions, "%s", pack);
    snprintf(text, sizeof text,
             "vec4(%s(vec2(float(index %% %du) / %d.0, min(float(index / %du) / %d.0, 1.0))))",
             pack, width, width - 1, width, height - 1);
    draw(f, &(Drawing){.functions = functions, .expression = text}, &f->canvas.halves);
    read_floats(f, &f->canvas.halves);
    for (int i = 0; i < width * height; i++)
        if (f->floats[i][0] != pack_half_from_code(i) || !half_is_plain(f->floats[i][0]))
            fail_msg("%s: code %d is stored as %.9g", pack, i, f->floats[i][0]);
    snprintf(text, sizeof text, "vec4(%s(t.x), 0.0, 0.0)", unpack);
    draw(f, &(Drawing){.functions = unpack, .expression = text, .source = &f->canvas.halves},
         &f->canvas.floats);
    read_floats(f, &f->canvas.floats);
    for (int i = 0; i < width * height; i++)
        if (fabs(f->floats[i][0] - i % width / (width - 1.)) > 1.2e-7 ||
            fabs(f->floats[i][1] - i / width / (height - 1.)) > 1.2e-7)
            fail_msg("%s: code %d comes back as %.9g, %.9g", unpack, i, f->floats[i][0],
                     f->floats[i][1]);
}

static void every_radix_code_survives(void **state)
{
    check_pairs(*state, "packRadix", "unpackRadix", RADIX_X, RADIX_Y);
}

/* Drawn from the reference's direction of each code. */
static void every_octahedral_radix_code_survives(void **state)
{
    Fixture *f = *state;
    draw(f,
         &(Drawing){.functions = "halfFromCode", .expression = "vec4(halfFromCode(float(index)))"},
         &f->canvas.halves);
    read_floats(f, &f->canvas.halves);
    for (int i = 0; i < HALF_CODES; i++)
        assert_true(f->floats[i][0] == pack_half_from_code(i));
    draw(f,
         &(Drawing){.functions = "octahedralFromRadix",
                    .expression = "vec4(octahedralFromRadix(t.x), 0.0)",
                    .source = &f->canvas.halves},
         &f->canvas.floats);
    draw(f,
         &(Drawing){.functions = "octahedralRadix",
                    .expression = "vec4(octahedralRadix(t.xyz))",
                    .source = &f->canvas.floats},
         &f->canvas.halves);
    read_floats(f, &f->canvas.halves);
    for (int i = 0; i < RADIX_X * RADIX_X; i++) {
        int x = i % RADIX_X, y = i / RADIX_X;
        if (f->floats[i][0] != pack_half_from_code(i) &&
            !is_on_border((unsigned)x, (unsigned)y, RADIX_X - 1))
            fail_msg("code %d %d comes back as %.9g", x, y, f->floats[i][0]);
    }
}

/* All of 8, and every seventh run of 12 bits, as whole numbers in half floats. */
static void octahedral_whole_numbers_survive(void **state)
{
    Fixture *f = *state;
    for (int bits = 8; bits <= 12; bits += 4) {
        unsigned runs = 1u << (2 * bits - 16), mask = (1u << bits) - 1;
        int scale = (1 << (bits - 1)) - 1;
        for (unsigned run = 0; run<runs; run += runs> 1 ? 7 : 1) {
            char decode[256], encode[128];
            snprintf(decode, sizeof decode,
                     "vec4(octahedralFromWhole(min(vec2(index & %uu, index >> %d) - %d.0, %d.0), "
                     "%d), 0.0)",
                     mask, bits, scale, scale, bits);
            snprintf(encode, sizeof encode, "vec4(octahedralWhole(t.xyz, %d), 0.0, 0.0)", bits);
            draw(f,
                 &(Drawing){.functions = "octahedralFromWhole",
                            .expression = decode,
                            .first = run * TEXELS},
                 &f->canvas.floats);
            draw(f,
                 &(Drawing){.functions = "octahedralWhole",
                            .expression = encode,
                            .source = &f->canvas.floats},
                 &f->canvas.halves);
            read_floats(f, &f->canvas.halves);
            for (unsigned i = 0; i < TEXELS; i++) {
                unsigned code = run * TEXELS + i, x = code & mask, y = code >> bits;
                if (is_on_border(x, y, mask - 1) || x == mask || y == mask)
                    continue;
                if (f->floats[i][0] != (int)x - scale || f->floats[i][1] != (int)y - scale)
                    fail_msg("%d bits: %u %u comes back as %g %g", bits, x, y, f->floats[i][0],
                             f->floats[i][1]);
            }
        }
    }
}

/* The axes: exact in every octahedral encoding, so that flat floors are flat. */
static void axes_are_exact(void **state)
{
    Fixture *f = *state;
    static const char *const trips[] = {
        "octahedralFromBits(octahedralBits(n, 8), 8)",
        "octahedralFromBits(octahedralBits(n, 12), 12)",
        "octahedralFromBits(octahedralBits(n, 16), 16)",
        "octahedralFromWhole(octahedralWhole(n, 12), 12)",
        "octahedralFromRadix(octahedralRadix(n))",
    };
    for (size_t k = 0; k < sizeof trips / sizeof *trips; k++) {
        char text[512];
        const char *n = "vec3(index / 2u == 0u ? s : 0.0, index / 2u == 1u ? s : 0.0, index / 2u "
                        "== 2u ? s : 0.0)";
        char trip[256], *at;
        snprintf(trip, sizeof trip, "%s", trips[k]);
        at = strstr(trip, "(n") + 1;
        *at = 0;
        snprintf(text, sizeof text, "vec4(%s%s%s, 0.0)", trip, n, at + 1);
        char whole[600] = "";
        for (char *c = text, *to = whole; *c; c++) /* s is the sign */
            if (*c == 's' && c[-1] == ' ' && c[1] == ' ')
                to += sprintf(to, "(index %% 2u == 0u ? 1.0 : -1.0)");
            else
                *to++ = *c, *to = 0;
        draw(f,
             &(Drawing){.functions =
                            "octahedralFromBits octahedralBits octahedralFromWhole octahedralWhole "
                            "octahedralFromRadix octahedralRadix",
                        .expression = whole},
             &f->canvas.floats);
        read_floats(f, &f->canvas.floats);
        for (int i = 0; i < 6; i++)
            for (int component = 0; component < 3; component++)
                assert_true(f->floats[i][component] == (component == i / 2 ? (i % 2 ? -1 : 1) : 0));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_code_survives),
        cmocka_unit_test(every_half_survives),
        cmocka_unit_test(halves_are_rounded_as_the_reference),
        cmocka_unit_test(every_shared_exponent_survives),
        cmocka_unit_test(every_octahedral_code_survives),
        cmocka_unit_test(every_radix_code_survives),
        cmocka_unit_test(every_octahedral_radix_code_survives),
        cmocka_unit_test(octahedral_whole_numbers_survive),
        cmocka_unit_test(axes_are_exact),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
