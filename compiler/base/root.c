/* Restricts reading to a root folder: first by the path's text, then by its resolved links, then
 * by opening each component without following links. */
#include "compiler/base/root.h"
#include "compiler/base/file.h"
#include "compiler/base/memory.h"
#include "compiler/base/text.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char root_outside[] = "it is outside the root folder";

void root_normalize(char *path)
{
    char *to = path, *start = path + (path[0] == '/');
    to = start;
    for (char *part = start; *part;) {
        size_t size = strcspn(part, "/");
        char *next = part + size + (part[size] == '/');
        bool up = size == 2 && part[0] == '.' && part[1] == '.', slash = part[size] == '/';
        bool can_pop = to > start && !(to - start >= 3 && !memcmp(to - 3, "../", 3) &&
                                       (to - 3 == start || to[-4] == '/'));
        if (size == 0 || (size == 1 && part[0] == '.')) {
            part = next;
            continue;
        }
        if (up && can_pop) {
            for (to--; to > start && to[-1] != '/';)
                to--;
        } else {
            memmove(to, part, size);
            to += size;
            if (slash)
                *to++ = '/';
        }
        part = next;
    }
    *to = 0;
}

/* Returns the part of `path` below `folder`, both absolute; NULL if it is not below. */
static const char *rest_below(const char *folder, const char *path)
{
    const size_t size = strcmp(folder, "/") ? strlen(folder) : 0;
    if (strncmp(path, folder, size) != 0 || path[size] != '/')
        return NULL;
    return path + size + 1;
}

/* Returns a normalized absolute path, without accessing the file; from malloc. NULL: errno says
 * why. */
static char *absolute(const char *path)
{
    char here[PATH_MAX] = "";
    if (path[0] != '/' && !getcwd(here, sizeof here))
        return NULL;
    char *whole = memory_checked(malloc(strlen(here) + 1 + strlen(path) + 1));
    strcpy(stpcpy(stpcpy(whole, here), "/"), path);
    root_normalize(whole);
    const size_t size = strlen(whole);
    if (size > 1 && whole[size - 1] == '/')
        whole[size - 1] = 0;
    return whole;
}

/* Returns true if the path's text leads below the root, either as the user wrote the root or
 * with its links resolved. */
static bool text_lies_below(const char *root, const char *canonical, const char *path)
{
    char *wanted = absolute(path), *written = absolute(root);
    const bool below =
        wanted && ((written && rest_below(written, wanted)) || rest_below(canonical, wanted));
    free(wanted);
    free(written);
    return below;
}

/* Opens the components of `rest` one after the other and fails at a symbolic link. Returns a
 * descriptor, or -1 and errno. */
static int open_rest(const char *folder, char *rest)
{
    int at = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    for (char *part = rest, *next; at >= 0; part = next + 1) {
        next = strchr(part, '/');
        if (next)
            *next = 0;
        const int how =
            O_RDONLY | O_CLOEXEC | O_NOFOLLOW | (next ? O_DIRECTORY : O_NONBLOCK | O_NOCTTY);
        const int below = openat(at, part, how), error = errno;
        close(at);
        errno = error;
        if (!next)
            return below;
        at = below;
    }
    return -1;
}

/* Resolves the links of a path; from malloc. Returns NULL and *why if the path leaves the root. */
static char *resolve(const char *root, const char *path, char **canonical, const char **why)
{
    *canonical = realpath(root, NULL);
    if (!*canonical) {
        *why = text_error(errno);
        return NULL;
    }
    if (!text_lies_below(root, *canonical, path)) {
        *why = root_outside;
        return NULL;
    }
    char *real = realpath(path, NULL);
    *why = !real ? text_error(errno) : rest_below(*canonical, real) ? NULL : root_outside;
    if (real && *why) {
        free(real);
        return NULL;
    }
    return real;
}

static int open_below(const char *root, const char *path, const char **why)
{
    char *canonical, *real = resolve(root, path, &canonical, why);
    const int descriptor = real ? open_rest(canonical, (char *)rest_below(canonical, real)) : -1;
    if (real && descriptor < 0)
        *why = text_error(errno);
    free(real);
    free(canonical);
    return descriptor;
}

int root_open(const char *root, const char *path, const char **why)
{
    const int descriptor = root ? open_below(root, path, why) : file_open(path, why);
    const char *fault = descriptor < 0 ? NULL : file_refuses(descriptor);
    if (!fault)
        return descriptor;
    close(descriptor);
    *why = fault;
    return -1;
}

char *root_read(const char *root, const char *path, size_t *size, const char **why)
{
    return file_read_whole(root_open(root, path, why), size, why);
}

const char *root_refuses(const char *root, const char *path)
{
    const char *why = NULL;
    char *canonical = NULL;
    if (root)
        free(resolve(root, path, &canonical, &why));
    free(canonical);
    return why == root_outside ? why : NULL;
}
