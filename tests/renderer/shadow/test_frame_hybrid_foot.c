/* Start of hybrid shadow volumes at a caster's back faces: light leaks at the foot of a step, up
 * to the first texel center next to it. Compared with the closed form, for objects at several
 * positions relative to the map's texels. */
#include "tests/test.h"
#include "runtime/shadow/shadow_state.h"
#include "runtime/frame_graph/frame.h"
#include "tests/frame/shadow_pair.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One body: a step 1 high over a floor 1 thick, which goes from x = -2 to `right`, and is 2 deep.
 * Its riser stands at x = 0. */
static Shape step(double right)
{
    const double outline[6][2] = {{-2, -1}, {right, -1}, {right, 0}, {0, 0}, {0, 1}, {-2, 1}};
    static const int ends[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {3, 4, 5}};
    Shape made = {.vertices = calloc(36, sizeof *made.vertices),
                  .indices = calloc(60, sizeof *made.indices)};
    assert_true(made.vertices && made.indices);
    for (int i = 0; i < 6; i++) { /* sides, with normals of their own */
        const double *a = outline[i], *b = outline[(i + 1) % 6],
                     length = hypot(b[0] - a[0], b[1] - a[1]);
        const int first = made.vertex_count;
        for (int k = 0; k < 4; k++) {
            const double *at = k % 2 ? b : a;
            made.vertices[made.vertex_count++] = (ShapeVertex){
                .position = {(float)at[0], k < 2 ? -1 : 1, (float)at[1]},
                .normal = {(float)((b[1] - a[1]) / length), 0, (float)((a[0] - b[0]) / length)}};
        }
        for (int k = 0; k < 6; k++)
            made.indices[made.index_count++] = (uint32_t)(first + (int[]){0, 2, 1, 1, 2, 3}[k]);
    }
    for (int side = 0; side < 2; side++) {
        const int first = made.vertex_count;
        for (int i = 0; i < 6; i++)
            made.vertices[made.vertex_count++] = (ShapeVertex){
                .position = {(float)outline[i][0], side ? 1 : -1, (float)outline[i][1]},
                .normal = {0, side ? 1 : -1, 0}};
        for (int k = 0; k < 12; k++)
            made.indices[made.index_count++] =
                (uint32_t)(first + ends[k / 3][side ? 2 - k % 3 : k % 3]);
    }
    return made;
}

/* The floor's middle from the riser on, seen from above: a row of pixels, 1/640 wide each. */
enum { WIDTH = 960, HEIGHT = 4 };
static const char text[] =
    "image: { width: 960, height: 4 }\nmaterials: { m: { material: Phong, diffuse: .8 } }\n"
    "camera: { camera: Orthographic, position: [.75, 0, 5], target: [.75, 0, 0], up: [0, 1, 0], "
    "size: .00625 }\n"
    "shadowMaps: { size: 64, volume: plain }\nlights: [{ light: Directional, direction: [1, 0, -1] "
    "}]\n"
    "objects:\n- { object: Sphere, material: m }\n";

/* Light goes along (1, 0, -1): a point (x, z) and one of the floor at x + z are in one line with
 * it. Texels' centers are `texel` apart there, and the first one behind the riser's foot is at
 * `gap`. There the map has the riser's back, at the height gap; one before, the floor's lower side,
 * at x = 1 + gap - texel. The volume's wall goes from the one to the other, and meets the floor in
 * between. */
static double wall_at(const ShadowView *view, int size, double *gap)
{
    const int axis = fabs(view->rows[0][0]) > fabs(view->rows[1][0]) ? 0 : 1;
    const double slope = view->rows[axis][0] * size / 2,
                 foot = (view->rows[axis][3] + 1) * size / 2 - .5;
    const double texel = 1 / fabs(slope);
    *gap = (slope > 0 ? ceil(foot) - foot : foot - floor(foot)) * texel;
    return (1 + *gap - texel) * *gap / (1 + *gap);
}

/* The first dark x behind the riser. */
static double begin_of(const float *shares)
{
    int pixel = 0;
    while (pixel < WIDTH &&
           !(shares[HEIGHT / 2 * WIDTH + pixel] >= 0 && shares[HEIGHT / 2 * WIDTH + pixel] < .5f))
        pixel++;
    return (pixel + .5) / 640;
}

/* Start of shadows on the floor, by the method. */
static double begin_by(const ShadowPair *pair, Scene *scene, Keyword method)
{
    scene->lights[0].shadows = method;
    float *shares = shadow_pair_shares(pair, scene);
    const double begin = begin_of(shares);
    free(shares);
    return begin;
}

static void light_comes_through_at_a_foot(void **state)
{
    (void)state;
    ShadowPair pair;
    double narrowest = 1, widest = 0;
    shadow_pair_open(GL_KIND_osmesa, &pair);
    for (int i = 0; i < 24; i++) {
        MatcDocument *document;
        double gap;
        Scene *scene = frame_scene(text, &pair.options, &document);
        SceneMesh mesh = {.shape = step(2 + .008 * i)};
        scene->meshes = &mesh;
        scene->mesh_count = 1;
        scene->objects[0].kind = SCENE_Mesh;
        scene->objects[0].mesh = 0;
        const double begin = begin_by(&pair, scene, KEYWORD_Shadows_hybrid);
        const double wall =
            wall_at(&pair.renders[0]->shadows->views.views[0], scene->shadow_size, &gap);
        print_message("a centre at %.4f: the floor is dark from %.4f on, by the closed form %.4f\n",
                      gap, begin, wall);
        assert_true(fabs(begin - wall) < 1.2 / 640);
        assert_true(begin_by(&pair, scene, KEYWORD_Shadows_exact) < 1.2 / 640);
        narrowest = fmin(narrowest, wall);
        widest = fmax(widest, wall);
        scene->mesh_count = 0;
        frame_forget(scene, document);
        shape_free(&mesh.shape);
    }
    assert_true(narrowest < .01 && widest > .05);
    shadow_pair_close(&pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(light_comes_through_at_a_foot)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
