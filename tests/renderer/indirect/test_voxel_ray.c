/* Rays through slice maps: voxelRay against a walk through single voxels, bit for bit, and both
 * against a walk in double. Random and hostile grids; rays along axes, faces and edges, from
 * outside, of any length, with components 0 or NaN. Prints the number of bricks that a ray
 * reads. */
/* ctest: seconds=12 */
#include "tests/test.h"
#include "gen/render_text.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/voxel_walk.h"
#include "runtime/gpu_material/screen_pass.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDE = 64, HIGH = 64, RAYS = WIDE * HIGH, LEVELS = 10, COMPONENTS = 4 };

/* Result of a ray: t, or -1; the voxel, in two floats; number of bricks read. */
static const char head[] =
    "uniform sampler2D rays;\n"
    "vec4 rayTexel(ivec2 pixel, int i) { return texelFetch(rays, ivec2(2 * pixel.x + i, pixel.y), "
    "0); }\n"
    "vec4 said(bool met, float t, ivec3 at, int steps)\n{\n"
    "    return met ? vec4(t, at.x + 1024 * at.y, at.z, steps) : vec4(-1.0, 0.0, 0.0, steps);\n}\n";
static const char by_bricks[] = "vec4 passPixel(ivec2 pixel)\n{\n"
                                "    vec4 from = rayTexel(pixel, 0), way = rayTexel(pixel, 1);\n"
                                "    VoxelMeeting meeting;\n    float t;\n"
                                "    bool met = voxelMeets(from.xyz, way.xyz, from.w, meeting);\n"
                                "    if (met != voxelRay(from.xyz, way.xyz, from.w, t) || met && "
                                "(t != meeting.t || !voxelIsFull(meeting.at))) "
                                "return vec4(-9.0);\n"
                                "    return said(met, meeting.t, meeting.at, meeting.bricks);\n}\n";
static const char by_voxels[] =
    "vec4 passPixel(ivec2 pixel)\n{\n"
    "    vec4 from = rayTexel(pixel, 0), way = rayTexel(pixel, 1);\n"
    "    VoxelHit hit = voxelWalk(from.xyz, way.xyz, from.w, 0, true);\n"
    "    return said(hit.way >= 0.0, hit.way, hit.at, 0);\n}\n";

static const char by_steps[] =
    "vec4 passPixel(ivec2 pixel)\n{\n"
    "    vec4 from = rayTexel(pixel, 0), way = rayTexel(pixel, 1);\n    float t;\n"
    "    bool met = voxelMarch(from.xyz, from.w * way.xyz, 16, 0.25, t);\n"
    "    return said(met, t, ivec3(0), 0);\n}\n";

/* Texels of a ray: from and far, way. */
typedef float Ray[2][4];
static Ray rays[RAYS];
static float reported[2][RAYS][4];

static uint32_t random_state;
static double random_unit(void)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) / 16777216.;
}

/* -- grids */

typedef enum { EMPTY, FULL, SPARSE, DENSE, SINGLES, BALL, SLABS, KINDS } Filling;
static const char *const kinds[KINDS] = {"empty",   "full", "sparse", "dense",
                                         "singles", "ball", "slabs"};

static bool is_full(Filling kind, int size, const int at[3])
{
    double far = 0;
    for (int k = 0; kind == BALL && k < 3; k++)
        far += (at[k] + .5 - size / 2.) * (at[k] + .5 - size / 2.);
    switch (kind) {
    case EMPTY:
        return false;
    case FULL:
        return true;
    case SPARSE:
        return random_unit() < .002;
    case DENSE:
        return random_unit() < .5;
    case SINGLES:
        return false;
    case BALL:
        return far < size * size / 9.;
    default:
        return at[0] % 32 == 7 || at[1] % 32 == 3 || at[2] < 3;
    }
}

static VoxelWords make_grid(Filling kind, int size)
{
    VoxelWords words = voxel_words(size);
    for (int i = 0; i < size * size * size; i++) {
        const int at[3] = {i % size, i / size % size, i / size / size};
        if (is_full(kind, size, at))
            voxel_words_set(&words, at);
    }
    for (int i = 0; kind == SINGLES && i < 8; i++)
        voxel_words_set(&words, (int[]){i & 1 ? size - 1 : 0, i & 2 ? size / 2 : 31,
                                        i & 4 ? size - 1 : size / 2 - 1});
    return words;
}

