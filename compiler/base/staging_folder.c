/* Folders where files wait: made, taken over, removed. All is opened below a folder that is open, and no link is followed. */
#include "compiler/base/staging_folder.h"
#include "compiler/base/text.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

enum { MOST_TRIES = 100, UNIQUE = 6, OWN = 0700, READABLE = 0666, CHUNK = 1 << 16 };

const char waiting_commit[] = ".matc-commit";
static const char waiting_prefix[] = ".matc-stage-", journal_name[] = "journal";

/* A name that nobody can know before. */
static void choose_name(char name[WAITING_NAME])
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    uint64_t random;
    if (getrandom(&random, sizeof random, GRND_NONBLOCK) != sizeof random) {
        struct timespec now;
        clock_gettime(CLOCK_MONOTONIC, &now);
        random = (uint64_t)getpid() << 32 ^ (uint64_t)now.tv_nsec;
    }
    strcpy(name, waiting_prefix);
    char *unique = name + sizeof waiting_prefix - 1;
    for (int i = 0; i < UNIQUE; i++, random /= sizeof letters - 1)
        unique[i] = letters[random % (sizeof letters - 1)];
    unique[UNIQUE] = 0;
}

static bool is_waiting(const char *name)
{
    return !strncmp(name, waiting_prefix, sizeof waiting_prefix - 1) &&
           strlen(name) == sizeof waiting_prefix - 1 + UNIQUE;
}

void waiting_leave(Waiting *w)
{
    int error = errno;
    if (w->journal >= 0)
        close(w->journal);
    if (w->at >= 0)
        close(w->at);
    w->journal = w->at = -1;
    errno = error;
}

/* The folder still has its name: nobody who cleans up was faster than our lock. */
static bool has_name(const Waiting *w)
{
    struct stat ours, there;
    return !fstat(w->at, &ours) && !fstatat(w->folder, w->name, &there, AT_SYMLINK_NOFOLLOW) &&
           ours.st_dev == there.st_dev && ours.st_ino == there.st_ino;
}

