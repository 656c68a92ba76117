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
            "Draws pictures of materials and of scenes, and prints the names of the files. A "
            "document with `objects:` or `lights:` is a scene;\n"
            "matc --list=scenes has what it is made of.\n\n"),
    TEXT("-o", output, " FILE",
         "the picture, - to standard output; without -o and -d NAME.png, here"),
    TEXT("-d", folder, " DIR",
         "write DIR/NAME.png for every document, DIR/NAME.MATERIAL.png where it has several "
         "materials"),
    {"--size", OPTION_int, AT(size), .min = 1, .max = PNG_SIZE_LIMIT,
     .wants = "--size wants a number from 1 to 16384", .label = "=N",
     .help = "pixels of an edge: 512, of a contact sheet's cell 192; of a scene: of its width, "
             "in its proportions"},
    {"--samples", OPTION_int, AT(samples), .min = 1, .max = RENDERER_SAMPLES_MAX,
     .wants = "--samples wants a number from 1 to 8", .label = "=N",
     .help = "N x N samples a pixel, 1 to 8: 2, of a scene 1"},
    {"--edges", OPTION_index, AT(edges), .words = OPTION_WORDS("none", "coverage"),
     .label = "=EDGES",
     .help = "coverage (default): pixels that an outline or a crease runs through show both "
             "sides; none"},
    TEXT("--view", view, "=NAME",
         "final (default), light, depth, shadow (maps, side by side), positions, voxels, ao, "
         "indirect, bent, visibility, or a slot; wireframe; volume, volumeWireframe, "
         "wireframes, volumeAlone, volumeWireframeAlone: with shadow volumes"),
    {"--tools", OPTION_set, AT(tools_named),
     .words = OPTION_WORDS("grid", "axes", "lights", "none"), .label = "=LIST",
     .help = "of grid, axes, lights, or none: lines over the picture; else as the scene says"},
    {"--format", OPTION_word, AT(format_named), .words = OPTION_WORDS("png", "exr"),
     .label = "=FORMAT",
     .help = "png (default), exr: linear light, before exposure and tone mapping; else as FILE "
             "ends"},
    {"--bits", OPTION_int, AT(bits), .min = 8, .max = 32, .wants = "--bits wants 8, 16 or 32",
     .label = "=N", .help = "of a lane: 8 (default) or 16 of a PNG; 16 (default) or 32 of an EXR"},
    {"--memory", OPTION_int, AT(memory), .min = 1, .max = MEMORY_MAX,
     .wants = "--memory wants a number of MiB, from 1 on", .label = "=MIB",
     .help = "that render targets may take: 256. A picture that takes more is drawn in tiles"},
    FLAG("--progress", progress, NULL, "how far it is, on standard error, as on a terminal"),
    {"--transparency", OPTION_word, AT(transparency),
     .words = OPTION_WORDS("auto", "lists", "peeling"), .label = "=HOW",
     .help = "auto (default), lists, peeling: how transparent surfaces are put in order; the "
             "picture is the same"},
    {"--lights", OPTION_word, AT(lights), .words = OPTION_WORDS("auto", "bounded", "all"),
     .label = "=HOW",
     .help = "auto (default), bounded, all: far ones of many together, less than half a step of "
             "8 bits off"},
    FLAG("--stats", stats, NULL,
         "which passes ran, what they took, and why others did not run, on standard error"),
    {"--emit", OPTION_word, AT(emit), .words = OPTION_WORDS("frame"), .label = "=frame",
     .help = "the passes and their targets, and no picture"},
    FLAG("--watch", watch, NULL,
         "draw again whenever a document, or a file that it depends on, changes"),
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
            "  --constants, --normals: as matc has them; of a scene, without --layout, the "
            "smallest that holds its materials\n"),
    {"--gl", OPTION_index, AT(gl), .words = {gl_word, NULL, GL_KIND_count}, .label = "=KIND",
     .help = "osmesa (default): in software; egl: on a GPU where there is one"},
    FLAG("--help", help, ", --version", ""),
    FLAG("-h", help, NULL, NULL),
    FLAG("--version", version, NULL, NULL),
    HEADING("of materials\n"),
    TEXT("--contact", contact, "=FILE",
         "one picture of all materials of all documents, with their names; --size is then that "
         "of a cell"),
    TEXT("--material", material, "=NAME", "of `materials:`"),
    {"--param", OPTION_text, 0, .set = add_param, .label = "=NAME=VALUE",
     .help = "a value of the document's param of that name, as documents have it: 0.7, #c04020, "
             "[0, 1, 0]"},
    {"--shape", OPTION_word, AT(shape), .words = {shape_word, NULL, SHAPE_count}, .label = "=SHAPE",
     .help = "sphere (default), plane, cube, torus, cloth, ground (a plane to the horizon)"},
    TEXT("--mesh", mesh, "=FILE",
         "an OBJ, glTF 2 (.gltf, .glb) or PLY file instead of a shape; it is scaled to the size "
         "of one"),
    TEXT("--camera", viewpoint, "=VIEWPOINT",
         "front, left, top, low, close, or X,Y,Z[,X,Y,Z[,DEGREES]]: where it stands, what it "
         "looks at,\nits angle of view; the shape is about 1 around the origin, and z is up"),
    {"--slot", OPTION_word, AT(slot), .words = {slot_word, NULL, SLOT_LOOK_COUNT}, .label = "=SLOT",
     .help = "shows a slot of the G-buffer: normal (in the eye's space), diffuse, ...; matc "
             "--list has all.\n"
             "Exponents as their logarithm to base 2, of 16; of the layout integer unless one "
             "is named"},
    {"--pass", OPTION_word, 0, .set = set_choice, .words = OPTION_WORDS("gbuffer", "sky"),
     .label = "=PASS",
     .help = "gbuffer (default), sky: the material as the sky all around, towards its brightest "
             "side"},
    {"--time", OPTION_real, AT(compile.time), .min = -INFINITY, .max = INFINITY,
     .wants = "--time wants a number of seconds", .label = "=SECONDS",
     .help = "the time of formulas; frames of a motion go on from there, 25 a second"},
    HEADING("of scenes\n"),
    {"--shadows", OPTION_index, AT(shadows), .words = {shadows_word, NULL, WORD_COUNT},
     .label = "=METHOD",
     .help = "how all lights cast shadows that do (matc --explain shadows), else "
             "as the scene says"},
    {"--indirect", OPTION_index, AT(indirect), .words = {indirect_word, NULL, WORD_COUNT},
     .label = "=METHOD", .put_help = put_indirect_words,
     .help = ":\nhow indirect light is found, else as the scene says"},
    {"--compare", OPTION_word, AT(compare),
     .words = OPTION_WORDS("shadows", "indirect", "displacement"), .label = "=WHAT",
     .help = "one picture, with names: all methods of shadows, of indirect, or of displacement, "
             "side by side"},
    {"--frames", OPTION_text, 0, .set = set_frames, .label = "=N, --frames=A-B, --frame=K",
     .help = "frames of the scene's motion: N for all of it, or of its own the A-th to the "
             "B-th, the\nK-th; the first is 0. -o names them, out-%04d.png"},
    {"--frame", OPTION_text, 0, .set = set_frames},
    HEADING("\nExit status: 0 fine, 1 a fault in a document or file, 2 wrong usage.\n"),
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

