/* Output files that appear together. New files wait in a hidden folder within the output folder
 * (staging_folder.c), so that moving them is a rename; a commit moves all of them even if the
 * process is killed (staging_commit.c). The hidden folder is created with the first file whose
 * bytes differ from those in the output folder, so a run that changes nothing writes nothing. */
#include "compiler/base/staging/staging.h"
#include "compiler/base/sets.h"
#include "compiler/base/staging/staging_commit.h"
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
    bool staged; /* false: the output folder already has these bytes */
    bool dropped, index;
} StagedFile;

struct Staging {
    char *path;
    int folder;
    dev_t device; /* identity of the folder */
    ino_t inode;
    unsigned how;
    bool new_folder; /* this run created the folder, which is still empty */
    bool begun;      /* the list of intents is on disk, and the folder is locked */
    Stage stage;
    StringSet names;
    StagedFile *files; /* files of the run, indexed by the number of the name */
    StringSet stale;
    Key *stale_hashes; /* hashes of stale files, indexed by the number of the stale name */
    Bytes intents;
    int moves, written;
    pthread_mutex_t mutex; /* guards the members above */
    /* held to create files, since kernels serialize creation by spin locks */
    pthread_mutex_t disk;
};

/* Finishes commits of ended processes and removes their staging folders. */
static const char *recover(int folder)
{
    const char *why = intents_lock(folder);
    if (!why)
        intents_unlock(folder);
    return why;
}

Staging *staging_open(const char *path, unsigned how, const char **why)
{
    struct stat info = {0};
    bool made = how & STAGING_new_folder && !mkdir(path, 0777);
    int folder = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    *why = folder < 0 || fstat(folder, &info) ? text_error(errno) : recover(folder);
    if (*why) {
        if (folder >= 0)
            close(folder);
        if (made)
            rmdir(path);
        return NULL;
    }
    Staging *s = sets_resize(NULL, sizeof *s);
    *s = (Staging){.path = sets_copy(path),
                   .folder = folder,
                   .how = how,
                   .new_folder = made,
                   .stage = {folder, -1, ""}};
    s->device = info.st_dev;
    s->inode = info.st_ino;
    pthread_mutex_init(&s->mutex, NULL);
    pthread_mutex_init(&s->disk, NULL);
    return s;
}

bool staging_same(const Staging *a, const Staging *b)
{
    return a->device == b->device && a->inode == b->inode;
}

/* Opens a regular file of the folder and returns its size. Returns -1 and errno on failure;
 * ENOENT for anything except a file or folder. Never blocks on a pipe. */
