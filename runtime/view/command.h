/* matview's command line, as data. */
#ifndef MATC_VIEW_COMMAND_H
#define MATC_VIEW_COMMAND_H
#include "runtime/view/picture.h"
#include "runtime/view/sheet.h"

typedef struct {
    PictureOptions picture;
    Viewpoint camera; /* where picture.view.camera points to, if one was asked for */
    Param params[PARAM_LIMIT];
    char message[PARAM_ROOM]; /* room for what is wrong */
    const char **inputs;
    int input_count;
    const char *output, *folder, *contact, *mesh, *material, *viewpoint;
    GlKind gl;
    bool watch, help, version;
    Sheet *sheet;              /* where pictures go while a contact sheet is made; or NULL */
    struct WatchList *watched; /* files that were met; or NULL */
} Command;

extern const char command_help[];

/* Reads the arguments. NULL, or what is wrong. command_free in either case. */
const char *command_read(Command *command, int argc, char **argv);
/* Whether they go together; completes what follows from them. NULL, or what is wrong. */
const char *command_check(Command *command);
void command_free(Command *command);
#endif
