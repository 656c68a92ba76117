/* Runs `matc -d` on many documents in its own folder, timed by that process' CPU clock. */
#include "growth.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

/* clang-format off */
const GrowthBatch growth_batches[] = {
#define BATCH(name, options, count, before, part) {#name, options, count, GROWTH_##before, part},
#include "growth.def"
};
/* clang-format on */
const int growth_batch_count = sizeof growth_batches / sizeof *growth_batches;

enum { MAX_FOLDER = 32, MAX_PATH = 128, MAX_COMMAND = 1024 };

/* Writes d0.yaml ... to the folder, and a list of them. */
static bool put_documents(const GrowthBatch *row, const char *folder, int count, const char *list)
{
    char path[MAX_PATH];
    snprintf(path, sizeof path, "%s/%s", folder, list);
    FILE *names = fopen(path, "w");
    for (int i = 0; names && i < count; i++) {
        snprintf(path, sizeof path, "%s/d%d.yaml", folder, i);
        FILE *out = fopen(path, "w");
        if (!out)
            break;
        fprintf(names, "%s\n", path);
        growth_put_part(out, row->part, i);
        fclose(out);
    }
    return names && !fclose(names);
}

/* CPU seconds of a shell command and its children; infinite if it fails. */
static double seconds_of(const char *command)
{
    struct rusage used;
    int status;
    pid_t child = fork();
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", command, (char *)NULL);
        _exit(127);
    }
    if (child < 0 || wait4(child, &status, 0, &used) != child || status != 0)
        return INFINITY;
    return (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec) * 1e-6;
}

static double run_batch(const GrowthBatch *row, const char *matc, const char *folder,
                        const char *list)
{
    char command[MAX_COMMAND], cache[MAX_PATH] = "";
    if (row->before == GROWTH_CACHED)
        snprintf(cache, sizeof cache, "--cache '%s/cache'", folder);
    snprintf(command, sizeof command, "exec '%s' -j1 --no-validate -d '%s/out' %s %s '@%s/%s'",
             matc, folder, cache, row->options, folder, list);
    return seconds_of(command);
}

static double empty(const char *folder, const char *what)
{
    char command[MAX_COMMAND];
    snprintf(command, sizeof command, "rm -rf '%s'%s", folder, what);
    return seconds_of(command);
}

/* Prepares the folder before the measured run. */
static void prepare(const GrowthBatch *row, const char *matc, const char *folder)
{
    empty(folder, "/out");
    if (row->before != GROWTH_FRESH)
        run_batch(row, matc, folder, row->before == GROWTH_FEWER ? "twice" : "list");
    if (row->before == GROWTH_CACHED)
        empty(folder, "/out");
}

/* Creates a folder, in memory if the machine has a memory file system: there a new file has a
 * constant cost, while on a disk it took from 10 to 1,000 microseconds of system time within a
 * minute. */
static bool make_folder(char path[MAX_FOLDER])
{
    return mkdtemp(strcpy(path, "/dev/shm/matc-growth-XXXXXX")) ||
           mkdtemp(strcpy(path, "/tmp/matc-growth-XXXXXX"));
}

double growth_batch_seconds(const GrowthBatch *row, const char *matc, int count, int runs)
{
    char folder[MAX_FOLDER];
    double least = INFINITY;
    if (!make_folder(folder))
        return INFINITY;
    bool made =
        put_documents(row, folder, 2 * count, "twice") && put_documents(row, folder, count, "list");
    for (int i = 0; i < runs && made; i++) {
        prepare(row, matc, folder);
        least = fmin(least, run_batch(row, matc, folder, "list"));
    }
    empty(folder, "");
    return least;
}
