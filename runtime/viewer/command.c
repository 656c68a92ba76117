/* matview's command line: the table of its options, --help, and which options exclude others. */
#include "runtime/viewer/command.h"
#include "compiler/base/memory.h"
#include "compiler/base/option.h"
#include "compiler/choice.h"
#include "runtime/gl/png_write.h"
#include "runtime/viewer/slot.h"
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 512, CELL = 192, MEMORY_MAX = 1 << 20 };
enum { TOOL_grid, TOOL_axes, TOOL_lights, TOOL_none }; /* the words of --tools */

/* -- words of options with a fixed list of values */

static const char *shape_word(const void *user, int i)
{
    (void)user;
    return shape_name((ShapeKind)i);
}

static const char *gl_word(const void *user, int i)
{
    (void)user;
    return gl_kind_name((GlKind)i);
}

static const char *slot_word(const void *user, int i)
{
    (void)user;
    return slot_look_name(i);
}

static const char *shadows_word(const void *user, int i)
{
    (void)user;
    return scene_shadows_name((Keyword)i);
}

static const char *indirect_word(const void *user, int i)
{
    (void)user;
    return scene_indirect_name((Keyword)i);
}

/* Appends the names of all indirect light methods for --help: "none, auto, march". */
static void put_indirect_words(Text *out)
{
    for (int i = 0, count = 0; i < WORD_COUNT; i++)
        if (scene_indirect_name((Keyword)i))
            text_format(out, "%s%s", count++ ? ", " : "", scene_indirect_name((Keyword)i));
}

/* -- setters for values that no kind of Option covers */

static const char *set_choice(void *to, const Option *option, const char *value)
{
    Command *command = to;
    choice_set(&command->compile, option->name + 2, value); /* command_check validates it */
    return NULL;
}

static const char *add_param(void *to, const Option *option, const char *text)
{
    Command *command = to;
    (void)option;
    if (command->param_count == PARAM_LIMIT)
        return "--param: no more than 64 of them";
    return param_read(text, &command->params[command->param_count++],
                      ARENA_ARRAY(&command->words, char, PARAM_CAPACITY));
}

static const char *set_frames(void *to, const Option *option, const char *value)
{
    Command *command = to;
    const bool one = !strcmp(option->name, "--frame");
    const char *wants = (one ? frames_read_one : frames_read)(value, &command->frames);
    return wants ? option_fault_number(&command->words, wants, value) : NULL;
}

static const char *take_input(void *to, const char *argument, bool literal)
{
    Command *command = to;
    (void)literal;
    command->inputs[command->input_count++] = argument;
    return NULL;
}

static bool find_values(const char *name, NameChoice *values)
{
    return !strncmp(name, "--", 2) && choice_values(name + 2, values);
}

/* -- the table */

#define AT(member) offsetof(Command, member)
#define HEADING(text)                                                                              \
    {                                                                                              \
        NULL, OPTION_heading, .help = text                                                         \
    }
#define TEXT(name, member, ...)                                                                    \
    {                                                                                              \
        name, OPTION_text, AT(member), ROW_HELP(__VA_ARGS__)                                       \
    }
#define FLAG(name, member, ...)                                                                    \
    {                                                                                              \
        name, OPTION_flag, AT(member), ROW_HELP(__VA_ARGS__)                                       \
    }
#define CHOICE(name)                                                                               \
    {                                                                                              \
        name, OPTION_text, .set = set_choice                                                       \
    }
