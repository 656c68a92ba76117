/* The cache's folder: the file of statistics, and removal of the least recently used entries, by
 * modification time. Only files with names that the cache gives are removed. */
#include "compiler/tool/cache_folder.h"
#include "compiler/base/memory.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum {
    NAME_DIGITS = 30,
    COUNTS_TEXT = 1024,
    LOCK_TRIES = 100,
    LOCK_WAIT_NS = 1000000,
    READABLE = 0666
};

static const char statistics[] = "statistics";

void cache_name(Key key, char *name)
{
    static const char digits[] = "0123456789abcdef";
    for (int i = 0; i < 32; i++) {
        uint64_t word = i < 16 ? key.high : key.low;
        *name++ = digits[word >> (60 - 4 * (i % 16)) & 15];
        if (i == 1)
            *name++ = '/';
    }
    *name = 0;
}

/* Waits for the lock for a limited time, since a process may have been stopped while holding it. */
static bool lock(int file)
{
    for (int i = 0; i < LOCK_TRIES; i++) {
        if (!flock(file, LOCK_EX | LOCK_NB))
            return true;
        nanosleep(&(struct timespec){0, LOCK_WAIT_NS}, NULL);
    }
    return false;
}

/* Parses the statistics; a missing or invalid line is 0. */
static CacheCounts parse_counts(const char *text)
{
    CacheCounts counts = {0};
#define X(member)                                                                                  \
    {                                                                                              \
        const char *line = strstr(text, #member " ");                                              \
        counts.member = line ? strtoull(line + sizeof #member, NULL, 10) : 0;                      \
    }
    CACHE_COUNTS(X)
#undef X
    return counts;
}

static CacheCounts read_counts(int file)
{
    char text[COUNTS_TEXT];
    ssize_t size = pread(file, text, sizeof text - 1, 0);
    text[size > 0 ? size : 0] = 0;
    return parse_counts(text);
}

static int print_counts(char *text, const CacheCounts *counts)
{
    int size = 0;
#define X(member)                                                                                  \
    size += snprintf(text + size, (size_t)(COUNTS_TEXT - size), #member " %llu\n",                 \
                     (unsigned long long)counts->member);
    CACHE_COUNTS(X)
#undef X
    return size;
}

/* Opens a file of the cache's own, creating it if needed. First removes anything else planted
 * under its name: a link, a pipe, or a hard link to a file elsewhere. */
static int open_own(int folder, const char *name)
{
    const int how = O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW;
    struct stat info;
    int file = openat(folder, name, how, READABLE);
    if (file < 0 ? errno != ELOOP
                 : !fstat(file, &info) && S_ISREG(info.st_mode) && info.st_nlink == 1)
        return file;
    if (file >= 0)
        close(file);
    return unlinkat(folder, name, 0) ? -1 : openat(folder, name, how | O_EXCL, READABLE);
}

CacheCounts cache_counts(int folder)
{
    int file = openat(folder, statistics, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW);
    if (file < 0)
        return (CacheCounts){0};
    CacheCounts counts = read_counts(file);
    close(file);
    return counts;
}

CacheCounts cache_count(int folder, const CacheCounts *more)
{
    char text[COUNTS_TEXT];
    int file = open_own(folder, statistics);
    CacheCounts sums = *more;
    if (file < 0)
        return sums;
    if (lock(file)) {
        sums = read_counts(file);
        sums.hits += more->hits;
        sums.misses += more->misses;
        sums.damaged += more->damaged;
        sums.removed += more->removed;
        sums.failed += more->failed;
        sums.bytes = more->scanned ? more->bytes : sums.bytes + more->bytes;
        sums.scanned = more->scanned ? more->scanned : sums.scanned;
        sums.limit = more->limit ? more->limit : sums.limit;
        int size = print_counts(text, &sums);
        if (pwrite(file, text, (size_t)size, 0) == size && ftruncate(file, size))
            sums = *more; /* cannot match a file that was just written */
    }
    close(file);
    return sums;
}

typedef struct {
    struct timespec used;
    uint64_t size;
    char name[CACHE_NAME];
} Entry;
typedef struct {
    Entry *at;
    size_t count, capacity;
    uint64_t bytes;
} Entries;

static void push(Entries *entries, const char *above, const char *name, const struct stat *info)
{
    if (entries->count == entries->capacity) {
        entries->capacity = entries->capacity ? 2 * entries->capacity : 1024;
        entries->at = realloc(entries->at, entries->capacity * sizeof *entries->at);
        if (!entries->at)
            memory_exhausted();
    }
    Entry *entry = &entries->at[entries->count++];
    *entry = (Entry){.used = info->st_mtim, .size = (uint64_t)info->st_size};
    snprintf(entry->name, sizeof entry->name, "%s/%.*s", above, NAME_DIGITS, name);
    entries->bytes += entry->size;
}

static bool is_entry(const char *name)
{
    return strspn(name, "0123456789abcdef") == NAME_DIGITS && !name[NAME_DIGITS];
}

/* Lists the entries of one folder; with `clean` removes stale temporary files. */
static void list_folder(Entries *entries, int folder, const char *above, bool clean)
{
    int file = openat(folder, above, O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW);
    DIR *dir = file < 0 ? NULL : fdopendir(file);
    struct stat info;
    if (!dir && file >= 0)
        close(file);
    if (!dir)
        return;
    for (struct dirent *item = readdir(dir); item; item = readdir(dir)) {
        bool temporary = !strncmp(item->d_name, ".tmp", 4);
        if ((!temporary && !is_entry(item->d_name)) ||
            fstatat(file, item->d_name, &info, AT_SYMLINK_NOFOLLOW) || !S_ISREG(info.st_mode))
            continue;
        if (!temporary)
            push(entries, above, item->d_name, &info);
        else if (clean && time(NULL) - info.st_mtime > CACHE_STALE)
            unlinkat(file, item->d_name, 0);
    }
    closedir(dir);
}

static Entries list_entries(int folder, bool clean)
{
    Entries entries = {0};
    char above[3];
    for (unsigned i = 0; i < CACHE_FOLDERS; i++) {
        snprintf(above, sizeof above, "%02x", i & 255u);
        list_folder(&entries, folder, above, clean);
    }
    return entries;
}

static int by_use(const void *a, const void *b)
{
    const Entry *x = a, *y = b;
    if (x->used.tv_sec != y->used.tv_sec)
        return x->used.tv_sec < y->used.tv_sec ? -1 : 1;
    if (x->used.tv_nsec != y->used.tv_nsec)
        return x->used.tv_nsec < y->used.tv_nsec ? -1 : 1;
    return strcmp(x->name, y->name);
}

static void remove_oldest(int folder, Entries *entries, uint64_t limit, CacheTrim *done)
{
    qsort(entries->at, entries->count, sizeof *entries->at, by_use);
    for (size_t i = 0; i < entries->count && done->bytes > cache_trimmed(limit); i++) {
        if (unlinkat(folder, entries->at[i].name, 0) && errno != ENOENT)
            continue; /* the user has no permission to remove the entry */
        done->bytes -= entries->at[i].size;
        done->entries--;
        done->removed++;
    }
}

bool cache_trim(int folder, uint64_t limit, CacheTrim *done)
{
    int file = open_own(folder, "trim.lock");
    bool free_to = file >= 0 && !flock(file, LOCK_EX | LOCK_NB);
    if (free_to) {
        Entries entries = list_entries(folder, true);
        *done = (CacheTrim){entries.count, entries.bytes, 0};
        if (limit && entries.bytes > limit)
            remove_oldest(folder, &entries, limit, done);
        free(entries.at);
    }
    if (file >= 0)
        close(file);
    return free_to;
}

/* Returns the number of entries and their bytes. */
static CacheTrim cache_sum(int folder)
{
    Entries entries = list_entries(folder, false);
    free(entries.at);
    return (CacheTrim){entries.count, entries.bytes, 0};
}

char *cache_statistics(const char *path)
{
    int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    char *text = folder < 0 ? NULL : malloc(COUNTS_TEXT);
    if (folder < 0)
        return NULL;
    if (!text)
        memory_exhausted();
    const CacheCounts sums = cache_counts(folder);
    const CacheTrim now = cache_sum(folder);
    close(folder);
    int size = snprintf(text, COUNTS_TEXT, "entries %llu\nbytes   %llu\n",
                        (unsigned long long)now.entries, (unsigned long long)now.bytes);
    if (sums.limit)
        size += snprintf(text + size, (size_t)(COUNTS_TEXT - size), "limit   %llu\n",
                         (unsigned long long)sums.limit);
    snprintf(text + size, (size_t)(COUNTS_TEXT - size),
             "hits    %llu\nmisses  %llu\ndamaged %llu\nremoved %llu\nfailed  %llu\n",
             (unsigned long long)sums.hits, (unsigned long long)sums.misses,
             (unsigned long long)sums.damaged, (unsigned long long)sums.removed,
             (unsigned long long)sums.failed);
    return text;
}
