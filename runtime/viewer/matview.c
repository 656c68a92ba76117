/* Main program matview: draws pictures of materials and scenes. The only file in this folder
 * that prints. */
#include "compiler/base/file.h"
#include "compiler/base/memory.h"
#include "compiler/base/output.h"
#include "compiler/base/progress.h"
#include "compiler/base/session.h"
#include "compiler/base/watch.h"
#include "runtime/tessellate/scene_displace.h"
#include "runtime/scene_reader/scene_read.h"
#include "runtime/viewer/compare.h"
#include "runtime/viewer/model_scene.h"
#include "runtime/viewer/picture_name.h"
#include "runtime/mesh_import/model.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { EXIT_OK = 0, EXIT_ERROR = 1, USAGE = 2, BY_SIGNAL = 128, LONGEST_MESSAGE = 8192 };

static int complain(const char *what, const char *why)
{
    Arena arena = {0};
    Text shown = text_new(&arena);
    text_visible(&shown, what, strlen(what));
    fprintf(stderr, "matview: error: %s: %s\n", shown.size ? shown.at : "", why);
    arena_free(&arena);
    return EXIT_ERROR;
}

static int usage(const char *what)
{
    fprintf(stderr, "matview: %s; see matview --help\n", what);
    return USAGE;
}

static int height_for(const Scene *scene, int width)
{
    const long height = ((long)scene->height * width + scene->width / 2) / scene->width;
    return height > 0 ? (int)height : 1;
}

/* Reads a mesh file as the document that draws it. A glTF file is one of materials if an option of
 * materials is given. */
static bool is_model(const Command *command, const char *path)
{
    const char *dot = strrchr(path, '.');
    const bool has_materials = dot && !text_same(dot, ".obj") && !text_same(dot, ".ply");
    return model_scene_is(path) && !(has_materials && command_asks_material(command));
}

static MatcDocument *read_model(const Command *command, const char *path, Scene **scene)
{
    Arena arena = {0};
    Text text = text_new(&arena), name = text_new(&arena);
    char error[LONGEST_MESSAGE];
    MatcDocument *document = NULL;
    if (command->watched)
        model_files(path, command->watched);
    text_format(&name, "%s.yaml", path); /* beside the mesh; YAML */
    if (model_scene_write(path, &text, error, sizeof error))
        document = scene_read(name.at, text.at, text.size, &command->compile, scene);
    else
        complain(path, error);
    arena_free(&arena);
    return document;
}

static MatcDocument *read_file(const Command *command, const char *path, Scene **scene)
{
    size_t size;
    const char *why;
    char *text = file_read_document(path, &size, &why);
    if (!text) {
        complain(path, why);
        return NULL;
    }
    MatcDocument *document =
        scene_read(file_document_name(path), text, size, &command->compile, scene);
    free(text);
    return document;
}

/* Reads a document. *scene stays NULL for a document of materials only. */
static MatcDocument *read_document(const Command *command, const char *path, Scene **scene)
{
    MatcDocument *document =
        (is_model(command, path) ? read_model : read_file)(command, path, scene);
    if (*scene && command->shadows != WORD_COUNT)
        scene_lights_shadow(*scene, command->shadows);
    if (*scene && command->size)
        scene_displace_resized(*scene, command->size, height_for(*scene, command->size));
    return document;
}

/* State of the progress line of the terminal. */
typedef struct {
    double last;
    int frame, frames; /* current frame and frame count of a motion */
    const char *parts; /* noun for the parts of a picture that are counted */
} Shown;

static void show_rows(void *user, int done, int rows)
{
    Shown *shown = user;
    char what[96];
    Arena arena = {0};
    Text text = text_new(&arena);
    const bool frames = shown->frames > 1;
    const char *parts = frames ? "frames" : shown->parts ? shown->parts : "rows";
    snprintf(what, sizeof what, "%d of %d %s drawn", frames ? shown->frame : done,
             frames ? shown->frames : rows, parts);
    fputs(progress_line(&text, what, session_now(), &shown->last), stderr);
    arena_free(&arena);
}