#define ROW_HELP(label_, help_) .label = label_, .help = help_
static const Option options[] = {
    HEADING("usage: matview [options] document...\n\n"
            "Renders materials and scenes to images, and prints the names of the files. A document "
            "with\n`objects:` or `lights:` is a scene; matc --list=scenes lists the parts of "
            "scenes.\n\n"),
    TEXT("-o", output, " FILE",
         "write the image to FILE, - is standard output; without -o and -d: NAME.png in this "
         "folder"),
    TEXT(
        "-d", folder, " DIR",
        "write DIR/NAME.png for every document, DIR/NAME.MATERIAL.png if it has several materials"),
    {"--size", OPTION_int, AT(size), .min = 1, .max = PNG_SIZE_LIMIT,
     .wants = "--size expects a number from 1 to 16384", .label = "=N",
     .help = "width and height in pixels (default: 512; contact sheet: 192 per cell); of a scene: "
             "its width,\nwith its aspect ratio"},
    {"--samples", OPTION_int, AT(samples), .min = 1, .max = RENDERER_SAMPLES_MAX,
     .wants = "--samples expects a number from 1 to 8", .label = "=N",
     .help = "N x N samples per pixel, 1 to 8 (default: 2; scenes: 1)"},
    {"--edges", OPTION_index, AT(edges), .words = OPTION_WORDS("none", "coverage"),
     .label = "=EDGES",
     .help = "coverage (default): blends both sides in pixels on an outline or a crease; none"},
    TEXT("--view", view, "=NAME",
         "final (default), light, depth, shadow (maps, side by side), positions, voxels, ao, "
         "indirect, bent, visibility, or a slot; wireframe; volume, volumeWireframe, "
         "wireframes, volumeAlone, volumeWireframeAlone: with shadow volumes"),
    {"--tools", OPTION_set, AT(tools_named),
     .words = OPTION_WORDS("grid", "axes", "lights", "none"), .label = "=LIST",
     .help = "overlay lines: grid, axes, lights, or none (default: as in the scene)"},
    {"--format", OPTION_word, AT(format_named), .words = OPTION_WORDS("png", "exr"),
     .label = "=FORMAT",
     .help = "png, or exr: linear light, before exposure and tone mapping (default: by FILE's "
             "extension)"},
    {"--bits", OPTION_int, AT(bits), .min = 8, .max = 32, .wants = "--bits expects 8, 16 or 32",
     .label = "=N",
     .help = "bits per channel: 8 (default) or 16 for PNG; 16 (default) or 32 for EXR"},
    {"--memory", OPTION_int, AT(memory), .min = 1, .max = MEMORY_MAX,
     .wants = "--memory expects a number of MiB, at least 1", .label = "=MIB",
     .help = "max memory of render targets (default: 256); larger images are rendered in tiles"},
    FLAG("--progress", progress, NULL, "print progress to standard error, as on a terminal"),
    {"--transparency", OPTION_word, AT(transparency),
     .words = OPTION_WORDS("auto", "lists", "peeling"), .label = "=HOW",
     .help = "auto (default), lists, peeling: how transparent surfaces are sorted; the image is "
             "the same"},
    {"--lights", OPTION_word, AT(lights), .words = OPTION_WORDS("auto", "bounded", "all"),
     .label = "=HOW",
     .help = "auto (default), bounded, all: many distant lights may be combined, with an error of "
             "less\nthan half a step of 8 bits"},
    FLAG("--stats", stats, NULL,
         "print the passes that ran, their times, and why others did not run, to standard error"),
    {"--emit", OPTION_word, AT(emit), .words = OPTION_WORDS("frame"), .label = "=frame",
     .help = "print the passes and their targets instead of an image"},
    FLAG("--watch", watch, NULL,
         "render again whenever a document, or a file that it depends on, changes"),
    {"-I", OPTION_list, AT(compile.include), AT(compile.include_count), .help = NULL},
    TEXT("--root", compile.root, NULL, NULL),
    CHOICE("--layout"),
    CHOICE("--noise"),
    CHOICE("--precision"),
    CHOICE("--aa"),
    CHOICE("--derivatives"),
    CHOICE("--coordinates"),
    CHOICE("--powers"),
    CHOICE("--trigonometry"),
    CHOICE("--constants"),
    CHOICE("--normals"),
    HEADING("  -I, --root, --layout, --noise, --precision, --aa, --derivatives, --coordinates, "
            "--powers, --trigonometry,\n"
            "  --constants, --normals: as in matc; the default layout of a scene is the smallest "
            "that stores its materials\n"),
    {"--gl", OPTION_index, AT(gl), .words = {gl_word, NULL, GL_KIND_count}, .label = "=KIND",
     .help = "osmesa (default): in software; egl: on a GPU if available"},
    FLAG("--help", help, ", --version", ""),
    FLAG("-h", help, NULL, NULL),
    FLAG("--version", version, NULL, NULL),
    HEADING("materials\n"),
    TEXT("--contact", contact, "=FILE",
         "write one image of all materials of all documents, with their names; --size is the size "
         "of\na cell"),
    TEXT("--material", material, "=NAME", "a material of `materials:`"),
    {"--param", OPTION_text, 0, .set = add_param, .label = "=NAME=VALUE",
     .help = "set the document's param of that name, in document syntax: 0.7, #c04020, [0, 1, 0]"},
    {"--shape", OPTION_word, AT(shape), .words = {shape_word, NULL, SHAPE_count}, .label = "=SHAPE",
     .help = "sphere (default), plane, cube, torus, cloth, ground (a plane to the horizon)"},
    TEXT("--mesh", mesh, "=FILE",
         "an OBJ, glTF 2 (.gltf, .glb) or PLY file instead of a shape, scaled to the size of the "
         "shapes"),
    TEXT("--camera", viewpoint, "=VIEWPOINT",
         "front, left, top, low, close, or X,Y,Z[,X,Y,Z[,DEGREES]]: position, target, angle of "
         "view;\nthe shape extends about 1 around the origin, and z is up"),
    {"--slot", OPTION_word, AT(slot), .words = {slot_word, NULL, SLOT_LOOK_COUNT}, .label = "=SLOT",
     .help = "show a slot of the G-buffer: normal (in eye space), diffuse, ...; see matc "
             "--list.\nExponents are shown as log2 / 16. The default layout is integer"},
    {"--pass", OPTION_word, 0, .set = set_choice, .words = OPTION_WORDS("gbuffer", "sky"),
     .label = "=PASS",
     .help = "gbuffer (default), sky: the material as the surrounding sky, viewed toward its "
             "brightest side"},
    {"--time", OPTION_real, AT(compile.time), .min = -INFINITY, .max = INFINITY,
     .wants = "--time expects a number of seconds", .label = "=SECONDS",
     .help = "the time of formulas; a motion starts at this time, with 25 frames per second"},
    HEADING("scenes\n"),
    {"--shadows", OPTION_index, AT(shadows), .words = {shadows_word, NULL, WORD_COUNT},
     .label = "=METHOD",
     .help = "shadow method of all lights that cast shadows (see matc --explain shadows; default: "
             "as in\nthe scene)"},
    {"--indirect", OPTION_index, AT(indirect), .words = {indirect_word, NULL, WORD_COUNT},
     .label = "=METHOD", .put_help = put_indirect_words,
     .help = ":\nmethod of indirect light (default: as in the scene)"},
    {"--compare", OPTION_word, AT(compare),
     .words = OPTION_WORDS("shadows", "indirect", "displacement"), .label = "=WHAT",
     .help = "write one image of all methods of shadows, indirect or displacement, side by side, "
             "with names"},
    {"--frames", OPTION_text, 0, .set = set_frames, .label = "=N, --frames=A-B, --frame=K",
     .help = "frames of the scene's motion: N frames for the whole motion, or the A-th to B-th, or "
             "K-th\nof its own frames, from 0. -o names the files, as in out-%04d.png"},
    {"--frame", OPTION_text, 0, .set = set_frames},
    HEADING("\nExit status: 0 success, 1 error in a document or file, 2 wrong usage.\n"),
};

