/* File callbacks for assimp: open regular files of at most MODEL_FILE_MIB. Pipes, devices and
 * folders are reported as missing. */
#ifndef MATC_SCENE_MODEL_OPEN_H
#define MATC_SCENE_MODEL_OPEN_H
#ifdef MATC_ASSIMP
#include <assimp/cfileio.h>

struct aiFileIO model_open_files(const char *root); /* NULL: no restriction; see root.h */
#endif
#endif