/* As a slice map, and as bricks of all levels. */
typedef struct {
    GLuint slices, bricks, buffer;
} Map;

/* A full voxel is in a brick of each level: 4 x 4 x 4 voxels of it, which are 2^level wide. The
 * highest level is the first in the buffer. */
static void put_voxel(const int at[3], int size, uint64_t *bricks)
{
    for (int level = 0, edge; (edge = size >> level >> 2) > 0; level++) {
        /* bricks of all levels above: 1 + 8 + 64 + .. */
        const int above = (edge * edge * edge - 1) / 7;
        const int voxel[3] = {at[0] >> level, at[1] >> level, at[2] >> level};
        bricks[above + (voxel[2] / 4 * edge + voxel[1] / 4) * edge + voxel[0] / 4] |=
            (uint64_t)1 << (voxel[0] % 4 + 4 * (voxel[1] % 4) + 16 * (voxel[2] % 4));
    }
}

/* Texels have two words, the lower first. */
static void make_bricks(const GlContext *gl, const VoxelWords *words, Map *map)
{
    const int size = words->size, columns = size * size, high = size / 32,
              count = (size * size * size / 8 - 1) / 7;
    uint64_t *bricks = calloc((size_t)count, sizeof *bricks);
    uint32_t *halves = calloc((size_t)count, 2 * sizeof *halves);
    assert_true(bricks && halves);
    for (int i = 0; i < columns * high; i++)
        for (int bit = 0; words->words[i] && bit < 32; bit++)
            if (words->words[i] >> bit & 1)
                put_voxel((int[]){i / high % size, i / high / size, i % high * 32 + bit}, size,
                          bricks);
    for (int i = 0; i < 2 * count; i++)
        halves[i] = (uint32_t)(bricks[i / 2] >> 32 * (i % 2));
    gl->GenBuffers(1, &map->buffer);
    gl->BindBuffer(GL_TEXTURE_BUFFER, map->buffer);
    gl->BufferData(GL_TEXTURE_BUFFER, (GLsizeiptr)((size_t)count * sizeof *bricks), halves,
                   GL_STATIC_DRAW);
    gl->GenTextures(1, &map->bricks);
    gl->ActiveTexture(GL_TEXTURE0 + 1);
    gl->BindTexture(GL_TEXTURE_BUFFER, map->bricks);
    gl->TexBuffer(GL_TEXTURE_BUFFER, GL_RG32UI, map->buffer);
    free(bricks);
    free(halves);
}

static Map make_map(const GlContext *gl, const VoxelWords *words)
{
    uint32_t *texels = voxel_words_texels(words);
    Map map;
    gl->GenTextures(1, &map.slices);
    gl->ActiveTexture(GL_TEXTURE0 + 2);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, map.slices);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA32UI, words->size, words->size,
                   (words->size / 32 + COMPONENTS - 1) / COMPONENTS, 0, GL_RGBA_INTEGER,
                   GL_UNSIGNED_INT, texels);
    make_bricks(gl, words, &map);
    free(texels);
    return map;
}

static void forget_map(const GlContext *gl, const Map *map)
{
    gl->DeleteTextures(1, &map->slices);
    gl->DeleteTextures(1, &map->bricks);
    gl->DeleteBuffers(1, &map->buffer);
}

/* -- rays */

static void random_ray(int size, bool outside, Ray ray)
{
    double length = 0;
    for (int k = 0; k < 3; k++) {
        ray[0][k] = (float)(outside ? size * (3 * random_unit() - 1) : size * random_unit());
        ray[1][k] = (float)(2 * random_unit() - 1);
        if (outside && random_unit() < .9) /* most go towards the map */
            ray[1][k] = (float)(size * random_unit() - ray[0][k]) / (float)size;
        length += ray[1][k] * ray[1][k];
    }
    ray[0][3] = (float)(size * (random_unit() < .5 ? .25 : 4) / sqrt(length));
}

/* Along axes, faces and edges; from corners; with components of 0 or nearly; lengths and components
 * that no ray has. */