/* Settings that all documents of a run share. */
typedef struct {
    const Command *command;
    GlContext *gl;
    /* collects the pictures of materials for --contact; NULL: no --contact */
    ContactSheet *sheet;
    MaterialPictures *materials; /* opened at the first material */
    const Shape *mesh;           /* imported mesh; NULL: a solid */
    MatcDocument *drawn;         /* the previous document, which the renderer may still use */
    const char *input;           /* the current document */
    PictureOwners owners;
    Shown shown;
} Run;

/* Default samples per pixel and direction for materials. Supersampling smooths what edge
 * antialiasing misses: discontinuities of the material and intersecting folds. */
enum { MATERIAL_SAMPLES = 2 };

static void show_progress(Run *run, ScenePictureOptions *options)
{
    options->progress = run->command->progress || isatty(STDERR_FILENO) ? show_rows : NULL;
    options->user = &run->shown;
}

static bool open_materials(Run *run)
{
    const Command *command = run->command;
    MaterialPictureOptions options = {.pictures = command_pictures(command, MATERIAL_SAMPLES),
                                      .preview = command->preview,
                                      .slot = command->slot,
                                      .tools = command->tools,
                                      .params = command->params,
                                      .param_count = command->param_count};
    if (run->materials)
        return true;
    options.preview.mesh = run->mesh;
    show_progress(run, &options.pictures);
    run->materials = material_pictures_open(run->gl, &options);
    return run->materials != NULL;
}

/* Draws the current scene into `path`. Errors are reported under the name `input`. */
static int draw_picture(Run *run, ScenePictures *pictures, const char *input, const char *path)
{
    ScenePicture picture = {0};
    const char *taken =
        run->command->emit ? NULL : picture_name_claim(&run->owners, path, run->input);
    if (taken)
        return complain(path, taken);
    const bool done = scene_pictures_draw(pictures, path, &picture);
    fputs(progress_erase(&run->shown.last), stderr);
    if (!done)
        return complain(picture.faulty ? picture.faulty : input, run->gl->error);
    fputs(picture.words ? picture.words : "", run->command->emit ? stdout : stderr);
    if (!run->command->emit && strcmp(path, "-") != 0)
        puts(path);
    free(picture.words);
    return EXIT_OK;
}

/* Draws the current scene into a cell of the contact sheet. */
static int draw_cell(Run *run, ScenePictures *pictures, const char *name)
{
    unsigned char *rgb =
        memory_checked(malloc((size_t)run->sheet->width * (size_t)run->sheet->height * 3));
    const bool reason = contact_sheet_has_capacity(run->sheet),
               done = reason && scene_pictures_pixels(pictures, rgb);
    fputs(progress_erase(&run->shown.last), stderr);
    if (done)
        contact_sheet_add(run->sheet, name, rgb);
    free(rgb);
    return done ? EXIT_OK : complain(name, reason ? run->gl->error : contact_sheet_too_large);
}

static int draw_material(Run *run, MatcDocument *document, int material, const char *name)
{
    char path[PICTURE_NAME_PATH];
    MaterialReport reported;
    if (!open_materials(run))
        return complain(name, run->gl->error);
    const bool made = material_pictures_show(run->materials, document, material, &reported);
    fputs(reported.diagnostics ? reported.diagnostics : "", stderr);
    free(reported.diagnostics);
    if (!made)
        return *reported.error ? complain(name, reported.error) : EXIT_ERROR;
    ScenePictures *pictures = material_pictures_of(run->materials);
    if (run->sheet)
        return draw_cell(run, pictures, name);
    picture_name_path(run->command, name, path);
    return draw_picture(run, pictures, name, path);
}

static int choose_and_draw(Run *run, MatcDocument *document, const char *input)
{
    const Command *command = run->command;
    char name[PICTURE_NAME_CAPACITY];
    int count = matc_material_count(document), status = EXIT_OK;
    if (!count)
        return command->output ? complain(input, "the document has no material to draw") : EXIT_OK;
    int chosen = command->material ? matc_material_find(document, command->material)
                 : count == 1      ? 0
                                   : -1;
    if (command->material && chosen < 0)
        return complain(command->material, "no such material in the document");
    if (chosen < 0 && command->output) {
        fputs("matview: error: the document has several materials; name one with --material, or "
              "use -d\n",
              stderr);
        return EXIT_ERROR;
    }
    for (int i = 0; i < count; i++) {
        if (chosen >= 0 && i != chosen)
            continue;
        picture_name_of(input, count > 1 ? matc_material_name(document, i) : NULL, name);
        status |= draw_material(run, document, i, name);
    }
    return status;
}

