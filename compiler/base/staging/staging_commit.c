/* A commit that a kill cannot leave half done. Its steps, and what a kill after each leads to:
 *
 *   1. All new files are staged.                               the next run removes them
 *   2. The file "intents" lists all moves and removals.        from here on: the next run does them
 *   3. The old index (the manifest) is removed, if it changes.
 *   4. Each new file is renamed over the old one.
 *   5. Each file that is no longer made is removed, if its bytes are still those of the last run.
 *   6. The new index is renamed to its place.
 *   7. The staging folder is removed, and the list with it.
 *
 * So an index, if there is one, always matches the files. The list can be carried out again after
 * any step, since a missing staged file has already been moved. For example, a process with the
 * list [hide manifest.json, put a.frag, remove b.frag, put manifest.json] that is killed after
 * a.frag leaves a folder without a manifest; the next run removes b.frag and moves the manifest. It
 * keeps a file that somebody has changed since the list was written. */
#include "compiler/base/staging/staging_commit.h"
#include "compiler/base/text.h"
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
    WAIT_NS = 5000000,
    MAX_WAITS = 6000 /* waits for half a minute in steps of 5 ms */,
    MAX_INTENTS = 64 << 20
};

static const char list_name[] = "intents", draft_name[] = "intents.new";
static const char damaged[] =
    "the list of an interrupted run, .matc-stage-*/intents, is damaged; remove that folder";

void intent_file(char name[STAGED_NAME], int number) { snprintf(name, STAGED_NAME, "%d", number); }

void intent_add(Bytes *intents, const Intent *intent)
{
    bytes_number(intents, (uint32_t)intent->kind);
    bytes_number(intents, (uint32_t)intent->number);
    bytes_add(intents, &intent->hash, sizeof intent->hash);
    bytes_text(intents, intent->name);
}

/* Reads the next intent. Returns false if the list is damaged. */
static bool intent_take(BytesReader *from, Intent *intent)
{
    uint32_t kind = bytes_take_number(from), number = bytes_take_number(from);
    const void *hash = bytes_take(from, sizeof intent->hash);
    const char *name = bytes_take_text(from);
    if (from->broken || kind >= INTENT_KINDS || number > INT32_MAX || !*name || strchr(name, '/'))
        return false;
    *intent = (Intent){.kind = (IntentKind)kind, .number = (int)number, .name = name};
    memcpy(&intent->hash, hash, sizeof intent->hash);
    return true;
}

const char *intents_write(const Stage *s, const Bytes *intents)
{
    const char *why = intents->size > MAX_INTENTS
                          ? "too many files"
                          : stage_write(s, draft_name, intents->at, intents->size);
    if (!why && renameat(s->at, draft_name, s->at, list_name))
        why = text_error(errno);
    return why;
}

void intents_withdraw(const Stage *s) { unlinkat(s->at, list_name, 0); }

/* Returns true if the file was changed after `time`, by somebody else than the ended process.
 * False if `time` is NULL. */
static bool is_newer(int folder, const char *name, const struct timespec *time)
{
    struct stat info;
    if (!time || fstatat(folder, name, &info, AT_SYMLINK_NOFOLLOW))
        return false;
    const struct timespec *changed = &info.st_ctim;
    return changed->tv_sec != time->tv_sec ? changed->tv_sec > time->tv_sec
                                           : changed->tv_nsec > time->tv_nsec;
}

static int remove_unchanged(int folder, const Intent *intent)
{
    Key hash;
    int error = stage_hash(folder, intent->name, &hash);
    if (error || !key_equal(hash, intent->hash))
        return error == ENOENT || error == EINVAL ? 0 : error;
    return unlinkat(folder, intent->name, 0) ? errno : 0;
}

/* Carries out one intent. Returns 0 or errno. `since` is documented at intents_apply(). */
static int apply_one(const Stage *s, const Intent *intent, const struct timespec *since)
{
    char staged[STAGED_NAME];
    if (intent->kind == INTENT_remove && since)
        return remove_unchanged(s->folder, intent);
    intent_file(staged, intent->number);
    if (since && (faccessat(s->at, staged, F_OK, AT_SYMLINK_NOFOLLOW) ||
                  is_newer(s->folder, intent->name, since)))
        return 0; /* the removal is done, or somebody has changed the file since */
    if (intent->kind != INTENT_put)
        return unlinkat(s->folder, intent->name, 0) && errno != ENOENT ? errno : 0;
    return renameat(s->at, staged, s->folder, intent->name) ? errno : 0;
}

const char *intents_apply(const Stage *s, const Bytes *intents, const struct timespec *since,
                          int *done)
{
    BytesReader from = {intents->at, intents->at + intents->size, false};
    Intent intent;
    while (from.at < from.end) {
        if (!intent_take(&from, &intent))
            return damaged;
        int error = apply_one(s, &intent, since);
        if (error)
            return text_error(error);
        (*done)++;
    }
    return NULL;
}

/* Finishes the commit of an ended process if its folder has a list. Returns NULL or a fault. */
static const char *finish(const Stage *s)
{
    struct stat info;
    Bytes intents = {0};
    int done = 0;
    int file = openat(s->at, list_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0)
        return errno == ENOENT ? NULL : damaged;
    bool fine = !fstat(file, &info) && S_ISREG(info.st_mode) && info.st_size <= MAX_INTENTS;
    intents.size = fine ? (size_t)info.st_size : 0;
    intents.at = fine ? malloc(intents.size + 1) : NULL;
    fine = intents.at && read(file, intents.at, intents.size) == (ssize_t)intents.size;
    const char *why = fine ? intents_apply(s, &intents, &info.st_mtim, &done) : damaged;
    bytes_free(&intents);
    close(file);
    return why;
}

/* Locks the output folder. On a file system without locks, commits of several processes may mix. */
static const char *lock(int folder)
{
    for (int i = 0; flock(folder, LOCK_EX | LOCK_NB) && (errno == EWOULDBLOCK || errno == EINTR);
         i++) {
        if (i == MAX_WAITS)
            return "another process is writing there and does not finish";
        nanosleep(&(struct timespec){0, WAIT_NS}, NULL);
    }
    return NULL;
}

const char *intents_lock(int folder)
{
    const char *why = lock(folder);
    if (!why && (why = stage_each_abandoned(folder, finish)))
        intents_unlock(folder);
    return why;
}

void intents_unlock(int folder) { flock(folder, LOCK_UN); }
