/* Folders, files and processes for the benchmarks of batches. */
#include "batch_run.h"
#include "batch_documents.h"
#include "matbench.h"
#include "tests/value/folder.h"
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

enum { LOOK_MS = 3 };

extern char **environ;

bool batch_folder_make(BatchFolder *folder, const char *matc)
{
    *folder = (BatchFolder){.matc = matc};
    const char *above = getenv("TMPDIR");
    int size = snprintf(folder->path, sizeof folder->path, "%s/matbenchXXXXXX",
                        above && *above ? above : "/tmp");
    return (size_t)size < sizeof folder->path && mkdtemp(folder->path);
}

void batch_folder_remove(const BatchFolder *folder) { folder_remove(folder->path); }

void batch_clear(const BatchFolder *folder, const char *name)
{
    char path[BATCH_PATH];
    snprintf(path, sizeof path, "%s/%s", folder->path, name);
    folder_remove(path);
}

static bool write_file(const char *path, const char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    bool fine = file && fwrite(bytes, 1, size, file) == size;
    return file && !fclose(file) && fine;
}

static bool write_pictures(const BatchFolder *folder)
{
    char path[BATCH_PATH], name[32];
    size_t size;
    char *picture = read_whole(SOURCE_FOLDER "/examples/tiles.png", &size);
    bool fine = picture != NULL;
    for (int i = 0; i < SCENE_PICTURES && fine; i++) {
        batch_picture(i, name);
        snprintf(path, sizeof path, "%s/%s", folder->path, name);
        fine = write_file(path, picture, size);
    }
    free(picture);
    return fine;
}

bool batch_folder_fill(BatchFolder *folder, const char *name, int count,
                       void (*write)(int index, Text *out))
{
    char path[BATCH_PATH];
    Arena arena = {0};
    bool fine = write_pictures(folder);
    folder->bytes = 0;
    snprintf(path, sizeof path, "%s/%s.txt", folder->path, name);
    FILE *list = fopen(path, "w");
    for (int i = 0; i < count && fine && list; i++) {
        Text text = text_new(&arena);
        write(i, &text);
        snprintf(path, sizeof path, "%s/%s%05d.yaml", folder->path, name, i);
        fine = write_file(path, text.at, text.size);
        fprintf(list, "%s\n", path);
        folder->bytes += text.size;
        arena_reset(&arena);
    }
    arena_free(&arena);
    fine = list && !fclose(list) && fine;
    if (!fine)
        perror(path);
    return fine;
}

bool batch_folder_list(const BatchFolder *folder, const char *name, int first, int end, bool back)
{
    char path[BATCH_PATH];
    snprintf(path, sizeof path, "%s/%s.txt", folder->path, name);
    FILE *list = fopen(path, "w");
    for (int i = first; i < end && list; i++)
        fprintf(list, "%s/m%05d.yaml\n", folder->path, back ? first + end - 1 - i : i);
    return list && !fclose(list);
}

BatchCache batch_cache(const BatchFolder *folder)
{
    BatchCache held = {0};
    char command[2 * BATCH_PATH], line[128];
    snprintf(command, sizeof command, "%s --cache-stats --cache=%s/cache", folder->matc,
             folder->path);
    FILE *reported = popen(command, "r");
    while (reported && fgets(line, sizeof line, reported))
        if (sscanf(line, "entries %ld", &held.entries) != 1 &&
            sscanf(line, "bytes %ld", &held.bytes) != 1)
            continue;
    if (reported)
        pclose(reported);
    return held;
}

static void show(const char *path)
{
    size_t size;
    char *reported = read_whole(path, &size);
    fprintf(stderr, "matbench: matc failed\n%.2000s\n", reported ? reported : "");
    free(reported);
}

static double seconds_of(struct timeval time)
{
    return (double)time.tv_sec + (double)time.tv_usec * 1e-6;
}

/* Peak resident memory of a process so far, KiB; 0 after it has ended. The value of wait4 would
 * be at least our own memory. */
static long memory_of(pid_t process)
{
    char path[64], line[256];
    long memory = 0;
    snprintf(path, sizeof path, "/proc/%ld/status", (long)process);
    FILE *status = fopen(path, "r");
    while (status && !memory && fgets(line, sizeof line, status))
        if (!strncmp(line, "VmHWM:", 6))
            memory = strtol(line + 6, NULL, 10);
    if (status)
        fclose(status);
    return memory;
}

/* Waits for a process, and polls its memory. */
static bool wait_for(pid_t child, int *status, struct rusage *usage, long *memory)
{
    struct pollfd end = {.fd = (int)syscall(SYS_pidfd_open, child, 0), .events = POLLIN};
    while (end.fd >= 0 && poll(&end, 1, LOOK_MS) == 0) {
        long now = memory_of(child);
        *memory = now > *memory ? now : *memory;
    }
    if (end.fd >= 0)
        close(end.fd);
    return wait4(child, status, 0, usage) == child;
}

/* Runs a process with its output redirected to a file. */
static bool run_process(char *const *arguments, const char *output, BatchTimes *times)
{
    posix_spawn_file_actions_t actions;
    struct rusage usage;
    int status = 1;
    long memory = 0;
    pid_t child;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output, O_WRONLY | O_CREAT | O_TRUNC,
                                     0666);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    double start = bench_now();
    bool fine = !posix_spawn(&child, arguments[0], &actions, NULL, arguments, environ) &&
                wait_for(child, &status, &usage, &memory) && status == 0;
    if (fine)
        *times = (BatchTimes){bench_now() - start,
                              seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime), memory};
    posix_spawn_file_actions_destroy(&actions);
    return fine;
}

bool batch_run(const BatchFolder *folder, const char *list, const char *out,
               const char *const *arguments, BatchTimes *times)
{
    char at_list[BATCH_PATH], to[BATCH_PATH], reported[BATCH_PATH];
    const char *all[BATCH_ARGUMENTS] = {folder->matc, "-d", to, at_list};
    int count = 4;
    snprintf(at_list, sizeof at_list, "@%s/%s.txt", folder->path, list);
    snprintf(to, sizeof to, "%s/%s", folder->path, out);
    snprintf(reported, sizeof reported, "%s/said", folder->path);
    for (; *arguments && count < BATCH_ARGUMENTS - 1; arguments++)
        all[count++] = *arguments;
    if (run_process((char *const *)all, reported, times))
        return true;
    show(reported);
    return false;
}

char *batch_read(const BatchFolder *folder, const char *out, const char *name)
{
    char path[2 * BATCH_PATH];
    size_t size;
    snprintf(path, sizeof path, "%s/%s/%s", folder->path, out, name);
    return read_whole(path, &size);
}
