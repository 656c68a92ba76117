/* Images that documents name. */
#ifndef MATC_IMAGE_H
#define MATC_IMAGE_H
#include "compiler/graph/resolver.h"

/* Loads an image file. Returns NULL after reporting a fault. Equal paths share one image. */
const Image *image_load(Resolver *r, const char *path, Span span);
#endif
