/* Files wait in a folder of the process within the folder, so that moving them is a rename. The process holds a lock on it: one
 * without is of a process that was ended, and whoever comes next removes it. */
#include "stage.h"
#include "sets.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

enum { LONGEST_PATH = 4096, MOST_TRIES = 100, UNIQUE = 6 /* characters that mkdtemp chooses */ };

static const char waiting_name[] = ".matc-stage-";

typedef struct {
    bool waits; /* in the stage; else the folder has it already */
    bool dropped;
} StagedFile;

struct Stage {
    char *folder, *waiting;
    bool new_folder; /* and nothing is in it yet */
    bool made;       /* `waiting` exists */
    int lock;        /* `waiting`, open */
    StringSet names;
    StagedFile *files; /* by number of the name */
    int written;
    pthread_mutex_t mutex, making; /* of what is here; of files being made */
};

/* A folder where files wait, locked; -1: somebody else has it, or it is not there. */
static int claim(const char *path)
{
    int file = open(path, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (file >= 0 && flock(file, LOCK_EX | LOCK_NB)) {
        close(file);
        return -1;
    }
    return file;
}

static void remove_abandoned(const char *path)
{
    char name[LONGEST_PATH];
    int lock = claim(path);
    DIR *dir = lock < 0 ? NULL : opendir(path);
    for (struct dirent *item = dir ? readdir(dir) : NULL; item; item = readdir(dir))
        if (snprintf(name, sizeof name, "%s/%s", path, item->d_name) < (int)sizeof name)
            unlink(name);
    if (dir) {
        closedir(dir);
        rmdir(path);
    }
    if (lock >= 0)
        close(lock);
}

/* What processes that were ended in the middle left behind. */
static void clean(const char *folder)
{
    char path[LONGEST_PATH];
    DIR *dir = opendir(folder);
    for (struct dirent *item = dir ? readdir(dir) : NULL; item; item = readdir(dir))
        if (!strncmp(item->d_name, waiting_name, strlen(waiting_name)) &&
            strlen(item->d_name) == strlen(waiting_name) + UNIQUE &&
            snprintf(path, sizeof path, "%s/%s", folder, item->d_name) < (int)sizeof path)
            remove_abandoned(path);
    if (dir)
        closedir(dir);
}

Stage *stage_open(const char *folder, const char **why)
{
    bool made = !mkdir(folder, 0777);
    if (!made && errno != EEXIST) {
        *why = strerror(errno);
        return NULL;
    }
    Stage *s = sets_resize(NULL, sizeof *s);
    *s = (Stage){.folder = sets_copy(folder), .new_folder = made, .lock = -1};
    s->waiting = sets_resize(NULL, strlen(folder) + sizeof waiting_name + UNIQUE + 1);
    pthread_mutex_init(&s->mutex, NULL);
    pthread_mutex_init(&s->making, NULL);
    sprintf(s->waiting, "%s/%sXXXXXX", folder, waiting_name); /* as long as it will be */
    clean(folder);
    return s;
}

/* The file's path; false: too long. */
static bool join(char path[LONGEST_PATH], const char *folder, const char *name)
{
    return snprintf(path, LONGEST_PATH, "%s/%s", folder, name) < LONGEST_PATH;
}

/* NULL, or why no file can be put there. Without waiting for a pipe's other end. */
static const char *look(const char *path, const void *bytes, size_t size, bool *equal)
{
    struct stat info;
    int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    *equal = false;
    if (file < 0)
        return NULL;
    bool known = !fstat(file, &info);
    const char *why = known && S_ISDIR(info.st_mode) ? strerror(EISDIR) : NULL;
    char *old = known && S_ISREG(info.st_mode) && (size_t)info.st_size == size ? malloc(size + 1) : NULL;
    *equal = old && read(file, old, size) == (ssize_t)size && !memcmp(old, bytes, size);
    free(old);
    close(file);
    return why;
}

/* Another process that cleans up may be faster than our lock. */
static const char *make_locked(Stage *s)
{
    char *unique = s->waiting + strlen(s->waiting) - UNIQUE;
    for (int i = 0; i < MOST_TRIES; i++) {
        struct stat ours, there;
        memset(unique, 'X', UNIQUE);
        if (!mkdtemp(s->waiting))
            return strerror(errno);
        s->lock = open(s->waiting, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        bool lost = s->lock < 0 || (flock(s->lock, LOCK_EX | LOCK_NB) && errno == EWOULDBLOCK);
        if (!lost && !fstat(s->lock, &ours) && !stat(s->waiting, &there) && ours.st_ino == there.st_ino)
            return NULL; /* where there are no locks, nobody cleans up either */
        if (s->lock >= 0)
            close(s->lock);
        s->lock = -1;
    }
    return strerror(EBUSY);
}

static const char *make_waiting(Stage *s)
{
    const char *why = NULL;
    pthread_mutex_lock(&s->mutex);
    if (!s->made)
        why = make_locked(s);
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
    bool equal;
    if (!join(path, s->waiting, name)) /* longer than in the folder itself */
        return "the path is too long";
    join(path, s->folder, name);
    const char *why = look(path, bytes, size, &equal);
    bool waits = !equal;
    if (waits && !why && !(why = make_waiting(s))) {
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

bool stage_holds(const Stage *s, const char *name)
{
    int number = strings_find(&s->names, name);
    return number >= 0 && s->files[number].waits && !s->files[number].dropped;
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
        s->new_folder = false;
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
    if (s->made) {
        rmdir(s->waiting);
        close(s->lock);
    }
    if (s->new_folder)
        rmdir(s->folder);
    pthread_mutex_destroy(&s->mutex);
    pthread_mutex_destroy(&s->making);
    free(s->files);
    strings_free(&s->names);
    free(s->folder);
    free(s->waiting);
    free(s);
}
