/* Picture files, read back by independent readers: PNG by libpng's simple interface and by its
 * chunks, OpenEXR by the compiler's reader of images and by the bytes of its chunks. A failed
 * write is reported, and leaves no file. */
#include "tests/test.h"
#include "runtime/viewer/picture_file.h"
#include <OpenEXR/openexr.h>
#include <math.h>
#include <png.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

enum { WIDTH = 37, HEIGHT = 41 }; /* blocks of 16 rows, the last one in part */

static char folder[] = "/tmp/picture_file.XXXXXX", path[64];

/* Multiples of 1/255, of 1/65535 or of 2^-10, below and above 1; the top row has y = 0. */
static float component_of(int x, int y, int component, int bits)
{
    const int number = (x * 131 + y * 517 + component * 29) % (bits == 8 ? 256 : 2048);
    return bits == 8 ? (float)number / 255 : bits == 32 ? (float)number / 3 : (float)number / 1024;
}

static void write_file(const PictureSpec *spec)
{
    const char *why = NULL;
    float row[WIDTH * 4];
    PictureFile *file = picture_file_open(spec, &why);
    assert_non_null(file);
    for (int y = 0; y < HEIGHT; y++) {
        for (int i = 0; i < WIDTH * 4; i++)
            row[i] = component_of(i / 4, y, i % 4, spec->bits);
        assert_null(picture_file_row(file, row));
    }
    assert_int_equal(access(path, F_OK), -1); /* nothing is there until it is whole */
    assert_null(picture_file_finish(file, path));
    picture_file_close(file);
}

static unsigned whole_of(double component, double most)
{
    return (unsigned)floor(fmin(component, 1) * most + .5);
}

static void read_png(const PictureSpec *spec)
{
    static uint16_t samples[WIDTH * HEIGHT * 4];
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_file(&image, path));
    assert_int_equal(image.width, WIDTH);
    assert_int_equal(image.height, HEIGHT);
    png_image_free(&image);
    FILE *in = fopen(path, "rb"); /* the samples as they stand there */
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    assert_true(in && png && info);
    png_init_io(png, in);
    png_read_info(png, info);
    assert_int_equal(png_get_bit_depth(png, info), spec->bits);
    assert_int_equal(png_get_channels(png, info), spec->components);
    assert_int_equal(png_get_valid(png, info, PNG_INFO_sRGB) != 0, spec->color);
    for (int y = 0; y < HEIGHT; y++) {
        png_byte row[WIDTH * 8];
        png_read_row(png, row, NULL);
        for (int i = 0; i < WIDTH * spec->components; i++)
            samples[i] = spec->bits == 8 ? row[i] : (uint16_t)(row[2 * i] << 8 | row[2 * i + 1]);
        for (int i = 0; i < WIDTH * spec->components; i++)
            assert_int_equal(samples[i], whole_of(component_of(i / spec->components, y,
                                                               i % spec->components, spec->bits),
                                                  spec->bits == 8 ? 255 : 65535));
    }
    png_destroy_read_struct(&png, &info, NULL);
    fclose(in);
}

static void pngs_hold_what_they_are_given(void **state)
{
    (void)state;
    static const PictureSpec specs[] = {{PICTURE_FORMAT_png, WIDTH, HEIGHT, 3, 8, true},
                                        {PICTURE_FORMAT_png, WIDTH, HEIGHT, 3, 16, true},
                                        {PICTURE_FORMAT_png, WIDTH, HEIGHT, 1, 8, false},
                                        {PICTURE_FORMAT_png, WIDTH, HEIGHT, 1, 16, false},
                                        {PICTURE_FORMAT_png, WIDTH, HEIGHT, 4, 16, true}};
    for (size_t i = 0; i < sizeof specs / sizeof *specs; i++) {
        write_file(&specs[i]);
        read_png(&specs[i]);
        unlink(path);
    }
}

