/* A commit. A process may be ended at any call, and any call may fail: the folder is then as it was, or is made so by the next run.
 *
 *   1. All new files wait, whole. The journal lists the steps; with an index it is on the disk.  a kill: nothing has changed
 *   2. The folder where they wait is called ".matc-commit".                                     from here on: undone
 *   3. The index (the manifest) is put aside, if it will be another: while files change none tells what they are.
 *   4. Each new file takes the place of the old one, which keeps a second name: "N.old".
 *   5. Each file that is no longer made is put aside.
 *   6. The new index takes its place.
 *   7. The journal is emptied.                                                                   from here on: done
 *   8. What is in it is removed, and it itself.
 *
 * Undoing takes the index away first, and brings the old one back last. It may be interrupted, too: a step that is undone already
 * has neither "N.old" nor "N". What it removes is a file with the new one's bytes and no other. */
#include "compiler/base/stage_journal.h"
#include "compiler/base/bytes.h"
#include "compiler/base/sets.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { WAIT_NS = 5000000, MOST_WAITS = 6000 /* half a minute */, LARGEST_JOURNAL = 64 << 20 };

static const char magic[8] = "matc jr1";

void step_file(char name[NUMBER_NAME], int number) { snprintf(name, NUMBER_NAME, "%d", number); }
static void old_file(char name[NUMBER_NAME], int number) { snprintf(name, NUMBER_NAME, "%d.old", number); }

/* NULL: there is none. */
static const Step *index_of(const Steps *steps)
{
    const Step *last = steps->count ? &steps->at[steps->count - 1] : NULL;
    return last && last->kind == STEP_index ? last : NULL;
}

/* -- the journal: magic, count, the steps, a hash of all that */

static const char *journal_write(const Waiting *w, const Steps *steps)
{
    Bytes bytes = {0};
    bytes_add(&bytes, magic, sizeof magic);
    bytes_number(&bytes, (uint32_t)steps->count);
    for (const Step *step = steps->at; step < steps->at + steps->count; step++) {
        bytes_number(&bytes, (uint32_t)step->kind);
        bytes_number(&bytes, (uint32_t)step->number);
        bytes_add(&bytes, &step->hash, sizeof step->hash);
        bytes_text(&bytes, step->name);
    }
    Key hash = key_of_bytes(bytes.at, bytes.size);
    bytes_add(&bytes, &hash, sizeof hash);
    const char *why = waiting_put(w->journal, bytes.at, bytes.size);
    if (!why && index_of(steps) && fdatasync(w->journal) && errno != EINVAL) /* where that is unknown, we go on */
        why = strerror(errno);
    bytes_free(&bytes);
    return why;
}

/* Of the folder itself: a journal can be anybody's. */
static bool is_plain(const char *name)
{
    return *name && !strchr(name, '/') && strcmp(name, ".") != 0 && strcmp(name, "..") != 0;
}

static bool take_step(BytesReader *from, Step *step)
{
    uint32_t kind = bytes_take_number(from), number = bytes_take_number(from);
    const void *hash = bytes_take(from, sizeof step->hash);
    const char *name = bytes_take_text(from);
    if (from->broken || kind >= STEP_KINDS || number > INT32_MAX || !is_plain(name))
        return false;
    *step = (Step){.kind = (StepKind)kind, .number = (int)number, .name = name};
    memcpy(&step->hash, hash, sizeof step->hash);
    return true;
}

/* The journal's bytes, from malloc, and the steps, whose names lie in them. NULL: it is none, or not whole. */
static char *journal_read(const Waiting *w, Steps *steps)
{
    struct stat info;
    const size_t ends = sizeof magic + sizeof(Key);
    *steps = (Steps){0};
    if (fstat(w->journal, &info) || info.st_size < (off_t)ends || info.st_size > LARGEST_JOURNAL)
        return NULL;
    size_t size = (size_t)info.st_size;
    char *bytes = sets_resize(NULL, size);
    Key hash, wanted = {0};
    if (pread(w->journal, bytes, size, 0) == (ssize_t)size)
        wanted = key_of_bytes(bytes, size - sizeof hash);
    memcpy(&hash, bytes + size - sizeof hash, sizeof hash);
    BytesReader from = {bytes, bytes + size - sizeof hash, false};
    const void *begin = bytes_take(&from, sizeof magic);
    uint32_t count = bytes_take_number(&from);
    bool fine = key_equal(hash, wanted) && begin && !memcmp(begin, magic, sizeof magic) && count <= size;
    steps->at = fine ? sets_resize(NULL, count * sizeof *steps->at) : NULL;
    while (fine && steps->count < (int)count)
        fine = take_step(&from, &steps->at[steps->count]) && ++steps->count;
    if (fine)
        return bytes;
    free(steps->at);
    free(bytes);
    *steps = (Steps){0};
    return NULL;
}

