/* matview's command line: draws pictures of materials. */
#include "compiler/base/file.h"
#include "compiler/base/output.h"
#include "compiler/base/text.h"
#include "runtime/view/picture.h"
#include "runtime/gl/png_write.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

extern const char view_text_screen[], view_text_light[];

enum { FINE = 0, FAULT = 1, USAGE = 2, LONGEST_PATH = 4096, LONGEST_MESSAGE = 8192 };

typedef struct {
    PictureOptions picture;
    const char **inputs;
    int input_count;
    const char *output, *folder, *material;
    GlKind gl;
    bool help, version;
} CommandLine;

static const char help_text[] =
    "usage: matview [options] document...\n"
    "\n"
    "Draws pictures of materials, and prints the names of the files.\n"
    "\n"
    "  -o FILE              the picture, - to standard output; without -o and -d NAME.png, here\n"
    "  -d DIR               write DIR/NAME.png for every document, DIR/NAME.MATERIAL.png where it has several "
    "materials\n"
    "  --material=NAME      of `materials:`\n"
    "  --shape=SHAPE        sphere (default), plane, cube, torus\n"
    "  --pass=PASS          gbuffer (default), sky: the material as the sky all around, towards its brightest side\n"
    "  --layout, --noise, --precision, --aa, --derivatives, --coordinates, --powers, --trigonometry,\n"
    "  --constants: as matc has them\n"
    "  --size=N             pixels of an edge: 512\n"
    "  --samples=N          N x N samples a pixel, 1 to 8: 4\n"
    "  --gl=KIND            osmesa (default): in software; egl: on a GPU where there is one\n"
    "  --help, --version\n"
    "\n"
    "Exit status: 0 fine, 1 a fault in a document or file, 2 wrong usage.\n";

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

/* NULL, or what is wrong with the number. */
static const char *read_number(const char *text, long most, int *number)
{
    char *end;
    errno = 0;
    long value = strtol(text, &end, 10);
    if (*end || end == text || errno || value < 1 || value > most)
        return "--size and --samples want a number from 1, of at most 8192 and 8";
    *number = (int)value;
    return NULL;
}

static const char *set_option(CommandLine *line, const char *name, const char *value)
{
    PictureOptions *picture = &line->picture;
    if (!strcmp(name, "-o"))
        line->output = value;
    else if (!strcmp(name, "-d"))
        line->folder = value;
    else if (!strcmp(name, "--material"))
        line->material = value;
    else if (!strncmp(name, "--", 2) && strcmp(name, "--target") != 0 && strcmp(name, "--slot") != 0 &&
             matc_options_set(&picture->compile, name + 2, value))
        return NULL;
    else if (!strcmp(name, "--shape"))
        return shape_find(value, &picture->view.shape) ? NULL : "--shape: sphere, plane, cube or torus";
    else if (!strcmp(name, "--gl"))
        return gl_kind_find(value, &line->gl) ? NULL : "--gl: osmesa or egl";
    else if (!strcmp(name, "--samples"))
        return read_number(value, VIEW_SUPERSAMPLING_LIMIT, &picture->view.supersampling);
    else if (!strcmp(name, "--size"))
        return read_number(value, VIEW_SIZE_LIMIT, &picture->view.width);
    else
        return "no such option";
    return NULL;
}

static bool read_flag(CommandLine *line, const char *arg)
{
    bool help = !strcmp(arg, "--help") || !strcmp(arg, "-h"), version = !strcmp(arg, "--version");
    line->help |= help;
    line->version |= version;
    return help || version;
}

/* "--name=value", "--name value", "-o value", "-ovalue". NULL or what is wrong. */
static const char *read_option(CommandLine *line, char **argv, int *i)
{
    char name[16] = {0};
    const char *arg = argv[*i];
    size_t size = arg[1] == '-' ? strcspn(arg, "=") : 2;
    if (size >= sizeof name)
        return "no such option";
    memcpy(name, arg, size);
    if (arg[size])
        return set_option(line, name, arg + size + (arg[size] == '='));
    return argv[*i + 1] ? set_option(line, name, argv[++*i]) : "an option lacks its value";
}

static const char *read_arguments(CommandLine *line, int argc, char **argv)
{
    const char *fault = NULL;
    bool only_files = false;
    for (int i = 1; i < argc && !fault; i++) {
        if (!only_files && !strcmp(argv[i], "--"))
            only_files = true;
        else if (only_files || argv[i][0] != '-' || !argv[i][1])
            line->inputs[line->input_count++] = argv[i];
        else if (!read_flag(line, argv[i]))
            fault = read_option(line, argv, &i);
    }
    return fault;
}

