/* OpenEXR files that are refused: kinds that matc does not support, truncated and altered files,
 * headers that claim more data than the file holds. */
#include "tests/test.h"
#include "tests/exr_file.h"
#include "tests/sanitized.h"
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static void kinds_that_are_refused(void **state)
{
    (void)state;
    static const struct {
        ExrHeader header;
        const char *why;
    } rows[] = {
        {{SMALL, "Z", {FLOAT}, 0, 0, 0}, "none of the channels R, G, B, A and Y"},
        {{SMALL, "A", {FLOAT}, 0, 0, 0}, "none of the channels R, G, B, A and Y"},
        {{SMALL, "BGR", {HALF, UINT, HALF}, 0, 0, 0}, "channels are integers"},
        {{WINDOW(4, 4), WINDOW(4, 4), "Y", {HALF}, 0, 2, 0}, "subsampled"},
        {{SMALL, "Y", {HALF}, B44, 0, 0}, "use none, RLE, ZIPS, ZIP or PIZ"},
        {{WINDOW(1, 1), WINDOW(LIMIT_IMAGE_SIDE + 1, 1), "Y", {HALF}, 0, 0, 0},
         "the image is too large"},
        {{WINDOW(1, 1), {0, 0, -1, 0}, "Y", {HALF}, 0, 0, 0}, ""},
        {{WINDOW(1, 1), {INT32_MIN, 0, INT32_MAX, 0}, "Y", {HALF}, 0, 0, 0}, ""},
    };
    static PictureFile file;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int pixels = 0; pixels < 2; pixels++) {
            exr_put_file(&file, &rows[i].header);
            picture_refused(&file, picture_alone, pixels, rows[i].why);
        }
}

/* A number that is none or infinite would spread over its neighbors. */
static void numbers_are_finite(void **state)
{
    (void)state;
    static const ExrHeader header = {SMALL, "Y", {HALF}, 0, 0, 0};
    static const double numbers[] = {NAN, INFINITY, -INFINITY};
    static PictureFile file;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        exr_put_file(&file, &header);
        file.size -= 2;
        exr_put_sample(&file, HALF, numbers[i]);
        picture_refused(&file, picture_alone, true, "a pixel is infinite or NaN");
    }
}

/* Two lines of three halves, each as `size` bytes. */
static void exr_put_short(PictureFile *file, int compression, const char *bytes, int size)
{
    exr_put_header(file, &(ExrHeader){SMALL, "Y", {HALF}, compression, 0, 0});
    for (int row = 0; row < 2; row++)
        exr_put_int(file, (int64_t)file->size + (2 - row) * 8 + row * (size + 8), 8);
    for (int row = 0; row < 2; row++) {
        exr_put_int(file, row, 4);
        exr_put_int(file, size, 4);
        picture_put(file, bytes, (size_t)size);
    }
}

/* Packed data must make all lines of a block: here two bytes, or five of six. */
static void blocks_are_whole(void **state)
{
    (void)state;
    static PictureFile file;
    exr_put_short(&file, EXR_COMPRESSION_RLE, "\1\0", 2);
    picture_refused(&file, picture_alone, true, "");
    exr_put_short(&file, EXR_COMPRESSION_RLE, "\4\200", 2);
    picture_refused(&file, picture_alone, true, "");
    /* 128 is no difference to the byte before: all are 0 */
    exr_put_short(&file, EXR_COMPRESSION_RLE, "\5\200", 2);
    MatcDocument *document = picture_read(&file, picture_alone, true);
    assert_non_null(picture_of(document)->texels);
    matc_document_free(document);
    exr_put_short(&file, UNCOMPRESSED, "\0\1\2\3\4", 5);
    picture_refused(&file, picture_alone, true, "");
    exr_put_short(&file, EXR_COMPRESSION_ZIPS, "\170\234\3\0\0\0\0\1", 8);
    picture_refused(&file, picture_alone, true, "");
}