/* Opens the folder; 0, or errno. */
static int open_folder(Waiting *w)
{
    struct stat info;
    w->at = openat(w->folder, w->name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (w->at < 0 || fstat(w->at, &info))
        return errno;
    return info.st_uid == geteuid() ? 0 : EACCES; /* whoever may write to /tmp must not have us rename our files */
}

/* Opens the journal and locks it; 0, or errno: EWOULDBLOCK where somebody has it. */
static int open_journal(Waiting *w, int how)
{
    struct stat info;
    w->journal = openat(w->at, journal_name, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | how, READABLE);
    if (w->journal < 0 || fstat(w->journal, &info))
        return errno;
    if (!S_ISREG(info.st_mode))
        return EINVAL;
    return flock(w->journal, LOCK_EX | LOCK_NB) ? errno : 0;
}

/* Makes the folder and what is in it; 0, or errno. Where there are no locks, nobody takes it away either. */
static int make_once(Waiting *w)
{
    choose_name(w->name);
    if (mkdirat(w->folder, w->name, OWN))
        return errno;
    int error = open_folder(w);
    if (!error)
        error = open_journal(w, O_EXCL);
    if (w->journal >= 0 && error != EWOULDBLOCK)
        error = has_name(w) ? 0 : ENOENT;
    if (error)
        waiting_remove(w);
    return error;
}

const char *waiting_make(Waiting *w, int folder)
{
    int error = 0;
    for (int i = 0; i < MOST_TRIES; i++) {
        *w = (Waiting){.folder = folder, .at = -1, .journal = -1};
        error = make_once(w);
        if (error != EEXIST && error != ENOENT && error != EWOULDBLOCK) /* else somebody was faster */
            break;
    }
    return error ? text_error(error) : NULL;
}

/* 0, or errno. */
static int remove_link(int folder, const char *name)
{
    struct stat info;
    if (fstatat(folder, name, &info, AT_SYMLINK_NOFOLLOW))
        return errno;
    if (!S_ISLNK(info.st_mode))
        return ENOTDIR;
    return unlinkat(folder, name, 0) ? errno : ENOENT;
}

/* What opening a folder and its journal says of a file, of a pipe or a socket, and of a journal that is a folder or a link. */
static bool is_strange(int error)
{
    return error == ENOTDIR || error == EINVAL || error == ENXIO || error == EISDIR || error == ELOOP;
}

Taken waiting_take(Waiting *w, int folder, const char *name)
{
    *w = (Waiting){.folder = folder, .at = -1, .journal = -1};
    snprintf(w->name, sizeof w->name, "%s", name);
    int error = open_folder(w);
    if (error == ENOTDIR || error == ELOOP)
        error = remove_link(folder, name);
    if (!error)
        error = open_journal(w, 0);
    if (!error && has_name(w))
        return TAKEN;
    waiting_leave(w);
    return !error || error == ENOENT ? TAKEN_none : is_strange(error) ? TAKEN_strange : TAKEN_by_other;
}

bool waiting_rename(Waiting *w, const char *name)
{
    if (renameat(w->folder, w->name, w->folder, name))
        return false;
    snprintf(w->name, sizeof w->name, "%s", name);
    return true;
}

bool waiting_finish(const Waiting *w) { return !ftruncate(w->journal, 0) || !unlinkat(w->at, journal_name, 0); }

/* "journal", "N" or "N.old". */
static bool is_own(const char *name)
{
    size_t digits = strspn(name, "0123456789");
    return !strcmp(name, journal_name) || (digits && (!name[digits] || !strcmp(name + digits, ".old")));
}

/* What a network's disk calls a file that was removed and is still open; it goes by itself. */
static bool is_removed(const char *name) { return !strncmp(name, ".nfs", 4); }

bool waiting_remove(Waiting *w)
{
    bool strange = false;
    int copy = w->at < 0 ? -1 : openat(w->at, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *dir = copy < 0 ? NULL : fdopendir(copy);
    for (struct dirent *item = dir ? readdir(dir) : NULL; item; item = readdir(dir)) {
        if (is_own(item->d_name))
            unlinkat(w->at, item->d_name, 0);
        else if (strcmp(item->d_name, ".") != 0 && strcmp(item->d_name, "..") != 0)
            strange |= !is_removed(item->d_name);
    }
    if (dir)
        closedir(dir);
    else if (copy >= 0)
        close(copy);
    unlinkat(w->folder, w->name, AT_REMOVEDIR);
    waiting_leave(w);
    return !strange;
}

void waiting_clean(int folder)
{
    Waiting w;
    int copy = openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *dir = copy < 0 ? NULL : fdopendir(copy);
    for (struct dirent *item = dir ? readdir(dir) : NULL; item; item = readdir(dir))
        if (is_waiting(item->d_name) && waiting_take(&w, folder, item->d_name) == TAKEN)
            waiting_remove(&w);
    if (dir)
        closedir(dir);
    else if (copy >= 0)
        close(copy);
}

const char *waiting_put(int file, const void *bytes, size_t size)
{
    for (const char *at = bytes; size;) {
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

const char *waiting_write(const Waiting *w, const char *name, const void *bytes, size_t size)
{
    const int how = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
    int file = openat(w->at, name, how, READABLE);
    if (file < 0 && errno == EEXIST &&
        !unlinkat(w->at, name, 0)) /* another thread's, of the same name: the later one stays */
        file = openat(w->at, name, how, READABLE);
    if (file < 0)
        return text_error(errno);
    const char *why = waiting_put(file, bytes, size);
    if (close(file) && !why)
        why = text_error(errno);
    if (why)
        unlinkat(w->at, name, 0);
    return why;
}

int waiting_hash(int folder, const char *name, Key *hash)
{
    struct stat info;
    XXH3_state_t state;
    char chunk[CHUNK];
    ssize_t got = -1;
    int file = openat(folder, name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return errno == ELOOP || errno == ENXIO ? EINVAL : errno; /* a link, a socket */
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
