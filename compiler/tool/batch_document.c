/* A document of a batch: its text, its parsed form while needed, its materials. */
#include "compiler/tool/batch_state.h"
#include "compiler/base/file.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool is_standard_input(const BatchDocument *document)
{
    return !strcmp(document->path, "-");
}

static bool is_regular(const char *path)
{
    struct stat info;
    return !stat(path, &info) && S_ISREG(info.st_mode);
}

bool batch_open(Batch *b, BatchDocument *document)
{
    const char *why;
    if (document->text || document->unreadable)
        return document->text != NULL;
    document->text = file_read_document(document->path, &document->size, &why);
    document->unreadable = !document->text;
    document->once = is_standard_input(document) || !is_regular(document->path);
    if (document->unreadable)
        batch_complain(b, document, document->path, why);
    return document->text != NULL;
}

const MatcDocument *batch_document_parsed(Batch *b, BatchDocument *document)
{
    pthread_mutex_lock(&document->mutex);
    if (!document->parsed) {
        const char *name = file_document_name(document->path);
        document->parsed = matc_read(name, document->text, document->size, &b->options);
    }
    pthread_mutex_unlock(&document->mutex);
    return document->parsed;
}

void batch_close(BatchDocument *document)
{
    matc_document_free(document->parsed);
    document->parsed = NULL;
    if (document->once)
        return;
    free(document->text);
    document->text = NULL;
}

/* Returns the number of selected materials: all, or the one of --material. */
static int count_materials(Batch *b, BatchDocument *document)
{
    const char *wanted = b->line->material;
    int count = matc_material_count(document->parsed);
    if (!wanted || !count)
        return count;
    document->offset = matc_material_find(document->parsed, wanted);
    if (document->offset < 0)
        batch_complain(b, document, wanted, "no such material in the document");
    return document->offset >= 0;
}

void batch_document_make_capacity(BatchDocument *document, int materials, int requests, int depends)
{
    size_t units = (size_t)materials * (size_t)requests;
    document->material_count = materials;
    document->materials = sets_resize(NULL, (size_t)materials * sizeof *document->materials);
    memset(document->materials, 0, (size_t)materials * sizeof *document->materials);
    document->units = sets_resize(NULL, units * sizeof *document->units);
    memset(document->units, 0, units * sizeof *document->units);
    for (int i = 0; i < materials; i++)
        document->materials[i].units = document->units + (size_t)i * (size_t)requests;
    document->depend_count = depends;
    document->depends = sets_resize(NULL, (size_t)depends * sizeof *document->depends);
}

bool batch_document_list(Batch *b, BatchDocument *document)
{
    const MatcDocument *parsed = batch_document_parsed(b, document);
    int count = count_materials(b, document);
    batch_document_make_capacity(document, count, b->request_count, matc_depend_count(parsed));
    for (int i = 0; i < count; i++)
        document->materials[i].name = sets_copy(matc_material_name(parsed, document->offset + i));
    for (int i = 0; i < document->depend_count; i++)
        document->depends[i] = sets_copy(matc_depend(parsed, i));
    batch_report(b, document, matc_diagnostics(document->parsed, b->line->diagnostics));
    if (!count && (matc_error_count(parsed) || b->line->material))
        batch_fault(b);
    return count > 0;
}

void batch_document_free(BatchDocument *document, int requests)
{
    for (int m = 0; m < document->material_count; m++) {
        for (int t = 0; t < requests; t++)
            unit_free(&document->materials[m].units[t]);
        free(document->materials[m].name);
        bytes_free(&document->materials[m].reported);
    }
    for (int i = 0; i < document->depend_count; i++)
        free(document->depends[i]);
    free(document->depends);
    free(document->materials);
    free(document->units);
    free(document->ranges);
    free(document->again);
    free(document->text);
    bytes_free(&document->reported);
    pthread_mutex_destroy(&document->mutex);
}
