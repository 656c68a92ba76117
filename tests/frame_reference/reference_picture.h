/* A picture written by tests/reference/render.py: linear light, and in alpha a mask of the
 * pixels to compare. RGBA, bottom row first. */
#ifndef MATC_REFERENCE_PICTURE_H
#define MATC_REFERENCE_PICTURE_H
#include "compiler/matc.h"

typedef struct {
    MatcDocument *document; /* owns the picture */
    int width, height;
    const float *rgba;
} ReferencePicture;

/* Reads a picture by folder and name: cycles/matt. Returns false on failure, with messages in
 * the document's diagnostics. */
bool reference_picture_read(const char *name, ReferencePicture *picture);
void reference_picture_free(ReferencePicture *picture);
#endif
