/* A store of blobs on disk under 128-bit keys. Threads may share a Cache, and processes may
 * share a folder: an entry is written under a temporary name and renamed, and read data are
 * verified by key, size and checksum, so that partial or corrupted entries are never returned. A
 * checksum detects accidents, not forgery: a folder or entry that others than this user and root
 * can write is refused.
 * A folder that is full or cannot be written causes misses, never faults. */
#ifndef MATC_CACHE_H
#define MATC_CACHE_H
#include "compiler/base/hash.h"

typedef struct Cache Cache;

/* Opens the cache and creates the folder and its parents. If the entries exceed limit_bytes (0:
 * no limit), the least recently used are removed. Returns NULL and a reason on failure; the
 * functions below treat NULL as an empty cache. */
Cache *cache_open(const char *folder, uint64_t limit_bytes, const char **why);
/* Returns the blob in memory from malloc, with a terminating zero; NULL: a miss. A corrupted
 * entry is a miss and is removed. */
char *cache_get(Cache *cache, Key key, size_t *size);
/* Stores a copy of the blob, replacing an older one. Failures are counted. */
void cache_put(Cache *cache, Key key, const void *bytes, size_t size);
/* Stores a blob whose key is the hash of its bytes. An existing entry is kept and marked as
 * used. */
void cache_keep(Cache *cache, Key key, const void *bytes, size_t size);
/* Returns NULL, or why the first failed store failed, for a single warning. */
const char *cache_trouble(const Cache *cache);
/* Adds this run's counts to the statistics and trims to the limit. */
void cache_close(Cache *cache);

/* Returns entries, bytes, limit, and the counts of all runs as lines of text from malloc; NULL
 * and errno if the folder is missing. */
char *cache_statistics(const char *folder);
#endif
