/* Host program that embeds text files in C: embed OUTPUT SYMBOL FILE... The SYMBOL "chunk_table"
 * writes library chunks for link.h; "library_table" files by name for grammar/library_table.h.
 * Any other symbol writes a string per file, `const char SYMBOL_<name>[]`, and next to OUTPUT a
 * header that declares all of them. A layout file pool.layout.def becomes the header
 * pool_layout.h for C; in GLSL it replaces the line #include "pool.layout.def". */
#include "compiler/gen/layout_text.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const char *path;
    char *name, *text;
} File;

static char *read_all(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file || fseek(file, 0, SEEK_END))
        return NULL;
    long size = ftell(file);
    rewind(file);
    char *text = malloc((size_t)size + 1);
    if (!text || fread(text, 1, (size_t)size, file) != (size_t)size)
        return NULL;
    text[size] = 0;
    fclose(file);
    return text;
}

/* Derives a chunk's name from its path, up to the last dot: "a/b/wood.glsl" -> "wood". */
static char *chunk_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *start = slash ? slash + 1 : path;
    size_t size = (size_t)(strrchr(start, '.') - start);
    char *name = calloc(1, size + 1);
    if (name)
        memcpy(name, start, size);
    return name;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const File *)a)->name, ((const File *)b)->name);
}

static void put_string(FILE *out, const char *text, size_t size)
{
    fputs("\"", out);
    for (size_t i = 0; i < size; i++)
        if (text[i] == '\n')
            fputs("\\n\"\n    \"", out);
        else
            fprintf(out, text[i] == '"' || text[i] == '\\' ? "\\%c" : "%c", text[i]);
    fputs("\"", out);
}

static int is_uniform(const char *line) { return !strncmp(line, "uniform ", 8); }

static const char *line_end(const char *line)
{
    const char *end = strchr(line, '\n');
    return end ? end + 1 : line + strlen(line);
}

/* Writes the uniforms that a text declares: "uniform highp sampler2D name;" as {"highp
 * sampler2D", "name", true}. */
static void put_uniforms(FILE *out, const char *text)
{
    fputs("(const ChunkUniform[]){", out);
    for (const char *line = text; *line; line = line_end(line)) {
        if (!is_uniform(line))
            continue;
        const char *type = line + 8, *stop = strchr(line, ';'), *name = stop,
                   *sampler = strstr(type, "sampler");
        while (name[-1] != ' ')
            name--;
        fprintf(out, "{\"%.*s\", \"%.*s\", %s}, ", (int)(name - 1 - type), type, (int)(stop - name),
                name, sampler && sampler < name ? "true" : "false");
    }
    fputs("{0}}", out);
}

/* Returns all other lines. */
static char *without_uniforms(const char *text)
{
    char *rest = calloc(1, strlen(text) + 1), *to = rest;
    for (const char *line = text, *end; rest && *line; line = end) {
        end = line_end(line);
        if (is_uniform(line))
            continue;
        memcpy(to, line, (size_t)(end - line));
        to += end - line;
    }
    return rest;
}

static int put_chunk(FILE *out, const File *file)
{
    static const char tag[] = "// needs:";
    if (strncmp(file->text, tag, sizeof tag - 1) != 0) {
        fprintf(stderr, "embed: %s.glsl does not begin with `%s`\n", file->name, tag);
        return 0;
    }
    const char *needs = file->text + sizeof tag - 1, *body = line_end(file->text);
    needs += strspn(needs, " ");
    char *rest = without_uniforms(body);
    fprintf(out, "    {\"%s\", ", file->name);
    put_string(out, needs, strcspn(needs, "\n"));
    fputs(",\n    ", out);
    put_uniforms(out, body);
    fputs(",\n    ", out);
    put_string(out, rest, strlen(rest));
    fputs("},\n", out);
    free(rest);
    return 1;
}

