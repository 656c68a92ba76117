/* Settings of scenes against numbers written down by hand from docs/reference/language.md and
 * scene.def: picture, tone mapping, shadow maps, displacement, voxels, tools and indirect light.
 * Each key is at its default once and away from it once; a part that a text does not name keeps
 * its defaults.
 *
 *   toneMapping: { toneMapping: Filmic, exposure: -2 }   a factor of 1/4, all else by default */
#include "tests/scene_values.h"

typedef struct {
    const char *text;
    Scene scene; /* the members of one part */
} Row;

/* The first row of each part has its defaults, the last is combined with the last of all others. */
static const Row image_rows[] = {
    {"", {.width = 512, .height = 512}},
    {"image: { width: 3, height: 700, glow: true }\n", {.width = 3, .height = 700, .glow = true}},
    {"image: { width: 640, height: 480, tiles: true }\n",
     {.width = 640, .height = 480, .tiles = true}},
};

static void check_image(const Scene *is, const Scene *should_be, const char *text)
{
    CHECK(width);
    CHECK(height);
    CHECK(tiles);
    CHECK(glow);
}

/* A factor of 2^exposure. */
static const Row tone_rows[] = {
    {"", {.tone = SCENE_Clamp, .exposure = 1}},
    {"toneMapping: { toneMapping: Clamp, exposure: 3 }\n", {.tone = SCENE_Clamp, .exposure = 8}},
    {"toneMapping: { toneMapping: Filmic }\n", {.tone = SCENE_Filmic, .exposure = 1}},
    {"toneMapping: { toneMapping: Filmic, exposure: -2 }\n",
     {.tone = SCENE_Filmic, .exposure = .25}},
    {"toneMapping: { toneMapping: Shoulder }\n",
     {.tone = SCENE_Shoulder, .exposure = 1, .tone_numbers = {.7}}},
    {"toneMapping: { toneMapping: Shoulder, exposure: 1, knee: .25 }\n",
     {.tone = SCENE_Shoulder, .exposure = 2, .tone_numbers = {.25}}},
    {"toneMapping: { toneMapping: Exponential, exposure: -1 }\n",
     {.tone = SCENE_Exponential, .exposure = .5}},
    {"toneMapping: { toneMapping: Linear, exposure: 4 }\n", {.tone = SCENE_Linear, .exposure = 16}},
    {"toneMapping: { toneMapping: ReinhardDevlin }\n",
     {.tone = SCENE_ReinhardDevlin, .exposure = 1, .tone_numbers = {0, 0, 0, 1}}},
    {"toneMapping: { toneMapping: ReinhardDevlin, intensity: -3, contrast: .5, "
     "chromaticAdaptation: .25, lightAdaptation: .125 }\n",
     {.tone = SCENE_ReinhardDevlin, .exposure = 1, .tone_numbers = {-3, .5, .25, .125}}},
    {"toneMapping: { toneMapping: Drago }\n",
     {.tone = SCENE_Drago, .exposure = 1, .tone_numbers = {.85}}},
    {"toneMapping: { toneMapping: Drago, bias: .5, exposure: 2 }\n",
     {.tone = SCENE_Drago, .exposure = 4, .tone_numbers = {.5}}},
};

static void check_tone(const Scene *is, const Scene *should_be, const char *text)
{
    CHECK(tone);
    CHECK(exposure);
    CHECK_LIST(tone_numbers);
}

static const Row shadow_rows[] = {
    {"",
     {.shadow_size = 1024,
      .shadow_filter = 1,
      .shadow_cascades = 1,
      .shadow_points = 5,
      .shadow_volume = KEYWORD_Volume_perfect,
      .shadow_path = KEYWORD_Path_auto,
      .shadow_offset = 1,
      .shadow_colored = true}},
    {"shadowMaps: { size: 256, filter: 3, cascades: 4, areaPoints: 7, colored: false, "
     "volume: blurred, path: copy, offset: 2.5, stretched: true }\n",
     {.shadow_size = 256,
      .shadow_filter = 3,
      .shadow_cascades = 4,
      .shadow_points = 7,
      .shadow_volume = KEYWORD_Volume_blurred,
      .shadow_path = KEYWORD_Path_copy,
      .shadow_offset = 2.5,
      .shadow_stretched = true}},
};

static void check_shadows(const Scene *is, const Scene *should_be, const char *text)
{
    CHECK(shadow_size);
    CHECK(shadow_filter);
    CHECK(shadow_cascades);
    CHECK(shadow_points);
    CHECK(shadow_volume);
    CHECK(shadow_path);
    CHECK(shadow_offset);
    CHECK(shadow_stretched);
    CHECK(shadow_colored);
}

