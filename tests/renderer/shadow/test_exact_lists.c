/* Triangle lists of exact shadows, as made on the GPU: every triangle between a point and a
 * light, in double, is in the list of the point's cell; each cell has all triangles that cover
 * any of it, by a clipper that visits cell by cell, and few others. */
/* ctest: seconds=11 */
#include "tests/test.h"
#include "runtime/exact/exact_cover.h"
#include "tests/frame/exact_cells.h"
#include "tests/frame/frame_draw.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static GlKind kind;
enum { TRIANGLES = 400, POINTS = 3000, MOST = 1 << 20 /* words */ };

static uint64_t state_of_chance = 1;

static double chance(void)
{
    state_of_chance = state_of_chance * 6364136223846793005u + 1442695040888963407u;
    return (double)(state_of_chance >> 11) / 9007199254740992.0;
}

/* So many, in a box around them. */
typedef struct {
    ExactCorners *corners;
    ExactObject all;
    ExactTriangles triangles;
} Objects;

/* Triangles of all sizes down to `least` of the greatest, with needles and points; as floats. */
static Objects some_objects(int count, double least)
{
    Objects made = {.corners = malloc((size_t)count * sizeof *made.corners + 1),
                    .all = {.count = count, .box = {{-2, -2, -2}, {2, 2, 2}}}};
    assert_non_null(made.corners);
    made.triangles = (ExactTriangles){.count = count, .reach = 2, .object_count = 1};
    for (int i = 0; i < count; i++) {
        const double size = 2 * pow(least, chance());
        double middle[3];
        for (int k = 0; k < 3; k++)
            middle[k] = 2 * chance() - 1;
        for (int corner = 0; corner < 3; corner++)
            for (int k = 0; k < 3; k++)
                made.corners[i][corner][k] =
                    (float)(middle[k] + (i % 7 && corner != 1 ? size * (chance() - .5) : 0));
        if (i % 11 == 0) /* a needle */
            for (int k = 0; k < 3; k++)
                made.corners[i][2][k] = made.corners[i][1][k] + 1e-6f * (float)k;
    }
    return made;
}

/* Lists of a scene's lights, read back. */
typedef struct {
    GlContext *gl;
    Store *store;
    ExactCover cover;
    GLuint corners;
    uint32_t *words;
    int heads[8]; /* of lights; -1: none */
} Made;

static Made open_made(size_t most)
{
    Made made = {.gl = frame_context_of(kind)};
    made.store = store_new(made.gl);
    assert_true(made.store && exact_cover_open(made.store, most, &made.cover));
    made.gl->GenBuffers(1, &made.corners);
    return made;
}

static bool make(Made *made, const Scene *scene, Objects *objects)
{
    const GlContext *gl = made->gl;
    objects->triangles.objects = &objects->all;
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, made->corners);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER,
                   (GLsizeiptr)((size_t)objects->triangles.count * sizeof *objects->corners),
                   objects->corners, GL_STATIC_DRAW);
    if (!exact_cover_make(&made->cover, scene, &objects->triangles, made->corners))
        return false;
    made->words = realloc(made->words, made->cover.words * sizeof *made->words);
    assert_non_null(made->words);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, made->cover.lists);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0,
                         (GLsizeiptr)(made->cover.words * sizeof *made->words), made->words);
    for (int i = 0, head = 0; i < scene->light_count; i++)
        made->heads[i] = exact_lists_wanted(&scene->lights[i]) ? head++ : -1;
    return true;
}

static void close_made(Made *made)
{
    made->gl->DeleteBuffers(1, &made->corners);
    exact_cover_close(&made->cover);
    store_free(made->store);
    gl_close(made->gl);
    free(made->words);
}

