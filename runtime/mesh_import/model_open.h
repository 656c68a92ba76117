/* How assimp opens files: regular ones of at most MODEL_FILE_MIB. A pipe, a device or a folder that
 * a mesh names is as if it were not there. */
#ifndef MATC_SCENE_MODEL_OPEN_H
#define MATC_SCENE_MODEL_OPEN_H
#ifdef MATC_ASSIMP
#include <assimp/cfileio.h>

struct aiFileIO model_open_files(const char *root); /* NULL: anywhere; root.h */
#endif
#endif
