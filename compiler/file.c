/* Reading whole files. */
#include "file.h"
#include "compile.h"
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { ROOM = 1 << 14 };

static char *resized(char *text, size_t room)
{
    char *more = realloc(text, room);
    if (!more)
        abort();
    return more;
}

char *file_read_from(int descriptor, size_t *size, const char **why)
{
    const size_t most = ((size_t)LIMIT_DOCUMENT_MIB << 20) + ROOM;
    struct stat info;
    bool sized = !fstat(descriptor, &info) && S_ISREG(info.st_mode) && (size_t)info.st_size < most;
    size_t room = sized ? (size_t)info.st_size + 2 : ROOM, used = 0; /* one more than it has, to see its end */
    char *text = resized(NULL, room);
    for (;;) {
        ssize_t got = read(descriptor, text + used, room - 1 - used);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0 || used > most) {
            *why = got < 0 ? strerror(errno) : "it is too large";
            free(text);
            return NULL;
        }
        used += (size_t)got;
        if (!got)
            break;
        if (used == room - 1)
            text = resized(text, room *= 2);
    }
    text[used] = 0;
    *size = used;
    return text;
}

char *file_read(const char *path, size_t *size, const char **why)
{
    int descriptor = open(path, O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        *why = strerror(errno);
        return NULL;
    }
    char *text = file_read_from(descriptor, size, why);
    close(descriptor);
    return text;
}