static void hostile_ray(int number, int size, Ray ray)
{
    static const float components[] = {0,  -0.f, 1e-30f, -1e-30f, 1e-42f, 1,
                                       -1, 1,    -1,     .5f,     1e-4f,  3};
    static const float never[] = {INFINITY, -INFINITY, NAN, 3e38f, -3e38f, 1e30f};
    random_ray(size, number % 4 == 3, ray);
    for (int k = 0; k < 3; k++) {
        const int corner = (int)(random_unit() * (size + 1));
        if (number % 8 < 5)
            ray[1][k] = components[(int)(random_unit() * (sizeof components / sizeof *components))];
        if (number % 3)
            ray[0][k] = (float)corner + (number % 3 == 2 && random_unit() < .5 ? .5f : 0);
        ray[1][k] *= number % 11 == 4 ? 1e25f : number % 11 == 5 ? 1e-25f : 1;
    }
    if (number % 11 == 4 || number % 11 == 5)
        ray[0][3] *= number % 11 == 4 ? 1e-25f : 1e25f;
    if (number % 13 == 0)
        ray[0][3] = INFINITY;
    if (number % 13 == 1)
        ray[0][3] = 0;
    if (number % 32 == 9)
        ray[random_unit() < .5][(int)(random_unit() * 4)] = never[(int)(random_unit() * 6)];
}

/* -- the GLSL */

static void run(GlContext *gl, int size, const char *text, const char *body, float (*result)[4])
{
    Store *store = store_new(gl);
    Screen screen;
    ScreenPass pass;
    Framebuffer target;
    const bool compute = !strcmp(body, by_bricks);
    const FramebufferSpec spec = {
        .width = WIDE, .height = HIGH, .color_count = 1, .color_format = GL_RGBA32F};
    const TextureSpec texture = {
        .width = 2 * WIDE, .height = HIGH, .components = 4, .floats = rays[0][0]};
    const ScreenPassText made = {
        .body = {render_text_voxel_map, text, head, body}, .format = "RGBA32F", .compute = compute};
    gl->ActiveTexture(GL_TEXTURE0);
    const GLuint name = texture_make(gl, &texture);
    if (!store || !screen_make(gl, &screen) || !framebuffer_make(gl, &spec, &target) || !name ||
        !screen_pass_make(store, &made, &pass))
        fail_msg("%s", gl->error);
    screen_pass_sampler(&pass, "rays", 0);
    screen_pass_sampler(&pass, "voxel_bricks", 1);
    screen_pass_sampler(&pass, "voxel_slices", 2);
    material_set_number(&pass.material, "voxel_size", (float)size);
    texture_bind(gl, name, 0);
    screen_pass_run(&pass, &target, &screen);
    assert_true(framebuffer_read(gl, &target, 0, result[0]));
    screen_pass_delete(&pass);
    framebuffer_delete(gl, &target);
    screen_delete(gl, &screen);
    gl->DeleteTextures(1, &name);
    store_free(store);
}

/* -- what is compared */

typedef struct {
    int met, apart, unlike, wrong;
    double bricks;
} Count;

/* Hit in double, also of neighboring rays; returns true if all hit the same voxel, or none. */
static bool truth_of(const VoxelWords *words, const Ray ray, VoxelMet *met)
{
    static const double beside[][3] = {
        {0, 0, 0}, {1, .4, -.7}, {-.6, 1, .3}, {.5, -.8, 1}, {-1, -.5, -.4}};
    double longest = 0;
    for (int k = 0; k < 3; k++)
        longest = fmax(longest, fabs(ray[1][k]));
    for (int i = 0; i < 5; i++) {
        VoxelLine line = {.far = ray[0][3] * (1 + (i - 2) * 1e-5)};
        for (int k = 0; k < 3; k++) {
            line.from[k] = ray[0][k] + 5e-4 * beside[i][k];
            line.way[k] = fabs(ray[1][k]) < 1e-20 * longest ? 0 : ray[1][k];
        }
        const VoxelMet now = voxel_walk(words, &line);
        if (i && (now.met != met->met || (now.met && memcmp(now.at, met->at, sizeof now.at))))
            return false;
        *met = i ? *met : now;
    }
    return true;
}

/* True if rounding errors are smaller than the differences of the neighboring rays. */
static bool is_plain(const Ray ray)
{
    const double most = 1e4;
    double length = 0;
    for (int k = 0; k < 3; k++) {
        if (!(fabs(ray[0][k]) < most) || !(fabs(ray[1][k]) < most))
            return false;
        length = fmax(length, fabs(ray[1][k]));
    }
    return length > 1 / most && ray[0][3] >= 0;
}

/* A ray with a NaN or infinite component hits nothing; the far end may be infinite. */
static bool is_none(const Ray ray)
{
    bool none = isnan(ray[0][3]);
    for (int k = 0; k < 3; k++)
        none |= !isfinite(ray[0][k]) || !isfinite(ray[1][k]);
    return none;
}

