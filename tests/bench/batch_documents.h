/* Documents for the benchmarks of batches. */
#ifndef BATCH_DOCUMENTS_H
#define BATCH_DOCUMENTS_H
#include "compiler/base/text.h"

enum { DIFFERENT_DOCUMENTS = 8 * 8 * 6 * 12 * 4 * 4 * 3, SCENE_PICTURES = 8 };

/* A material of ordinary size; every index below DIFFERENT_DOCUMENTS has a distinct structure,
 * though a few compile to the same program, because for example an Abs of a nonnegative value is
 * removed. */
void batch_different(int index, Text *out);
/* A material of a game's scene: in a family many materials share a structure and differ in
 * colors, scales and pictures; some have a part that others lack. `family` is set to the
 * family's name. */
void batch_scene(int index, Text *out, const char **family);
/* Name of a picture that documents use, in their folder. */
void batch_picture(int index, char name[32]);
#endif