static ScenePictureOptions scene_options(Run *run, const Scene *scene)
{
    const int size = run->command->size, width = size ? size : scene->width;
    ScenePictureOptions options = command_pictures(run->command, 1);
    options.renderer.width = width;
    options.renderer.height = height_for(scene, width);
    show_progress(run, &options);
    return options;
}

/* State of drawing a scene's frames: each frame draws the copy `seen` with another camera. */
typedef struct {
    Run *run;
    const char *input;
    Scene *scene;
    Scene seen;
    Frames frames;
    ScenePictureOptions options;
    ScenePictures *pictures;
} Drawing;

static bool open_pictures(Drawing *d)
{
    d->options = scene_options(d->run, d->scene);
    d->pictures = scene_pictures_open(d->run->gl, &d->options);
    if (!d->pictures || !scene_pictures_show(d->pictures, &d->seen))
        return false;
    char *reported = scene_pictures_diagnostics(d->pictures);
    fputs(reported, stderr);
    free(reported);
    return true;
}

static int draw_frame(Drawing *d, int frame, const char *path)
{
    if (!frames_place(&d->frames, d->scene, frame, &d->seen))
        return complain(d->input, "the camera has no direction in this frame");
    if (!(d->pictures ? scene_pictures_turn(d->pictures, d->scene, &d->seen) : open_pictures(d)))
        return complain(d->input, d->run->gl->error);
    return draw_picture(d->run, d->pictures, d->input, path);
}

static int draw_frames(Drawing *d)
{
    char path[PICTURE_NAME_PATH];
    Shown *shown = &d->run->shown;
    for (int frame = d->frames.first; frame <= d->frames.last; frame++) {
        const char *fault = picture_name_frame(d->run->command, d->input, frame, path);
        if (fault)
            return usage(fault);
        if (draw_frame(d, frame, path) != EXIT_OK)
            return EXIT_ERROR;
        shown->frame++;
        if (d->options.progress && shown->frames > 1 && frame < d->frames.last)
            d->options.progress(shown, 0, 0);
    }
    return EXIT_OK;
}

static int write_sheet(const ContactSheet *sheet, const char *path)
{
    const char *why = contact_sheet_write(sheet, path);
    if (!why && strcmp(path, "-") != 0)
        puts(path);
    return why ? complain(path, why) : EXIT_OK;
}

static int draw_comparison(Run *run, Scene *scene, const char *input)
{
    char path[PICTURE_NAME_PATH];
    ScenePictureOptions options = scene_options(run, scene);
    ContactSheet sheet = {0};
    run->shown.parts = "methods";
    picture_name_frame(run->command, input, 0, path);
    const bool drawn = compare_methods(run->gl, scene, run->command->compare, &options, &sheet);
    fputs(progress_erase(&run->shown.last), stderr);
    const int status = drawn ? write_sheet(&sheet, path) : complain(input, run->gl->error);
    contact_sheet_free(&sheet);
    return status;
}

static int draw_scene(Run *run, Scene *scene, const char *input)
{
    Drawing d = {
        .run = run, .input = input, .scene = scene, .seen = *scene, .frames = run->command->frames};
    char reason[FRAMES_CAPACITY];
    const char *wrong = command_check_scene(run->command, scene);
    const char *fault = wrong ? wrong : frames_check(scene, &d.frames, reason);
    command_set_scene(run->command, run->command->compare ? scene : &d.seen);
    if (fault)
        return usage(fault);
    if (run->command->compare)
        return draw_comparison(run, scene, input);
    run->shown.frames = d.frames.last - d.frames.first + 1;
    const int status = draw_frames(&d);
    scene_pictures_close(d.pictures);
    return status;
}

/* Adds the files that the picture depends on to the watch list. `document` is NULL if the input
 * could not be read. */
static void watch_input(const Command *command, const char *input, const MatcDocument *document)
{
    if (!command->watched)
        return;
    watch_list_add(command->watched, input);
    for (int i = 0; document && i < matc_depend_count(document); i++)
        if (strcmp(matc_depend(document, i), input) != 0)
            watch_list_add(command->watched, matc_depend(document, i));
}

