/* Readers of picture files, one a format. Each gives the header's size, bits and alpha, and where
 * the session wants them the texels: RGBA, the bottom row first. NULL, or what is wrong. The file
 * is untrusted: a header alone takes no memory. */
#ifndef MATC_IMAGE_FILE_H
#define MATC_IMAGE_FILE_H
#include "compiler/graph/resolver.h"

typedef struct {
    Session *session;
    const char *at, *end; /* what is not read yet */
    size_t room;          /* bytes that pictures may still take */
    Image *image;         /* that is being read */
    Arena memory;         /* the texels, and what decoding takes: freed where the file is broken */
} ImageFile;

const char *image_png(ImageFile *file);
const char *image_jpeg(ImageFile *file);
const char *image_exr(ImageFile *file);
const char *image_bmp(ImageFile *file);

/* Faults that all formats have. */
extern const char image_file_cut[], image_file_too_large[], image_file_too_many[];
/* NULL, or what is wrong with the size that a header speaks of; a size of 0 is. */
const char *image_file_check_side(double width, double height);
/* Bytes that an image takes, decoded. */
size_t image_file_size(const Image *image);
/* NULL and the texels, which are the image's; or what is wrong: there is no room. A reader decodes
 * the first of them before, so that a file whose data are broken at once takes no memory. */
const char *image_file_allocate(ImageFile *file);
#endif
