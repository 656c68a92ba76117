/* The program matview: draws pictures of materials. The only file here that prints. */
#include "compiler/base/file.h"
#include "compiler/base/output.h"
#include "compiler/base/progress.h"
#include "compiler/base/session.h"
#include "compiler/base/text.h"
#include "compiler/base/watch.h"
#include "runtime/view/command.h"
#include "runtime/view/scene_picture.h"
#include "runtime/scene/model.h"
#include "runtime/gl/png_write.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

extern const char view_text_screen[], view_text_light[], view_text_slot[];

enum {
    FINE = 0,
    FAULT = 1,
    USAGE = 2,
    BY_SIGNAL = 128,
    LONGEST_PATH = 4096,
    LONGEST_NAME = 512,
    LONGEST_MESSAGE = 8192
};

static int complain(const char *what, const char *why)
{
    Arena arena = {0};
    Text shown = text_new(&arena);
    text_visible(&shown, what, strlen(what));
    fprintf(stderr, "matview: error: %s: %s\n", shown.size ? shown.at : "", why);
    arena_free(&arena);
    return FAULT;
}

static int usage(const char *what)
{
    fprintf(stderr, "matview: %s; see matview --help\n", what);
    return USAGE;
}

/* *scene is NULL for materials alone. */
static MatcDocument *read_document(const Command *command, const char *path, Scene **scene)
{
    bool standard = !strcmp(path, "-");
    size_t size;
    const char *why;
    char *text = standard ? file_read_from(STDIN_FILENO, &size, &why) : file_read_named(path, &size, &why);
    if (!text)
        complain(path, why);
    MatcDocument *document =
        text ? scene_read(standard ? "<stdin>" : path, text, size, &command->picture.compile, scene) : NULL;
    if (document && *scene && command->shadows != WORD_COUNT)
        scene_lights_shadow(*scene, command->shadows);
    free(text);
    return document;
}

/* A document's name without folders and ending, and that of the material where it has several. */
static void name_of(const char *input, const char *material, char name[LONGEST_NAME])
{
    const char *slash = strrchr(input, '/'), *stem = slash ? slash + 1 : input, *dot = strrchr(stem, '.');
    int size = dot && dot != stem ? (int)(dot - stem) : (int)strlen(stem);
    snprintf(name, LONGEST_NAME, "%.*s%s%s", size, stem, material ? "." : "", material ? material : "");
}

static void path_of(const Command *command, const char *name, char *path)
{
    if (command->output)
        snprintf(path, LONGEST_PATH, "%s", command->output);
    else
        snprintf(path, LONGEST_PATH, "%s%s%s.%s", command->folder ? command->folder : "", command->folder ? "/" : "",
                 name, command->format == PICTURE_FORMAT_exr ? "exr" : "png");
}

static bool write_picture(const PngPicture *picture, const char *path)
{
    const char *why;
    size_t size;
    uint8_t *file = png_write(picture, &size, &why);
    if (file)
        why = output_write(path, file, size);
    free(file);
    if (why)
        complain(path, why);
    else if (strcmp(path, "-") != 0)
        puts(path);
    return !why;
}

/* Into a file of its own, or a cell of the contact sheet. */
static bool keep_picture(const Command *command, const char *name, unsigned char *rgb)
{
    const PngPicture png = {command->picture.view.width, command->picture.view.height, 3, rgb};
    char path[LONGEST_PATH];
    if (command->sheet) {
        sheet_add(command->sheet, name, rgb);
        return true;
    }
    path_of(command, name, path);
    return write_picture(&png, path);
}

static int draw_material(const Command *command, MatcDocument *document, int material, const char *name)
{
    const ViewOptions *view = &command->picture.view;
    Picture picture = {.rgb = malloc((size_t)view->width * (size_t)view->height * 3)};
    if (!picture.rgb)
        abort();
    bool done = picture_draw(document, material, &command->picture, &picture);
    fputs(picture.diagnostics ? picture.diagnostics : "", stderr);
    if (!done && *picture.error)
        complain(name, picture.error);
    done = done && keep_picture(command, name, picture.rgb);
    free(picture.diagnostics);
    free(picture.rgb);
    return done ? FINE : FAULT;
}

static int choose_and_draw(const Command *command, MatcDocument *document, const char *input)
{
    char name[LONGEST_NAME];
    int count = matc_material_count(document), status = FINE;
    if (!count)
        return command->output ? complain(input, "the document has no material to draw") : FINE;
    int chosen = command->material ? matc_material_find(document, command->material) : count == 1 ? 0 : -1;
    if (command->material && chosen < 0)
        return complain(command->material, "no such material in the document");
    if (chosen < 0 && command->output) {
        fputs("matview: error: the document has several materials; name one with --material, or use -d\n", stderr);
        return FAULT;
    }
    for (int i = 0; i < count; i++) {
        if (chosen >= 0 && i != chosen)
            continue;
        name_of(input, count > 1 ? matc_material_name(document, i) : NULL, name);
        status |= draw_material(command, document, i, name);
    }
    return status;
}

