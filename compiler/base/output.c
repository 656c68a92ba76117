/* Writes files atomically, and formats textures as KTX. */
#include "compiler/base/output.h"
#include "compiler/base/memory.h"
#include "compiler/base/text.h"
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *write_to(FILE *file, const void *bytes, size_t size)
{
    if (fwrite(bytes, 1, size, file) != size)
        return text_error(errno ? errno : EIO);
    return fflush(file) ? text_error(errno) : NULL;
}

/* Returns true for a path that cannot or must not be replaced by a rename. As root, a rename
 * could put a file in place of /dev/stdout. */
static bool is_special(const char *path)
{
    static const char *const open_files[] = {"/dev/stdout", "/dev/stderr", "/dev/fd/", "/proc/"};
    struct stat info;
    for (size_t i = 0; i < sizeof open_files / sizeof *open_files; i++)
        if (!strncmp(path, open_files[i], strlen(open_files[i])))
            return true;
    if (!stat(path, &info) && S_ISDIR(info.st_mode))
        return true; /* the open() that follows reports the error */
    return !lstat(path, &info) && !S_ISREG(info.st_mode) && !S_ISLNK(info.st_mode);
}

static const char *write_directly(const char *path, const void *bytes, size_t size)
{
    int number = open(path, O_WRONLY | O_TRUNC | O_NOCTTY | O_CLOEXEC);
    if (number < 0)
        return text_error(errno);
    FILE *file = fdopen(number, "wb");
    if (!file)
        memory_exhausted();
    const char *why = write_to(file, bytes, size);
    if (fclose(file) && !why)
        why = text_error(errno);
    return why;
}

Staging *outputs_open(Outputs *o, const char *folder, unsigned how, const char **why)
{
    *why = "too many folders";
    Staging *staging = o->count < OUTPUT_FOLDERS ? staging_open(folder, how, why) : NULL;
    for (int i = 0; i < o->count && staging; i++)
        if (staging_same(o->stagings[i], staging)) {
            staging_close(staging);
            return o->stagings[i];
        }
    if (staging)
        o->stagings[o->count++] = staging;
    return staging;
}

void output_hold_streams(void)
{
    for (int number = STDIN_FILENO; number <= STDERR_FILENO; number++)
        if (fcntl(number, F_GETFD) < 0)
            /* open() returns the lowest free descriptor */
            (void)!open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

const char *outputs_put(Outputs *o, const char *path, const void *bytes, size_t size)
{
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *why = NULL;
    if (!strcmp(path, "-"))
        return write_to(stdout, bytes, size);
    if (is_special(path))
        return write_directly(path, bytes, size);
    char *folder = slash ? strndup(path, (size_t)(slash - path) + 1) : strdup(".");
    if (!folder)
        return "out of memory";
    Staging *staging = outputs_open(o, folder, STAGING_renew, &why);
    free(folder);
    return staging ? staging_put(staging, name, bytes, size) : why;
}

const char *outputs_commit(Outputs *o) { return staging_commit(o->stagings, o->count); }

void outputs_close(Outputs *o)
{
    while (o->count)
        staging_close(o->stagings[--o->count]);
}

const char *output_write(const char *path, const void *bytes, size_t size)
{
    Outputs one = {0};
    const char *why = outputs_put(&one, path, bytes, size);
    if (!why)
        why = outputs_commit(&one);
    outputs_close(&one);
    return why;
}

enum { KTX_IDENTIFIER = 12, KTX_WORDS = 13, KTX_HEADER = KTX_IDENTIFIER + 4 * KTX_WORDS };

/* Fills the header of a KTX 1.1 file: endianness; type, type size, format, internal format, base
 * format; width, height, depth; array elements, faces, mipmap levels; bytes of key-value data. */
static void fill_ktx_header(const MatcTexture *t, unsigned char header[KTX_HEADER])
{
    enum {
        GL_UNSIGNED_BYTE = 0x1401,
        GL_FLOAT = 0x1406,
        GL_RED = 0x1903,
        GL_RGBA = 0x1908,
        GL_R8 = 0x8229,
        GL_R32F = 0x822E,
        GL_RGBA8 = 0x8058,
        GL_RGBA32F = 0x8814,
        ENDIANNESS = 0x04030201
    };
    static const unsigned char identifier[KTX_IDENTIFIER] = {0xAB, 'K',  'T',  'X',  ' ',  '1',
                                                             '1',  0xBB, '\r', '\n', 0x1A, '\n'};
    const bool floats = t->floats != NULL, rgba = t->components == 4;
    const uint32_t format = rgba ? GL_RGBA : GL_RED;
    const uint32_t inside = floats ? (rgba ? GL_RGBA32F : GL_R32F) : (rgba ? GL_RGBA8 : GL_R8);
    const uint32_t words[KTX_WORDS] = {ENDIANNESS,
                                       floats ? GL_FLOAT : GL_UNSIGNED_BYTE,
                                       floats ? sizeof(float) : 1,
                                       format,
                                       inside,
                                       format,
                                       (uint32_t)t->width,
                                       (uint32_t)t->height,
                                       0,
                                       0,
                                       1,
                                       1,
                                       0};
    memcpy(header, identifier, sizeof identifier);
    memcpy(header + sizeof identifier, words, sizeof words);
}

char *output_ktx(const MatcTexture *t, size_t *file_size)
{
    const size_t row = (size_t)t->width * (size_t)t->components * (t->floats ? sizeof(float) : 1);
    const size_t padded = (row + 3) & ~(size_t)3;
    const uint32_t size = (uint32_t)(padded * (size_t)t->height);
    unsigned char *file = calloc(1, KTX_HEADER + sizeof size + size);
    if (!file)
        memory_exhausted();
    fill_ktx_header(t, file);
    memcpy(file + KTX_HEADER, &size, sizeof size);
    const unsigned char *texels = t->floats ? (const unsigned char *)t->floats : t->bytes;
    for (int y = 0; y < t->height; y++)
        memcpy(file + KTX_HEADER + sizeof size + (size_t)y * padded, texels + (size_t)y * row, row);
    *file_size = KTX_HEADER + sizeof size + size;
    return (char *)file;
}
