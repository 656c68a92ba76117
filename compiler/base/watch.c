/* Detects changed files by comparing their stat() data. Notifications of the system (inotify on
 * the folders, since editors rename over files) serve two purposes. They trigger the comparison,
 * and they reveal a write that leaves the stat() data unchanged. All files are also polled every
 * second: notifications do not arrive from network file systems, through links, or when a parent
 * folder is moved. */
#include "compiler/base/watch.h"
#include "compiler/base/memory.h"
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/inotify.h>
#endif

enum {
    QUIET_MS = 50,    /* quiet time that ends a burst of changes */
    ROW_MS = 1000,    /* max time after which a burst is reported */
    POLL_MS = 200,    /* polling interval without notifications */
    LOOK_MS = 1000,   /* polling interval with notifications */
    SIGNAL_MS = 200,  /* polling interval for signals */
    CLOCK_MS = 20,    /* max lag of a file's time behind the clock */
    NOTICES = 1 << 14 /* max bytes of notifications read at once */
};

/* A file's stat() data. */
typedef struct {
    bool exists;
    mode_t mode;
    dev_t device;
    ino_t inode;
    off_t size;
    struct timespec modified;
} Look;

typedef struct {
    char *path;
    const char *name; /* last part of the path */
    int notices;      /* watch descriptor of the file's folder; -1: none */
    Look look;        /* state of the file when last reported or set */
    bool dirty;       /* the file has changed since `look` */
    bool changed;     /* the last watch_wait reported the file */
} File;

struct Watch {
    File *files;
    int count;
    int notices; /* inotify descriptor; -1: none */
    bool poll_only;
    struct timespec since; /* wall-clock time at which the last watch_wait ended */
};

static Look look_at(const char *path)
{
    struct stat info;
    if (stat(path, &info))
        return (Look){0};
    return (Look){true, info.st_mode, info.st_dev, info.st_ino, info.st_size, info.st_mtim};
}

static bool same_look(const Look *a, const Look *b)
{
    return a->exists == b->exists && a->mode == b->mode && a->device == b->device &&
           a->inode == b->inode && a->size == b->size && a->modified.tv_sec == b->modified.tv_sec &&
           a->modified.tv_nsec == b->modified.tv_nsec;
}

static long milliseconds_from(const struct timespec *a, const struct timespec *b)
{
    return (long)(b->tv_sec - a->tv_sec) * 1000 + (b->tv_nsec - a->tv_nsec) / 1000000;
}

static long milliseconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return milliseconds_from(&(struct timespec){0}, &now);
}

#ifdef __linux__
/* Requests notifications of a folder, or of the nearest existing folder above it. Returns the
 * watch descriptor; -1: failed. */
static int ask_for_folder(int notices, char *folder)
{
    const uint32_t what = IN_ONLYDIR | IN_CLOSE_WRITE | IN_MODIFY | IN_ATTRIB | IN_CREATE |
                          IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO | IN_DELETE_SELF | IN_MOVE_SELF;
    for (;;) {
        int number = inotify_add_watch(notices, *folder ? folder : ".", what);
        if (number >= 0 || (errno != ENOENT && errno != ENOTDIR) || !*folder ||
            !strcmp(folder, "/"))
            return number;
        char *slash = strrchr(folder, '/');
        if (!slash)
            *folder = 0;
        else
            slash[slash == folder] = 0;
    }
}

/* Requests the notifications of all files. If any request fails, notifications are disabled, and
 * files are polled more often. */
static void ask(Watch *watch)
{
    if (watch->notices >= 0)
        close(watch->notices);
    watch->notices = watch->poll_only ? -1 : inotify_init1(IN_CLOEXEC | IN_NONBLOCK);
    for (int i = 0; i < watch->count && watch->notices >= 0; i++) {
        File *file = &watch->files[i];
        size_t size = (size_t)(file->name - file->path);
        char *folder = malloc(size + 1);
        if (!folder)
            memory_exhausted();
        memcpy(folder, file->path, size);
        folder[size > 1 ? size - 1 : size] = 0; /* keeps the root folder "/" */
        file->notices = ask_for_folder(watch->notices, folder);
        free(folder);
        if (file->notices < 0) {
            close(watch->notices);
            watch->notices = -1;
        }
    }
}