/* What stands on the terminal's last line. */
typedef struct {
    double last;
    int frame, frames; /* of several: the one that is drawn */
} Shown;

static void show_rows(void *user, int done, int rows)
{
    Shown *shown = user;
    char what[96];
    Arena arena = {0};
    Text text = text_new(&arena);
    if (shown->frames > 1)
        snprintf(what, sizeof what, "%d of %d frames drawn", shown->frame, shown->frames);
    else
        snprintf(what, sizeof what, "%d of %d rows drawn", done, rows);
    fputs(progress_line(&text, what, session_now(), &shown->last), stderr);
    arena_free(&arena);
}

static ScenePictureOptions scene_options(const Command *command, const Scene *scene)
{
    const int width = command->size ? command->size : scene->width;
    const long height = ((long)scene->height * width + scene->width / 2) / scene->width;
    return (ScenePictureOptions){.render = {.compile = &command->picture.compile,
                                            .view = command->view,
                                            .transparency = command->transparency,
                                            .lights = command->lights,
                                            .width = width,
                                            .height = height > 0 ? (int)height : 1,
                                            .edges = command->edges,
                                            .memory = (size_t)command->memory << 20},
                                 .stats = command->stats,
                                 .graph = command->graph,
                                 .format = command->format,
                                 .bits = command->bits,
                                 .progress = command->progress || isatty(STDERR_FILENO) ? show_rows : NULL};
}

/* Of a frame: its name has the number. */
static const char *scene_path(const Command *command, const char *input, int frame, char path[LONGEST_PATH])
{
    char name[LONGEST_NAME], pattern[LONGEST_PATH];
    name_of(input, NULL, name);
    if (!command->frames.given)
        return path_of(command, name, path), NULL;
    if (command->output && command->frames.first == command->frames.last && !strchr(command->output, '%'))
        return snprintf(path, LONGEST_PATH, "%s", command->output), NULL;
    const size_t size = strlen(name);
    if (!command->output)
        snprintf(name + size, sizeof name - size, "-%04d", frame);
    path_of(command, name, pattern);
    if (!command->output)
        return memcpy(path, pattern, sizeof pattern), NULL;
    return frames_path(pattern, frame, path, LONGEST_PATH) ? NULL
                                                           : "-o wants a place for the frame's number: out-%04d.png";
}

/* The pictures of a scene: each frame is the scene with another camera. */
typedef struct {
    const Command *command;
    const char *input;
    Scene seen;
    ScenePictureOptions options;
    ScenePictures *pictures; /* NULL before the first */
    Shown shown;
} Drawing;

static bool open_or_turn(Drawing *d)
{
    if (d->pictures)
        return scene_pictures_turn(d->pictures);
    d->pictures = scene_pictures_open(d->command->picture.view.gl, &d->seen, &d->options);
    return d->pictures != NULL;
}

static int draw_picture(Drawing *d, const char *path)
{
    ScenePicture picture = {0};
    const bool done = open_or_turn(d) && scene_pictures_draw(d->pictures, path, &picture);
    fputs(progress_erase(&d->shown.last), stderr);
    if (!done)
        return complain(picture.faulty ? picture.faulty : d->input, d->command->picture.view.gl->error);
    fputs(picture.words ? picture.words : "", d->options.graph ? stdout : stderr);
    if (!d->options.graph && strcmp(path, "-") != 0)
        puts(path);
    free(picture.words);
    return FINE;
}

static int draw_frames(Drawing *d, const Scene *scene, const Frames *frames)
{
    char path[LONGEST_PATH];
    for (int frame = frames->first; frame <= frames->last; frame++) {
        const char *fault = scene_path(d->command, d->input, frame, path);
        if (fault)
            return usage(fault);
        if (frames->given && !scene_motion_camera(scene, frame, frames->whole, &d->seen.camera))
            return complain(d->input, "the camera has no direction in this frame");
        if (draw_picture(d, path) != FINE)
            return FAULT;
        d->shown.frame++;
        if (d->options.progress && d->shown.frames > 1 && frame < frames->last)
            d->options.progress(&d->shown, 0, 0);
    }
    return FINE;
}

static int draw_scene(const Command *command, const Scene *scene, const char *input)
{
    Frames frames = command->frames;
    Drawing d = {.command = command, .input = input, .seen = *scene, .options = scene_options(command, scene)};
    const char *fault = command_check_scene(command, scene);
    command_set_tools(command, &d.seen.tools);
    if (!fault)
        fault = frames_check(scene, &frames);
    if (fault)
        return usage(fault);
    d.shown.frames = frames.last - frames.first + 1;
    d.options.user = &d.shown;
    const int status = draw_frames(&d, scene, &frames);
    scene_pictures_close(d.pictures);
    return status;
}

