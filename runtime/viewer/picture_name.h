/* File names of pictures: derived from their documents, unless the command line names the file. */
#ifndef MATC_VIEWER_PICTURE_NAME_H
#define MATC_VIEWER_PICTURE_NAME_H
#include "compiler/base/names.h"
#include "runtime/viewer/command.h"

enum { PICTURE_NAME_CAPACITY = 512, PICTURE_NAME_PATH = 4096 };

/* Paths written in this run, each with the document it was drawn from. {0} is empty. Free
 * `arena` at the end. */
typedef struct {
    Arena arena;
    Names paths;
    const char **inputs; /* parallel to `paths` */
    size_t input_count, input_capacity;
} PictureOwners;

/* Reserves a path for a document's picture. Returns NULL, or an error message if another
 * document of this run has used the path. Standard output ("-") may be used by several
 * documents. */
const char *picture_name_claim(PictureOwners *owners, const char *path, const char *input);

/* Sets the picture's base name: the document's file name without folders and extension, followed
 * by the material's name unless `material` is NULL (document with a single material). */
void picture_name_of(const char *input, const char *material, char name[PICTURE_NAME_CAPACITY]);
/* Sets the output path of the picture with that base name. */
void picture_name_path(const Command *command, const char *name, char path[PICTURE_NAME_PATH]);
/* Sets the output path of a scene's frame, with the frame number. Returns NULL, or a usage
 * error. */
const char *picture_name_frame(const Command *command, const char *input, int frame,
                               char path[PICTURE_NAME_PATH]);
#endif