#define DIVIDING                                                                                   \
    .skirts = KEYWORD_Skirts_auto, .near = 4, .detail = 250, .symbol = KEYWORD_Symbol_square

static const Row displacement_rows[] = {
    {"",
     {.displaced_by = KEYWORD_Displacing_mesh,
      .displaced_triangles = 131072,
      .dividing = {DIVIDING}}},
    {"displacement: { level: 9, triangles: 77 }\n",
     {.displaced_by = KEYWORD_Displacing_mesh,
      .displaced_level = 9,
      .displaced_triangles = 77,
      .dividing = {DIVIDING}}},
    {"displacement: { method: bisection, pixels: .5, triangles: 5000 }\n",
     {.displaced_by = KEYWORD_Displacing_bisection,
      .displaced_pixels = .5,
      .displaced_triangles = 5000,
      .dividing = {DIVIDING}}},
    {"displacement: { method: points, level: 3, spread: .75, symbol: sphere }\n",
     {.displaced_by = KEYWORD_Displacing_points,
      .displaced_level = 3,
      .displaced_triangles = 131072,
      .dividing = {.skirts = KEYWORD_Skirts_auto,
                   .near = 4,
                   .detail = 250,
                   .spread = .75,
                   .symbol = KEYWORD_Symbol_sphere}}},
    {"displacement: { method: feedback, near: -3, detail: 40, steps: 5, push: 2, bulge: .25, "
     "skirts: borders }\n",
     {.displaced_by = KEYWORD_Displacing_feedback,
      .displaced_triangles = 131072,
      .dividing = {.skirts = KEYWORD_Skirts_borders,
                   .symbol = KEYWORD_Symbol_square,
                   .near = -3,
                   .detail = 40,
                   .push = 2,
                   .bulge = .25,
                   .steps = 5}}},
};

static void check_displacement(const Scene *is, const Scene *should_be, const char *text)
{
    CHECK(displaced);
    CHECK(displaced_by);
    CHECK(displaced_pixels);
    CHECK(displaced_level);
    CHECK(displaced_triangles);
    CHECK(dividing.skirts);
    CHECK(dividing.symbol);
    CHECK(dividing.spread);
    CHECK(dividing.near);
    CHECK(dividing.detail);
    CHECK(dividing.push);
    CHECK(dividing.bulge);
    CHECK(dividing.steps);
}

static const Row voxel_rows[] = {
    {"", {.voxel_size = 128}},
    {"voxels: { size: 32 }\n", {.voxel_size = 32}},
};

static void check_voxels(const Scene *is, const Scene *should_be, const char *text)
{
    CHECK(voxel_size);
}

static const Row tools_rows[] = {
    {"", {.tools = {.grid_cells = 10, .grid_step = 1, .axes_length = 1, .light_size = .5}}},
    {"tools: { grid: true, gridCells: 7 }\n",
     {.tools =
          {.grid = true, .grid_cells = 7, .grid_step = 1, .axes_length = 1, .light_size = .5}}},
    {"tools: { axes: true, axesLength: 3 }\n",
     {.tools =
          {.axes = true, .grid_cells = 10, .grid_step = 1, .axes_length = 3, .light_size = .5}}},
    {"tools: { lights: true, lightSize: .125, gridStep: .25 }\n",
     {.tools = {.lights = true,
                .grid_cells = 10,
                .grid_step = .25,
                .axes_length = 1,
                .light_size = .125}}},
};

static void check_tools(const Scene *is, const Scene *should_be, const char *text)
{
    CHECK(tools.grid);
    CHECK(tools.axes);
    CHECK(tools.lights);
    CHECK(tools.grid_cells);
    CHECK(tools.grid_step);
    CHECK(tools.axes_length);
    CHECK(tools.light_size);
}

static const struct {
    const char *name;
    const Row *rows;
    int count;
    void (*check)(const Scene *is, const Scene *should_be, const char *text);
} parts[] = {
    {"image", image_rows, COUNT(image_rows), check_image},
    {"toneMapping", tone_rows, COUNT(tone_rows), check_tone},
    {"shadowMaps", shadow_rows, COUNT(shadow_rows), check_shadows},
    {"displacement", displacement_rows, COUNT(displacement_rows), check_displacement},
    {"voxels", voxel_rows, COUNT(voxel_rows), check_voxels},
    {"tools", tools_rows, COUNT(tools_rows), check_tools},
};

