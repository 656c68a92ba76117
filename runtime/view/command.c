/* From arguments to a Command. */
#include "runtime/view/command.h"
#include "compiler/base/memory.h"
#include "runtime/gl/png_write.h"
#include "compiler/base/text.h"
#include "compiler/choice.h"
#include "runtime/view/words.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 512, CELL = 192 };

static WordsRoom room_of(Command *command)
{
    return (WordsRoom){command->message, sizeof command->message, command_help};
}

static const char *add_param(Command *command, const char *text)
{
    if (command->param_count == PARAM_LIMIT)
        return "--param: no more than 64 of them";
    return param_read(text, &command->params[command->param_count++], command->message);
}

static const char *add_folder(Command *command, const char *folder)
{
    if (command->compile.include_count == FOLDER_LIMIT)
        return "-I: no more than 64 of them";
    command->folders[command->compile.include_count++] = folder;
    command->compile.include = command->folders;
    return NULL;
}

typedef struct {
    long least, most;
    const char *wants; /* in words */
} Whole;

/* NULL, or that it is no such whole number. */
static const char *read_whole(Command *command, const Whole *whole, const char *text, int *number)
{
    char *end;
    errno = 0;
    const long value = strtol(text, &end, 10);
    if (*end || end == text || errno || value < whole->least || value > whole->most)
        return words_number(room_of(command), whole->wants, text);
    *number = (int)value;
    return NULL;
}

/* What a number of frames wants to be, and what it is; NULL: nothing is wanted. */
static const char *say_frames(Command *command, const char *wants, const char *value)
{
    return wants ? words_number(room_of(command), wants, value) : NULL;
}

/* "grid,axes", or "none". */
static void read_tools(const char *list, SceneTools *tools)
{
    const struct {
        const char *name;
        bool *flag;
    } names[] = {{"grid", &tools->grid}, {"axes", &tools->axes}, {"lights", &tools->lights}};
    enum { NAMES = sizeof names / sizeof *names };
    *tools = (SceneTools){0};
    for (const char *name = list; name; name = strchr(name, ',') ? strchr(name, ',') + 1 : NULL)
        for (int i = 0; i < NAMES; i++)
            *names[i].flag |=
                strcspn(name, ",") == strlen(names[i].name) && !strncmp(name, names[i].name, strlen(names[i].name));
}

static const char *set_scene(Command *command, const char *name, const char *value)
{
    if (!strcmp(name, "--time"))
        return text_number(value, strlen(value), &command->compile.time)
                   ? NULL
                   : words_number(room_of(command), "--time wants a number of seconds", value);
    static const Whole memory = {1, 1 << 20, "--memory wants a number of MiB, from 1 on"},
                       bits = {8, 32, "--bits wants 8, 16 or 32"};
    if (!strcmp(name, "--memory"))
        return read_whole(command, &memory, value, &command->memory);
    if (!strcmp(name, "--bits"))
        return read_whole(command, &bits, value, &command->bits);
    if (!strcmp(name, "--frames"))
        return say_frames(command, frames_read(value, &command->frames), value);
    if (!strcmp(name, "--frame"))
        return say_frames(command, frames_read_one(value, &command->frames), value);
    if (!strcmp(name, "--edges")) {
        command->edges = !strcmp(value, "coverage") ? RENDER_EDGES_coverage : RENDER_EDGES_none;
    } else if (!strcmp(name, "--tools")) {
        command->has_tools = true;
        read_tools(value, &command->tools);
    } else if (!strcmp(name, "--format")) {
        command->formatted = true;
        command->format = !strcmp(value, "exr") ? PICTURE_FORMAT_exr : PICTURE_FORMAT_png;
    } else if (!strcmp(name, "--shadows")) {
        scene_shadows_find(value, &command->shadows);
    } else if (!strcmp(name, "--compare")) {
        command->compare = value;
    } else if (!strcmp(name, "--indirect")) {
        scene_indirect_find(value, &command->indirect);
    } else if (!strcmp(name, "--emit")) {
        command->graph = true;
    } else {
        return words_option(room_of(command), name, "takes no value");
    }
    return NULL;
}

