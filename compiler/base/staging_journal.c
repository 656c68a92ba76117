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
 * has neither "N.old" nor "N". It removes or replaces a file with the new one's bytes and no other: what somebody put there since
 * stays. A journal that cannot be followed to its end is not begun: it is an error, and all stays as it is. */
#include "compiler/base/staging_journal.h"
#include "compiler/base/bytes.h"
#include "compiler/base/sets.h"
#include "compiler/base/text.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { WAIT_NS = 5000000, MOST_WAITS = 6000 /* half a minute */, LARGEST_JOURNAL = 64 << 20 };

/* A step of a journal without its name, and with an empty one. */
enum { STEP_HEAD = 2 * sizeof(uint32_t) + sizeof(Key), SMALLEST_STEP = STEP_HEAD + sizeof(uint32_t) + 1 };

static const char magic[8] = "matc jr2";

static const char damaged[] =
    "the journal of an interrupted run, .matc-commit/journal, is damaged or another version's: nothing "
    "was changed; remove .matc-commit to go on without its files";
static const char copied[] =
    "the journal of an interrupted run, .matc-commit/journal, is a copy from another place: nothing was "
    "changed; remove .matc-commit to go on without its files";
static const char strange[] = "what is called .matc-commit there is not as matc makes it: move it away";
static const char crowded[] = "other files than matc's are in .matc-commit there: move them away";

void step_file(char name[NUMBER_NAME], int number) { snprintf(name, NUMBER_NAME, "%d", number); }
static void old_file(char name[NUMBER_NAME], int number) { snprintf(name, NUMBER_NAME, "%d.old", number); }

/* NULL: there is none. */
static const Step *index_of(const Steps *steps)
{
    const Step *last = steps->count ? &steps->at[steps->count - 1] : NULL;
    return last && last->kind == STEP_index ? last : NULL;
}

/* -- the journal: magic, its own number on the disk, count, the steps, a hash of all that */

static uint64_t number_on_disk(int file)
{
    struct stat info;
    return fstat(file, &info) ? 0 : (uint64_t)info.st_ino;
}

static const char *journal_write(const Waiting *w, const Steps *steps)
{
    Bytes bytes = {0};
    uint64_t own = number_on_disk(w->journal);
    bytes_add(&bytes, magic, sizeof magic);
    bytes_add(&bytes, &own, sizeof own);
    bytes_number(&bytes, (uint32_t)steps->count);
    for (const Step *step = steps->at; step < steps->at + steps->count; step++) {
        bytes_number(&bytes, (uint32_t)step->kind);
        bytes_number(&bytes, (uint32_t)step->number);
        bytes_add(&bytes, &step->hash, sizeof step->hash);
        bytes_text(&bytes, step->name);
    }
    Key hash = key_of_bytes(bytes.at, bytes.size);
    bytes_add(&bytes, &hash, sizeof hash);
    const char *why = bytes.size > LARGEST_JOURNAL ? "too many files" : waiting_put(w->journal, bytes.at, bytes.size);
    if (!why && index_of(steps) && fdatasync(w->journal) && errno != EINVAL) /* where that is unknown, we go on */
        why = text_error(errno);
    bytes_free(&bytes);
    return why;
}

/* A name in the folder itself: a journal can be anybody's. */
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

/* The steps, whose names lie in the bytes. NULL, or why they cannot be followed: then there are none. */
static const char *take_steps(BytesReader *from, uint64_t own, Steps *steps)
{
    uint64_t written = 0;
    const void *begin = bytes_take(from, sizeof magic), *number = bytes_take(from, sizeof written);
    uint32_t count = bytes_take_number(from);
    if (from->broken || memcmp(begin, magic, sizeof magic) != 0 ||
        count > (size_t)(from->end - from->at) / SMALLEST_STEP)
        return damaged;
    memcpy(&written, number, sizeof written);
    if (written != own)
        return copied;
    steps->at = sets_resize(NULL, count * sizeof *steps->at);
    while (steps->count < (int)count && take_step(from, &steps->at[steps->count]))
        steps->count++;
    if (steps->count == (int)count && from->at == from->end)
        return NULL;
    free(steps->at);
    *steps = (Steps){0};
    return damaged;
}

