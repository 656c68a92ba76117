/* matview's command line, as data. */
#ifndef MATC_VIEW_COMMAND_H
#define MATC_VIEW_COMMAND_H
#include "runtime/render/render.h"
#include "compiler/base/arena.h"
#include "runtime/view/frames.h"
#include "runtime/view/material_picture.h"

typedef struct {
    MatcOptions compile;
    GlKind gl;
    const char **inputs;
    int input_count;
    const char *output, *folder;
    int size;                 /* pixels, as it was asked for; 0: it was not */
    int samples;              /* of a pixel, across and down; 0: not asked for */
    const char *view;         /* what is shown of what was drawn */
    const char *format_named; /* --format */
    PictureFormat format;     /* as it is named, or as the output's name ends */
    int bits, memory;         /* of a lane, and MiB; 0: not asked for */
    bool progress;
    RenderEdges edges;
    const char *transparency; /* how transparent surfaces are put in order */
    const char *lights;       /* how many lights are summed */
    const char *emit;         /* --emit=frame */
    bool stats;               /* --stats */
    bool tools_named[4];      /* words that --tools names; none: no --tools */
    SceneTools tools;         /* the tools that these words select */
    bool watch, help, version;
    /* of materials alone */
    PreviewOptions preview;
    Viewpoint camera; /* where preview.camera points to */
    Param params[PARAM_LIMIT];
    int param_count;
    const char *contact, *shape, *mesh, *material, *viewpoint, *slot;
    /* of scenes alone */
    Frames frames;
    const char *compare; /* all methods of these in one picture: "shadows" or "indirect"; or NULL */
    Word shadows,
        /* how lights cast them, how indirect light is found: words of these lists; WORD_COUNT: as
         * the scene says */
        indirect;

    Arena words;               /* texts built from arguments, and messages */
    struct WatchList *watched; /* files that were met; or NULL */
} Command;

/* Reads the arguments. NULL, or what is wrong. command_free in either case. */
const char *command_read(Command *command, int argc, char **argv);
/* The text of --help. */
const char *command_help(Command *command);
/* Whether they go together; completes what follows from them. NULL, or what is wrong. */
const char *command_check(Command *command);
/* Whether they go together with a scene, and with materials alone. NULL, or what is wrong. */
const char *command_check_scene(const Command *command, const Scene *scene);
const char *command_check_material(const Command *command);
/* How pictures are drawn that have so many samples unless the command says else; their size is left
 * out. */
ScenePictureOptions command_pictures(const Command *command, int samples);
/* Applies the command's options for a scene's tools, whose sizes stay, and for indirect light. */
void command_set_scene(const Command *command, Scene *scene);
void command_free(Command *command);
#endif
