/* Reads whole files and pipes. */
#include "compiler/base/file.h"
#include "compiler/base/memory.h"
#include "compiler/base/session.h"
#include "compiler/base/text.h"
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    CAPACITY = 1 << 14,
    FOR_EVER = -1,
    FIRST_BYTE_MS = 1000 /* timeout for a pipe that has no writer yet */
};

static char *resized(char *text, size_t capacity)
{
    char *more = realloc(text, capacity);
    if (!more)
        memory_exhausted();
    return more;
}

/* Waits until bytes are available, the last writer has closed its end, or the timeout has
 * expired. */
static void wait_for_bytes(int descriptor, int milliseconds)
{
    struct pollfd wanted = {.fd = descriptor, .events = POLLIN};
    while (poll(&wanted, 1, milliseconds) < 0 && errno == EINTR)
        continue;
}

char *file_read_from(int descriptor, size_t *size, const char **why)
{
    const size_t most = ((size_t)LIMIT_DOCUMENT_MIB << 20) + CAPACITY;
    struct stat info;
    bool sized = !fstat(descriptor, &info) && S_ISREG(info.st_mode) && (size_t)info.st_size < most;
    /* Two bytes more than the file's size: one detects its end, the other holds the terminating
     * zero. */
    size_t capacity = sized ? (size_t)info.st_size + 2 : CAPACITY, used = 0;
    char *text = resized(NULL, capacity);
    for (;;) {
        ssize_t got = read(descriptor, text + used, capacity - 1 - used);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0 && errno == EAGAIN) {
            wait_for_bytes(descriptor, FOR_EVER);
            continue;
        }
        if (got < 0 || used > most) {
            *why = got < 0 ? text_error(errno) : "the file is too large";
            free(text);
            return NULL;
        }
        used += (size_t)got;
        if (!got)
            break;
        if (used == capacity - 1)
            text = resized(text, capacity *= 2);
    }
    text[used] = 0;
    *size = used;
    return text;
}

const char *file_refuses(int descriptor)
{
    struct stat info;
    if (fstat(descriptor, &info))
        return text_error(errno);
    if (S_ISREG(info.st_mode))
        return NULL;
    return S_ISDIR(info.st_mode)    ? text_error(EISDIR)
           : S_ISFIFO(info.st_mode) ? "the file is a pipe"
                                    : "the file is a device";
}

int file_open(const char *path, const char **why)
{
    int descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor < 0)
        *why = text_error(errno);
    return descriptor;
}

char *file_read_whole(int descriptor, size_t *size, const char **why)
{
    if (descriptor < 0)
        return NULL;
    *why = file_refuses(descriptor);
    char *text = *why ? NULL : file_read_from(descriptor, size, why);
    close(descriptor);
    return text;
}

char *file_read(const char *path, size_t *size, const char **why)
{
    return file_read_whole(file_open(path, why), size, why);
}

static char *read_pipe(int descriptor, size_t *size, const char **why)
{
    wait_for_bytes(descriptor, FIRST_BYTE_MS);
    char *text = file_read_from(descriptor, size, why);
    if (!text || *size)
        return text;
    *why = "the pipe has no data";
    free(text);
    return NULL;
}

char *file_read_named(const char *path, size_t *size, const char **why)
{
    struct stat info;
    int descriptor = file_open(path, why);
    if (descriptor < 0)
        return NULL;
    bool pipe = !fstat(descriptor, &info) && S_ISFIFO(info.st_mode);
    *why = pipe ? NULL : file_refuses(descriptor);
    if (*why && isatty(descriptor))
        *why = NULL;
    char *text = *why   ? NULL
                 : pipe ? read_pipe(descriptor, size, why)
                        : file_read_from(descriptor, size, why);
    close(descriptor);
    return text;
}

char *file_read_document(const char *path, size_t *size, const char **why)
{
    return strcmp(path, "-") ? file_read_named(path, size, why)
                             : file_read_from(STDIN_FILENO, size, why);
}

const char *file_document_name(const char *path) { return strcmp(path, "-") ? path : "<stdin>"; }