/* One part as its row says, all others by default. */
static void check_row(int part, int row)
{
    char text[1024];
    MatcDocument *document;
    snprintf(text, sizeof text, LIT_SPHERE "%s", parts[part].rows[row].text);
    Scene *scene = read_fine(text, &document);
    for (int i = 0; i < COUNT(parts); i++)
        parts[i].check(scene, &parts[i].rows[i == part ? row : 0].scene, text);
    forget(scene, document);
}

static void each_part(void **state)
{
    (void)state;
    for (int part = 0; part < COUNT(parts); part++)
        for (int row = 0; row < parts[part].count; row++)
            check_row(part, row);
    bool met[SCENE_KIND_COUNT] = {false};
    for (int row = 0; row < COUNT(tone_rows); row++)
        met[tone_rows[row].scene.tone] = true;
    all_kinds_met(SCENE_SORT_toneMapping, met);
}

static void all_parts_at_once(void **state)
{
    (void)state;
    char text[4096] = LIT_SPHERE;
    MatcDocument *document;
    for (int i = 0; i < COUNT(parts); i++)
        strncat(text, parts[i].rows[parts[i].count - 1].text, sizeof text - strlen(text) - 1);
    Scene *scene = read_fine(text, &document);
    for (int i = 0; i < COUNT(parts); i++)
        parts[i].check(scene, &parts[i].rows[parts[i].count - 1].scene, text);
    forget(scene, document);
}

#define NUMBERS                                                                                    \
    .samples = 1, .contrast = 1, .weight = KEYWORD_Weight_none,                                    \
    .distribution = KEYWORD_Distribution_cosine, .bounces = 1, .gain = 1, .moving = 1
#define DEFAULTS NUMBERS, .jitter = true, .checked = true, .directional = true
#define AUTO                                                                                       \
    .method = KEYWORD_Indirect_auto, .rays = 8, .coarse = 1, .march = KEYWORD_March_space, NOISE,  \
    SMOOTH
#define NOISE  .sequence = KEYWORD_Sequence_sobol, .rotation = KEYWORD_Rotation_tile
#define SMOOTH .filter = KEYWORD_Filter_separable
/* Values that the thesis' presets share: Hammersley's points, random shifts and no filter. */
#define THESIS                                                                                     \
    DEFAULTS, .coarse = 1, .sequence = KEYWORD_Sequence_hammersley,                                \
              .rotation = KEYWORD_Rotation_random, .filter = KEYWORD_Filter_none
#define THESIS_MARCH .method = KEYWORD_Indirect_march, THESIS

static const struct {
    const char *text;
    SceneIndirect indirect;
} indirect_rows[] = {
    {"",
     {.method = KEYWORD_Indirect_none,
      .rays = 8,
      .coarse = 1,
      .march = KEYWORD_March_space,
      DEFAULTS,
      NOISE,
      SMOOTH}},
    {"indirect: {}\n", {AUTO, DEFAULTS}},
    {"indirect: { jitter: false }\n", {AUTO, NUMBERS, .checked = true, .directional = true}},
    {"indirect: { checked: false }\n", {AUTO, NUMBERS, .jitter = true, .directional = true}},
    {"indirect: { directional: false }\n", {AUTO, NUMBERS, .jitter = true, .checked = true}},
    {"indirect: { method: screen, rays: 5, samples: 6, error: .125, history: 7, steps: 9, "
     "radius: 2.5, offset: .25, thickness: .75, contrast: 1.5, weight: quadratic, "
     "distribution: uniform, sequence: halton, rotation: blue, jitter: false, march: picture, "
     "checked: false, bounces: 3, gain: 4, resolution: quarter, moving: half, filter: atrous, "
     "filterSize: 11, directional: false, dimsDirect: true }\n",
     {.method = KEYWORD_Indirect_screen,
      .rays = 5,
      .samples = 6,
      .steps = 9,
      .history = 7,
      .error = .125,
      .radius = 2.5,
      .offset = .25,
      .thickness = .75,
      .contrast = 1.5,
      .weight = KEYWORD_Weight_quadratic,
      .distribution = KEYWORD_Distribution_uniform,
      .sequence = KEYWORD_Sequence_halton,
      .rotation = KEYWORD_Rotation_blue,
      .march = KEYWORD_March_picture,
      .filter = KEYWORD_Filter_atrous,
      .filter_size = 11,
      .coarse = 4,
      .moving = 2,
      .dims_direct = true,
      .bounces = 3,
      .gain = 4}},
    {"indirect: { quality: draft }\n",
     {.method = KEYWORD_Indirect_auto,
      .rays = 2,
      .coarse = 1,
      .march = KEYWORD_March_space,
      DEFAULTS,
      NOISE,
      SMOOTH}},
    {"indirect: { quality: fine }\n",
     {.method = KEYWORD_Indirect_auto,
      .rays = 64,
      .coarse = 1,
      .march = KEYWORD_March_space,
      DEFAULTS,
      NOISE,
      .filter = KEYWORD_Filter_atrous}},
    {"indirect: { preset: thesisMarch }\n",
     {.rays = 12, .steps = 10, .radius = 1.5, .march = KEYWORD_March_space, THESIS_MARCH}},
    {"indirect: { preset: thesisPoints }\n",
     {.rays = 32,
      .radius = 1.5,
      .march = KEYWORD_March_space,
      .method = KEYWORD_Indirect_points,
      THESIS}},
    {"indirect: { preset: thesisBuddha }\n",
     {.rays = 32, .steps = 32, .radius = 4, .march = KEYWORD_March_voxels, THESIS_MARCH}},
    {"indirect: { preset: thesisSheep }\n",
     {.rays = 24, .steps = 20, .radius = 3.5, .march = KEYWORD_March_voxels, THESIS_MARCH}},
    {"indirect: { preset: thesisDragons }\n",
     {.rays = 32, .steps = 20, .radius = 3.5, .march = KEYWORD_March_voxels, THESIS_MARCH}},
};

