/* Names of pictures: those of their documents, unless the command line gives one. */
#ifndef MATC_VIEW_PICTURE_NAME_H
#define MATC_VIEW_PICTURE_NAME_H
#include "compiler/base/names.h"
#include "runtime/view/command.h"

enum { PICTURE_NAME_ROOM = 512, PICTURE_NAME_PATH = 4096 };

/* The pictures of a run, each with the document that it was drawn from. {0} is none; its arena is
 * freed at the end. */
typedef struct {
    Arena arena;
    Names paths;
    const char **inputs; /* by index of the path */
    size_t input_count, input_room;
} PictureOwners;

/* Reserves a path for a document's picture. NULL, or the reason why not: another document of this
 * run has drawn to it. Pictures on standard output ("-") may follow one another. */
const char *picture_name_claim(PictureOwners *owners, const char *path, const char *input);

/* A document's name without folders and ending, and that of the material where it has several; else
 * `material` is NULL. */
void picture_name_of(const char *input, const char *material, char name[PICTURE_NAME_ROOM]);
/* Where a picture of that name goes. */
void picture_name_path(const Command *command, const char *name, char path[PICTURE_NAME_PATH]);
/* Name of a frame of a scene, with its number. NULL, or the fault of the command line. */
const char *picture_name_frame(const Command *command, const char *input, int frame,
                               char path[PICTURE_NAME_PATH]);
#endif