const char *command_read(Command *command, int argc, char **argv)
{
    const OptionTable table = {options, sizeof options / sizeof *options, find_values, take_input};
    command->inputs = calloc((size_t)argc + 1, sizeof *command->inputs);
    if (!command->inputs)
        memory_exhausted();
    return option_read(&table, command, &command->words, argc, argv);
}

const char *command_help(Command *command)
{
    Text out = text_new(&command->words);
    option_put_help(&out, options, sizeof options / sizeof *options);
    return out.at;
}

/* -- conflicts between options */

void command_set_scene(const Command *command, Scene *scene)
{
    if (command->indirect != WORD_COUNT)
        scene->indirect.method = command->indirect;
    const SceneTools *tools = &command->tools;
    if (!tools->grid && !tools->axes && !tools->lights && !command->tools_named[TOOL_none])
        return;
    scene->tools.grid = tools->grid;
    scene->tools.axes = tools->axes;
    scene->tools.lights = tools->lights;
}

bool command_asks_material(const Command *command)
{
    return command->contact || command->mesh || command->material || command->viewpoint ||
           command->shape || command->slot || command->preview.sky || command->param_count;
}

/* Returns NULL, or a message if an option does not apply to scenes. */
const char *command_check_scene(const Command *command, const Scene *scene)
{
    if (command_asks_material(command))
        return "a scene has its own objects, materials and camera; it does not accept --shape, "
               "--mesh, --material, "
               "--param, --camera, --slot, --pass or --contact";
    if ((long)command->size * scene->height > (long)PNG_SIZE_LIMIT * scene->width)
        return "--size: the image would be higher than 16384 pixels";
    if (command->compare &&
        ((command->view && !strcmp(command->view, "shadow")) || command->shadows != WORD_COUNT ||
         command->indirect != WORD_COUNT || command->frames.given || command->emit ||
         command->stats || command->format == PICTURE_FORMAT_exr || command->bits > 8))
        return "--compare writes one 8-bit PNG of all methods; it does not accept --view=shadow, "
               "--shadows, --indirect, "
               "--frames, "
               "--frame, "
               "--stats, "
               "--emit, --format=exr or --bits";
    return NULL;
}

const char *command_check_material(const Command *command)
{
    return command->shadows != WORD_COUNT || command->indirect != WORD_COUNT ||
                   command->frames.given || command->compare
               ? "--shadows, --indirect, --compare and --frames only apply to scenes"
               : NULL;
}