/* Keeps the document alive, since the renderer uses the last drawn scene until the next. */
static void keep_document(Run *run, MatcDocument *document)
{
    matc_document_free(run->drawn);
    run->drawn = document;
}

static int run_input(Run *run, const char *input)
{
    Scene *scene = NULL;
    const Command *command = run->command;
    MatcDocument *document = read_document(command, input, &scene);
    run->input = input;
    watch_input(command, input, document);
    if (!document)
        return EXIT_ERROR;
    run->shown = (Shown){.parts = "rows"};
    fputs(matc_diagnostics(document, MATC_TEXT), stderr);
    for (int i = 0; scene && i < scene->document_count; i++)
        fputs(matc_diagnostics(scene->documents[i], MATC_TEXT), stderr);
    const char *fault = scene ? NULL : command_check_material(command);
    int status = matc_error_count(document) ? EXIT_ERROR
                 : scene                    ? draw_scene(run, scene, input)
                 : fault                    ? usage(fault)
                                            : choose_and_draw(run, document, input);
    scene_free(scene);
    keep_document(run, document);
    return status;
}

/* Draws all inputs. The contact sheet is written only if no document has an error. */
static int draw_inputs(const Command *command, GlContext *gl, const Shape *mesh)
{
    ContactSheet sheet = {.width = command->preview.width, .height = command->preview.width};
    Run run = {
        .command = command, .gl = gl, .sheet = command->contact ? &sheet : NULL, .mesh = mesh};
    int status = EXIT_OK;
    for (int i = 0; i < command->input_count; i++)
        status |= run_input(&run, command->inputs[i]);
    if (command->contact && status == EXIT_OK)
        status = write_sheet(&sheet, command->contact);
    material_pictures_close(run.materials);
    keep_document(&run, NULL);
    arena_free(&run.owners.arena);
    contact_sheet_free(&sheet);
    return status;
}

/* Draws all inputs on the shape, or on the mesh of --mesh, which is read in every run. */
static int run_inputs(const Command *command, GlContext *gl)
{
    char error[LONGEST_MESSAGE];
    Shape mesh;
    if (!command->mesh)
        return draw_inputs(command, gl, NULL);
    if (command->watched) {
        watch_list_add(command->watched, command->mesh);
        model_files(command->mesh, command->watched);
    }
    if (!model_read(command->mesh, &mesh, error, sizeof error)) {
        for (int i = 0; command->watched && i < command->input_count; i++)
            watch_list_add(command->watched, command->inputs[i]);
        return complain(command->mesh, error);
    }
    const int status = draw_inputs(command, gl, &mesh);
    return shape_free(&mesh), status;
}

/* Redraws after every change until a signal arrives; the GL context stays open. A document with
 * an error keeps its previous picture. */
static int run_watching(Command *command, GlContext *gl)
{
    Watch *watch = watch_open();
    int signal;
    do {
        WatchList files = {0};
        command->watched = &files;
        const char *done = run_inputs(command, gl) == EXIT_OK ? "drawn" : "not drawn";
        fflush(stdout);
        watch_set(watch, (const char *const *)files.at, files.count);
        fprintf(stderr, "matview: %s; watching %d file%s\n", done, files.count,
                files.count == 1 ? "" : "s");
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
    GlContext *gl = gl_open(command->gl, true, error, sizeof error);
    if (!gl)
        return complain(gl_kind_name(command->gl), error);
    int status = command->watch ? run_watching(command, gl) : run_inputs(command, gl);
    gl_close(gl);
    return status;
}

int main(int argc, char **argv)
{
    Command command = {
        .edges = RENDERER_EDGES_coverage, .shadows = WORD_COUNT, .indirect = WORD_COUNT};
    output_hold_streams();
    matc_options_init(&command.compile);
    command.compile.pixels = true;
    const char *fault = command_read(&command, argc, argv);
    int status = EXIT_OK;
    if (fault)
        status = usage(fault);
    else if (command.help)
        fputs(command_help(&command), stdout);
    else if (command.version)
        puts("matview " MATC_VERSION);
    else
        status = (fault = command_check(&command)) ? usage(fault) : run(&command);
    command_free(&command);
    if ((fflush(stdout) || ferror(stdout)) && status == EXIT_OK)
        status = complain("standard output", text_error(errno));
    return status;
}