static void check_indirect(const SceneIndirect *is, const SceneIndirect *should_be,
                           const char *text)
{
    CHECK(method);
    CHECK(rays);
    CHECK(samples);
    CHECK(steps);
    CHECK(history);
    CHECK(error);
    CHECK(radius);
    CHECK(offset);
    CHECK(thickness);
    CHECK(contrast);
    CHECK(weight);
    CHECK(distribution);
    CHECK(sequence);
    CHECK(rotation);
    CHECK(march);
    CHECK(filter);
    CHECK(filter_size);
    CHECK(coarse);
    CHECK(moving);
    CHECK(jitter);
    CHECK(checked);
    CHECK(directional);
    CHECK(dims_direct);
    CHECK(bounces);
    CHECK(gain);
}

static void indirect_light(void **state)
{
    (void)state;
    for (int i = 0; i < COUNT(indirect_rows); i++) {
        char text[1024];
        MatcDocument *document;
        snprintf(text, sizeof text, LIT_SPHERE "%s", indirect_rows[i].text);
        Scene *scene = read_fine(text, &document);
        check_indirect(&scene->indirect, &indirect_rows[i].indirect, text);
        forget(scene, document);
    }
}

/* Writes the settings of a keyword of `quality`, from the table: "rays: 4, resolution: half". */
static void put_keys(Keyword word, char *text, size_t size)
{
    *text = 0;
    for (int i = 0; i < scene_preset_count; i++) {
        const ScenePresetRow *row = &scene_preset_table[i];
        const ParamRow *param = &scene_param_table[row->param].param;
        const size_t at = strlen(text);
        if (row->key != S_Indirect_quality || row->word != word)
            continue;
        if (param_is_word(param))
            snprintf(text + at, size - at, "%s%s: %s", at ? ", " : "", param->name,
                     keyword_table[(int)row->value].name);
        else
            snprintf(text + at, size - at, "%s%s: %.17g", at ? ", " : "", param->name, row->value);
    }
}

/* Each quality is read like its settings, and `normal` like none. */
static void quality_is_its_keys(void **state)
{
    (void)state;
    for (Keyword word = KEYWORD_Quality_draft; word <= KEYWORD_Quality_fine; word++) {
        char keys[512], by_keys[1024], by_quality[1024];
        MatcDocument *documents[2];
        put_keys(word, keys, sizeof keys);
        assert_true((*keys != 0) == (word != KEYWORD_Quality_normal));
        snprintf(by_keys, sizeof by_keys, LIT_SPHERE "indirect: { %s }\n", keys);
        snprintf(by_quality, sizeof by_quality, LIT_SPHERE "indirect: { quality: %s }\n",
                 keyword_table[word].name);
        Scene *a = read_fine(by_keys, &documents[0]), *b = read_fine(by_quality, &documents[1]);
        check_indirect(&b->indirect, &a->indirect, by_quality);
        forget(a, documents[0]);
        forget(b, documents[1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_part),
        cmocka_unit_test(all_parts_at_once),
        cmocka_unit_test(indirect_light),
        cmocka_unit_test(quality_is_its_keys),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
