/* Files wait in a folder of the process within the folder, so that moving them is a rename. */
#include "stage.h"
#include "sets.h"
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LONGEST_PATH = 4096 };

typedef struct {
    bool waits; /* in the stage; else the folder has it already */
    bool dropped;
} StagedFile;

struct Stage {
    char *folder, *waiting;
    bool made; /* `waiting` exists */
    StringSet names;
    StagedFile *files; /* by number of the name */
    int written;
    pthread_mutex_t mutex, making; /* of what is here; of files being made */
};

Stage *stage_open(const char *folder, const char **why)
{
    char waiting[64];
    if (mkdir(folder, 0777) && errno != EEXIST) {
        *why = strerror(errno);
        return NULL;
    }
    Stage *s = sets_resize(NULL, sizeof *s);
    snprintf(waiting, sizeof waiting, "/.matc-%ld", (long)getpid());
    *s = (Stage){.folder = sets_copy(folder), .waiting = sets_resize(NULL, strlen(folder) + sizeof waiting)};
    strcat(strcpy(s->waiting, folder), waiting);
    pthread_mutex_init(&s->mutex, NULL);
    pthread_mutex_init(&s->making, NULL);
    return s;
}

/* The file's path; false: too long. */
static bool join(char path[LONGEST_PATH], const char *folder, const char *name)
{
    return snprintf(path, LONGEST_PATH, "%s/%s", folder, name) < LONGEST_PATH;
}

static bool is_there(const char *path, const void *bytes, size_t size)
{
    struct stat info;
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0)
        return false;
    bool equal = !fstat(file, &info) && S_ISREG(info.st_mode) && (size_t)info.st_size == size;
    char *old = equal ? malloc(size + 1) : NULL;
    equal = old && read(file, old, size) == (ssize_t)size && !memcmp(old, bytes, size);
    free(old);
    close(file);
    return equal;
}

static const char *make_waiting(Stage *s)
{
    const char *why = NULL;
    pthread_mutex_lock(&s->mutex);
    if (!s->made && mkdir(s->waiting, 0777) && errno != EEXIST)
        why = strerror(errno);
    s->made |= !why;
    pthread_mutex_unlock(&s->mutex);
    return why;
}

static const char *write_waiting(const char *path, const void *bytes, size_t size)
{
    int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0)
        return strerror(errno);
    const char *at = bytes, *why = NULL;
    while (size && !why) {
        ssize_t got = write(file, at, size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            why = strerror(errno ? errno : EIO);
        at += got > 0 ? got : 0;
        size -= got > 0 ? (size_t)got : 0;
    }
    if (close(file) && !why)
        why = strerror(errno);
    return why;
}

const char *stage_put(Stage *s, const char *name, const void *bytes, size_t size)
{
    char path[LONGEST_PATH];
    const char *why = NULL;
    if (!join(path, s->waiting, name)) /* longer than in the folder itself */
        return "the path is too long";
    join(path, s->folder, name);
    bool waits = !is_there(path, bytes, size);
    if (waits && !(why = make_waiting(s))) {
        join(path, s->waiting, name);
        pthread_mutex_lock(&s->making); /* kernels serialise it anyway, and spin */
        why = write_waiting(path, bytes, size);
        pthread_mutex_unlock(&s->making);
    }
    if (why)
        return why;
    pthread_mutex_lock(&s->mutex);
    bool added;
    int number = strings_add(&s->names, name, &added);
    if (added)
        s->files = sets_resize(s->files, (size_t)s->names.room * sizeof *s->files);
    else if (s->files[number].waits && !waits && join(path, s->waiting, name))
        unlink(path);
    s->files[number] = (StagedFile){.waits = waits};
    pthread_mutex_unlock(&s->mutex);
    return NULL;
}

void stage_drop(Stage *s, const char *name)
{
    pthread_mutex_lock(&s->mutex);
    int number = strings_find(&s->names, name);
    if (number >= 0)
        s->files[number].dropped = true;
    pthread_mutex_unlock(&s->mutex);
}

const char *stage_commit(Stage *s)
{
    char from[LONGEST_PATH], to[LONGEST_PATH];
    for (int i = 0; i < s->names.count; i++) {
        StagedFile *file = &s->files[i];
        if (!file->waits || file->dropped)
            continue;
        join(from, s->waiting, s->names.at[i]);
        join(to, s->folder, s->names.at[i]);
        if (rename(from, to))
            return strerror(errno);
        file->waits = false;
        s->written++;
    }
    return NULL;
}

void stage_remove_stale(Stage *s, const char *name)
{
    char path[LONGEST_PATH];
    int number = strings_find(&s->names, name);
    if ((number < 0 || s->files[number].dropped) && !strchr(name, '/') && join(path, s->folder, name))
        unlink(path);
}

int stage_written(const Stage *s) { return s->written; }

void stage_close(Stage *s)
{
    char path[LONGEST_PATH];
    if (!s)
        return;
    for (int i = 0; i < s->names.count; i++) {
        if (s->files[i].waits && join(path, s->waiting, s->names.at[i]))
            unlink(path);
    }
    if (s->made)
        rmdir(s->waiting);
    pthread_mutex_destroy(&s->mutex);
    pthread_mutex_destroy(&s->making);
    free(s->files);
    strings_free(&s->names);
    free(s->folder);
    free(s->waiting);
    free(s);
}
