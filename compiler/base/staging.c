/* Files wait in a folder within the folder (staging_folder.c), so that moving them is a rename, and a journal makes all the renames one
 * (staging_journal.c). The folder where they wait is made with the first file that differs from what is there: a run that changes
 * nothing writes nothing. */
#include "compiler/base/staging.h"
#include "compiler/base/sets.h"
#include "compiler/base/staging_journal.h"
#include "compiler/base/text.h"
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct {
    Key hash;
    bool waits; /* in the staging; else the folder has it already */
    bool dropped, index;
} StagedFile;

struct Staging {
    char *path;
    int folder;
    dev_t device; /* of the folder */
    ino_t inode;
    unsigned how;
    bool new_folder; /* and nothing is in it yet */
    bool made;       /* `waiting` is there */
    bool begun;      /* its files are being moved */
    Waiting waiting;
    StringSet names;
    StagedFile *files; /* by number of the name */
    StringSet removed;
    Steps steps;
    int written;
    pthread_mutex_t mutex, making; /* of what is here; of files being made */
};

Staging *staging_open(const char *path, unsigned how, const char **why)
{
    struct stat info = {0};
    bool made = how & STAGING_new_folder && !mkdir(path, 0777);
    int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    *why = folder < 0 || fstat(folder, &info) ? text_error(errno) : steps_recover(folder);
    if (*why) {
        if (folder >= 0)
            close(folder);
        if (made)
            rmdir(path);
        return NULL;
    }
    Staging *s = sets_resize(NULL, sizeof *s);
    *s = (Staging){.path = sets_copy(path), .folder = folder, .how = how, .new_folder = made};
    s->device = info.st_dev;
    s->inode = info.st_ino;
    pthread_mutex_init(&s->mutex, NULL);
    pthread_mutex_init(&s->making, NULL);
    waiting_clean(folder);
    return s;
}

bool staging_same(const Staging *a, const Staging *b) { return a->device == b->device && a->inode == b->inode; }

/* Opens a regular file of the folder, with its size. -1: errno, ENOENT for what is neither that nor a folder. Never waits for a
 * pipe's other end. */
static int open_regular(const Staging *s, const char *name, size_t *size)
{
    struct stat info;
    int file = openat(s->folder, name, O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) {
        errno = errno == ELOOP || errno == ENXIO ? ENOENT : errno; /* a link, a socket */
        return -1;
    }
    int error = fstat(file, &info) ? errno : S_ISREG(info.st_mode) ? 0 : S_ISDIR(info.st_mode) ? EISDIR : ENOENT;
    *size = (size_t)info.st_size;
    if (!error)
        return file;
    close(file);
    errno = error;
    return -1;
}

/* As much as there is, up to size. */
static size_t read_all(int file, char *bytes, size_t size)
{
    size_t used = 0;
    while (used < size) {
        ssize_t got = read(file, bytes + used, size - used);
        if (got == 0 || (got < 0 && errno != EINTR))
            break;
        used += got > 0 ? (size_t)got : 0;
    }
    return used;
}

char *staging_read(const Staging *s, const char *name, const char **why)
{
    size_t size;
    struct stat info;
    bool special = !fstatat(s->folder, name, &info, 0) && !S_ISREG(info.st_mode); /* or a link to such a file */
    int file = special ? -1 : open_regular(s, name, &size);
    *why = special ? "it is no regular file" : file < 0 && errno != ENOENT ? text_error(errno) : NULL;
    if (file < 0)
        return NULL;
    char *bytes = sets_resize(NULL, size + 1);
    bool whole = read_all(file, bytes, size) == size;
    bytes[size] = 0;
    *why = whole ? NULL : text_error(EIO);
    close(file);
    if (whole)
        return bytes;
    free(bytes);
    return NULL;
}

/* NULL, or why no file can be put there. */
static const char *look(const Staging *s, const char *name, const void *bytes, size_t size, bool *equal)
{
    size_t old_size;
    int file = open_regular(s, name, &old_size);
    *equal = false;
    if (file < 0)
        return errno == EISDIR ? text_error(EISDIR) : NULL; /* what cannot be read can be replaced */
    char *old = old_size == size && !(s->how & STAGING_renew) ? malloc(size + 1) : NULL;
    *equal = old && read_all(file, old, size) == size && !memcmp(old, bytes, size);
    free(old);
    close(file);
    return NULL;
}

static const char *make_waiting(Staging *s)
{
    const char *why = s->made ? NULL : waiting_make(&s->waiting, s->folder);
    s->made |= !why;
    return why;
}

/* The number of a name, and whether a file of it waits already. */
static int number_of(Staging *s, const char *name, bool *again)
{
    bool added;
    pthread_mutex_lock(&s->mutex);
    int number = string_set_add(&s->names, name, &added);
    if (added) {
        s->files = sets_resize(s->files, (size_t)s->names.room * sizeof *s->files);
        s->files[number] = (StagedFile){.dropped = true}; /* until it is known */
    }
    *again = s->files[number].waits;
    pthread_mutex_unlock(&s->mutex);
    return number;
}

/* Kernels serialise the making of files anyway, and spin. */
static const char *put_waiting(Staging *s, int number, bool again, const void *bytes, size_t size)
{
    char file[NUMBER_NAME];
    step_file(file, number);
    pthread_mutex_lock(&s->making);
    const char *why = make_waiting(s);
    if (!why && again)
        unlinkat(s->waiting.at, file, 0);
    if (!why)
        why = waiting_write(&s->waiting, file, bytes, size);
    pthread_mutex_unlock(&s->making);
    return why;
}