static int put_chunks(FILE *out, const File *files, int count)
{
    int fine = 1;
    fputs("#include \"compiler/library/chunk.h\"\nconst Chunk chunk_table[] = {\n", out);
    for (int i = 0; i < count; i++)
        fine &= put_chunk(out, &files[i]);
    fputs("};\nconst int chunk_count = sizeof chunk_table / sizeof *chunk_table;\n", out);
    return fine;
}

/* Writes the sentence of "    doc: A wall." or "    doc: \"A wall.\"".
 * tests/compiler/front/test_shipped.c compares it with the YAML parser's result. */
static void put_doc(FILE *out, const char *line)
{
    static const char key[] = "    doc: ";
    const char *start = line, *end = line;
    if (!strncmp(line, key, sizeof key - 1)) {
        start = line + sizeof key - 1;
        end = start + strcspn(start, "\n");
        if (*start == '"' && end > start + 1) {
            start++;
            end--;
        }
    }
    put_string(out, start, (size_t)(end - start));
}

/* Writes the keys under `defs:`, indented by two columns. */
static void put_names(FILE *out, const File *file)
{
    const char *defs = strstr(file->text, "\ndefs:\n");
    for (const char *line = defs ? defs + 1 : ""; *line; line = line_end(line)) {
        const size_t size = strcspn(line, ":\n");
        if (strncmp(line, "  ", 2) != 0 || line[2] == ' ' || line[2] == '#' || line[size] != ':')
            continue;
        fprintf(out, "    {\"%.*s\", \"%s.yaml\", ", (int)size - 2, line + 2, file->name);
        put_doc(out, line_end(line));
        fputs("},\n", out);
    }
}

static void put_library(FILE *out, const File *files, int count)
{
    fputs("#include \"grammar/library_table.h\"\nconst LibraryFile library_table[] = {\n", out);
    for (int i = 0; i < count; i++) {
        fprintf(out, "    {\"%s.yaml\", ", files[i].name);
        put_string(out, files[i].text, strlen(files[i].text));
        fputs("},\n", out);
    }
    fputs("};\nconst int library_count = sizeof library_table / sizeof *library_table;\n", out);
    fputs("const LibraryName library_names[] = {\n", out);
    for (int i = 0; i < count; i++)
        put_names(out, &files[i]);
    fputs("};\nconst int library_name_count = sizeof library_names / sizeof *library_names;\n",
          out);
}

/* -- Layouts */

/* Writes the GLSL declarations of the layout that a line includes. Returns 0 if the layout is
 * missing or has a wrong row. */
static int put_layout(FILE *out, const char *line, const File *files, int count)
{
    const char *name = line + sizeof "#include \"" - 1;
    const size_t size = strcspn(name, "\"\n");
    for (int i = 0; i < count; i++) {
        const char *slash = strrchr(files[i].path, '/'), *path = slash ? slash + 1 : files[i].path;
        if (layout_text_is(path) && strlen(path) == size && !strncmp(path, name, size))
            return layout_text_glsl(out, files[i].name, files[i].text);
    }
    fprintf(stderr, "embed: no layout for %.*s\n", (int)strcspn(line, "\n"), line);
    return 0;
}

/* Returns the file's text with each #include of a layout replaced; NULL on failure. */
static char *with_layouts(const File *file, const File *files, int count)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    int fine = out != NULL;
    for (const char *line = file->text, *end; fine && *line; line = end) {
        end = line_end(line);
        if (!strncmp(line, "#include \"", 10))
            fine = put_layout(out, line, files, count);
        else
            fwrite(line, 1, (size_t)(end - line), out);
    }
    if (out && fclose(out))
        fine = 0;
    if (!fine) {
        free(text);
        text = NULL;
    }
    return text;
}

