/* Writes the documents of growth.def, and compiles them, timed by the thread's CPU clock. */
#include "growth.h"
#include "compiler/read/tree.h"
#include "compiler/ir/ir.h"
#include "compiler/matc.h"
#include "compiler/pipeline.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* clang-format off */
const GrowthRow growth_table[] = {
#define MANY(name, options, count, head, part, tail) \
    {#name, options, count, false, false, head, part, tail, "", ""},
#define BAD(name, options, count, head, part, tail) \
    {#name, options, count, true, false, head, part, tail, "", ""},
#define NEST(name, options, count, head, part, middle, close, tail) \
    {#name, options, count, false, false, head, part, middle, close, tail},
#define DEEP(name, options, count, part, top) \
    {#name, options, count, false, true, top, part, "", "", ""},
#include "growth.def"
};
/* clang-format on */
const int growth_count = sizeof growth_table / sizeof *growth_table;

enum {
    STEP = 40
    /* maps that a material resolves itself: a reference and its target each use a level of
     * LIMIT_DEPTH */
};

void growth_put_part(FILE *out, const char *part, int number)
{
    for (const char *at = part; *at; at++)
        if (*at == '$')
            fprintf(out, "%d", number);
        else if (*at == '@')
            fprintf(out, "{ ref: k%d }", number - 1);
        else
            fputc(*at, out);
}

static void put_many(FILE *out, const GrowthRow *row, int count)
{
    fputs(row->head, out);
    for (int i = 0; i < count; i++)
        growth_put_part(out, row->part, i);
    fputs(row->middle, out);
    for (int i = 0; i < count; i++)
        growth_put_part(out, row->close, i);
    fputs(row->tail, out);
}

/* Writes k0 ... as definitions; the last one has `top`, or with '!' a frame of `top`. */
static void put_deep(FILE *out, const GrowthRow *row, int count)
{
    fputs("defs:\n  k0: { map: Granite }\n", out);
    for (int i = 1; i <= count; i++) {
        fprintf(out, "  k%d: ", i);
        growth_put_part(out, row->part, i);
        fputc('\n', out);
    }
    fputs("materials:\n", out);
    for (int i = STEP; i < count; i += STEP)
        fprintf(out, "  m%d: { material: Phong, diffuse: { ref: k%d } }\n", i, i);
    bool frame = *row->head == '!';
    fprintf(out, "  top: { material: Phong, %s: ", frame ? "input" : "diffuse");
    growth_put_part(out, row->head + frame, count + 1);
    fputs(" }\n", out);
}

char *growth_text(const GrowthRow *row, int count, size_t *size)
{
    char *text = NULL;
    FILE *out = open_memstream(&text, size);
    if (row->deep)
        put_deep(out, row, count);
    else
        put_many(out, row, count);
    fclose(out);
    return text;
}

/* One white pixel. */
static const unsigned char picture[] = {
    0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48,
    0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00,
    0x00, 0x3A, 0x7E, 0x9B, 0x55, 0x00, 0x00, 0x00, 0x0A, 0x49, 0x44, 0x41, 0x54, 0x78,
    0xDA, 0x63, 0xF8, 0x0F, 0x00, 0x01, 0x01, 0x01, 0x00, 0x1C, 0xB0, 0x8C, 0x99, 0x00,
    0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};

#define TEXT(text) text, sizeof(text) - 1
static char *read_made(void *user, const char *path, size_t *size, const char **why)
{
    static const struct {
        const char *in_name, *text;
        size_t size;
    } files[] = {{".png", (const char *)picture, sizeof picture},
                 {".gltf", TEXT("{\"images\":[{\"uri\":\"a.png\"}]}")},
                 {"material", TEXT("material: RGBA\n")},
                 {"", TEXT("defs: {}\n")}};
    int i = 0;
    (void)user;
    *why = "it is missing";
    if (strstr(path, "missing"))
        return NULL;
    while (!strstr(path, files[i].in_name))
        i++;
    *size = files[i].size;
    char *bytes = malloc(*size + 1);
    memcpy(bytes, files[i].text, *size);
    bytes[*size] = 0;
    return bytes;
}

typedef struct {
    MatcOptions options;
    bool eval, fit, all, ir, scene, layout, tree;
    const char *name; /* name of the document; its ending determines the format */
    const char *mesh; /* ending of a mesh file; NULL: no mesh */
} Setting;

static void set_option(Setting *s, const char *name, char *value)
{
    if (!strcmp(name, "eval"))
        s->eval = s->options.pixels = true;
    else if (!strcmp(name, "fit"))
        s->fit = true;
    else if (!strcmp(name, "json"))
        s->name = "growth.json";
    else if (!strcmp(name, "gltf"))
        s->name = "growth.gltf";
    else if (!strcmp(name, "tree"))
        s->name = "growth.gltf", s->tree = true;
    else if (!strcmp(name, "mesh"))
        s->mesh = value;
    else if (!strcmp(name, "file"))
        s->layout = true;
    else if (!strcmp(name, "ir"))
        s->ir = true;
    else if (!strcmp(name, "scene"))
        s->scene = true;
    else if (!strcmp(name, "all"))
        s->all = true;
    else if (!strcmp(name, "measure"))
        s->options.measure = true;
    else if (!strcmp(name, "validate"))
        s->options.validate = true;
    else if (name[0] == 'O')
        s->options.optimize = name[1] - '0';
    else if (!value || !matc_options_set(&s->options, name, value))
        abort();
}

/* `words` stores the values, and must outlive the setting. */
static Setting setting_of(const GrowthRow *row, char *words)
{
    Setting s = {.name = "growth.yaml"};
    matc_options_init(&s.options);
    s.options.validate = false;
    s.options.read_file = read_made;
    s.options.check = false;
    strcpy(words, row->options);
    for (char *rest, *word = strtok_r(words, " ", &rest); word; word = strtok_r(NULL, " ", &rest)) {
        char *value = strchr(word, '=');
        if (value)
            *value++ = 0;
        set_option(&s, word, value);
    }
    return s;
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

static void compile(MatcDocument *document, int material, const Setting *s, GrowthRun *run)
{
    static const unsigned outputs[] = {MATC_FRAGMENT, MATC_VERTEX, MATC_UNPACK, MATC_REFLECT,
                                       MATC_IR,       MATC_DOT,    MATC_LAYOUT, MATC_STATS};
    enum { COUNT = sizeof outputs / sizeof *outputs };
    unsigned all = 0;
    for (int i = 0; i < COUNT; i++)
        all |= outputs[i];
    MatcProgram *program = matc_compile(document, material, all, &s->options);
    for (int i = 0; i < COUNT; i++) {
        size_t size = 0;
        run->written += matc_output(program, (MatcOutput)outputs[i], &size) ? size : 0;
    }
    if (matc_ok(program))
        run->written += strlen(matc_key(program)) + (size_t)matc_place_count(program);
    run->written += (size_t)matc_texture_count(program);
    run->written += strlen(matc_program_diagnostics(program, MATC_JSON));
    run->errors += !matc_ok(program);
    matc_program_free(program);
}

static void evaluate(const MatcDocument *document, int material, const Setting *s, GrowthRun *run)
{
    const char *fault;
    char *text = matc_eval(document, material, "u=0.3 v=0.4 x=0.2 y=0.7", &s->options, &fault);
    run->written += text ? strlen(text) : 0;
    run->errors += !text;
    free(text);
}

/* Makes a layout as --layout=auto does, from a material's intervals. */
static void fit(const MatcDocument *document, int material, const Setting *s, GrowthRun *run)
{
    MatcRanges *ranges = malloc(sizeof *ranges);
    char *fault;
    matc_ranges_init(ranges);
    run->errors += !matc_ranges_add(ranges, document, material, &s->options, &fault);
    MatcLayout *layout = matc_layout_for(ranges, 0, &s->options);
    run->errors += !matc_layout_ok(layout);
    run->written += strlen(matc_layout_diagnostics(layout, MATC_TEXT)) + (size_t)ranges->materials;
    matc_layout_free(layout);
    free(fault);
    free(ranges);
}

/* Reads the document made from a glTF file's materials. */
static void read_tree(const Setting *s, const char *text, GrowthRun *run)
{
    Arena arena = {0};
    Session session = session_open(&s->options, &arena);
    const Source source = {.name = s->name, .text = text, .size = run->read};
    ARENA_PUSH(&arena, session.sources, session.source_count, session.source_capacity, source);
    const Tree *tree = read_document(&session, 0);
    const Member *materials = tree ? tree_find(tree, "materials") : NULL;
    run->written += materials ? materials->value->count : 0;
    run->errors += session.diags.count;
    arena_free(&arena);
}

/* Prints the IR of the last material, reads it back and prints it. */
static void read_back(const Setting *s, const char *text, GrowthRun *run)
{
    Arena arena = {0};
    Session session = {.options = &s->options, .arena = &arena, .optimize = s->options.optimize};
    Source source = {.name = "growth.yaml", .text = text, .size = run->read};
    Tree *tree;
    Job job;
    ARENA_PUSH(&arena, session.sources, session.source_count, session.source_capacity, source);
    choice_job(&s->options, &job);
    Graph *graph = compile_front(&session, 0, &tree);
    Ir *ir =
        graph ? compile_ir(&session, graph, graph->materials[graph->material_count - 1].node, &job)
              : NULL;
    Text out = text_new(&arena), again = text_new(&arena);
    const char *wrong = NULL;
    if (ir) {
        ir_print(&out, ir);
        ir = ir_read(&session, out.at, graph, &wrong);
    }
    if (ir)
        ir_print(&again, ir);
    run->written += again.size;
    run->errors += !ir;
    arena_free(&arena);
}

/* Reads a layout file. */
static void read_layout(const Setting *s, const char *text, GrowthRun *run)
{
    MatcLayout *layout = matc_layout_read(s->name, text, run->read, &s->options);
    run->errors += !matc_layout_ok(layout);
    run->written += strlen(matc_layout_diagnostics(layout, MATC_TEXT));
    run->written += matc_layout_ok(layout) ? strlen(matc_layout_text(layout)) : 0;
    matc_layout_free(layout);
}

static void compile_document(const Setting *s, const char *text, GrowthRun *run)
{
    MatcDocument *document = matc_read(s->name, text, run->read, &s->options);
    run->written += strlen(matc_tree_text(document)) + (size_t)matc_depend_count(document);
    run->written += strlen(matc_diagnostics(document, MATC_TEXT)) +
                    strlen(matc_diagnostics(document, MATC_JSON));
    run->errors += matc_error_count(document);
    int materials = matc_material_count(document);
    for (int i = s->all ? 0 : materials - 1; i >= 0 && i < materials; i++)
        if (s->eval)
            evaluate(document, i, s, run);
        else if (s->fit)
            fit(document, i, s, run);
        else
            compile(document, i, s, run);
    matc_document_free(document);
}

GrowthRun growth_run(const GrowthRow *row, int count)
{
    char words[128];
    const Setting s = setting_of(row, words);
    GrowthRun run = {0};
    char *text = growth_text(row, count, &run.read);
    if (s.mesh) {
        growth_mesh(text, s.mesh, &run);
        free(text);
        return run;
    }
    double start = now();
    if (s.ir)
        read_back(&s, text, &run);
    else if (s.tree)
        read_tree(&s, text, &run);
    else if (s.layout)
        read_layout(&s, text, &run);
    else if (s.scene)
        growth_scene(text, &s.options, &run);
    else
        compile_document(&s, text, &run);
    run.seconds = now() - start;
    free(text);
    return run;
}

double growth_seconds(const GrowthRow *row, int count, int runs)
{
    double least = INFINITY;
    for (int i = 0; i < runs; i++)
        least = fmin(least, growth_run(row, count).seconds);
    return least;
}
