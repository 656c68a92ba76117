/* The cache's entries: look-up, reading with verification, and writing by renaming. */
#define XXH_INLINE_ALL
#include "compiler/tool/cache_folder.h"
#include "compiler/base/memory.h"
#include "compiler/base/text.h"
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>
#include <xxhash.h>

enum { VERSION = 1, LARGEST_BLOB = 256 << 20, ABOVE = 3 /* ABOVE: length of the prefix "ab/" */ };
/* Permissions that exclude writes by others whatever the umask, since entries are trusted when
 * read. */
enum { READABLE = 0644, PASSABLE = 0755, BY_OTHERS = S_IWGRP | S_IWOTH };

struct Cache {
    int folder;
    uint64_t limit;
    uint64_t mark; /* distinguishes temporary names of this Cache */
    atomic_uint_fast64_t temporaries;
    /* Counts since the last addition to the statistics. */
    atomic_uint_fast64_t hits, misses, damaged, failed, written;
    /* Estimated bytes in the folder. */
    atomic_uint_fast64_t total;
    /* errno of the first failure; 0: no failure */
    atomic_int trouble;
    atomic_flag trimming; /* a thread is trimming; stays set if trimming does not help */
};

/* Header of every blob, in the machine's byte order: a machine of the other order reads another
 * version and ignores the entry. */
typedef struct {
    char magic[4];
    uint32_t version;
    Key key;
    uint64_t size, checksum;
} Header;

/* Checksum of key and blob together. */
static uint64_t checksum(Key key, const void *bytes, size_t size)
{
    return XXH3_64bits_withSeed(bytes, size, XXH3_64bits(&key, sizeof key));
}

static Header header_of(Key key, const void *bytes, size_t size)
{
    return (Header){{'m', 'a', 't', 'c'}, VERSION, key, size, checksum(key, bytes, size)};
}

