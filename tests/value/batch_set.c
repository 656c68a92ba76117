/* Writes documents, runs matc, reads what it wrote. */
#include "batch_set.h"
#include "compiler/base/file.h"
#include "compiler/matc.h"
#include <ctype.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

bool batch_set_open(BatchSet *set)
{
    char picture[SET_PATH];
    *set = (BatchSet){.folder = "/tmp/matc-set-XXXXXX"};
    if (!mkdtemp(set->folder))
        return false;
    snprintf(picture, sizeof picture, "%s/tiles.png", set->folder);
    return !symlink(SOURCE_FOLDER "/examples/tiles.png", picture);
}

void batch_set_close(BatchSet *set)
{
    char command[SET_PATH];
    cJSON_Delete(set->manifest);
    snprintf(command, sizeof command, "rm -rf '%s'", set->folder);
    if (*set->folder && system(command))
        perror(set->folder);
    *set = (BatchSet){0};
}

/* True if a number with a fraction starts here, outside of a word. */
static bool is_fraction(const char *text, const char *at)
{
    size_t whole = strspn(at, "0123456789");
    bool begins = at == text || !(isalnum((unsigned char)at[-1]) || strchr("._\"#", at[-1]));
    return begins && at[whole] == '.' && isdigit((unsigned char)at[whole + 1]);
}

static void put_color(FILE *out, const char *digits, int variant)
{
    static const char hex[] = "0123456789abcdef";
    for (int i = 0; i < 6; i++) {
        const char *digit = strchr(hex, tolower((unsigned char)digits[i]));
        fputc(hex[((digit ? digit - hex : 0) * 7 + 5 * variant) % 16], out);
    }
}

static bool is_color(const char *at)
{
    return *at == '#' && strspn(at + 1, "0123456789abcdefABCDEF") == 6;
}

/* Returns the text with other numbers; from malloc. */
static char *vary(const char *text, int variant)
{
    static const double factors[] = {1, 0.75, 0.9, 0.4};
    char *varied = NULL;
    size_t size;
    FILE *out = open_memstream(&varied, &size);
    if (!out)
        abort();
    for (const char *at = text; *at;) {
        if (variant && is_color(at)) {
            fputc('#', out);
            put_color(out, at + 1, variant);
            at += 7;
        } else if (variant && is_fraction(text, at)) {
            char *end;
            fprintf(out, "%#.6g", strtod(at, &end) * factors[variant % 4]);
            at = end;
        } else {
            fputc(*at++, out);
        }
    }
    fclose(out);
    return varied;
}

static bool is_valid(const char *path, const char *text)
{
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read(path, text, strlen(text), &options);
    bool valid = matc_material_count(document) == 1;
    matc_document_free(document);
    return valid;
}

static bool add(BatchSet *set, const char *text)
{
    char path[SET_PATH];
    snprintf(path, sizeof path, "%s/d%d.yaml", set->folder, set->count);
    FILE *file = is_valid(path, text) ? fopen(path, "w") : NULL;
    if (!file)
        return false;
    fputs(text, file);
    set->count += !fclose(file);
    return true;
}

int batch_set_add(BatchSet *set, const char *text, int variants)
{
    int added = 0;
    for (int i = 0; i <= variants; i++) {
        char *varied = vary(text, i);
        added += add(set, varied);
        free(varied);
    }
    return added;
}

char *batch_set_file(const BatchSet *set, const char *name, size_t *size)
{
    char path[SET_PATH];
    const char *why;
    snprintf(path, sizeof path, "%s/out/%s", set->folder, name);
    return file_read(path, size, &why);
}

char *batch_set_layout(const BatchSet *set, size_t *size)
{
    char pattern[SET_PATH];
    const char *why;
    glob_t found = {0};
    snprintf(pattern, sizeof pattern, "%s/out/*.layout.yaml", set->folder);
    char *text = glob(pattern, 0, NULL, &found) ? NULL : file_read(found.gl_pathv[0], size, &why);
    globfree(&found);
    return text;
}

bool batch_set_run(BatchSet *set, const char *matc, const char *options)
{
    char command[4 * SET_PATH];
    size_t size;
    snprintf(command, sizeof command,
             "cd '%s' && rm -rf out && ls d*.yaml > list && '%s' -j2 -d out %s @list", set->folder,
             matc, options);
    cJSON_Delete(set->manifest);
    set->manifest = NULL;
    if (system(command))
        return false;
    char *text = batch_set_file(set, "manifest.json", &size);
    set->manifest = text ? cJSON_Parse(text) : NULL;
    free(text);
    return set->manifest != NULL;
}
