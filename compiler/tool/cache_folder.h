/* The folder of a cache as a whole: names, statistics of all runs, trimming. Internal to
 * cache*.c. */
#ifndef MATC_CACHE_FOLDER_H
#define MATC_CACHE_FOLDER_H
#include "compiler/tool/cache.h"
#include <stdbool.h>

enum {
    /* number of folders: entries are ab/cdef..., by the key's first two digits */
    CACHE_FOLDERS = 256,
    CACHE_NAME = 64, /* capacity for a name relative to the folder */
    CACHE_FRESH =
        /* Seconds for which an entry counts as recently used: updating its time on each use
         * would cost more than reading. */
    60,
    CACHE_TRIM_PART = 90, /* percentage of the limit that trimming leaves */
    /* Seconds after which the folder is scanned even if it seems small enough. */
    CACHE_SCAN_AFTER = 86400,
    CACHE_STALE = 3600, /* age in seconds of a temporary file without a writer */
};

/* Members of the file "statistics", in this order. */
#define CACHE_COUNTS(X)                                                                            \
    X(hits)                                                                                        \
    X(misses)                                                                                      \
    X(damaged) /* number of invalid entries, which are also misses */                              \
    X(removed) /* number of entries removed to keep the limit */                                   \
    X(failed)  /* number of blobs that could not be stored */                                      \
    X(bytes)   /* approximate size; exact after each scan of the folder */                         \
    X(scanned) /* time of the last scan, seconds since 1970 */                                     \
    X(limit)   /* size limit of the last run that had one */
typedef struct {
#define X(name) uint64_t name;
    CACHE_COUNTS(X)
#undef X
} CacheCounts;

/* Returns the size to which a cache with that limit is trimmed. */
static inline uint64_t cache_trimmed(uint64_t limit)
{
    return limit - limit / 100 * (100 - CACHE_TRIM_PART);
}
/* Writes the path "ab/cdef..." of a key. */
void cache_name(Key key, char *name);
/* Returns the sums of all runs; zeros if they cannot be read. */
CacheCounts cache_counts(int folder);
/* Adds counts and returns the new sums. `scanned` and `limit` are replaced, not added; with
 * `scanned`, `bytes` is replaced, too. */
CacheCounts cache_count(int folder, const CacheCounts *more);
/* Scans the folder: sums up entries and bytes, and removes stale temporary files. Above the
 * limit, also removes the least recently used entries. Returns false if another process is
 * trimming. */
typedef struct {
    uint64_t entries, bytes, removed;
} CacheTrim;
bool cache_trim(int folder, uint64_t limit, CacheTrim *done);
#endif
