/* --list FILE, --explain NAME FILE and --schema FILE: definitions of documents. */
#include "compiler/base/file.h"
#include "compiler/tool/main.h"
#include "compiler/tool/options_fault.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool main_is_document(const char *name)
{
    static const char *const endings[] = {".yaml", ".yml", ".json"};
    const size_t size = strlen(name);
    bool is = false;
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++)
        is |= size > strlen(endings[i]) && !strcmp(name + size - strlen(endings[i]), endings[i]);
    return is;
}

static int say(const CommandLine *line, const char *path, char *text, const char *otherwise)
{
    if (!text)
        return main_complain(line, path, otherwise);
    fputs(text, stdout);
    free(text);
    return EXIT_OK;
}

/* Returns true if a name is in matc's own tables. */
static bool main_is_own(const char *name)
{
    char *text = matc_explain(name);
    free(text);
    return text != NULL;
}

/* Answers a query. An unknown name is a usage error, as it is without a document. */
static int answer(CommandLine *line, const char *path, MatcDocument *document)
{
    if (line->schema)
        return say(line, path, matc_document_schema(document), "the file has errors");
    if (line->list)
        return say(line, path, matc_definitions(document), "the file has no definitions");
    char *text = matc_explain_definition(document, line->explain);
    if (!text)
        text = matc_explain(line->explain);
    if (!text)
        return main_usage(line, options_fault_explain(&line->words, line->explain));
    return say(line, path, text, "");
}

int main_definitions(CommandLine *line, const char *path)
{
    size_t size;
    const char *why;
    char *text = file_read_document(path, &size, &why);
    if (!text)
        return main_complain(line, path, why);
    MatcDocument *document = matc_read(file_document_name(path), text, size, &line->compile);
    free(text);
    int status = EXIT_ERROR;
    if (matc_error_count(document) && line->explain && main_is_own(line->explain))
        status = say(line, path, matc_explain(line->explain), "");
    else if (matc_error_count(document))
        fputs(matc_diagnostics(document, line->diagnostics), stderr);
    else
        status = answer(line, path, document);
    matc_document_free(document);
    return status;
}