/* True if a triangle is hit by at + t way, 0 < t < most: by signed volumes. */
static bool is_met(const ExactCorners corners, const double at[3], const double way[3], double most)
{
    double from[3][3], sides[3], normal[3], edge[2][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            from[i][k] = corners[i][k] - at[k];
    for (int i = 0; i < 3; i++) {
        cross(from[i], from[(i + 1) % 3], normal);
        sides[i] = dot(normal, way);
    }
    if (!((sides[0] > 0 && sides[1] > 0 && sides[2] > 0) ||
          (sides[0] < 0 && sides[1] < 0 && sides[2] < 0)))
        return false;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            edge[i][k] = from[i + 1][k] - from[0][k];
    cross(edge[0], edge[1], normal);
    const double t = dot(normal, from[0]) / dot(normal, way);
    return t > 0 && t < most;
}

/* -- lists */

static const uint32_t *head_of(const Made *made, int light)
{
    return made->words + (size_t)made->heads[light] * EXACT_LISTS_HEAD;
}

/* The first word of a cell's list, and the one after its last. */
static void list_of(const Made *made, const uint32_t *head, long cell, const uint32_t *list[2])
{
    const uint32_t *pair = made->words + head[EXACT_LISTS_CELLS] + EXACT_LISTS_PAIR * cell;
    assert_true(pair[0] <= pair[1] && pair[1] <= made->cover.words);
    list[0] = made->words + pair[0];
    list[1] = made->words + pair[1];
}

/* Once. */
static bool is_listed(const Made *made, const uint32_t *head, long cell, uint32_t triangle)
{
    const uint32_t *list[2];
    int found = 0;
    list_of(made, head, cell, list);
    for (const uint32_t *word = list[0]; word < list[1]; word++)
        found += *word == triangle;
    assert_true(found <= 1);
    return found;
}

/* Returns the number of hit triangles, each of which must be listed. */
static int count_met(const Objects *objects, const Made *made, int light, int points)
{
    const uint32_t *head = head_of(made, light);
    const bool placed = exact_cell_number(head, EXACT_LISTS_PLACED) > 0;
    int met = 0;
    for (int i = 0; i < points; i++) {
        double at[3], way[3];
        for (int k = 0; k < 3; k++) {
            at[k] = 3 * chance() - 1.5;
            way[k] = exact_cell_number(head, EXACT_LISTS_FROM + k) - (placed ? at[k] : 0);
        }
        const long cell = exact_cell_of(head, at);
        for (int t = 0; cell >= 0 && t < objects->triangles.count; t++)
            if (is_met((const float(*)[4])objects->corners[t], at, way, placed ? 1 : INFINITY)) {
                assert_true(is_listed(made, head, cell, (uint32_t)t));
                met++;
            }
    }
    return met;
}

/* -- cell by cell */

/* Counts of triangles in cells: those that overlap a cell, those that may be listed, and those
 * that are. */
typedef struct {
    long covered, wide, listed;
} Counts;

static void count_cells(const Objects *objects, const Made *made, int light, Counts *counts)
{
    const uint32_t *head = head_of(made, light);
    const int size = (int)head[EXACT_LISTS_SIZE], faces = (int)head[EXACT_LISTS_VIEWS];
    for (int t = 0; t < objects->triangles.count * faces; t++) {
        const int face = t % faces;
        const ExactPolygon polygon = exact_cell_polygon(head, &objects->corners[t / faces], face);
        for (int i = 0; i < size * size; i++) {
            const bool covered =
                exact_cell_has(head, &polygon, (int[]){i % size, i / size}, 1. / 64 - 1e-4);
            const bool listed =
                is_listed(made, head, face * size * size + i, (uint32_t)(t / faces));
            counts->covered += covered;
            counts->listed += listed;
            counts->wide +=
                exact_cell_has(head, &polygon, (int[]){i % size, i / size}, 1. / 64 + 1e-4);
            assert_true(listed || !covered);
        }
    }
}

/* -- */

#define EXACT .shadows = KEYWORD_Shadows_exact
static SceneLight lights[] = {
    {.kind = SCENE_Point, EXACT, .position = {.1, .2, .3}}, /* among the triangles */
    {.kind = SCENE_Point, .shadows = KEYWORD_Shadows_map},
    {.kind = SCENE_Point, EXACT, .position = {4, 1, 2}},
    {.kind = SCENE_Spot,
     EXACT,
     .position = {0, 3, 3},
     .direction = {0, -.8, -.6},
     .outer_cosine = .8},
    {.kind = SCENE_Spot,
     EXACT,
     .position = {0, 1, 2},
     .direction = {0, -.8, -.6},
     .outer_cosine = -.3},
    {.kind = SCENE_Directional, EXACT, .direction = {.6, 0, -.8}},
};
enum { LIGHTS = sizeof lights / sizeof *lights, EXACT_LIGHTS = LIGHTS - 1 };

static const Scene scene = {.lights = lights, .light_count = LIGHTS};

static void free_objects(Objects *objects) { free(objects->corners); }

static void all_are_listed(void **state)
{
    (void)state;
    Objects objects = some_objects(TRIANGLES, .001);
    Made made = open_made(MOST);
    assert_true(make(&made, &scene, &objects));
    assert_int_equal(made.cover.light_count, EXACT_LIGHTS);
    assert_int_equal(made.cover.coarsened, 0);
    for (int i = 0; i < LIGHTS; i++)
        if (made.heads[i] >= 0)
            assert_true(count_met(&objects, &made, i, POINTS) > 100);
    close_made(&made);
    free_objects(&objects);
}

/* Each cell has all that covers it where it is 1/64 wider on all sides, and 2 % more: what goes
 * through the plane in which the light is, and what it sees from the side. */
static void cells(void **state)
{
    (void)state;
    Objects objects = some_objects(TRIANGLES, .001);
    Made made = open_made(MOST);
    assert_true(make(&made, &scene, &objects));
    for (int i = 0; i < LIGHTS; i++) {
        Counts counts = {0};
        if (made.heads[i] < 0)
            continue;
        count_cells(&objects, &made, i, &counts);
        print_message("light %d: %ld triangles in cells 1/64 wider, %ld a bit beyond, %ld listed\n",
                      i, counts.covered, counts.wide, counts.listed);
        assert_true(counts.covered > TRIANGLES &&
                    (double)counts.listed <= 1.02 * (double)counts.wide);
    }
    close_made(&made);
    free_objects(&objects);
}

/* So many large triangles that the programs' lists of row blocks, and the lists, must grow; then
 * few of them. */
static void many_large(void **state)
{
    (void)state;
    Objects objects = some_objects(4000, .5), few = some_objects(TRIANGLES, .5);
    Made made = open_made(32 * MOST);
    assert_true(make(&made, &scene, &few));
    const size_t first = made.cover.capacity, blocks = made.cover.blocks;
    assert_true(make(&made, &scene, &objects));
    assert_true(made.cover.capacity > first && made.cover.blocks > blocks && !made.cover.coarsened);
    for (int i = 0; i < LIGHTS; i++)
        if (made.heads[i] >= 0)
            assert_true(count_met(&objects, &made, i, 50) > 100);
    const size_t capacity = made.cover.capacity;
    made.gl->DeleteBuffers(1, &made.cover.work); /* room for lists, and none for blocks */
    made.cover.work = 0;
    made.cover.blocks = 0;
    assert_true(make(&made, &scene, &objects));
    assert_true(made.cover.capacity == capacity && count_met(&objects, &made, 5, 50) > 100);
    assert_true(make(&made, &scene, &few));
    assert_true(made.cover.capacity == capacity && made.cover.words <= first);
    assert_true(count_met(&few, &made, 0, POINTS) > 100);
    close_made(&made);
    free_objects(&objects);
    free_objects(&few);
}

/* With less memory cells are larger, and the lists still complete; with too little, the message
 * states the needed amount. */
static void less_capacity(void **state)
{
    (void)state;
    Objects objects = some_objects(TRIANGLES, .001);
    Made made = open_made(MOST);
    assert_true(make(&made, &scene, &objects));
    made.cover.most = made.cover.words / 2;
    exact_cover_empty(&made.cover);
    assert_true(make(&made, &scene, &objects));
    assert_true(made.cover.coarsened > 0 && made.cover.words <= made.cover.most);
    for (int i = 0; i < LIGHTS; i++)
        if (made.heads[i] >= 0)
            assert_true(count_met(&objects, &made, i, POINTS) > 100);
    made.cover.most = TRIANGLES;
    assert_false(make(&made, &scene, &objects));
    assert_non_null(strstr(made.gl->error, "bytes in a buffer, and there may be 1600"));
    close_made(&made);
    free_objects(&objects);
}

static void of_nothing(void **state)
{
    (void)state;
    Objects nothing = some_objects(0, 1);
    Made made = open_made(MOST);
    assert_true(make(&made, &scene, &nothing));
    assert_int_equal(exact_cover_longest(&made.cover), 0);
    close_made(&made);
    free_objects(&nothing);
}

int main(int count, char **arguments)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_are_listed), cmocka_unit_test(cells),
        cmocka_unit_test(many_large),     cmocka_unit_test(less_capacity),
        cmocka_unit_test(of_nothing),
    };
    kind = frame_kind(count, arguments);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