/* Marks a written file as dirty, since its stat() data may be unchanged: a write of equal size
 * within one tick of the clock. */
static void mark_written(Watch *watch, const struct inotify_event *notice)
{
    if (!notice->len || !(notice->mask & (IN_MODIFY | IN_MOVED_TO | IN_CREATE)))
        return;
    for (int i = 0; i < watch->count; i++)
        if (watch->files[i].notices == notice->wd && !strcmp(watch->files[i].name, notice->name))
            watch->files[i].dirty = true;
}

/* Reads all pending notifications. */
static void read_notices(Watch *watch)
{
    _Alignas(struct inotify_event) char bytes[NOTICES];
    bool folders = false;
    for (ssize_t size;
         watch->notices >= 0 && (size = read(watch->notices, bytes, sizeof bytes)) > 0;)
        for (char *at = bytes; at < bytes + size;) {
            const struct inotify_event *notice = (const void *)at;
            folders |=
                notice->mask & (IN_ISDIR | IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED | IN_UNMOUNT);
            mark_written(watch, notice);
            at += sizeof *notice + notice->len;
        }
    if (folders)
        ask(watch);
}
#else
static void ask(Watch *watch) { watch->notices = -1; }
static void read_notices(Watch *watch) { (void)watch; }
#endif

/* Compares all files; returns true if any has changed since the last comparison. */
static bool look(Watch *watch)
{
    bool news = false;
    for (int i = 0; i < watch->count; i++) {
        File *file = &watch->files[i];
        const Look now = look_at(file->path);
        if (same_look(&now, &file->look))
            continue;
        file->look = now;
        file->dirty = news = true;
    }
    return news;
}

static bool any_dirty(const Watch *watch)
{
    for (int i = 0; i < watch->count; i++)
        if (watch->files[i].dirty)
            return true;
    return false;
}

void watch_list_add(WatchList *list, const char *file)
{
    if (list->count == list->capacity) {
        list->capacity = list->capacity ? 2 * list->capacity : 64;
        list->at = realloc(list->at, (size_t)list->capacity * sizeof *list->at);
        if (!list->at)
            memory_exhausted();
    }
    list->at[list->count] = strdup(file);
    if (!list->at[list->count++])
        memory_exhausted();
}

void watch_list_free(WatchList *list)
{
    for (int i = 0; i < list->count; i++)
        free(list->at[i]);
    free(list->at);
    *list = (WatchList){0};
}

Watch *watch_open(void)
{
    Watch *watch = calloc(1, sizeof *watch);
    if (!watch)
        memory_exhausted();
    watch->notices = -1;
    clock_gettime(CLOCK_REALTIME, &watch->since);
    return watch;
}

void watch_poll_only(Watch *watch)
{
    watch->poll_only = true;
    ask(watch);
}

static void free_files(File *files, int count)
{
    for (int i = 0; i < count; i++)
        free(files[i].path);
    free(files);
}

static int by_path(const void *a, const void *b)
{
    return strcmp((*(const File *const *)a)->path, (*(const File *const *)b)->path);
}

/* Returns the files sorted by path, for binary search; from malloc. */
static const File **sorted_files(const Watch *watch)
{
    const File **sorted = malloc(((size_t)watch->count + 1) * sizeof *sorted);
    if (!sorted)
        memory_exhausted();
    for (int i = 0; i < watch->count; i++)
        sorted[i] = &watch->files[i];
    qsort(sorted, (size_t)watch->count, sizeof *sorted, by_path);
    return sorted;
}