static int open_regular(const Staging *s, const char *name, size_t *size)
{
    struct stat info;
    int file = openat(s->folder, name, O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
    if (file < 0) {
        /* ELOOP: a symbolic link; ENXIO: a socket */
        errno = errno == ELOOP || errno == ENXIO ? ENOENT : errno;
        return -1;
    }
    int error = fstat(file, &info)      ? errno
                : S_ISREG(info.st_mode) ? 0
                : S_ISDIR(info.st_mode) ? EISDIR
                                        : ENOENT;
    *size = (size_t)info.st_size;
    if (!error)
        return file;
    close(file);
    errno = error;
    return -1;
}

/* Reads until the end of the file, at most `size` bytes. */
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
    /* The target of a link counts, too. */
    bool special = !fstatat(s->folder, name, &info, 0) && !S_ISREG(info.st_mode);
    int file = special ? -1 : open_regular(s, name, &size);
    *why = special                       ? "it is not a regular file"
           : file < 0 && errno != ENOENT ? text_error(errno)
                                         : NULL;
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

/* Returns NULL, or the reason why no file can be put there. *equal: the folder's file already
 * has these bytes. */
static const char *look(const Staging *s, const char *name, const void *bytes, size_t size,
                        bool *equal)
{
    size_t old_size;
    int file = open_regular(s, name, &old_size);
    *equal = false;
    if (file < 0)
        /* An unreadable file can still be replaced. */
        return errno == EISDIR ? text_error(EISDIR) : NULL;
    char *old = old_size == size && !(s->how & STAGING_renew) ? malloc(size + 1) : NULL;
    *equal = old && read_all(file, old, size) == size && !memcmp(old, bytes, size);
    free(old);
    close(file);
    return NULL;
}

/* Returns the number of a name; a new name gets an entry. */
static int number_of(Staging *s, const char *name)
{
    bool added;
    pthread_mutex_lock(&s->mutex);
    int number = string_set_add(&s->names, name, &added);
    if (added) {
        s->files = sets_resize(s->files, (size_t)s->names.capacity * sizeof *s->files);
        s->files[number] = (StagedFile){.dropped = true}; /* dropped until the file is written */
    }
    pthread_mutex_unlock(&s->mutex);
    return number;
}

static const char *stage_file(Staging *s, int number, const void *bytes, size_t size)
{
    char file[STAGED_NAME];
    intent_file(file, number);
    pthread_mutex_lock(&s->disk);
    const char *why = s->stage.at < 0 ? stage_make(&s->stage, s->folder) : NULL;
    if (!why)
        why = stage_write(&s->stage, file, bytes, size);
    pthread_mutex_unlock(&s->disk);
    return why;
}

static const char *put(Staging *s, const char *name, const void *bytes, size_t size, bool index)
{
    bool equal;
    const char *why = look(s, name, bytes, size, &equal);
    int number = why ? -1 : number_of(s, name);
    if (!why && !equal)
        why = stage_file(s, number, bytes, size);
    if (why)
        return why;
    const StagedFile file = {.hash = key_of_bytes(bytes, size), .staged = !equal, .index = index};
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
    return number >= 0 && s->files[number].staged && !s->files[number].dropped;
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

static void add_stale(Staging *s, const char *name, Key hash)
{
    int number = string_set_add(&s->stale, name, NULL);
    s->stale_hashes =
        sets_resize(s->stale_hashes, (size_t)s->stale.capacity * sizeof *s->stale_hashes);
    s->stale_hashes[number] = hash;
}

const char *staging_remove(Staging *s, const char *name, Key hash, bool *stays)
{
    Key now;
    int number = string_set_find(&s->names, name);
    *stays = false;
    if ((number >= 0 && !s->files[number].dropped) || strchr(name, '/'))
        return NULL; /* written by this run, or not directly in the folder */
    int error = stage_hash(s->folder, name, &now);
    *stays = error == EINVAL || (!error && !key_equal(now, hash));
    if (!error && !*stays)
        add_stale(s, name, hash);
    return error && error != EINVAL && error != ENOENT ? text_error(error) : NULL;
}

static void add_move(Staging *s, int number)
{
    intent_add(&s->intents,
               &(Intent){.kind = INTENT_put, .number = number, .name = s->names.at[number]});
    s->moves++;
}

/* Lists the intents of a commit: it removes the old index first and moves the new one last. Returns
 * the number of moves and removals. */
static int list_intents(Staging *s)
{
    int index = -1;
    for (int i = 0; i < s->names.count; i++)
        if (s->files[i].index && s->files[i].staged && !s->files[i].dropped)
            index = i;
    if (index >= 0)
        intent_add(&s->intents,
                   &(Intent){.kind = INTENT_hide, .number = index, .name = s->names.at[index]});
    for (int i = 0; i < s->names.count; i++)
        if (s->files[i].staged && !s->files[i].dropped && i != index)
            add_move(s, i);
    for (int i = 0; i < s->stale.count; i++)
        intent_add(
            &s->intents,
            &(Intent){.kind = INTENT_remove, .hash = s->stale_hashes[i], .name = s->stale.at[i]});
    if (index >= 0)
        add_move(s, index);
    return s->moves + s->stale.count;
}

/* Locks the folder and writes the list of intents. On success the folder stays locked. */
static const char *begin(Staging *s)
{
    const char *why = s->stage.at < 0 ? stage_make(&s->stage, s->folder) : NULL;
    if (!why)
        why = intents_lock(s->folder);
    if (why)
        return why;
    why = intents_write(&s->stage, &s->intents);
    s->begun = !why;
    if (why)
        intents_unlock(s->folder);
    return why;
}

/* Deletes a list that was written but not begun, and unlocks the folder. */
static void withdraw(Staging *s)
{
    if (!s->begun)
        return;
    intents_withdraw(&s->stage);
    intents_unlock(s->folder);
    s->begun = false;
}

/* Carries out the intents. They are on the disk too, unless the commit is a single rename. */
static const char *apply(Staging *s, int *done)
{
    const char *why = intents_apply(&s->stage, &s->intents, NULL, done);
    if (why)
        return why;
    if (s->begun)
        intents_unlock(s->folder);
    s->begun = false;
    s->written += s->moves;
    s->new_folder &= !s->written;
    return NULL;
}

/* Writes the lists of all folders before it moves the first file. A failure before that move
 * deletes the lists; after it they stay, and the next run finishes them. */
const char *staging_commit(Staging *const *stagings, int count)
{
    const char *why = NULL;
    int steps = 0, done = 0;
    for (int i = 0; i < count; i++)
        steps += list_intents(stagings[i]);
    for (int i = 0; i < count && !why && steps > 1; i++)
        why = stagings[i]->intents.size ? begin(stagings[i]) : NULL;
    for (int i = 0; i < count && !why; i++)
        why = apply(stagings[i], &done);
    for (int i = 0; i < count && why && !done; i++)
        withdraw(stagings[i]);
    return why;
}

int staging_written(const Staging *s) { return s->written; }

void staging_close(Staging *s)
{
    if (!s)
        return;
    if (s->stage.at >= 0)
        s->begun ? stage_leave(&s->stage) : stage_remove(&s->stage);
    if (s->new_folder)
        rmdir(s->path);
    close(s->folder);
    pthread_mutex_destroy(&s->mutex);
    pthread_mutex_destroy(&s->disk);
    bytes_free(&s->intents);
    free(s->stale_hashes);
    free(s->files);
    string_set_free(&s->names);
    string_set_free(&s->stale);
    free(s->path);
    free(s);
}