/* Returns NULL, or a message if an option does not apply to scenes. */
const char *command_check_scene(const Command *command, const Scene *scene)
{
    if (command->contact || command->mesh || command->material || command->viewpoint ||
        command->shape || command->slot || command->preview.sky || command->param_count)
        return "a scene has its own objects, materials and camera: it takes none of --shape, "
               "--mesh, --material, "
               "--param, --camera, --slot, --pass, --contact";
    if ((long)command->size * scene->height > (long)PNG_SIZE_LIMIT * scene->width)
        return "--size: the picture would be higher than 16384 pixels";
    if (command->compare &&
        ((command->view && !strcmp(command->view, "shadow")) || command->shadows != WORD_COUNT ||
         command->indirect != WORD_COUNT || command->frames.given || command->emit ||
         command->stats || command->format == PICTURE_FORMAT_exr || command->bits > 8))
        return "--compare is one PNG of 8 bits, of all methods: it takes none of --view=shadow, "
               "--shadows, --indirect, "
               "--frames, "
               "--frame, "
               "--stats, "
               "--emit, --format=exr, --bits";
    return NULL;
}

const char *command_check_material(const Command *command)
{
    return command->shadows != WORD_COUNT || command->indirect != WORD_COUNT ||
                   command->frames.given || command->compare
               ? "--shadows, --indirect, --compare and --frames are of scenes: a material has none"
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
        return "--pass=sky has neither --slot nor --camera";
    if (command->slot && (command->view || command->format == PICTURE_FORMAT_exr))
        return "--slot shows a slot as one can look at it; --view its numbers, also as OpenEXR";
    if (command->shape)
        shape_find(command->shape, &preview->shape);
    command->camera = camera_viewpoint_for(preview->shape);
    if (command->viewpoint && !camera_viewpoint_read(command->viewpoint, &command->camera))
        return option_fault_number(&command->words,
                                   "--camera wants front, left, top, low, close, or "
                                   "X,Y,Z[,X,Y,Z[,DEGREES]] that looks at something, and not "
                                   "straight up or down",
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
                                   "-o wants a name that ends in .png or .exr, or --format",
                                   command->output);
    if (named && ends != command->format)
        return option_fault_number(&command->words, "-o wants the ending of --format",
                                   command->output);
    command->format = ends;
    if (command->contact &&
        (!picture_file_ending(command->contact, &sheet) || sheet != PICTURE_FORMAT_png))
        return option_fault_number(&command->words, "--contact wants a name that ends in .png",
                                   command->contact);
    return NULL;
}

static const char *check_format(const Command *command)
{
    const bool exr = command->format == PICTURE_FORMAT_exr;
    if (command->bits && command->bits != 16 && command->bits != (exr ? 32 : 8))
        return "--bits: 8 or 16 of a PNG, 16 or 32 of an EXR";
    return command->contact && (exr || command->bits > 8)
               ? "--contact: a contact sheet is a PNG of 8 bits"
               : NULL;
}

/* Checks the compiler options. Returns NULL, or a message such as "--aa: there is no 'x', but
 * auto, none, ...". */
static const char *check_choices(Command *command)
{
    if (command->compile.layout && !strcmp(command->compile.layout, "auto"))
        return "--layout=auto is made of a set of materials, by matc -d; a picture is drawn by one "
               "of the layouts that "
               "matc --list=layouts shows";
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
        return "-o and -d exclude each other";
    if (command->contact && (command->output || command->folder))
        return "--contact excludes -o and -d";
    for (int i = 0; i < command->input_count && command->watch; i++)
        if (!strcmp(command->inputs[i], "-"))
            return "--watch wants files, not standard input";
    if (command->watch && ((command->output && !strcmp(command->output, "-")) ||
                           (command->contact && !strcmp(command->contact, "-"))))
        return "--watch wants a file for its picture";
    return command->output && command->input_count > 1 ? "several documents need -d, not -o" : NULL;
}

void command_free(Command *command)
{
    arena_free(&command->words);
    free(command->inputs);
}
