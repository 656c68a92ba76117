/* Documents of growth.def that are mesh files. A separate process reads them, and its time
 * counts. */
#include "growth.h"
#include "runtime/mesh_import/model.h"
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

enum { PATH = 64, MESSAGE = 256 };

static double seconds_of(int who)
{
    struct rusage used;
    getrusage(who, &used);
    return (double)(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           (double)(used.ru_utime.tv_usec + used.ru_stime.tv_usec) * 1e-6;
}

static double now(void) { return seconds_of(RUSAGE_SELF) + seconds_of(RUSAGE_CHILDREN); }

static bool write_file(const char *path, const char *text, size_t size)
{
    FILE *out = fopen(path, "w");
    return out && (fwrite(text, 1, size, out) == size) && !fclose(out);
}

void growth_mesh(const char *text, const char *ending, GrowthRun *run)
{
    char folder[] = "/tmp/matc-growth-XXXXXX", path[PATH], error[MESSAGE];
    ModelPart *parts = NULL;
    int count = 0;
    if (!mkdtemp(folder))
        abort();
    snprintf(path, sizeof path, "%s/mesh.%s", folder, ending);
    if (!write_file(path, text, run->read))
        abort();
    const double start = now();
    run->errors += !model_read_parts(path, &parts, &count, error, sizeof error);
    run->seconds = now() - start;
    for (int i = 0; i < count; i++) {
        run->written += (size_t)parts[i].shape.index_count;
        shape_free(&parts[i].shape);
    }
    free(parts);
    remove(path);
    rmdir(folder);
}