static const char *put(Staging *s, const char *name, const void *bytes, size_t size, bool index)
{
    bool equal, again;
    const char *why = look(s, name, bytes, size, &equal);
    int number = why ? -1 : number_of(s, name, &again);
    if (!why && !equal)
        why = put_waiting(s, number, again, bytes, size);
    if (why)
        return why;
    const StagedFile file = {.hash = key_of_bytes(bytes, size), .waits = !equal, .index = index};
    pthread_mutex_lock(&s->mutex);
    s->files[number] = file;
    pthread_mutex_unlock(&s->mutex);
    return NULL;
}

const char *staging_put(Staging *s, const char *name, const void *bytes, size_t size)
{
    return put(s, name, bytes, size, false);
}

const char *staging_put_index(Staging *s, const char *name, const void *bytes, size_t size)
{
    return put(s, name, bytes, size, true);
}

void staging_drop(Staging *s, const char *name)
{
    pthread_mutex_lock(&s->mutex);
    int number = string_set_find(&s->names, name);
    if (number >= 0)
        s->files[number].dropped = true;
    pthread_mutex_unlock(&s->mutex);
}

bool staging_holds(const Staging *s, const char *name)
{
    int number = string_set_find(&s->names, name);
    return number >= 0 && s->files[number].waits && !s->files[number].dropped;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const StagingFile *)a)->name, ((const StagingFile *)b)->name);
}

StagingFile *staging_list(const Staging *s, int *count)
{
    StagingFile *list = sets_resize(NULL, (size_t)s->names.count * sizeof *list);
    *count = 0;
    for (int i = 0; i < s->names.count; i++)
        if (!s->files[i].dropped)
            list[(*count)++] = (StagingFile){s->names.at[i], s->files[i].hash};
    qsort(list, (size_t)*count, sizeof *list, by_name);
    return list;
}

const char *staging_remove(Staging *s, const char *name, Key hash, bool *stays)
{
    Key now;
    int number = string_set_find(&s->names, name);
    *stays = false;
    if ((number >= 0 && !s->files[number].dropped) || strchr(name, '/'))
        return NULL; /* it is made again */
    int error = waiting_hash(s->folder, name, &now);
    *stays = error == EINVAL || (!error && !key_equal(now, hash));
    if (!error && !*stays)
        string_set_add(&s->removed, name, NULL);
    return error && error != EINVAL && error != ENOENT ? text_error(error) : NULL;
}

/* The index last, and removals before it. */
static void list_steps(Staging *s)
{
    int count = s->names.count, last = -1;
    s->steps.at = sets_resize(NULL, (size_t)(count + s->removed.count) * sizeof *s->steps.at);
    for (int i = 0; i < count; i++) {
        const StagedFile *file = &s->files[i];
        if (file->waits && !file->dropped && file->index)
            last = i;
        else if (file->waits && !file->dropped)
            s->steps.at[s->steps.count++] = (Step){STEP_put, i, file->hash, s->names.at[i]};
    }
    for (int i = 0; i < s->removed.count; i++)
        s->steps.at[s->steps.count++] = (Step){.kind = STEP_remove, .number = count + i, .name = s->removed.at[i]};
    if (last >= 0)
        s->steps.at[s->steps.count++] = (Step){STEP_index, last, s->files[last].hash, s->names.at[last]};
}

/* One file in one folder needs no journal. */
static const char *move_one(const Staging *s)
{
    char file[NUMBER_NAME];
    const Step *step = s->steps.at;
    if (step->kind == STEP_remove)
        return unlinkat(s->folder, step->name, 0) && errno != ENOENT ? text_error(errno) : NULL;
    step_file(file, step->number);
    return renameat(s->waiting.at, file, s->folder, step->name) ? text_error(errno) : NULL;
}

static const char *begin_and_do(Staging *s)
{
    const char *why = make_waiting(s); /* it may have to remove alone */
    if (!why)
        why = steps_begin(&s->waiting, &s->steps);
    if (why)
        return why;
    s->begun = true;
    return steps_do(&s->waiting, &s->steps);
}

/* After a failure. What cannot be undone now is left to the next run. */
static void undo(Staging *s)
{
    if (!s->begun)
        return;
    if (!steps_undo(&s->waiting, &s->steps) || !waiting_finish(&s->waiting))
        waiting_leave(&s->waiting);
    s->made = s->waiting.at >= 0;
    s->begun = false;
}

static const char *end(Staging *s)
{
    const char *why = s->begun ? steps_end(&s->waiting) : NULL;
    if (why)
        return why;
    s->begun = false;
    for (int i = 0; i < s->steps.count; i++)
        s->written += s->steps.at[i].kind != STEP_remove;
    s->new_folder &= !s->written;
    return NULL;
}

const char *staging_commit(Staging *const *stagings, int count)
{
    const char *why = NULL;
    int busy = 0;
    for (int i = 0; i < count; i++) {
        list_steps(stagings[i]);
        busy += stagings[i]->steps.count;
    }
    for (int i = 0; i < count && !why; i++)
        if (stagings[i]->steps.count)
            why = busy == 1 ? move_one(stagings[i]) : begin_and_do(stagings[i]);
    for (int i = 0; i < count && !why; i++)
        why = end(stagings[i]);
    for (int i = count - 1; i >= 0 && why; i--)
        undo(stagings[i]);
    return why;
}

int staging_written(const Staging *s) { return s->written; }

void staging_close(Staging *s)
{
    if (!s)
        return;
    if (s->made)
        waiting_remove(&s->waiting);
    if (s->new_folder)
        rmdir(s->path);
    close(s->folder);
    pthread_mutex_destroy(&s->mutex);
    pthread_mutex_destroy(&s->making);
    free(s->steps.at);
    free(s->files);
    string_set_free(&s->names);
    string_set_free(&s->removed);
    free(s->path);
    free(s);
}
