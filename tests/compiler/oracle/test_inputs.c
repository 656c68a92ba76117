/* Premise of the value tests: a fragment program receives the exact floats of a point, on front
 * and back faces and in either context. */
#include "tests/test.h"
#include "tests/draw/draw.h"
#include <math.h>
#include <stdio.h>

/* A fragment program that shows one input, and the side in its fourth component. */
static void show_input(char *text, size_t capacity, bool core, Input input)
{
    const char *type = type_table[input_table[input].type].name, *name = input_table[input].glsl;
    snprintf(
        text, capacity,
        "#version %s\n%s %s %s;\n%svoid main() { %s = vec4(%s%s, gl_FrontFacing ? 1.0 : 0.0); }",
        core ? "330 core" : "110", core ? "in" : "varying", type, name, core ? "out vec4 c;\n" : "",
        core ? "c" : "gl_FragData[0]", name, input == INPUT_U ? ", 0.0" : "");
}

static void compare_input(const Point *points, Input input, bool front, const float *rgba)
{
    for (int i = 0; i < POINT_COUNT; i++) {
        assert_true(rgba[4 * i + 3] == front);
        for (int component = 0; component < type_table[input_table[input].type].components;
             component++) {
            float want = points[i].input[input][component], got = rgba[4 * i + component];
            bool flushed = got == 0 && fabsf(want) < WAVE_LEAST;
            if (got != want && !flushed)
                fail_msg("%s, point %d: %.9g instead of %.9g", input_table[input].glsl, i, got,
                         want);
        }
    }
}

static void inputs_arrive_exactly(void **state)
{
    (void)state;
    static Point points[POINT_COUNT];
    static float texels[POINT_COUNT * 4];
    float *rgba = texels;
    points_make(points);
    for (int core = 0; core < 2; core++) {
        Drawer drawer;
        assert_true(drawer_open(&drawer, core, points, POINT_COUNT));
        for (int input = 0; input < POINT_VARYINGS; input++) {
            char text[512];
            show_input(text, sizeof text, core, (Input)input);
            Shading shading = {.fragment = text, .target = core ? TARGET_glsl330 : TARGET_glsl110};
            Material material;
            if (!drawer_material(&drawer, &shading, &material))
                fail_msg("%s", drawer.error);
            for (int front = 0; front < 2; front++) {
                if (!drawer_draw(&drawer, &material, front, &rgba, 1))
                    fail_msg("%s", drawer.error);
                compare_input(points, (Input)input, front, rgba);
            }
            material_delete(&material);
        }
        drawer_close(&drawer);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(inputs_arrive_exactly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