/* What the picture is made of: also of a document that could not be read. */
static void watch_input(const Command *command, const char *input, const MatcDocument *document)
{
    if (!command->watched)
        return;
    watch_list_add(command->watched, input);
    for (int i = 0; document && i < matc_depend_count(document); i++)
        if (strcmp(matc_depend(document, i), input) != 0)
            watch_list_add(command->watched, matc_depend(document, i));
}

static int run_input(const Command *command, const char *input)
{
    Scene *scene = NULL;
    MatcDocument *document = read_document(command, input, &scene);
    watch_input(command, input, document);
    if (!document)
        return FAULT;
    fputs(matc_diagnostics(document, MATC_TEXT), stderr);
    const char *fault = scene ? NULL : command_check_material(command);
    int status = matc_error_count(document) ? FAULT
                 : scene                    ? draw_scene(command, scene, input)
                 : fault                    ? usage(fault)
                                            : choose_and_draw(command, document, input);
    scene_free(scene);
    matc_document_free(document);
    return status;
}

static bool write_sheet(const Sheet *sheet, const char *path)
{
    PngPicture picture = {0};
    const char *why = sheet_draw(sheet, &picture);
    if (why)
        complain(path, why);
    bool done = !why && write_picture(&picture, path);
    free(picture.bytes);
    return done;
}

/* A contact sheet is written if nothing is wrong in any of its documents. */
static int draw_inputs(Command *command)
{
    Sheet sheet = {.edge = command->picture.view.width};
    int status = FINE;
    command->sheet = command->contact ? &sheet : NULL;
    for (int i = 0; i < command->input_count; i++)
        status |= run_input(command, command->inputs[i]);
    if (command->contact && status == FINE && !write_sheet(&sheet, command->contact))
        status = FAULT;
    sheet_free(&sheet);
    return status;
}

/* On the shape, or a mesh that is read anew every time. */
static int run_inputs(Command *command)
{
    char error[LONGEST_MESSAGE];
    Shape mesh;
    if (!command->mesh)
        return draw_inputs(command);
    if (command->watched) {
        watch_list_add(command->watched, command->mesh);
        model_files(command->mesh, command->watched);
    }
    if (!model_read(command->mesh, &mesh, error, sizeof error)) {
        for (int i = 0; command->watched && i < command->input_count; i++)
            watch_list_add(command->watched, command->inputs[i]);
        return complain(command->mesh, error);
    }
    command->picture.view.mesh = &mesh;
    int status = draw_inputs(command);
    shape_free(&mesh);
    return status;
}

/* Until a signal comes; the context stays open. A document with a fault leaves its picture as it was. */
static int run_watching(Command *command)
{
    Watch *watch = watch_open();
    int signal;
    do {
        WatchList files = {0};
        command->watched = &files;
        int status = run_inputs(command);
        fflush(stdout);
        watch_set(watch, (const char *const *)files.at, files.count);
        fprintf(stderr, "matview: %s; watching %d files\n", status == FINE ? "drawn" : "not drawn", files.count);
        watch_list_free(&files);
    } while (!(signal = watch_next(watch)));
    watch_close(watch);
    return BY_SIGNAL + signal;
}

static int run(Command *command)
{
    char error[LONGEST_MESSAGE] = "";
    if (command->folder && mkdir(command->folder, 0777) && errno != EEXIST)
        return complain(command->folder, text_error(errno));
    command->picture.view.gl = gl_open(command->gl, true, error, sizeof error);
    if (!command->picture.view.gl)
        return complain(gl_kind_name(command->gl), error);
    int status = command->watch ? run_watching(command) : run_inputs(command);
    gl_close(command->picture.view.gl);
    return status;
}

int main(int argc, char **argv)
{
    Command command = {.edges = RENDER_EDGES_coverage, .shadows = WORD_COUNT};
    matc_options_init(&command.picture.compile);
    command.picture.compile.pixels = true;
    command.picture.view = (ViewOptions){.supersampling = 4,
                                         .screen_text = view_text_screen,
                                         .light_text = view_text_light,
                                         .slot_text = view_text_slot};
    const char *fault = command_read(&command, argc, argv);
    int status = FINE;
    if (fault)
        status = usage(fault);
    else if (command.help)
        fputs(command_help, stdout);
    else if (command.version)
        puts("matview " MATC_VERSION);
    else
        status = (fault = command_check(&command)) ? usage(fault) : run(&command);
    command_free(&command);
    return status;
}
