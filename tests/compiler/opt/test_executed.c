/* How often a drawn program evaluates a noise at a pixel: the noise functions of the emitted
 * text increment a counter, and the counter is drawn. This proves the savings of branches,
 * wherever they are and whatever their conditions. */
#include "tests/test.h"
#include "tests/compile_text.h"
#include "tests/draw/draw.h"

enum { PLACES = 4, CAPACITY = 65536 };
static const float place_u[PLACES] = {0.25F, 0.5F, 0.75F, 1.25F};

/* smoothstep(.4, .6, u) is 0, something between, 1 and 1 at the places; smoothstep(.8, 1, u) is 1
 * at the last alone. */
#define MASK   "mask: \"= smoothstep(.4, .6, u)\"\n"
#define COSTLY "{ map: VolumeTurbulence, octaves: 4 }"
#define PLAIN  "{ material: Phong, diffuse: 0.5 }"

static void add(char *text, const char *from, size_t size)
{
    const size_t length = strlen(text);
    assert_true(length + size < CAPACITY);
    memcpy(text + length, from, size);
    text[length + size] = 0;
}

static bool begins(const char *line, const char *with)
{
    return !strncmp(line, with, strlen(with));
}

/* A program of outputs that nobody reads, but for the count. */
static void count_in(const char *fragment, char *text)
{
    static const char *const functions[] = {"float turbulence(", "vec4 turbulenceGradient("};
    static const char first[] = "layout(location = 0)",
                      drawn[] = "layout(location = 0) out vec4 drawn;\nint executions = 0;\n",
                      counted[] = "executions++;\n",
                      end_of_main[] = "    drawn = vec4(float(executions));\n}\n";
    bool counts = false; /* in the head of a counted function, which may take several lines */
    text[0] = 0;
    for (const char *line = fragment, *end; *line; line = end) {
        end = strchr(line, '\n') + 1;
        if (begins(line, first))
            add(text, drawn, strlen(drawn));
        if (begins(line, "layout(location = ")) {
            const char *type = strstr(line, " out ") + strlen(" out ");
            add(text, type, (size_t)(end - type)); /* a global like any other */
            continue;
        }
        add(text, line, (size_t)(end - line));
        for (size_t i = 0; i < sizeof functions / sizeof *functions; i++)
            counts |= begins(line, functions[i]);
        if (counts && end[-2] == '{') {
            add(text, counted, strlen(counted));
            counts = false;
        }
    }
    char *brace = strrchr(text, '}');
    *brace = 0;
    add(text, end_of_main, strlen(end_of_main));
}

static void draw_counts(Drawer *drawer, const char *fragment, float rgba[PLACES * 4])
{
    static char text[CAPACITY];
    count_in(fragment, text);
    Shading shading = {.fragment = text, .target = TARGET_glsl330};
    Material material;
    if (!drawer_material(drawer, &shading, &material) ||
        !drawer_draw(drawer, &material, true, &rgba, 1))
        fail_msg("%s\n%s", drawer->error, text);
    material_delete(&material);
}

typedef struct {
    const char *document;
    int counts[PLACES];
} Counted;

static void expect_counts(Drawer *drawer, const Counted *row)
{
    float rgba[GRID_WIDTH * GRID_HEIGHT * 4];
    MatcOptions options = quick();
    options.layout = "integer";
    char *fragment = compile_text(row->document, MATC_FRAGMENT, &options);
    draw_counts(drawer, fragment, rgba);
    for (int i = 0; i < PLACES; i++)
        if (rgba[4 * i] != (float)row->counts[i])
            fail_msg("%s\n%s\nu = %g: %g executions, not %d", row->document, fragment, place_u[i],
                     rgba[4 * i], row->counts[i]);
    free(fragment);
}

