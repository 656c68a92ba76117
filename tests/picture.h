/* Picture files that a test makes in memory, so that their texels are known, and their texels as
 * the product reads them. */
#ifndef TESTS_PICTURE_H
#define TESTS_PICTURE_H
#include "compiler/document.h"
#include "compiler/pipeline.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PICTURE_CAPACITY = 1 << 17 };

typedef struct {
    uint8_t bytes[PICTURE_CAPACITY];
    size_t size;
} PictureFile;

static inline void picture_put(PictureFile *file, const void *bytes, size_t size)
{
    assert_true(file->size + size <= PICTURE_CAPACITY);
    if (size)
        memcpy(file->bytes + file->size, bytes, size);
    file->size += size;
}

/* Documents name their pictures a and, if there are two files, b. */
static const char picture_alone[] =
    "material: Phong\ndiffuse: { map: ImageMap, image: a, bilinearFiltering: false }\n";

static inline char *picture_give(void *user, const char *path, size_t *size, const char **why)
{
    const PictureFile *file = (const PictureFile *)user + (path[0] == 'b');
    (void)why;
    char *copy = malloc(file->size + 1);
    assert_non_null(copy);
    memcpy(copy, file->bytes, file->size);
    copy[file->size] = 0;
    *size = file->size;
    return copy;
}

static inline MatcDocument *picture_read(PictureFile *files, const char *text, bool pixels)
{
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = pixels;
    options.read_file = picture_give;
    options.user = files;
    return matc_read("a.yaml", text, strlen(text), &options);
}

/* The document's first picture, which must have texels. */
static inline const Image *picture_of(const MatcDocument *document)
{
    if (!document->graph)
        fail_msg("%s", matc_diagnostics((MatcDocument *)(uintptr_t)document, MATC_TEXT));
    return document->graph->images[0];
}

/* Content of a file: RGBA, the bottom row first; bytes, 16-bit words or floats by `bits`. */
typedef struct {
    int width, height, bits;
    bool opaque;
    const void *texels;
} PictureWanted;

static inline void picture_check(PictureFile *file, const PictureWanted *wanted)
{
    MatcDocument *document = picture_read(file, picture_alone, true);
    const Image *image = picture_of(document);
    assert_int_equal(image->width, wanted->width);
    assert_int_equal(image->height, wanted->height);
    assert_int_equal(image->bits, wanted->bits);
    assert_int_equal(image->opaque, wanted->opaque);
    assert_non_null(image->texels);
    assert_memory_equal(image->texels, wanted->texels,
                        (size_t)(wanted->width * wanted->height * wanted->bits / 2));
    matc_document_free(document);
}

/* Checks for exactly one error, whose message contains `text`. */
static inline void picture_refused(PictureFile *files, const char *text, bool pixels,
                                   const char *why)
{
    MatcDocument *document = picture_read(files, text, pixels);
    const char *reported = matc_diagnostics(document, MATC_TEXT);
    if (document->graph || matc_error_count(document) != 1 || !strstr(reported, why) ||
        !strstr(reported, text == picture_alone ? "a.yaml:2:34" : "a.yaml:"))
        fail_msg("'%s' is wanted, not '%s'", why, reported);
    matc_document_free(document);
}
#endif
