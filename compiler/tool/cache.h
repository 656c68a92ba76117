/* A store of blobs on disk under 128-bit keys. Any number of threads may share one Cache, any
 * number of processes one folder: an entry is written under a temporary name and renamed, and what
 * is read is checked against its key, size and checksum, so that nobody sees half an entry or a
 * damaged one. A checksum finds accidents, not forgery: a folder or an entry that anybody but this
 * user and root may write is refused.
 * A folder that cannot be written or is full makes misses, never faults. */
#ifndef MATC_CACHE_H
#define MATC_CACHE_H
#include "compiler/base/hash.h"

typedef struct Cache Cache;

/* Makes the folder and its parents. limit_bytes is the sum of the entries' sizes above which the
 * least recently used go; 0: no limit. NULL and a reason where there can be no such folder; the
 * calls below take that NULL for a cache that is always empty. */
Cache *cache_open(const char *folder, uint64_t limit_bytes, const char **why);
/* The blob in memory from malloc, with a zero byte behind; NULL: a miss. A damaged entry is a miss,
 * and is removed. */
char *cache_get(Cache *cache, Key key, size_t *size);
/* Keeps a copy of the blob, in place of an older one. What cannot be kept is counted. */
void cache_put(Cache *cache, Key key, const void *bytes, size_t size);
/* Stores a blob whose key is the hash of its bytes: if it is there, it stays, and counts as used.
 * */
void cache_keep(Cache *cache, Key key, const void *bytes, size_t size);
/* NULL, or why the first of the blobs that could not be kept was not: something to warn of,
 * once. */
const char *cache_trouble(const Cache *cache);
/* Adds this run's counts to the statistics and trims to the limit. */
void cache_close(Cache *cache);

/* Entries, bytes, limit, and the counts of all runs, as lines of text from malloc; NULL: there is
 * no such folder (errno). */
char *cache_statistics(const char *folder);
#endif
