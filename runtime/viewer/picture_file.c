/* Buffers a picture in a temporary file through the writer of its format. */
#include "runtime/viewer/picture_file.h"
#include "compiler/base/memory.h"
#include "compiler/base/output.h"
#include "compiler/base/text.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

struct PictureFile {
    const PictureWriter *writer;
    void *state;
    FILE *out;
    int missing; /* rows still to be written */
};

bool picture_file_ending(const char *path, PictureFormat *format)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path,
               *dot = strrchr(name, '.');
    if (!dot || dot == name)
        return true;
    const bool png = text_same(dot, ".png"), exr = text_same(dot, ".exr");
    if (png || exr)
        *format = exr ? PICTURE_FORMAT_exr : PICTURE_FORMAT_png;
    return png || exr;
}

/* Opens an unnamed file in a folder. Returns NULL if the folder is missing or its file system
 * lacks O_TMPFILE. */
static FILE *nameless_file(const char *folder)
{
    const int number = open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    FILE *file = number < 0 ? NULL : fdopen(number, "w+b");
    if (number >= 0 && !file)
        close(number);
    return file;
}

/* Opens a temporary file in TMPDIR, else in tmpfile()'s folder. */
static FILE *temporary_file(void)
{
    const char *folder = getenv("TMPDIR");
    FILE *file = folder && *folder ? nameless_file(folder) : NULL;
    return file ? file : tmpfile();
}

PictureFile *picture_file_open(const PictureSpec *spec, const char **why)
{
    PictureFile *file = calloc(1, sizeof *file);
    if (!file)
        memory_exhausted();
    file->writer = spec->format == PICTURE_FORMAT_png ? &picture_png : &picture_exr;
    file->missing = spec->height;
    file->out = temporary_file();
    *why = file->out ? NULL : "no temporary file can be made in TMPDIR or " P_tmpdir;
    if (file->out)
        file->state = file->writer->open(spec, file->out, why);
    if (file->state)
        return file;
    picture_file_close(file);
    return NULL;
}

/* Returns the reason of a failure: the system's message for a write error, which the format's
 * library reports only vaguely. errno must be 0 before the call to the library. */
static const char *cause(const PictureFile *file, const char *why)
{
    return why && errno && ferror(file->out) ? text_error(errno) : why;
}

const char *picture_file_row(PictureFile *file, const float *rgba)
{
    file->missing--;
    errno = 0;
    return cause(file, file->writer->row(file->state, rgba));
}

/* Writes the temporary file's contents to `path`. The file is memory-mapped, so pages load on
 * demand. */
static const char *put(FILE *out, const char *path)
{
    const off_t size = fseeko(out, 0, SEEK_END) ? -1 : ftello(out);
    if (size <= 0)
        return text_error(errno ? errno : EIO);
    void *bytes = mmap(NULL, (size_t)size, PROT_READ, MAP_PRIVATE, fileno(out), 0);
    if (bytes == MAP_FAILED)
        return text_error(errno);
    const char *why = output_write(path, bytes, (size_t)size);
    munmap(bytes, (size_t)size);
    return why;
}

const char *picture_file_finish(PictureFile *file, const char *path)
{
    errno = 0;
    const char *why =
        file->missing ? "rows are missing" : cause(file, file->writer->finish(file->state));
    if (!why && fflush(file->out))
        why = text_error(errno);
    return why ? why : put(file->out, path);
}

void picture_file_close(PictureFile *file)
{
    if (!file)
        return;
    if (file->state)
        file->writer->close(file->state);
    if (file->out)
        fclose(file->out);
    free(file);
}