/* A header speaks of much: nothing is allocated for what cannot be there. */
static void large(void **state)
{
    (void)state;
    static PictureFile file;
    for (int k = 0; k < EXR_COMPRESSIONS; k++) {
        const ExrHeader h = {WINDOW(LIMIT_IMAGE_SIDE, LIMIT_IMAGE_SIDE),
                             WINDOW(LIMIT_IMAGE_SIDE, LIMIT_IMAGE_SIDE),
                             "Y",
                             {HALF},
                             exr_compressions[k],
                             0,
                             0};
        exr_put_header(&file, &h);
        /* and not that it needs too much memory */
        picture_refused(&file, picture_alone, true, "the file is truncated");
        MatcDocument *document = picture_read(&file, picture_alone, false);
        assert_int_equal(picture_of(document)->width, LIMIT_IMAGE_SIDE);
        matc_document_free(document);
    }
}

/* Every length of a file that is cut off is an error; a byte that is another is one, or another
 * picture. */
static void broken(void **state)
{
    (void)state;
    static PictureFile file;
    for (int k = 0; k < EXR_COMPRESSIONS; k++) {
        const ExrHeader h = {
            WINDOW(5, 3),  WINDOW(5, 3), "ABGR", {HALF, HALF, HALF, HALF}, exr_compressions[k], 0,
            k % 2 ? 16 : 0};
        exr_write_file(&file, &h);
        const size_t whole = file.size;
        for (file.size = 4; file.size < whole; file.size += 3)
            picture_refused(&file, picture_alone, true, "cannot read the image 'a'");
        file.size = whole;
        for (size_t i = 4; i < whole; i++) {
            file.bytes[i] ^= 0x55;
            matc_document_free(picture_read(&file, picture_alone, true));
            file.bytes[i] ^= 0x55;
        }
        exr_check(&file, &h, false);
    }
}

enum { MAX_KIB = 16 << 10 };

/* A document of so many pictures of that file, under as many names. */
static char *many(int count)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    fputs("material: Phong\ndiffuse:\n  map: Blend\n  blend:\n", out);
    for (int i = 0; i < count; i++)
        fprintf(out, "  - { value: %d, input: { map: ImageMap, image: a%d } }\n", i, i);
    fclose(out);
    return text;
}

static long resident(void)
{
    struct rusage used;
    getrusage(RUSAGE_SELF, &used);
    return used.ru_maxrss;
}

/* Reads the pictures in a process of its own, whose greatest resident size may grow by so much. */
static void take_little(PictureFile *file, int count)
{
    char *text = many(count);
    int status;
    const pid_t child = fork();
    if (!child) {
        const long before = resident();
        MatcDocument *document = picture_read(file, text, true);
        const long grown = resident() - before;
        fprintf(stderr, "%d broken pictures: %ld KiB\n", count, grown);
        _exit(matc_error_count(document) == count && grown < MAX_KIB ? 0 : 1);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    assert_int_equal(status, 0);
    free(text);
}

/* Each would have 64 MiB of texels. Its first block does not decode, and there is no room for them
 * before. */
static void first_block_is_broken(void **state)
{
    (void)state;
    enum { SIDE = 2048, CHUNKS = SIDE / 32 /* lines of a block */, PACKED = 512 };
    static PictureFile file;
    const ExrHeader h = {
        WINDOW(SIDE, SIDE), WINDOW(SIDE, SIDE), "Y", {HALF}, EXR_COMPRESSION_PIZ, 0, 0};
    if (SANITIZED) /* whose allocator keeps what is freed */
        skip();
    exr_put_header(&file, &h);
    for (int i = 0; i < CHUNKS; i++)
        exr_put_int(&file, (int64_t)file.size + 8 * (CHUNKS - i), 8);
    exr_put_int(&file, 0, 4);
    exr_put_int(&file, PACKED, 4);
    for (int i = 0; i < PACKED; i += 8)
        exr_put_int(&file, -1, 8);
    take_little(&file, 20);
}

/* Each has 256 KiB of texels when its last block turns out to be cut, which go with it. */
static void last_block_is_broken(void **state)
{
    (void)state;
    static PictureFile file;
    const ExrHeader h = {
        WINDOW(128, 128), WINDOW(128, 128), "Y", {HALF}, EXR_COMPRESSION_ZIPS, 0, 0};
    if (SANITIZED)
        skip();
    exr_write_file(&file, &h);
    file.size -= 3;
    take_little(&file, 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kinds_that_are_refused),
        cmocka_unit_test(numbers_are_finite),
        cmocka_unit_test(blocks_are_whole),
        cmocka_unit_test(large),
        cmocka_unit_test(broken),
        cmocka_unit_test(first_block_is_broken),
        cmocka_unit_test(last_block_is_broken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
