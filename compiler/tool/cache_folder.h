/* The folder of a cache as a whole: names, counts of all runs, trimming. Internal to cache*.c. */
#ifndef MATC_CACHE_FOLDER_H
#define MATC_CACHE_FOLDER_H
#include "compiler/tool/cache.h"
#include <stdbool.h>

enum {
    CACHE_FOLDERS = 256, /* entries are ab/cdef..., by the key's first two digits */
    CACHE_NAME = 64,     /* room for a name below the folder */
    CACHE_FRESH =
        /* seconds: an entry used within them is not marked as used again, which would cost more
         * than reading */
    60,
    CACHE_TRIM_PART = 90, /* per cent of the limit that are left by trimming */
    /* seconds after which the folder is looked through although it seems small enough */
    CACHE_SCAN_AFTER = 86400,
    CACHE_STALE = 3600, /* seconds after which a temporary file has lost its writer */
};

/* The file "statistics", in this order. */
#define CACHE_COUNTS(X)                                                                            \
    X(hits)                                                                                        \
    X(misses)                                                                                      \
    X(damaged) /* entries that were not what they should be; they are misses, too */               \
    X(removed) /* to keep the limit */                                                             \
    X(failed)  /* blobs that could not be kept */                                                  \
    X(bytes)   /* about; exact after each look through the folder */                               \
    X(scanned) /* when that was, seconds since 1970 */                                             \
    X(limit)   /* of the last run that had one */
typedef struct {
#define X(name) uint64_t name;
    CACHE_COUNTS(X)
#undef X
} CacheCounts;

/* Size to which a cache of that limit is trimmed. */
static inline uint64_t cache_trimmed(uint64_t limit)
{
    return limit - limit / 100 * (100 - CACHE_TRIM_PART);
}
/* "ab/cdef..." of a key. */
void cache_name(Key key, char *name);
/* The sums of all runs so far; zeros where they cannot be read. */
CacheCounts cache_counts(int folder);
/* Adds to them and returns the new sums. `scanned` and `limit` are set, not added; with `scanned`,
 * `bytes` is, too. */
CacheCounts cache_count(int folder, const CacheCounts *more);
/* Looks through the folder: sums up entries and bytes, and with a limit that they exceed removes
 * the least recently used ones, and temporary files without a writer. False: another process is at
 * it. */
typedef struct {
    uint64_t entries, bytes, removed;
} CacheTrim;
bool cache_trim(int folder, uint64_t limit, CacheTrim *done);
#endif