static const char *check_usage(CommandLine *line)
{
    MatcOptions *compile = &line->picture.compile;
    ViewOptions *view = &line->picture.view;
    if (matc_options_fault(compile))
        return "an option names what does not exist";
    view->sky = compile->pass && !strcmp(compile->pass, "sky");
    view->height = view->width;
    if (compile->pass && !view->sky && strcmp(compile->pass, "gbuffer") != 0)
        return "--pass: gbuffer or sky";
    if (view->width > VIEW_SIZE_LIMIT / view->supersampling)
        return "--size times --samples is more than 8192";
    if (!line->input_count)
        return "no document";
    if (line->output && line->folder)
        return "-o and -d exclude each other";
    return line->output && line->input_count > 1 ? "several documents need -d, not -o" : NULL;
}

static MatcDocument *read_document(const CommandLine *line, const char *path)
{
    bool standard = !strcmp(path, "-");
    size_t size;
    const char *why;
    char *text = standard ? file_read_from(STDIN_FILENO, &size, &why) : file_read_named(path, &size, &why);
    if (!text)
        complain(path, why);
    MatcDocument *document = text ? matc_read(standard ? "<stdin>" : path, text, size, &line->picture.compile) : NULL;
    free(text);
    return document;
}

static void path_of(const CommandLine *line, const char *input, const char *material, char *path)
{
    const char *slash = strrchr(input, '/'), *stem = slash ? slash + 1 : input, *dot = strrchr(stem, '.');
    int size = dot && dot != stem ? (int)(dot - stem) : (int)strlen(stem);
    if (line->output)
        snprintf(path, LONGEST_PATH, "%s", line->output);
    else
        snprintf(path, LONGEST_PATH, "%s%s%.*s%s%s.png", line->folder ? line->folder : "", line->folder ? "/" : "",
                 size, stem, material ? "." : "", material ? material : "");
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
    return !why;
}

static int draw_material(const CommandLine *line, MatcDocument *document, int material, const char *path)
{
    const ViewOptions *view = &line->picture.view;
    Picture picture = {.rgb = malloc((size_t)view->width * (size_t)view->height * 3)};
    const PngPicture png = {view->width, view->height, 3, picture.rgb};
    if (!picture.rgb)
        abort();
    bool done = picture_draw(document, material, &line->picture, &picture);
    fputs(picture.diagnostics ? picture.diagnostics : "", stderr);
    if (!done && *picture.error)
        complain(path, picture.error);
    done = done && write_picture(&png, path);
    if (done && strcmp(path, "-") != 0)
        puts(path);
    free(picture.diagnostics);
    free(picture.rgb);
    return done ? FINE : FAULT;
}

static int choose_and_draw(const CommandLine *line, MatcDocument *document, const char *input)
{
    char path[LONGEST_PATH];
    int count = matc_material_count(document), status = FINE;
    int chosen = line->material ? matc_material_find(document, line->material) : count == 1 ? 0 : -1;
    if (line->material && chosen < 0)
        return complain(line->material, "no such material in the document");
    if (chosen < 0 && line->output) {
        fputs("matview: error: the document has several materials; name one with --material, or use -d\n", stderr);
        return FAULT;
    }
    for (int i = 0; i < count; i++) {
        if (chosen >= 0 && i != chosen)
            continue;
        path_of(line, input, count > 1 ? matc_material_name(document, i) : NULL, path);
        status |= draw_material(line, document, i, path);
    }
    return status;
}

static int run_input(const CommandLine *line, const char *input)
{
    MatcDocument *document = read_document(line, input);
    if (!document)
        return FAULT;
    fputs(matc_diagnostics(document, MATC_TEXT), stderr);
    int status = matc_material_count(document) ? choose_and_draw(line, document, input) : FAULT;
    matc_document_free(document);
    return status;
}

static int run(CommandLine *line)
{
    char error[LONGEST_MESSAGE] = "";
    if (line->folder && mkdir(line->folder, 0777) && errno != EEXIST)
        return complain(line->folder, strerror(errno));
    line->picture.view.gl = gl_open(line->gl, true, error, sizeof error);
    if (!line->picture.view.gl)
        return complain(gl_kind_name(line->gl), error);
    int status = FINE;
    for (int i = 0; i < line->input_count; i++)
        status |= run_input(line, line->inputs[i]);
    gl_close(line->picture.view.gl);
    return status;
}

int main(int argc, char **argv)
{
    CommandLine line = {.inputs = calloc((size_t)argc + 1, sizeof *line.inputs)};
    if (!line.inputs)
        abort();
    matc_options_init(&line.picture.compile);
    line.picture.compile.pixels = true;
    line.picture.view =
        (ViewOptions){.width = 512, .supersampling = 4, .screen_text = view_text_screen, .light_text = view_text_light};
    const char *fault = read_arguments(&line, argc, argv);
    int status = FINE;
    if (fault)
        status = usage(fault);
    else if (line.help)
        fputs(help_text, stdout);
    else if (line.version)
        puts("matview " MATC_VERSION);
    else
        status = (fault = check_usage(&line)) ? usage(fault) : run(&line);
    free(line.inputs);
    return status;
}