/* Initializes a file that was not watched before. */
static void begin_file(const Watch *watch, File *file)
{
    file->look = look_at(file->path);
    file->dirty =
        file->look.exists && milliseconds_from(&watch->since, &file->look.modified) > -CLOCK_MS;
}

void watch_set(Watch *watch, const char *const *paths, int count)
{
    File *files = calloc((size_t)count + 1, sizeof *files);
    const File **old = sorted_files(watch);
    if (!files)
        memory_exhausted();
    for (int i = 0; i < count; i++) {
        File *file = &files[i], *key = file;
        file->path = strdup(paths[i]);
        if (!file->path)
            memory_exhausted();
        const char *slash = strrchr(file->path, '/');
        file->name = slash ? slash + 1 : file->path;
        file->notices = -1;
        const File *const *known = bsearch(&key, old, (size_t)watch->count, sizeof *old, by_path);
        if (known) {
            file->look = (*known)->look;
            file->dirty = (*known)->dirty;
        } else {
            begin_file(watch, file);
        }
    }
    free(old);
    free_files(watch->files, watch->count);
    watch->files = files;
    watch->count = count;
    ask(watch);
}

/* Sleeps until notifications arrive or the timeout ends. Returns false if a signal interrupted
 * the sleep. */
static bool sleep_for(Watch *watch, long ms)
{
    struct pollfd notices = {.fd = watch->notices, .events = POLLIN};
    bool fine = poll(&notices, watch->notices >= 0, (int)ms) >= 0 || errno != EINTR;
    if (fine)
        read_notices(watch);
    return fine;
}

/* Waits until the changed files have been quiet for QUIET_MS. */
static void wait_for_quiet(Watch *watch)
{
    const long begin = milliseconds_now();
    for (long last = begin, now = begin; now - last < QUIET_MS && now - begin < ROW_MS;
         now = milliseconds_now()) {
        if (!sleep_for(watch, QUIET_MS - (now - last)))
            return;
        if (look(watch))
            last = milliseconds_now();
    }
}

static int report(Watch *watch)
{
    int count = 0;
    for (int i = 0; i < watch->count; i++) {
        File *file = &watch->files[i];
        count += file->changed = file->dirty;
        file->dirty = false;
    }
    clock_gettime(CLOCK_REALTIME, &watch->since);
    return count;
}

int watch_wait(Watch *watch, int timeout_ms)
{
    /* Both clock readings are rounded down; 1 ms more ensures that no wait is shorter than
     * requested. */
    const long end = timeout_ms < 0 ? LONG_MAX : milliseconds_now() + timeout_ms + (timeout_ms > 0);
    for (;;) {
        look(watch);
        if (any_dirty(watch)) {
            wait_for_quiet(watch);
            return report(watch);
        }
        long left = end - milliseconds_now(), most = watch->notices < 0 ? POLL_MS : LOOK_MS;
        if (left <= 0 || !sleep_for(watch, left < most ? left : most))
            return report(watch);
    }
}

int watch_next(Watch *watch)
{
    static const struct timespec at_once = {0, 0};
    int signal = -1, changed = 0;
    sigset_t ends, before;
    sigemptyset(&ends);
    sigaddset(&ends, SIGINT);
    sigaddset(&ends, SIGTERM);
    sigaddset(&ends, SIGHUP);
    pthread_sigmask(SIG_BLOCK, &ends, &before);
    while (!changed && (signal = sigtimedwait(&ends, NULL, &at_once)) < 0)
        changed = watch_wait(watch, SIGNAL_MS);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return changed ? 0 : signal;
}

bool watch_changed(const Watch *watch, int file)
{
    return file < watch->count && watch->files[file].changed;
}

void watch_close(Watch *watch)
{
    if (!watch)
        return;
    free_files(watch->files, watch->count);
    if (watch->notices >= 0)
        close(watch->notices);
    free(watch);
}