static void read_block(exr_context_t exr, const PictureSpec *spec, int top)
{
    static float planes[4][16 * WIDTH];
    exr_chunk_info_t chunk;
    exr_decode_pipeline_t pipe = EXR_DECODE_PIPELINE_INITIALIZER;
    assert_int_equal(exr_read_scanline_chunk_info(exr, 0, top, &chunk), 0);
    assert_int_equal(exr_decoding_initialize(exr, 0, &chunk, &pipe), 0);
    assert_int_equal(pipe.channel_count, spec->components);
    for (int i = 0; i < pipe.channel_count; i++) {
        assert_int_equal(pipe.channels[i].data_type,
                         spec->bits == 16 ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT);
        pipe.channels[i].user_data_type = EXR_PIXEL_FLOAT;
        pipe.channels[i].user_bytes_per_element = 4;
        pipe.channels[i].user_pixel_stride = 4;
        pipe.channels[i].user_line_stride = 4 * WIDTH;
        pipe.channels[i].decode_to_ptr = (uint8_t *)planes[i];
    }
    assert_int_equal(exr_decoding_choose_default_routines(exr, 0, &pipe), 0);
    assert_int_equal(exr_decoding_run(exr, 0, &pipe), 0);
    for (int y = 0; y < chunk.height; y++)
        for (int x = 0; x < WIDTH; x++)
            for (int i = 0; i < spec->components; i++) {
                static const char order[] = "RGBA";
                const char *place = strchr(order, *pipe.channels[i].channel_name);
                const int component = place ? (int)(place - order) : 0;
                assert_true(planes[i][y * WIDTH + x] ==
                            component_of(x, top + y, component, spec->bits));
            }
    exr_decoding_destroy(exr, &pipe);
}

static void exrs_hold_what_they_are_given(void **state)
{
    (void)state;
    static const PictureSpec specs[] = {{PICTURE_FORMAT_exr, WIDTH, HEIGHT, 4, 16, true},
                                        {PICTURE_FORMAT_exr, WIDTH, HEIGHT, 4, 32, true},
                                        {PICTURE_FORMAT_exr, WIDTH, HEIGHT, 3, 32, false},
                                        {PICTURE_FORMAT_exr, WIDTH, HEIGHT, 1, 32, false}};
    for (size_t i = 0; i < sizeof specs / sizeof *specs; i++) {
        exr_context_t exr;
        struct stat info;
        write_file(&specs[i]);
        assert_int_equal(exr_start_read(&exr, path, NULL), 0);
        for (int top = 0; top < HEIGHT; top += 16)
            read_block(exr, &specs[i], top);
        exr_finish(&exr);
        assert_int_equal(stat(path, &info), 0); /* what repeats is compressed */
        assert_true(info.st_size < WIDTH * HEIGHT * specs[i].components * specs[i].bits / 8);
        unlink(path);
    }
}

static void what_fails_leaves_nothing(void **state)
{
    (void)state;
    const PictureSpec spec = {PICTURE_FORMAT_exr, 1, 2, 3, 16, true};
    const float pixel[4] = {.5f, .5f, .5f, 1};
    const char *why = NULL;
    PictureFile *file = picture_file_open(&spec, &why);
    assert_non_null(file);
    assert_null(picture_file_row(file, pixel));
    assert_null(picture_file_row(file, pixel));
    assert_string_equal(picture_file_finish(file, "/nowhere/at/all.exr"),
                        "No such file or directory");
    picture_file_close(file);
    file = picture_file_open(&spec, &why);
    assert_null(picture_file_row(file, pixel));
    assert_non_null(picture_file_finish(file, path)); /* a row is missing */
    picture_file_close(file);
    assert_int_equal(access(path, F_OK), -1);
}

/* On a full disk, simulated by a file size limit, the system's cause is reported, not a
 * library's message. */
static void full_disks_are_said(void **state)
{
    (void)state;
    static const PictureSpec specs[] = {{PICTURE_FORMAT_png, 1 << 10, 1 << 10, 4, 16, false},
                                        {PICTURE_FORMAT_exr, 1 << 10, 1 << 10, 4, 32, false}};
    static float row[4 << 10];
    struct rlimit before;
    unsigned number = 1;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    signal(SIGXFSZ, SIG_IGN);
    for (int i = 0; i < 2; i++) {
        const char *why = NULL;
        PictureFile *file = picture_file_open(&specs[i], &why);
        assert_non_null(file);
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &(struct rlimit){1 << 16, before.rlim_max}), 0);
        for (int y = 0; y < specs[i].height && !why; y++) {
            for (int k = 0; k < 4 << 10; k++)
                row[k] = (float)((number = number * 1664525 + 1013904223) >> 8) / (1 << 24);
            why = picture_file_row(file, row);
        }
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &before), 0);
        assert_non_null(why);
        assert_string_equal(why, "File too large");
        picture_file_close(file);
    }
    signal(SIGXFSZ, SIG_DFL);
}

int main(void)
{
    if (!mkdtemp(folder))
        abort();
    snprintf(path, sizeof path, "%s/picture", folder);
    const struct CMUnitTest tests[] = {cmocka_unit_test(pngs_hold_what_they_are_given),
                                       cmocka_unit_test(exrs_hold_what_they_are_given),
                                       cmocka_unit_test(what_fails_leaves_nothing),
                                       cmocka_unit_test(full_disks_are_said)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    rmdir(folder);
    return failed;
}
