/* Creates, takes over and removes staging folders. Every path is opened relative to an open
 * folder, and no symbolic link is followed. */
#include "compiler/base/staging/staging_folder.h"
#include "compiler/base/text.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

enum { MAX_TRIES = 100, UNIQUE = 6, OWNER_ONLY = 0700, READABLE = 0666, CHUNK = 1 << 16 };

static const char prefix[] = ".matc-stage-";

/* Chooses an unpredictable name. */
static void choose_name(char name[STAGE_NAME])
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    uint64_t random;
    if (getrandom(&random, sizeof random, GRND_NONBLOCK) != sizeof random) {
        struct timespec now;
        clock_gettime(CLOCK_MONOTONIC, &now);
        random = (uint64_t)getpid() << 32 ^ (uint64_t)now.tv_nsec;
    }
    strcpy(name, prefix);
    char *unique = name + sizeof prefix - 1;
    for (int i = 0; i < UNIQUE; i++, random /= sizeof letters - 1)
        unique[i] = letters[random % (sizeof letters - 1)];
    unique[UNIQUE] = 0;
}

static bool is_stage(const char *name)
{
    return !strncmp(name, prefix, sizeof prefix - 1) && strlen(name) == sizeof prefix - 1 + UNIQUE;
}

/* Opens and locks the staging folder. Returns 0 or errno: EWOULDBLOCK if its process is alive,
 * ENOENT if the folder was removed before it was locked. */
static int open_locked(Stage *s)
{
    struct stat ours, there;
    s->at = openat(s->folder, s->name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (s->at < 0 || fstat(s->at, &ours))
        return errno;
    if (ours.st_uid != geteuid())
        return EACCES; /* another user must not control renames of this process, as in /tmp */
    if (flock(s->at, LOCK_EX | LOCK_NB))
        return errno;
    return fstatat(s->folder, s->name, &there, AT_SYMLINK_NOFOLLOW) ||
                   ours.st_dev != there.st_dev || ours.st_ino != there.st_ino
               ? ENOENT
               : 0;
}

void stage_leave(Stage *s)
{
    if (s->at >= 0)
        close(s->at);
    s->at = -1;
}

/* Opens a folder's directory stream; NULL on failure. */
static DIR *list_names(int folder)
{
    int copy = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *names = copy < 0 ? NULL : fdopendir(copy);
    if (!names && copy >= 0)
        close(copy);
    return names;
}

void stage_remove(Stage *s)
{
    DIR *names = s->at < 0 ? NULL : list_names(s->at);
    for (struct dirent *item = names ? readdir(names) : NULL; item; item = readdir(names))
        if (strcmp(item->d_name, ".") != 0 && strcmp(item->d_name, "..") != 0)
            unlinkat(s->at, item->d_name, 0);
    if (names)
        closedir(names);
    unlinkat(s->folder, s->name, AT_REMOVEDIR);
    stage_leave(s);
}

/* Returns true if the error means that the file system has no locks. No other process can then
 * lock and remove the folder either. */
static bool has_no_locks(int error)
{
    return error == ENOLCK || error == EOPNOTSUPP || error == ENOSYS || error == EBADF;
}

const char *stage_make(Stage *s, int folder)
{
    int error = EEXIST;
    for (int i = 0; i < MAX_TRIES && (error == EEXIST || error == ENOENT || error == EWOULDBLOCK);
         i++) {
        *s = (Stage){.folder = folder, .at = -1};
        choose_name(s->name);
        if (mkdirat(folder, s->name, OWNER_ONLY)) {
            error = errno;
            continue;
        }
        error = open_locked(s);
        if (!error || (s->at >= 0 && has_no_locks(error)))
            return NULL;
        /* Removes the folder even if another process locked it first in order to remove it. */
        stage_remove(s);
    }
    return text_error(error);
}

const char *stage_each_abandoned(int folder, const char *(*finish)(const Stage *stage))
{
    const char *why = NULL;
    DIR *names = list_names(folder);
    for (struct dirent *item = names ? readdir(names) : NULL; item && !why; item = readdir(names)) {
        if (!is_stage(item->d_name))
            continue;
        Stage stage = {.folder = folder, .at = -1};
        strcpy(stage.name, item->d_name);
        if (!open_locked(&stage)) {
            why = finish(&stage);
            if (!why)
                stage_remove(&stage);
        }
        stage_leave(&stage);
    }
    if (names)
        closedir(names);
    return why;
}

static const char *write_all(int file, const char *at, size_t size)
{
    while (size) {
        ssize_t got = write(file, at, size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return text_error(got ? errno : ENOSPC);
        at += got;
        size -= (size_t)got;
    }
    return NULL;
}

const char *stage_write(const Stage *s, const char *name, const void *bytes, size_t size)
{
    unlinkat(s->at, name, 0);
    int file = openat(s->at, name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, READABLE);
    if (file < 0)
        return text_error(errno);
    const char *why = write_all(file, bytes, size);
    if (close(file) && !why)
        why = text_error(errno);
    if (why)
        unlinkat(s->at, name, 0);
    return why;
}

int stage_hash(int folder, const char *name, Key *hash)
{
    struct stat info;
    XXH3_state_t state;
    char chunk[CHUNK];
    ssize_t got = -1;
    int file = openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        /* ELOOP: a symbolic link; ENXIO: a socket */
        return errno == ELOOP || errno == ENXIO ? EINVAL : errno;
    XXH3_128bits_reset(&state);
    int error = fstat(file, &info) ? errno : S_ISREG(info.st_mode) ? 0 : EINVAL;
    while (!error && (got = read(file, chunk, sizeof chunk)) != 0) {
        if (got > 0)
            XXH3_128bits_update(&state, chunk, (size_t)got);
        else if (errno != EINTR)
            error = errno;
    }
    close(file);
    XXH128_hash_t digest = XXH3_128bits_digest(&state);
    *hash = (Key){digest.low64, digest.high64};
    return error;
}
