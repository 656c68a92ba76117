/* Image readers, one per format. A reader fills in size, bits and alpha, and if the session
 * needs them the texels: RGBA, bottom row first. It returns NULL or a fault. Files are
 * untrusted: a header alone causes no large allocation. */
#ifndef MATC_IMAGE_FILE_H
#define MATC_IMAGE_FILE_H
#include "compiler/graph/resolver.h"

typedef struct {
    Session *session;
    const char *at, *end; /* range of the unread bytes */
    size_t capacity;      /* bytes that images may still use */
    Image *image;         /* the image being read */
    Arena memory;         /* texels and decoder memory: freed if the file is broken */
} ImageFile;

const char *image_png(ImageFile *file);
const char *image_jpeg(ImageFile *file);
const char *image_exr(ImageFile *file);
const char *image_bmp(ImageFile *file);

/* Faults common to all formats. */
extern const char image_file_cut[], image_file_too_large[], image_file_too_many[];
/* Checks the size in a header. Returns NULL or a fault; a size of 0 is a fault. */
const char *image_file_check_side(double width, double height);
/* Returns the bytes that a decoded image occupies. */
size_t image_file_size(const Image *image);
/* Allocates the image's texels. Returns NULL, or a fault if the limit of image memory is
 * exceeded. Readers decode a first part before this call, so that a file with broken data causes
 * no large allocation. */
const char *image_file_allocate(ImageFile *file);
#endif