static const char *set_view(Command *command, const char *name, const char *value)
{
    static const Whole samples = {1, RENDER_SAMPLES_MOST, "--samples wants a number from 1 to 8"},
                       size = {1, PNG_SIZE_LIMIT, "--size wants a number from 1 to 16384"};
    command->shaped |= !strcmp(name, "--shape");
    if (!strcmp(name, "--samples"))
        return read_whole(command, &samples, value, &command->samples);
    if (!strcmp(name, "--size"))
        return read_whole(command, &size, value, &command->size);
    if (!strcmp(name, "--shape"))
        shape_find(value, &command->preview.shape);
    else if (!strcmp(name, "--gl"))
        gl_kind_find(value, &command->gl);
    else if (!strcmp(name, "--camera"))
        command->viewpoint = value;
    else if (!strcmp(name, "--slot"))
        command->slot = value;
    else if (!strcmp(name, "--view"))
        command->view = value;
    else if (!strcmp(name, "--transparency"))
        command->transparency = value;
    else if (!strcmp(name, "--lights"))
        command->lights = value;
    else
        return set_scene(command, name, value);
    return NULL;
}

static const char *set_option(Command *command, const char *name, const char *value)
{
    const char *fault = words_fault(room_of(command), name, value);
    if (fault)
        return fault;
    if (!strcmp(name, "-o"))
        command->output = value;
    else if (!strcmp(name, "-I"))
        return add_folder(command, value);
    else if (!strcmp(name, "--root"))
        command->compile.root = value;
    else if (!strcmp(name, "-d"))
        command->folder = value;
    else if (!strcmp(name, "--material"))
        command->material = value;
    else if (!strcmp(name, "--contact"))
        command->contact = value;
    else if (!strcmp(name, "--mesh"))
        command->mesh = value;
    else if (!strcmp(name, "--param"))
        return add_param(command, value);
    else if (!strncmp(name, "--", 2) && strcmp(name, "--target") != 0 && strcmp(name, "--slot") != 0 &&
             choice_set(&command->compile, name + 2, value))
        return NULL; /* command_check looks at it */
    else
        return set_view(command, name, value);
    return NULL;
}

static bool read_flag(Command *command, const char *arg)
{
    const struct {
        const char *name;
        bool *flag;
    } flags[] = {{"--help", &command->help},         {"-h", &command->help},
                 {"--version", &command->version},   {"--stats", &command->stats},
                 {"--progress", &command->progress}, {"--watch", &command->watch}};
    for (size_t i = 0; i < sizeof flags / sizeof *flags; i++)
        if (!strcmp(arg, flags[i].name))
            return *flags[i].flag = true;
    return false;
}

/* "--name=value", "--name value", "-o value", "-ovalue". NULL or what is wrong. */
static const char *read_option(Command *command, char **argv, int *i)
{
    char name[16] = {0};
    const char *arg = argv[*i];
    size_t size = arg[1] == '-' ? strcspn(arg, "=") : 2;
    if (size >= sizeof name)
        return words_option(room_of(command), arg, "takes no value");
    memcpy(name, arg, size);
    if (arg[size])
        return set_option(command, name, arg + size + (arg[size] == '='));
    return argv[*i + 1] ? set_option(command, name, argv[++*i]) : words_option(room_of(command), name, "wants a value");
}

const char *command_read(Command *command, int argc, char **argv)
{
    const char *fault = NULL;
    bool only_files = false;
    command->inputs = calloc((size_t)argc + 1, sizeof *command->inputs);
    if (!command->inputs)
        memory_exhausted();
    for (int i = 1; i < argc && !fault; i++) {
        if (!only_files && !strcmp(argv[i], "--"))
            only_files = true;
        else if (only_files || argv[i][0] != '-' || !argv[i][1])
            command->inputs[command->input_count++] = argv[i];
        else if (!read_flag(command, argv[i]))
            fault = read_option(command, argv, &i);
    }
    return fault;
}

void command_set_scene(const Command *command, Scene *scene)
{
    if (command->indirect != WORD_COUNT)
        scene->indirect.method = command->indirect;
    if (!command->has_tools)
        return;
    scene->tools.grid = command->tools.grid;
    scene->tools.axes = command->tools.axes;
    scene->tools.lights = command->tools.lights;
}

/* NULL, or the option that a scene has no use for. */
const char *command_check_scene(const Command *command, const Scene *scene)
{
    if (command->contact || command->mesh || command->material || command->viewpoint || command->shaped ||
        command->slot || command->preview.sky || command->param_count)
        return "a scene has its own objects, materials and camera: it takes none of --shape, --mesh, --material, "
               "--param, --camera, --slot, --pass, --contact";
    if ((long)command->size * scene->height > (long)PNG_SIZE_LIMIT * scene->width)
        return "--size: the picture would be higher than 16384 pixels";
    if (command->compare && ((command->view && !strcmp(command->view, "shadow")) || command->shadows != WORD_COUNT ||
                             command->indirect != WORD_COUNT || command->frames.given || command->graph ||
                             command->stats || command->format == PICTURE_FORMAT_exr || command->bits > 8))
        return "--compare is one PNG of 8 bits, of all methods: it takes none of --view=shadow, --shadows, --indirect, "
               "--frames, "
               "--frame, "
               "--stats, "
               "--emit, --format=exr, --bits";
    return NULL;
}