static void a_side_is_computed_where_it_shows(void **state)
{
    static const Counted rows[] = {
        /* in one slot, in two, in five of which one is a slope */
        {"material: Mix\n" MASK "a: " PLAIN "\nb: { material: Phong, diffuse: " COSTLY " }\n",
         {0, 1, 1, 1}},
        {"material: Mix\n" MASK "a: " PLAIN "\nb: { material: Phong, diffuse: &t " COSTLY
         ", shininess: *t }\n",
         {0, 1, 1, 1}},
        {"material: Mix\n" MASK "b: " PLAIN "\na: { material: Phong, diffuse: &t " COSTLY
         ", shininess: *t }\n",
         {1, 1, 0, 0}},
        {"material: Mix\n" MASK
         "a: { material: Principled }\nb: { material: Principled, baseColor: &t " COSTLY
         ", roughness: *t, metalness: *t, emission: *t, emissionColor: *t, input: { map: BumpMap, "
         "displacement: *t } "
         "}\n",
         {0, 1, 1, 1}},
        /* of what another slot weighs */
        {"material: Mix\n" MASK "a: { material: Principled, coat: 1, coatRoughness: .1 }\nb: { "
         "material: Principled, coat: &t " COSTLY ", coatRoughness: *t, roughness: *t }\n",
         {0, 1, 1, 1}},
        /* each side its own */
        {"material: Mix\n" MASK "a: { material: Phong, diffuse: &s { map: VolumeTurbulence, "
         "octaves: 3 }, shininess: *s }\n"
         "b: { material: Phong, diffuse: &t " COSTLY ", shininess: *t }\n",
         {1, 2, 1, 1}},
        /* both sides need it, or the mask: everywhere */
        {"material: Mix\n" MASK "a: { material: Phong, diffuse: &t " COSTLY
         " }\nb: { material: Phong, shininess: *t }\n",
         {1, 1, 1, 1}},
        {"material: Mix\nmask: { map: Expression, is: \"smoothstep(.4, .6, u + 1e-7 * t)\", with: "
         "{ t: &t " COSTLY " } }\na: " PLAIN
         "\nb: { material: Phong, diffuse: *t, shininess: *t }\n",
         {1, 1, 1, 1}},
        /* a Mix in a Mix: the mask of the inner one, then its sides */
        {"material: Mix\n" MASK "a: " PLAIN
         "\nb:\n  material: Mix\n  mask: \"= smoothstep(.8, 1, u)\"\n  b: " PLAIN
         "\n  a: { material: Phong, diffuse: &t " COSTLY ", shininess: *t }\n",
         {0, 1, 1, 0}},
        {"material: Mix\n" MASK "a: " PLAIN
         "\nb:\n  material: Mix\n  mask: { map: Expression, is: \".5 + .1 * t\", with: { t: " COSTLY
         " } }\n  a: { material: Phong, diffuse: red, specular: 0.3 }\n"
         "  b: { material: Phong, diffuse: { map: VolumeTurbulence, octaves: 5 }, shininess: 0.3, "
         "specular: 0.2 }\n",
         {0, 2, 2, 2}},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        expect_counts(*state, &rows[i]);
}

/* Choices of maps by one condition are one branch, too. */
static void choices_of_several_slots_are_one_branch(void **state)
{
    expect_counts(
        *state,
        &(Counted){"material: Phong\ndiffuse: { map: Expression, is: \"u < .4 ? t : .2\", with: { "
                   "t: &t " COSTLY " } }\n"
                   "specular: { map: Expression, is: \"u < .4 ? t * .5 : u\", with: { t: *t } }\n",
                   {1, 0, 0, 0}});
}

static int open_drawer(void **state)
{
    static Drawer drawer;
    static Point points[POINT_COUNT];
    points_make(points);
    for (int i = 0; i < PLACES; i++)
        points[i].input[INPUT_U][0] = place_u[i];
    *state = &drawer;
    return drawer_open(&drawer, true, points, POINT_COUNT) ? 0 : 1;
}

static int close_drawer(void **state)
{
    drawer_close(*state);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_side_is_computed_where_it_shows),
        cmocka_unit_test(choices_of_several_slots_are_one_branch),
    };
    return cmocka_run_group_tests(tests, open_drawer, close_drawer);
}
