/* Opens files for assimp: the mesh file, and the files that it refers to. */
#include "runtime/mesh_import/model_open.h"
#ifdef MATC_ASSIMP
#include "compiler/base/memory.h"
#include "compiler/base/root.h"
#include "compiler/base/text.h"
#include "runtime/mesh_import/model_number.h"
#include <assimp/cfileio.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct {
    struct aiFile calls; /* first member: assimp's pointer is also a pointer to ModelFile */
    FILE *file;
    char *text; /* rewritten content that `file` reads; NULL: a file on disk */
    size_t size;
} ModelFile;

static FILE *file_of(struct aiFile *opened) { return ((ModelFile *)opened)->file; }

static size_t read_some(struct aiFile *opened, char *to, size_t size, size_t count)
{
    return fread(to, size, count, file_of(opened));
}

static size_t write_nothing(struct aiFile *opened, const char *from, size_t size, size_t count)
{
    (void)opened, (void)from, (void)size, (void)count;
    return 0;
}

static void flush_nothing(struct aiFile *opened) { (void)opened; }

static size_t tell(struct aiFile *opened) { return (size_t)ftello(file_of(opened)); }

static size_t size_of(struct aiFile *opened) { return ((ModelFile *)opened)->size; }

static enum aiReturn seek(struct aiFile *opened, size_t offset, enum aiOrigin origin)
{
    static const int whence[] = {
        [aiOrigin_SET] = SEEK_SET, [aiOrigin_CUR] = SEEK_CUR, [aiOrigin_END] = SEEK_END};
    return fseeko(file_of(opened), (off_t)offset, whence[origin]) ? aiReturn_FAILURE
                                                                  : aiReturn_SUCCESS;
}

/* Opens a file without blocking on pipes. Returns NULL if the path is no regular file or the
 * file is too large. */
static FILE *open_file(const char *root, const char *path, size_t *size)
{
    struct stat info;
    const char *why;
    const int descriptor = root_open(root, path, &why);
    if (descriptor < 0)
        return NULL;
    FILE *file = !fstat(descriptor, &info) && info.st_size <= (off_t)MODEL_FILE_MIB << 20
                     ? fdopen(descriptor, "rb")
                     : NULL;
    if (file)
        *size = (size_t)info.st_size;
    else
        close(descriptor);
    return file;
}

/* Replaces a .gltf or .glb by its copy with numbered materials and vertices. */
static void number_file(ModelFile *opened, bool binary)
{
    char *text = malloc(opened->size + 1);
    if (!text)
        memory_exhausted();
    size_t size = fread(text, 1, opened->size, opened->file);
    opened->text = binary ? model_number_binary(text, size, &size) : model_number_text(text, size);
    if (opened->text && !binary)
        size = strlen(opened->text);
    free(text);
    rewind(opened->file);
    FILE *file = opened->text ? fmemopen(opened->text, size, "rb") : NULL;
    if (!file)
        return;
    fclose(opened->file);
    opened->file = file;
    opened->size = size;
}

static struct aiFile *open_model_file(struct aiFileIO *files, const char *path, const char *mode)
{
    (void)mode;
    ModelFile *opened = calloc(1, sizeof *opened);
    if (!opened)
        memory_exhausted();
    opened->calls =
        (struct aiFile){read_some, write_nothing, tell, size_of, seek, flush_nothing, NULL};
    opened->file = open_file(files->UserData, path, &opened->size);
    if (opened->file) {
        const char *dot = strrchr(path, '.');
        if (dot && (text_same(dot, ".gltf") || text_same(dot, ".glb")))
            number_file(opened, text_same(dot, ".glb"));
        return &opened->calls;
    }
    free(opened);
    return NULL;
}

static void close_model_file(struct aiFileIO *files, struct aiFile *opened)
{
    (void)files;
    fclose(file_of(opened));
    free(((ModelFile *)opened)->text);
    free(opened);
}

struct aiFileIO model_open_files(const char *root)
{
    return (struct aiFileIO){open_model_file, close_model_file, (aiUserData)root};
}
#endif
