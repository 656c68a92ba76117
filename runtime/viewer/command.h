/* Parsed command line of matview. */
#ifndef MATC_VIEWER_COMMAND_H
#define MATC_VIEWER_COMMAND_H
#include "runtime/renderer/renderer.h"
#include "compiler/base/arena.h"
#include "runtime/viewer/frames.h"
#include "runtime/viewer/material_picture.h"

typedef struct {
    MatcOptions compile;
    GlKind gl;
    const char **inputs;
    int input_count;
    const char *output, *folder;
    int size;                 /* pixels, as requested; 0: not given */
    int samples;              /* samples per pixel along each axis; 0: not given */
    const char *view;         /* --view: name of the displayed buffer */
    const char *format_named; /* --format */
    PictureFormat format;     /* format from --format, else from the output's file extension */
    int bits, memory;         /* bits per component; render target budget in MiB; 0: not given */
    bool progress;
    RendererEdges edges;
    const char *transparency; /* --transparency: method that orders transparent surfaces */
    const char *lights;       /* --lights: light selection (auto, bounded, all) */
    const char *emit;         /* --emit=frame */
    bool stats;               /* --stats */
    bool tools_named[4];      /* words that --tools names; all false: no --tools */
    SceneTools tools;         /* the tools that these words select */
    bool watch, help, version;
    /* Options for materials only. */
    PreviewOptions preview;
    Viewpoint camera; /* target of the pointer preview.camera */
    Param params[PARAM_LIMIT];
    int param_count;
    const char *contact, *shape, *mesh, *material, *viewpoint, *slot;
    /* Options for scenes only. */
    Frames frames;
    /* list whose methods share one picture: "shadows", "indirect", "displacement"; NULL: no
     * comparison */
    const char *compare;
    /* Shadow method and indirect light method that override the scene's; WORD_COUNT: keep
     * the scene's. */
    Keyword shadows, indirect;

    Arena words;               /* owns messages and strings built from arguments */
    struct WatchList *watched; /* input files read so far; NULL: not watched */
} Command;

/* Parses the arguments. Returns NULL, or an error message. Call command_free in both cases. */
const char *command_read(Command *command, int argc, char **argv);
/* Returns the text of --help. */
const char *command_help(Command *command);
/* Checks the options for conflicts and derives the dependent fields. Returns NULL, or an error
 * message. */
const char *command_check(Command *command);
/* Returns true if an option that applies to materials only is given. */
bool command_asks_material(const Command *command);
/* Check the options against a scene, and against a document of materials only. Return NULL, or
 * an error message. */
const char *command_check_scene(const Command *command, const Scene *scene);
const char *command_check_material(const Command *command);
/* Returns the options for drawing pictures. `samples` is the default that --samples overrides.
 * Width and height stay unset. */
ScenePictureOptions command_pictures(const Command *command, int samples);
/* Applies --tools (without changing the tools' sizes) and --indirect to the scene. */
void command_set_scene(const Command *command, Scene *scene);
void command_free(Command *command);
#endif