static Count compare(const VoxelWords *words)
{
    Count count = {0};
    for (int i = 0; i < RAYS; i++) {
        const float *fast = reported[0][i], *slow = reported[1][i];
        const int at[3] = {(int)fast[1] % 1024, (int)fast[1] / 1024, (int)fast[2]};
        VoxelMet met;
        count.met += fast[0] >= 0;
        count.bricks += fast[3] / RAYS;
        count.apart += memcmp(fast, slow, 3 * sizeof *fast) != 0;
        count.wrong += is_none((const float(*)[4])rays[i]) && fast[0] >= 0;
        if (!is_plain((const float(*)[4])rays[i]))
            continue;
        if (!truth_of(words, (const float(*)[4])rays[i], &met))
            count.unlike++;
        else if (met.met != (fast[0] >= 0) || (met.met && memcmp(at, met.at, sizeof at)) ||
                 (met.met && !(fabs(fast[0] - met.t) <= 2e-3 + 1e-5 * met.t)))
            count.wrong++;
    }
    return count;
}

static void try_rays(GlContext *gl, Filling kind, const VoxelWords *words, bool hostile)
{
    const int size = words->size;
    random_state = (uint32_t)(size + kind);
    for (int i = 0; i < RAYS; i++)
        if (hostile)
            hostile_ray(i, size, rays[i]);
        else
            random_ray(size, i % 4 == 0, rays[i]);
    run(gl, size, render_text_voxel_ray, by_bricks, reported[0]);
    run(gl, size, render_text_voxel_walk, by_voxels, reported[1]);
    const Count count = compare(words);
    print_message("%3d %-7s %s: %4d of %d meet, %d apart; in double %d wrong, %d at an edge; %.1f "
                  "bricks a ray\n",
                  size, kinds[kind], hostile ? "hostile" : "random ", count.met, RAYS, count.apart,
                  count.wrong, count.unlike, count.bricks);
    assert_int_equal(count.apart, 0);
    assert_int_equal(count.wrong, 0);
    if (!hostile)
        assert_true(count.unlike < RAYS / 20);
}

static void rays_meet_what_a_walk_meets(void **state)
{
    (void)state;
    static const int sizes[] = {32, 64, 128, 256, 512};
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (Filling kind = 0; kind < KINDS; kind++) {
            if (sizes[i] != 32 && sizes[i] != 128 && kind != BALL && kind != SPARSE)
                continue;
            VoxelWords words = make_grid(kind, sizes[i]);
            const Map map = make_map(gl, &words);
            for (int hostile = 0; hostile < 2; hostile++)
                try_rays(gl, kind, &words, hostile);
            forget_map(gl, &map);
            free(words.words);
        }
    gl_close(gl);
}

/* The thesis' march: the first of 16 evenly spaced points in a full voxel; points near a face
 * may be on either side. */
static int march(const VoxelWords *words, const Ray ray, bool *near_face)
{
    for (int j = 1; j <= 16; j++) {
        const double t = (j + .25) / 16 * ray[0][3];
        int at[3], outside = 0;
        for (int k = 0; k < 3; k++) {
            const double place = ray[0][k] + t * ray[1][k];
            at[k] = (int)floor(place);
            *near_face |= fabs(place - round(place)) < 1e-3;
            outside += at[k] < 0 || at[k] >= words->size;
        }
        if (!outside && voxel_words_at(words, at))
            return j;
    }
    return 0;
}

static void marches_look_at_even_places(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    VoxelWords words = make_grid(BALL, 64);
    const Map map = make_map(gl, &words);
    int met = 0, compared = 0;
    random_state = 9;
    for (int i = 0; i < RAYS; i++)
        random_ray(64, i % 4 == 0, rays[i]);
    run(gl, 64, render_text_voxel_march, by_steps, reported[0]);
    for (int i = 0; i < RAYS; i++) {
        bool near_face = false;
        const int step = march(&words, (const float(*)[4])rays[i], &near_face);
        if (near_face)
            continue;
        assert_true(reported[0][i][0] == (step ? (step + .25f) / 16 : -1));
        met += step > 0;
        compared++;
    }
    assert_true(compared > RAYS / 2 && met > RAYS / 10);
    forget_map(gl, &map);
    free(words.words);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_meet_what_a_walk_meets),
        cmocka_unit_test(marches_look_at_even_places),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
