/* matview's command line, as data. */
#ifndef MATC_VIEW_COMMAND_H
#define MATC_VIEW_COMMAND_H
#include "runtime/render/render.h"
#include "runtime/view/frames.h"
#include "runtime/view/picture.h"
#include "runtime/view/picture_file.h"
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
    int size;             /* as it was asked for; 0: it was not */
    const char *view;     /* of a scene: what is shown of it */
    PictureFormat format; /* of a scene's picture: as it is named, or as the output's name ends */
    int bits, memory;     /* of a scene: of a lane, and MiB; 0: not asked for */
    bool formatted, progress;
    RenderEdges edges;
    Frames frames;
    const char *transparency;  /* of a scene: how transparent surfaces are put in order */
    const char *lights;        /* of a scene: how many lights are summed */
    bool stats, graph, shaped; /* of a scene: --stats, --emit=frame; of a material: --shape or --samples was given */
    SceneTools tools;          /* of a scene, if --tools was given: which are drawn */
    bool has_tools;
    Word shadows; /* of a scene: how its lights cast them, a word of the list Shadows; WORD_COUNT: as it says */
    bool watch, help, version;
    Sheet *sheet;              /* where pictures go while a contact sheet is made; or NULL */
    struct WatchList *watched; /* files that were met; or NULL */
} Command;

extern const char command_help[];

/* Reads the arguments. NULL, or what is wrong. command_free in either case. */
const char *command_read(Command *command, int argc, char **argv);
/* Whether they go together; completes what follows from them. NULL, or what is wrong. */
const char *command_check(Command *command);
/* Whether they go together with a scene, and with materials alone. NULL, or what is wrong. */
const char *command_check_scene(const Command *command, const Scene *scene);
const char *command_check_material(const Command *command);
/* Those that are drawn, if the command says so; their sizes stay. */
void command_set_tools(const Command *command, SceneTools *tools);
void command_free(Command *command);
#endif