/* Creates a folder and its parents. Returns false and errno on failure. */
static bool make_folders(const char *path)
{
    char *copy = strdup(path);
    if (!copy)
        memory_exhausted();
    for (char *slash = strchr(copy + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = 0;
        mkdir(copy, PASSABLE); /* ignores failures, which show at the last folder */
        *slash = '/';
    }
    free(copy);
    return !mkdir(path, PASSABLE) || errno == EEXIST;
}

/* Writes CACHEDIR.TAG, which makes backups and indexers skip the folder. */
static void put_tag(int folder)
{
    static const char text[] =
        "Signature: 8a477f597d28d172789f06886806bc55\n"
        "# This folder is a cache of matc's; it can be removed at any time.\n";
    int file = openat(folder, "CACHEDIR.TAG", O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, READABLE);
    if (file < 0)
        return;
    ssize_t put = write(file, text, sizeof text - 1);
    (void)put; /* ignores failures: a full disk shows soon enough */
    close(file);
}

/* Returns true if only this user and root can have written the file. A checksum detects
 * corruption, not forgery. */
static bool is_own(const struct stat *info)
{
    return (info->st_uid == geteuid() || info->st_uid == 0) && !(info->st_mode & BY_OTHERS);
}

/* Returns NULL, or the reason why a folder's entries are not trusted. */
static const char *distrust(int folder)
{
    struct stat info;
    if (fstat(folder, &info))
        return text_error(errno);
    if (is_own(&info))
        return NULL;
    return info.st_mode & BY_OTHERS
               ? "others may write to the folder, and could forge its entries (chmod go-w)"
               : "the folder belongs to another user, who could forge its entries";
}

Cache *cache_open(const char *path, uint64_t limit_bytes, const char **why)
{
    int folder = make_folders(path) ? open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    *why = folder < 0 ? text_error(errno) : distrust(folder);
    if (*why) {
        if (folder >= 0)
            close(folder);
        return NULL;
    }
    Cache *cache = calloc(1, sizeof *cache);
    if (!cache)
        memory_exhausted();
    cache->folder = folder;
    cache->limit = limit_bytes;
    if (getrandom(&cache->mark, sizeof cache->mark, GRND_NONBLOCK) != sizeof cache->mark)
        cache->mark = (uint64_t)getpid() << 32 ^ (uint64_t)time(NULL);
    cache->total = cache_counts(folder).bytes;
    put_tag(folder);
    return cache;
}

/* Returns true for an entry whose last recorded use is so old that it must be updated. */
static bool is_stale(const struct stat *info)
{
    struct timespec now;
    clock_gettime(CLOCK_REALTIME_COARSE, &now);
    return llabs((long long)now.tv_sec - (long long)info->st_mtime) > CACHE_FRESH;
}

/* Returns the blob of an open entry; NULL if the entry is invalid. */
static char *read_entry(int file, Key key, size_t *size)
{
    struct stat info;
    Header header;
    if (fstat(file, &info) || !S_ISREG(info.st_mode) || !is_own(&info) ||
        info.st_size < (off_t)sizeof header || info.st_size > LARGEST_BLOB + (off_t)sizeof header)
        return NULL;
    size_t length = (size_t)info.st_size - sizeof header;
    char *bytes = malloc(length + 1);
    if (!bytes)
        memory_exhausted();
    const struct iovec parts[] = {{&header, sizeof header}, {bytes, length}};
    ssize_t got = readv(file, parts, 2);
    if (got == (ssize_t)info.st_size) {
        const Header wanted = header_of(key, bytes, length);
        if (!memcmp(&header, &wanted, sizeof header)) {
            if (is_stale(&info))
                futimens(file, NULL);
            bytes[length] = 0;
            *size = length;
            return bytes;
        }
    }
    free(bytes);
    return NULL;
}

/* Opens the folder of an entry, creating it if needed; a link is refused. Returns -1 and errno
 * on failure. */
static int open_above(const Cache *cache, const char *name)
{
    const char above[3] = {name[0], name[1], 0};
    const int how = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC;
    int folder = openat(cache->folder, above, how);
    if (folder >= 0 || errno != ENOENT ||
        (mkdirat(cache->folder, above, PASSABLE) && errno != EEXIST))
        return folder;
    return openat(cache->folder, above, how);
}

/* May remove a valid entry that was stored meanwhile; the entry is then regenerated later. */
static void remove_entry(const Cache *cache, const char *name)
{
    int above = open_above(cache, name);
    if (above < 0)
        return;
    unlinkat(above, name + ABOVE, 0);
    close(above);
}

char *cache_get(Cache *cache, Key key, size_t *size)
{
    char name[CACHE_NAME], *bytes = NULL;
    if (!cache)
        return NULL;
    cache_name(key, name);
    /* O_NONBLOCK: a pipe of that name must not block */
    int file = openat(cache->folder, name, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    bool there = file >= 0 || errno == ELOOP;
    if (file >= 0) {
        bytes = read_entry(file, key, size);
        close(file);
    }
    if (there && !bytes) {
        remove_entry(cache, name);
        cache->damaged++;
    }
    if (bytes)
        cache->hits++;
    else
        cache->misses++;
    return bytes;
}

/* Writes an entry to a new file. Returns false and errno on failure. */
static bool write_entry(int above, const char *name, const Header *header, const void *bytes)
{
    int file = openat(above, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, READABLE);
    if (file < 0)
        return false;
    const struct iovec parts[] = {{(void *)header, sizeof *header}, {(void *)bytes, header->size}};
    ssize_t put = writev(file, parts, 2);
    bool whole = put == (ssize_t)(sizeof *header + header->size);
    if (put >= 0 && !whole)
        errno = ENOSPC; /* the disk is full: only part of the entry was written */
    int error = errno;
    bool closed = !close(file);
    errno = whole ? errno : error;
    return whole && closed;
}

static bool put_entry(Cache *cache, Key key, const void *bytes, size_t size)
{
    char name[CACHE_NAME], temporary[CACHE_NAME];
    const Header header = header_of(key, bytes, size);
    cache_name(key, name);
    snprintf(temporary, sizeof temporary, ".tmp%016llx-%llx", (unsigned long long)cache->mark,
             (unsigned long long)cache->temporaries++);
    int above = open_above(cache, name), none = 0;
    bool fine = above >= 0 && write_entry(above, temporary, &header, bytes) &&
                !renameat(above, temporary, above, name + ABOVE);
    int error = errno;
    if (!fine && above >= 0)
        unlinkat(above, temporary, 0);
    if (above >= 0)
        close(above);
    if (!fine)
        atomic_compare_exchange_strong(&cache->trouble, &none, error);
    return fine;
}

/* Adds the counts since the last call to the statistics, and trims the folder if it may be too
 * large. */
static void settle(Cache *cache)
{
    const CacheCounts counts = {.hits = atomic_exchange(&cache->hits, 0),
                                .misses = atomic_exchange(&cache->misses, 0),
                                .damaged = atomic_exchange(&cache->damaged, 0),
                                .failed = atomic_exchange(&cache->failed, 0),
                                .bytes = atomic_exchange(&cache->written, 0),
                                .limit = cache->limit};
    const CacheCounts sums = cache_count(cache->folder, &counts);
    const uint64_t now = (uint64_t)time(NULL);
    CacheTrim done;
    cache->total = sums.bytes;
    bool large = cache->limit && sums.bytes > cache->limit;
    if (!large && now - sums.scanned < CACHE_SCAN_AFTER)
        return;
    if (!cache_trim(cache->folder, cache->limit, &done)) {
        /* assumes the size that another process, which is trimming, leaves */
        cache->total = cache_trimmed(cache->limit);
        return;
    }
    cache_count(cache->folder,
                &(CacheCounts){.removed = done.removed, .bytes = done.bytes, .scanned = now});
    cache->total = done.bytes;
}

/* Trims on one thread; other threads continue. */
static void settle_if_large(Cache *cache)
{
    if (!cache->limit || cache->total <= cache->limit || atomic_flag_test_and_set(&cache->trimming))
        return;
    settle(cache);
    if (cache->total <= cache->limit)
        atomic_flag_clear(&cache->trimming);
}

void cache_put(Cache *cache, Key key, const void *bytes, size_t size)
{
    if (!cache)
        return;
    size_t whole = sizeof(Header) + size;
    if (size > LARGEST_BLOB || (cache->limit && whole > cache_trimmed(cache->limit)) ||
        !put_entry(cache, key, bytes, size)) {
        cache->failed++;
        return;
    }
    cache->written += whole;
    cache->total += whole;
    settle_if_large(cache);
}

void cache_keep(Cache *cache, Key key, const void *bytes, size_t size)
{
    char name[CACHE_NAME];
    struct stat info;
    if (!cache)
        return;
    cache_name(key, name);
    bool there = !fstatat(cache->folder, name, &info, AT_SYMLINK_NOFOLLOW) &&
                 S_ISREG(info.st_mode) && info.st_size == (off_t)(sizeof(Header) + size);
    if (!there)
        cache_put(cache, key, bytes, size);
    else if (is_stale(&info))
        utimensat(cache->folder, name, NULL, AT_SYMLINK_NOFOLLOW);
}

const char *cache_trouble(const Cache *cache)
{
    int error = cache ? cache->trouble : 0;
    return error ? text_error(error) : NULL;
}

void cache_close(Cache *cache)
{
    if (!cache)
        return;
    settle(cache);
    close(cache->folder);
    free(cache);
}
