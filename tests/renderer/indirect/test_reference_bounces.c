/* Indirect light of one bounce and of four, against path tracing by Cycles:
 * tests/reference/README.md. Compares a frame's light minus that of lamps, at pixels that
 * Cycles' mask marks as no edge.
 *
 *   test_reference_bounces N KEYS...      drawn N times as wide and high, and averaged: one
 *   bounce with each of these keys */
/* ctest: unsanitized */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_picture.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 1 << 14, BLOCK = 4, EDGE = 128 };
#define FOLDER SOURCE_FOLDER "/tests/reference/cycles/"

/* Reads the document with its lines `indirect:` and `image:` replaced. */
static void read_text(const char *keys, int times, char text[TEXT])
{
    static const char image[] = "image: { width: ";
    FILE *file = fopen(FOLDER "bounced.yaml", "rb");
    char line[TEXT / 8];
    assert_non_null(file);
    *text = 0;
    while (fgets(line, sizeof line, file)) {
        if (!strncmp(line, image, strlen(image)))
            snprintf(line, sizeof line, "%s%d, height: %d }\n", image, EDGE * times, EDGE * times);
        strcat(text, strncmp(line, "indirect:", strlen("indirect:")) != 0 ? line : keys);
    }
    fclose(file);
}

/* Draws at `times` times the size, and averages. */
static float *draw(GlContext *gl, Renderer *renderer, int times, const char *keys)
{
    const MatcOptions options = frame_exact_options();
    char text[TEXT];
    MatcDocument *document;
    read_text(keys, times, text);
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats_by(gl, renderer, scene),
          *mean = calloc(4 * EDGE * EDGE, sizeof *mean);
    assert_true(mean && scene->width == EDGE * times && scene->height == EDGE * times);
    for (int i = 0; i < 4 * EDGE * times * EDGE * times; i++) {
        const int component = i % 4, x = i / 4 % (EDGE * times) / times,
                  y = i / 4 / (EDGE * times) / times;
        mean[4 * (y * EDGE + x) + component] += rgba[i] / (float)(times * times);
    }
    free(rgba);
    frame_forget(scene, document);
    return mean;
}

/* Over means of 4 x 4 pixels, because path tracing is noisy: root mean square error, and mean
 * excess, both relative to the mean light. */
typedef struct {
    double off, more;
    int blocks;
} Result;

static Result compare(const ReferencePicture *picture, const float *all, const float *direct)
{
    Result result = {0};
    double wanted = 0, found = 0, squares = 0;
    for (int y = 0; y + BLOCK <= picture->height; y += BLOCK)
        for (int x = 0; x + BLOCK <= picture->width; x += BLOCK) {
            double mean[3] = {0}, right[3] = {0}, light = 0;
            bool even = true;
            for (int i = 0; i < BLOCK * BLOCK; i++) {
                const int pixel = (y + i / BLOCK) * picture->width + x + i % BLOCK;
                even &= picture->rgba[4 * pixel + 3] == 1;
                for (int k = 0; k < 3; k++) {
                    mean[k] += ((double)all[4 * pixel + k] - (double)direct[4 * pixel + k]) /
                               (BLOCK * BLOCK);
                    right[k] += (double)picture->rgba[4 * pixel + k] / (BLOCK * BLOCK);
                }
            }
            if (!even)
                continue;
            for (int k = 0; k < 3; k++) {
                squares += (mean[k] - right[k]) * (mean[k] - right[k]) / 3;
                light += right[k] / 3;
                found += mean[k] / 3;
            }
            wanted += light;
            result.blocks++;
        }
    result.off = sqrt(squares / result.blocks) / (wanted / result.blocks);
    result.more = found / wanted - 1;
    return result;
}

typedef struct {
    const char *name, *keys;
    double off, more; /* at most */
} Case;

static void try_cases(int times, const Case *cases, int count)
{
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Renderer *renderer =
        renderer_open(gl, &(RendererOptions){.compile = &options, .view = "light", .deep = true});
    float *direct = draw(gl, renderer, times, "");
    for (int i = 0; i < count; i++) {
        ReferencePicture picture;
        assert_true(reference_picture_read(cases[i].name, &picture));
        float *all = draw(gl, renderer, times, cases[i].keys);
        const Result result = compare(&picture, all, direct);
        print_message("%s, %.*s: %.4f off, %.2f %% more in the mean, of %d blocks\n", cases[i].name,
                      (int)strcspn(cases[i].keys, "\n"), cases[i].keys, result.off,
                      100 * result.more, result.blocks);
        assert_true(result.blocks > 300 && result.off < cases[i].off &&
                    fabs(result.more) < cases[i].more);
        free(all);
        reference_picture_free(&picture);
    }
    free(direct);
    renderer_close(renderer);
    gl_close(gl);
}

static void bounces_are_those_of_paths(void **state)
{
    (void)state;
    static const Case cases[] = {
        {"cycles/bounced_1", "indirect: { bounces: 1, rays: 64, radius: 8 }\n", .035, .02},
        {"cycles/bounced_1", "indirect: { bounces: 1, radius: 8 }\n", .045, .02},
        {"cycles/bounced_4", "indirect: { bounces: 4, rays: 16, radius: 8 }\n", .04, .02},
    };
    static const Case large = {"cycles/bounced_1", "indirect: { bounces: 1, radius: 8 }\n", .02,
                               .005};
    try_cases(1, cases, sizeof cases / sizeof *cases);
    try_cases(4, &large, 1);
}

static int print_cases(int times, char **keys, int count)
{
    for (int i = 0; i < count && times > 0; i++) {
        char text[TEXT / 8];
        snprintf(text, sizeof text, "indirect: { bounces: 1, radius: 8, %s }\n", keys[i]);
        try_cases(times, &(Case){"cycles/bounced_1", text, 9, 9}, 1);
    }
    return times <= 0;
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bounces_are_those_of_paths)};
    if (argc > 2)
        return print_cases(atoi(argv[1]), argv + 2, argc - 2);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
