/* Pictures that documents name. */
#ifndef MATC_IMAGE_H
#define MATC_IMAGE_H
#include "compiler/graph/resolver.h"

/* Loads a picture file; NULL and a diagnostic when it cannot. Equal paths are one image. */
const Image *image_load(Resolver *r, const char *path, Span span);
#endif