static int write_output(FILE *out, const char *symbol, const File *files, int count)
{
    fputs("/* Made by compiler/gen/embed.c. */\n", out);
    if (!strcmp(symbol, "chunk_table"))
        return put_chunks(out, files, count);
    if (!strcmp(symbol, "library_table")) {
        put_library(out, files, count);
        return 1;
    }
    fprintf(out, "#include \"gen/%s.h\"\n", symbol);
    int fine = 1;
    for (int i = 0; fine && i < count; i++) {
        if (layout_text_is(files[i].path))
            continue;
        char *text = with_layouts(&files[i], files, count);
        fine = text != NULL;
        fprintf(out, "const char %s_%s[] = ", symbol, files[i].name);
        put_string(out, fine ? text : "", fine ? strlen(text) : 0);
        fputs(";\n", out);
        free(text);
    }
    return fine;
}

static char *header_text(const char *symbol, const File *files, int count)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return NULL;
    fputs("/* Made by compiler/gen/embed.c. */\n", out);
    for (int i = 0; i < count; i++)
        if (!layout_text_is(files[i].path))
            fprintf(out, "extern const char %s_%s[];\n", symbol, files[i].name);
    return fclose(out) ? NULL : text;
}

/* Leaves a file with equal text untouched, so that its users are not recompiled. */
static int write_if_changed(const char *path, const char *text)
{
    char *had = read_all(path);
    const int same = had && !strcmp(had, text);
    free(had);
    if (same)
        return 1;
    FILE *file = fopen(path, "w");
    if (!file)
        return 0;
    const int fine = fputs(text, file) >= 0;
    return !fclose(file) && fine;
}

/* Writes the header for an output: "gen/render_text.c" -> "gen/render_text.h". */
static int write_header(const char *output, const char *symbol, const File *files, int count)
{
    char *text = header_text(symbol, files, count), *path = strdup(output);
    const int fine =
        text && path && *path && (path[strlen(path) - 1] = 'h', write_if_changed(path, text));
    free(text);
    free(path);
    return fine;
}

/* Derives a layout's header: "gen/render_text.c" and "a/pool.layout.def" -> "gen/pool_layout.h". */
static char *layout_path(const char *output, const File *layout)
{
    const char *slash = strrchr(output, '/');
    char *path = NULL;
    if (asprintf(&path, "%.*s%s.h", slash ? (int)(slash + 1 - output) : 0, output, layout->name) <
        0)
        return NULL;
    char *dot = strstr(path, ".layout.h");
    if (dot)
        *dot = '_';
    return path;
}

static int write_layout(const char *output, const File *layout)
{
    char *text = NULL, *path = layout_path(output, layout);
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    int fine = out && layout_text_c(out, layout->name, layout->text);
    if (out && fclose(out))
        fine = 0;
    fine = fine && path && write_if_changed(path, text);
    free(text);
    free(path);
    return fine;
}

static int write_headers(const char *output, const char *symbol, const File *files, int count)
{
    int fine = write_header(output, symbol, files, count);
    for (int i = 0; fine && i < count; i++)
        if (layout_text_is(files[i].path))
            fine = write_layout(output, &files[i]);
    return fine;
}

static int is_table(const char *symbol)
{
    return !strcmp(symbol, "chunk_table") || !strcmp(symbol, "library_table");
}

int main(int argc, char **argv)
{
    if (argc < 4) {
        fputs("usage: embed OUTPUT SYMBOL FILE...\n", stderr);
        return 2;
    }
    int count = argc - 3;
    File *files = calloc((size_t)count, sizeof *files);
    for (int i = 0; i < count; i++) {
        files[i] = (File){argv[i + 3], chunk_name(argv[i + 3]), read_all(argv[i + 3])};
        if (!files[i].name || !files[i].text) {
            fprintf(stderr, "embed: cannot read %s\n", argv[i + 3]);
            return 1;
        }
    }
    qsort(files, (size_t)count, sizeof *files, by_name);
    FILE *out = fopen(argv[1], "w");
    int fine = out && write_output(out, argv[2], files, count);
    if (out && fclose(out))
        fine = 0;
    if (fine && !is_table(argv[2]))
        fine = write_headers(argv[1], argv[2], files, count);
    for (int i = 0; i < count; i++) {
        free(files[i].name);
        free(files[i].text);
    }
    free(files);
    return fine ? 0 : 1;
}
