/* Writing files: a temporary name in the same folder, then rename, so that no reader ever sees half a file. */
#include "output.h"
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static const char *write_to(FILE *file, const void *bytes, size_t size)
{
    if (fwrite(bytes, 1, size, file) != size)
        return strerror(errno ? errno : EIO);
    return NULL;
}

/* A device or a pipe cannot be renamed over: it is written as it is. */
static bool is_special(const char *path)
{
    struct stat info;
    return !stat(path, &info) && !S_ISREG(info.st_mode);
}

static const char *write_directly(const char *path, const void *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    if (!file)
        return strerror(errno);
    const char *why = write_to(file, bytes, size);
    if (fclose(file) && !why)
        why = strerror(errno);
    return why;
}

const char *output_write(const char *path, const void *bytes, size_t size)
{
    if (!strcmp(path, "-")) {
        const char *why = write_to(stdout, bytes, size);
        return why ? why : fflush(stdout) ? strerror(errno) : NULL;
    }
    if (is_special(path))
        return write_directly(path, bytes, size);
    size_t length = strlen(path) + 32;
    char *temporary = malloc(length);
    if (!temporary)
        return "out of memory";
    snprintf(temporary, length, "%s.tmp%ld", path, (long)getpid());
    const char *why = write_directly(temporary, bytes, size);
    if (!why && rename(temporary, path))
        why = strerror(errno);
    if (why)
        unlink(temporary);
    free(temporary);
    return why;
}

char *output_ktx(const MatcTexture *t, size_t *file_size)
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
        KTX_ENDIANNESS = 0x04030201,
        HEADER = 64
    };
    static const unsigned char identifier[12] = {0xAB, 'K', 'T', 'X', ' ', '1', '1', 0xBB, '\r', '\n', 0x1A, '\n'};
    bool floats = t->floats != NULL, rgba = t->lanes == 4;
    size_t row = (size_t)t->width * (size_t)t->lanes * (floats ? sizeof(float) : 1), padded = (row + 3) & ~(size_t)3;
    uint32_t size = (uint32_t)(padded * (size_t)t->height);
    uint32_t words[13] = {KTX_ENDIANNESS,
                          floats ? GL_FLOAT : GL_UNSIGNED_BYTE,
                          floats ? 4 : 1,
                          rgba ? GL_RGBA : GL_RED,
                          floats ? (rgba ? GL_RGBA32F : GL_R32F)
                          : rgba ? GL_RGBA8
                                 : GL_R8,
                          rgba ? GL_RGBA : GL_RED,
                          (uint32_t)t->width,
                          (uint32_t)t->height,
                          0,
                          0,
                          1,
                          1,
                          0};
    unsigned char *file = calloc(1, HEADER + sizeof size + size);
    if (!file)
        abort();
    memcpy(file, identifier, sizeof identifier);
    memcpy(file + sizeof identifier, words, sizeof words);
    memcpy(file + HEADER, &size, sizeof size);
    const unsigned char *texels = floats ? (const unsigned char *)t->floats : t->bytes;
    for (int y = 0; y < t->height; y++)
        memcpy(file + HEADER + sizeof size + (size_t)y * padded, texels + (size_t)y * row, row);
    *file_size = HEADER + sizeof size + size;
    return (char *)file;
}