/* All of it, from malloc. NULL: it cannot be read, or is too large for one. */
static char *read_whole(int file, size_t *size)
{
    struct stat info;
    if (fstat(file, &info) || info.st_size > LARGEST_JOURNAL)
        return NULL;
    *size = (size_t)info.st_size;
    char *bytes = sets_resize(NULL, *size);
    if (pread(file, bytes, *size, 0) == (ssize_t)*size)
        return bytes;
    free(bytes);
    return NULL;
}

/* The journal's bytes, from malloc, and the steps; none, where it is empty. Or why they cannot be followed. */
static const char *journal_read(const Waiting *w, char **bytes, Steps *steps)
{
    size_t size;
    Key hash;
    *steps = (Steps){0};
    *bytes = read_whole(w->journal, &size);
    if (!*bytes)
        return damaged;
    if (!size)
        return NULL;
    if (size < sizeof hash)
        return damaged;
    BytesReader from = {*bytes, *bytes + size - sizeof hash, false};
    memcpy(&hash, from.end, sizeof hash);
    return key_equal(hash, key_of_bytes(*bytes, size - sizeof hash))
               ? take_steps(&from, number_on_disk(w->journal), steps)
               : damaged;
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
    return fine ? NULL : text_error(errno);
}

const char *steps_end(const Waiting *w) { return waiting_finish(w) ? NULL : text_error(errno); }

/* One at a time. */
const char *steps_begin(Waiting *w, const Steps *steps)
{
    const char *why = journal_write(w, steps);
    for (int i = 0; !why && !waiting_rename(w, waiting_commit); i++) {
        if (errno != EEXIST && errno != ENOTEMPTY && errno != ENOTDIR)
            return text_error(errno);
        why = i < MOST_WAITS ? steps_recover(w->folder) : "another process writes there and does not end";
        nanosleep(&(struct timespec){0, WAIT_NS}, NULL);
    }
    return why;
}

/* -- undoing */

typedef enum { THERE_nothing, THERE_new, THERE_other } There;

/* What has the file's name in the folder now. False: errno. */
static bool look(const Waiting *w, const Step *step, There *there)
{
    Key hash;
    int error = waiting_hash(w->folder, step->name, &hash);
    *there = error == ENOENT ? THERE_nothing : !error && key_equal(hash, step->hash) ? THERE_new : THERE_other;
    errno = error;
    return !error || error == ENOENT || error == EINVAL;
}

static bool has(const Waiting *w, const char *file) { return !faccessat(w->at, file, F_OK, AT_SYMLINK_NOFOLLOW); }

/* The old file, where the new one is or nothing. */
static bool bring_back(const Waiting *w, const Step *step)
{
    char old[NUMBER_NAME];
    There there;
    old_file(old, step->number);
    if (!has(w, old))
        return true;
    return look(w, step, &there) && (there == THERE_other || !renameat(w->at, old, w->folder, step->name));
}

/* Takes the new file away, if it is there. */
static bool take_new(const Waiting *w, const Step *step)
{
    char file[NUMBER_NAME];
    There there;
    step_file(file, step->number);
    if (has(w, file))
        return true;
    return look(w, step, &there) && (there != THERE_new || !unlinkat(w->folder, step->name, 0));
}

/* A file that had an old one becomes that at once: the folder is never without it. */
static bool undo_step(const Waiting *w, const Step *step)
{
    char old[NUMBER_NAME];
    old_file(old, step->number);
    return step->kind == STEP_remove || has(w, old) ? bring_back(w, step) : take_new(w, step);
}

bool steps_undo(const Waiting *w, const Steps *steps)
{
    const Step *index = index_of(steps);
    bool fine = !index || take_new(w, index);
    for (int i = steps->count - 1; i >= 0 && fine; i--)
        fine = &steps->at[i] == index || undo_step(w, &steps->at[i]);
    return fine && (!index || bring_back(w, index));
}

const char *steps_recover(int folder)
{
    Waiting w;
    Steps steps;
    char *bytes;
    Taken taken = waiting_take(&w, folder, waiting_commit);
    if (taken != TAKEN)
        return taken == TAKEN_strange ? strange : NULL; /* who is at it ends soon */
    const char *why = journal_read(&w, &bytes, &steps);
    if (!why && !(steps_undo(&w, &steps) && waiting_finish(&w)))
        why = text_error(errno);
    free(steps.at);
    free(bytes);
    if (!why)
        return waiting_remove(&w) ? NULL : crowded;
    waiting_leave(&w);
    return why;
}