const char *command_check_material(const Command *command)
{
    return command->shadows != WORD_COUNT || command->indirect != WORD_COUNT || command->frames.given ||
                   command->compare
               ? "--shadows, --indirect, --compare and --frames are of scenes: a material has none"
               : NULL;
}

ScenePictureOptions command_pictures(const Command *command, int samples)
{
    if (command->samples)
        samples = command->samples;
    return (ScenePictureOptions){.render = {.compile = &command->compile,
                                            .view = command->view,
                                            .samples = samples,
                                            .transparency = command->transparency,
                                            .lights = command->lights,
                                            .edges = command->edges,
                                            .memory = (size_t)command->memory << 20},
                                 .stats = command->stats,
                                 .graph = command->graph,
                                 .format = command->format,
                                 .bits = command->bits};
}

/* What is seen, and from where. */
static const char *check_view(Command *command)
{
    PreviewOptions *preview = &command->preview;
    preview->sky = command->compile.pass && !strcmp(command->compile.pass, "sky");
    preview->width = preview->height = command->size ? command->size : command->contact ? CELL : EDGE;
    if (preview->sky && (command->slot || command->viewpoint))
        return "--pass=sky has neither --slot nor --camera";
    if (command->slot && (command->view || command->format == PICTURE_FORMAT_exr))
        return "--slot shows a slot as one can look at it; --view its numbers, also as OpenEXR";
    command->camera = camera_viewpoint_for(preview->shape);
    if (command->viewpoint && !camera_viewpoint_read(command->viewpoint, &command->camera))
        return words_number(room_of(command),
                            "--camera wants front, left, top, low, close, or X,Y,Z[,X,Y,Z[,DEGREES]] that looks at "
                            "something, and not straight up or down",
                            command->viewpoint);
    preview->camera = &command->camera;
    return NULL;
}

/* The format is what --format says, else what the name ends in. */
static const char *check_endings(Command *command)
{
    PictureFormat ends = command->format, sheet = PICTURE_FORMAT_png;
    const bool known = !command->output || picture_file_ending(command->output, &ends);
    if (!known && !command->formatted)
        return words_number(room_of(command), "-o wants a name that ends in .png or .exr, or --format",
                            command->output);
    if (command->formatted && ends != command->format)
        return words_number(room_of(command), "-o wants the ending of --format", command->output);
    command->format = ends;
    if (command->contact && (!picture_file_ending(command->contact, &sheet) || sheet != PICTURE_FORMAT_png))
        return words_number(room_of(command), "--contact wants a name that ends in .png", command->contact);
    return NULL;
}

static const char *check_format(const Command *command)
{
    const bool exr = command->format == PICTURE_FORMAT_exr;
    if (command->bits && command->bits != 16 && command->bits != (exr ? 32 : 8))
        return "--bits: 8 or 16 of a PNG, 16 or 32 of an EXR";
    return command->contact && (exr || command->bits > 8) ? "--contact: a contact sheet is a PNG of 8 bits" : NULL;
}

/* "--aa: there is no 'x', but auto, none, ..." */
static const char *check_choices(Command *command)
{
    if (command->compile.layout && !strcmp(command->compile.layout, "auto"))
        return "--layout=auto is made of a set of materials, by matc -d; a picture is drawn by one of the layouts that "
               "matc --list=layouts shows";
    Arena arena = {0};
    const char *fault = choice_fault(&arena, &command->compile);
    if (fault)
        snprintf(command->message, sizeof command->message, "--%s", fault);
    arena_free(&arena);
    return fault ? command->message : NULL;
}

const char *command_check(Command *command)
{
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
    if (command->watch &&
        ((command->output && !strcmp(command->output, "-")) || (command->contact && !strcmp(command->contact, "-"))))
        return "--watch wants a file for its picture";
    return command->output && command->input_count > 1 ? "several documents need -d, not -o" : NULL;
}

void command_free(Command *command) { free(command->inputs); }
