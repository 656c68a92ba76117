/* Light by way of surfaces, of one bounce and of four, against Cycles, which traces paths: tests/reference/README.md. All of a frame's light, less that of lamps, where Cycles says that no edge is. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_draw.h"
#include "tests/frame/reference_picture.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 1 << 14, BLOCK = 4 };
#define FOLDER SOURCE_FOLDER "/tests/reference/cycles/"

/* The document, its line `indirect:` replaced. */
static void read_text(const char *keys, char text[TEXT])
{
    FILE *file = fopen(FOLDER "bounced.yaml", "rb");
    char line[TEXT / 8];
    assert_non_null(file);
    *text = 0;
    while (fgets(line, sizeof line, file))
        strcat(text, strncmp(line, "indirect:", strlen("indirect:")) != 0 ? line : keys);
    fclose(file);
}

static float *draw(GlContext *gl, Render *render, const MatcOptions *options, const char *keys)
{
    char text[TEXT];
    MatcDocument *document;
    read_text(keys, text);
    Scene *scene = frame_scene(text, options, &document);
    float *rgba = frame_floats_by(gl, render, scene);
    frame_forget(scene, document);
    return rgba;
}

/* Over means of 4 x 4 pixels, as paths are noise: root of the mean square off, and how much more in the mean, both over the mean of light. */
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
                    mean[k] += ((double)all[4 * pixel + k] - (double)direct[4 * pixel + k]) / (BLOCK * BLOCK);
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

static void bounces_are_those_of_paths(void **state)
{
    (void)state;
    static const struct {
        const char *name, *keys;
        double off, more; /* at most */
    } cases[] = {
        {"cycles/bounced_1", "indirect: { bounces: 1, rays: 64, radius: 8 }\n", .035, .02},
        {"cycles/bounced_1", "indirect: { bounces: 1, radius: 8 }\n", .045, .02},
        {"cycles/bounced_4", "indirect: { bounces: 4, rays: 16, radius: 8 }\n", .04, .02},
    };
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    Render *render = render_open(gl, &(RenderOptions){.compile = &options, .view = "light", .deep = true});
    float *direct = draw(gl, render, &options, "");
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        ReferencePicture picture;
        assert_true(reference_picture_read(cases[i].name, &picture));
        float *all = draw(gl, render, &options, cases[i].keys);
        const Result result = compare(&picture, all, direct);
        print_message("%s, %.*s: %.4f off, %.2f %% more in the mean, of %d blocks\n", cases[i].name,
                      (int)strcspn(cases[i].keys, "\n"), cases[i].keys, result.off, 100 * result.more, result.blocks);
        assert_true(result.blocks > 300 && result.off < cases[i].off && fabs(result.more) < cases[i].more);
        free(all);
        reference_picture_free(&picture);
    }
    free(direct);
    render_close(render);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(bounces_are_those_of_paths)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