ScenePictureOptions command_pictures(const Command *command, int samples)
{
    if (command->samples)
        samples = command->samples;
    return (ScenePictureOptions){.renderer = {.compile = &command->compile,
                                              .view = command->view,
                                              .samples = samples,
                                              .transparency = command->transparency,
                                              .lights = command->lights,
                                              .edges = command->edges,
                                              .memory = (size_t)command->memory << 20},
                                 .stats = command->stats,
                                 .graph = command->emit != NULL,
                                 .format = command->format,
                                 .bits = command->bits};
}

/* Checks the view and the camera, and fills in the preview options. */
static const char *check_view(Command *command)
{
    PreviewOptions *preview = &command->preview;
    const bool *tools = command->tools_named;
    command->tools = (SceneTools){tools[TOOL_grid], tools[TOOL_axes], .lights = tools[TOOL_lights]};
    preview->sky = command->compile.pass && !strcmp(command->compile.pass, "sky");
    preview->width = preview->height = command->size      ? command->size
                                       : command->contact ? CELL
                                                          : EDGE;
    if (preview->sky && (command->slot || command->viewpoint))
        return "--pass=sky does not accept --slot or --camera";
    if (command->slot && (command->view || command->format == PICTURE_FORMAT_exr))
        return "--slot writes a viewable PNG of a slot; use --view for its numbers, also as "
               "OpenEXR";
    if (command->shape)
        shape_find(command->shape, &preview->shape);
    command->camera = camera_viewpoint_for(preview->shape);
    if (command->viewpoint && !camera_viewpoint_read(command->viewpoint, &command->camera))
        return option_fault_number(&command->words,
                                   "--camera expects front, left, top, low, close, or "
                                   "X,Y,Z[,X,Y,Z[,DEGREES]] with a direction that is not vertical",
                                   command->viewpoint);
    preview->camera = &command->camera;
    return NULL;
}

/* Sets the picture format from --format, else from the output's extension. */
static const char *check_endings(Command *command)
{
    const char *named = command->format_named;
    PictureFormat sheet = PICTURE_FORMAT_png;
    command->format = named && !strcmp(named, "exr") ? PICTURE_FORMAT_exr : PICTURE_FORMAT_png;
    PictureFormat ends = command->format;
    const bool known = !command->output || picture_file_ending(command->output, &ends);
    if (!known && !named)
        return option_fault_number(&command->words,
                                   "-o expects a name that ends in .png or .exr, or --format",
                                   command->output);
    if (named && ends != command->format)
        return option_fault_number(&command->words, "-o expects the extension of --format",
                                   command->output);
    command->format = ends;
    if (command->contact &&
        (!picture_file_ending(command->contact, &sheet) || sheet != PICTURE_FORMAT_png))
        return option_fault_number(&command->words, "--contact expects a name that ends in .png",
                                   command->contact);
    return NULL;
}

static const char *check_format(const Command *command)
{
    const bool exr = command->format == PICTURE_FORMAT_exr;
    if (command->bits && command->bits != 16 && command->bits != (exr ? 32 : 8))
        return "--bits: 8 or 16 for PNG, 16 or 32 for EXR";
    return command->contact && (exr || command->bits > 8)
               ? "--contact: a contact sheet is an 8-bit PNG"
               : NULL;
}

/* Checks the compiler options. Returns NULL, or a message such as "--aa: there is no 'x', but
 * auto, none, ...". */
static const char *check_choices(Command *command)
{
    if (command->compile.layout && !strcmp(command->compile.layout, "auto"))
        return "--layout=auto needs a set of materials (matc -d); use one of the layouts of matc "
               "--list=layouts";
    const char *fault = choice_fault(&command->words, &command->compile);
    Text option = text_new(&command->words);
    text_format(&option, "--%s", fault ? fault : "");
    return fault ? option.at : NULL;
}

const char *command_check(Command *command)
{
    command->view = renderer_view_canonical(command->view);
    const char *fault = check_endings(command);
    if (!fault)
        fault = check_choices(command);
    if (!fault)
        fault = check_view(command);
    if (!fault)
        fault = check_format(command);
    if (fault)
        return fault;
    if (!command->input_count)
        return "no document";
    if (command->output && command->folder)
        return "-o and -d are mutually exclusive";
    if (command->contact && (command->output || command->folder))
        return "--contact and -o or -d are mutually exclusive";
    for (int i = 0; i < command->input_count && command->watch; i++)
        if (!strcmp(command->inputs[i], "-"))
            return "--watch needs files, not standard input";
    if (command->watch && ((command->output && !strcmp(command->output, "-")) ||
                           (command->contact && !strcmp(command->contact, "-"))))
        return "--watch needs an output file, not standard output";
    return command->output && command->input_count > 1 ? "several documents need -d, not -o" : NULL;
}

void command_free(Command *command)
{
    arena_free(&command->words);
    free(command->inputs);
}