/* -- doing */

static bool put_aside(const Waiting *w, const Step *step)
{
    char old[NUMBER_NAME];
    old_file(old, step->number);
    return !renameat(w->folder, step->name, w->at, old) || errno == ENOENT;
}

/* By a second name, so that the folder always has the file; where that cannot be, by its only one. */
static bool keep_old(const Waiting *w, const Step *step)
{
    char old[NUMBER_NAME];
    struct stat info;
    old_file(old, step->number);
    if (!linkat(w->folder, step->name, w->at, old, 0) || errno == ENOENT)
        return true;
    if (fstatat(w->folder, step->name, &info, AT_SYMLINK_NOFOLLOW) || !S_ISDIR(info.st_mode))
        return put_aside(w, step);
    errno = EISDIR;
    return false;
}

static bool put(const Waiting *w, const Step *step)
{
    char file[NUMBER_NAME];
    step_file(file, step->number);
    return keep_old(w, step) && !renameat(w->at, file, w->folder, step->name);
}

const char *steps_do(const Waiting *w, const Steps *steps)
{
    const Step *index = index_of(steps);
    bool fine = !index || steps->count == 1 || put_aside(w, index);
    for (int i = 0; i < steps->count && fine; i++)
        fine = steps->at[i].kind == STEP_remove ? put_aside(w, &steps->at[i]) : put(w, &steps->at[i]);
    return fine ? NULL : strerror(errno);
}

const char *steps_end(const Waiting *w) { return waiting_finish(w) ? NULL : strerror(errno); }

/* One at a time. */
const char *steps_begin(Waiting *w, const Steps *steps)
{
    const char *why = journal_write(w, steps);
    for (int i = 0; !why && !waiting_rename(w, waiting_commit); i++) {
        if (errno != EEXIST && errno != ENOTEMPTY && errno != ENOTDIR)
            return strerror(errno);
        why = i < MOST_WAITS ? steps_recover(w->folder) : "another process writes there and does not end";
        nanosleep(&(struct timespec){0, WAIT_NS}, NULL);
    }
    return why;
}

/* -- undoing */

static bool bring_back(const Waiting *w, const Step *step)
{
    char old[NUMBER_NAME];
    old_file(old, step->number);
    return !renameat(w->at, old, w->folder, step->name) || errno == ENOENT;
}

/* Takes the new file away, if it is there. */
static bool take_new(const Waiting *w, const Step *step)
{
    char file[NUMBER_NAME];
    Key hash;
    step_file(file, step->number);
    if (!faccessat(w->at, file, F_OK, AT_SYMLINK_NOFOLLOW))
        return true;
    int error = waiting_hash(w->folder, step->name, &hash);
    if (error == ENOENT || error == EINVAL || (!error && !key_equal(hash, step->hash)))
        return true;
    errno = error;
    return !error && !unlinkat(w->folder, step->name, 0);
}

static bool has_old(const Waiting *w, const Step *step)
{
    char old[NUMBER_NAME];
    old_file(old, step->number);
    return !faccessat(w->at, old, F_OK, AT_SYMLINK_NOFOLLOW);
}

bool steps_undo(const Waiting *w, const Steps *steps)
{
    const Step *index = index_of(steps);
    bool fine = !index || take_new(w, index);
    for (int i = steps->count - 1; i >= 0 && fine; i--) {
        const Step *step = &steps->at[i];
        if (step != index)
            fine = step->kind == STEP_remove || has_old(w, step) ? bring_back(w, step) : take_new(w, step);
    }
    return fine && (!index || bring_back(w, index));
}

const char *steps_recover(int folder)
{
    Waiting w;
    Steps steps;
    Taken taken = waiting_take(&w, folder, waiting_commit);
    if (taken != TAKEN)
        return NULL; /* who is at it ends soon */
    char *bytes = journal_read(&w, &steps);
    const char *why = steps_undo(&w, &steps) && waiting_finish(&w) ? NULL : strerror(errno);
    free(steps.at);
    free(bytes);
    if (why)
        waiting_leave(&w);
    else
        waiting_remove(&w);
    return why;
}
