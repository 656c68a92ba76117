/* Documents for the benchmarks of batches. */
#ifndef BATCH_DOCUMENTS_H
#define BATCH_DOCUMENTS_H
#include "compiler/base/text.h"

enum { DIFFERENT_DOCUMENTS = 8 * 8 * 6 * 12 * 4 * 4 * 3, SCENE_PICTURES = 8 };

/* A material of ordinary size, as no other index below DIFFERENT_DOCUMENTS is built; few of them
 * come to the same program, since an Abs of what is never negative, for one, goes. */
void batch_different(int index, Text *out);
/* A material of a game's scene: of a family, many of which share a structure and differ in colours,
 * scales and pictures; some have a part that others of the family lack. `family` is set to its
 * name. */
void batch_scene(int index, Text *out, const char **family);
/* Pictures that documents ask for are these, beside them. */
void batch_picture(int index, char name[32]);
#endif
