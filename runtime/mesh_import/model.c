/* Mesh files are untrusted, and the library that parses them is large. It runs in a child
 * process with limits on time and memory. Data received through the pipe is validated like the
 * file itself. A file that crashes the parser is reported as an ordinary error. */
#include "runtime/mesh_import/model.h"
#include "compiler/base/memory.h"
#include "compiler/base/root.h"
#include "compiler/base/text.h"
#include "runtime/gl/message.h"
#include "runtime/mesh_import/gltf_mesh.h"
#include "runtime/mesh_import/model_divide.h"
#include "runtime/mesh_import/model_reader.h"
#include "runtime/mesh_import/obj_read.h"
#include "runtime/mesh_import/ply_read.h"
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__)
enum { HAS_MEMORY_LIMIT = 0 }; /* AddressSanitizer's shadow memory would exceed the limit */
#else
enum { HAS_MEMORY_LIMIT = 1 };
#endif

enum { MESSAGE = 1024, BROKEN = 3 };

/* Header of the message through the pipe; vertices, indices, runs and optional extras follow. */
typedef struct {
    bool done;
    int vertex_count, index_count, run_count;
    bool extras[SHAPE_EXTRAS];
    ShapeNames names;
    char error[MESSAGE];
} Head;

static const struct {
    const char *ending;
    ModelReader *read; /* NULL: assimp, in a process of its own */
    bool y_up;
} endings[] = {{".obj", obj_read, true},
               {".gltf", gltf_mesh_read, true},
               {".glb", gltf_mesh_read, true},
               {".ply", ply_read, false}};

static int find_ending(const char *path)
{
    const char *dot = strrchr(path, '.');
    for (int i = 0; dot && i < (int)(sizeof endings / sizeof *endings); i++)
        if (text_same(dot, endings[i].ending))
            return i;
    return -1;
}

static bool send_all(int pipe, const void *bytes, size_t size)
{
    for (const char *at = bytes; size;) {
        ssize_t sent = write(pipe, at, size);
        if (sent < 0 && errno == EINTR)
            continue;
        if (sent <= 0)
            return false;
        at += sent;
        size -= (size_t)sent;
    }
    return true;
}

static bool receive_all(int pipe, void *bytes, size_t size)
{
    for (char *at = bytes; size;) {
        ssize_t got = read(pipe, at, size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        at += got;
        size -= (size_t)got;
    }
    return true;
}

static void limit(int what, rlim_t most)
{
    const struct rlimit limits = {most, most};
    setrlimit(what, &limits);
}

/* Main function of the child process: imports the file and sends the result. */
static _Noreturn void import_and_send(const ModelSource *source, int pipe)
{
    ModelParts parts;
    Head head = {0};
    limit(RLIMIT_CPU, MODEL_SECONDS);
    limit(RLIMIT_CORE, 0);
    if (HAS_MEMORY_LIMIT)
        limit(RLIMIT_AS, (rlim_t)MODEL_MEMORY_MIB << 20);
    head.done = model_import(source, &parts, head.error, sizeof head.error);
    head.vertex_count = parts.shape.vertex_count;
    head.index_count = parts.shape.index_count;
    head.run_count = parts.run_count;
    for (int i = 0; i < SHAPE_EXTRAS; i++)
        head.extras[i] = parts.shape.extra[i] != NULL;
    memcpy(head.names, parts.shape.names, sizeof head.names);
    bool sent = send_all(pipe, &head, sizeof head);
    if (sent && head.done)
        sent = send_all(pipe, parts.shape.vertices,
                        (size_t)head.vertex_count * sizeof *parts.shape.vertices) &&
               send_all(pipe, parts.shape.indices,
                        (size_t)head.index_count * sizeof *parts.shape.indices) &&
               send_all(pipe, parts.runs, (size_t)head.run_count * sizeof *parts.runs);
    for (int i = 0; sent && head.done && i < SHAPE_EXTRAS; i++)
        sent =
            !head.extras[i] || send_all(pipe, parts.shape.extra[i],
                                        (size_t)head.vertex_count * sizeof *parts.shape.extra[i]);
    _exit(sent ? 0 : BROKEN);
}

/* Returns whether the runs cover all indices and vertices exactly. */
static bool are_whole(const ModelRun *runs, const Head *head)
{
    int64_t indices = 0, vertices = 0;
    for (int i = 0; i < head->run_count; i++) {
        if (runs[i].index_count < 0 || runs[i].vertex_count < 0 || runs[i].material < 0)
            return false;
        indices += runs[i].index_count;
        vertices += runs[i].vertex_count;
    }
    return indices == head->index_count && vertices == head->vertex_count;
}

/* Receives the extra attributes; NaN and infinities become 0. */
static bool receive_extras(int pipe, const Head *head, Shape *shape)
{
    memcpy(shape->names, head->names, sizeof shape->names);
    for (int i = 0; i < SHAPE_NAMED; i++)
        shape->names[i][SHAPE_NAME - 1] = 0;
    for (int i = 0; i < SHAPE_EXTRAS; i++) {
        if (!head->extras[i])
            continue;
        shape->extra[i] = calloc((size_t)head->vertex_count + 1, sizeof *shape->extra[i]);
        if (!shape->extra[i])
            memory_exhausted();
        if (!receive_all(pipe, shape->extra[i],
                         (size_t)head->vertex_count * sizeof *shape->extra[i]))
            return false;
        for (int k = 0; k < 4 * head->vertex_count; k++)
            if (!isfinite(shape->extra[i][k / 4][k % 4]))
                shape->extra[i][k / 4][k % 4] = 0;
    }
    return true;
}

/* Receives and validates the child's message. Returns false if the message is missing, truncated
 * or invalid. */
static bool receive(int pipe, Head *head, Shape *shape, ModelRun **runs)
{
    if (!receive_all(pipe, head, sizeof *head))
        return false;
    head->error[MESSAGE - 1] = 0;
    if (!head->done)
        return true;
    if (head->vertex_count < 0 || head->vertex_count > MODEL_VERTICES || head->index_count < 0 ||
        head->index_count > MODEL_INDICES || head->run_count < 0 || head->run_count > MODEL_RUNS)
        return false;
    *runs = calloc((size_t)head->run_count + 1, sizeof **runs);
    *shape = (Shape){.vertices = calloc((size_t)head->vertex_count + 1, sizeof *shape->vertices),
                     .indices = calloc((size_t)head->index_count + 1, sizeof *shape->indices),
                     .vertex_count = head->vertex_count,
                     .index_count = head->index_count};
    if (!shape->vertices || !shape->indices || !*runs)
        memory_exhausted();
    return receive_all(pipe, shape->vertices,
                       (size_t)head->vertex_count * sizeof *shape->vertices) &&
           receive_all(pipe, shape->indices, (size_t)head->index_count * sizeof *shape->indices) &&
           receive_all(pipe, *runs, (size_t)head->run_count * sizeof **runs) &&
           are_whole(*runs, head) && receive_extras(pipe, head, shape);
}

/* Result of reading a file. */
typedef struct {
    Shape shape;
    ModelRun *runs;
    int run_count;
    char *error;
    size_t capacity;
} Import;

/* Imports a file in a child process. */
static bool import_apart(const ModelSource *source, Import *to)
{
    int ends[2], status = 0;
    Head head = {0};
    if (pipe(ends))
        return message_fail(to->error, to->capacity, "%s", text_error(errno));
    const pid_t child = fork();
    if (!child) {
        close(ends[0]);
        import_and_send(source, ends[1]);
    }
    close(ends[1]);
    bool whole = child > 0 && receive(ends[0], &head, &to->shape, &to->runs);
    close(ends[0]);
    while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
        continue;
    if (!whole)
        return message_fail(to->error, to->capacity,
                            "reading it took too much time or memory, or broke off: the file is "
                            "damaged, or too large");
    to->run_count = head.run_count;
    return head.done || message_fail(to->error, to->capacity, "%s", head.error);
}

/* Reads a file by the reader of its ending. */
static bool import(const ModelSource *source, Import *to)
{
    ModelParts parts = {0};
    ModelReader *read = endings[find_ending(source->path)].read;
    if (!read)
        return import_apart(source, to);
    const bool done = read(source, &parts, to->error, to->capacity);
    to->shape = parts.shape;
    to->runs = parts.runs;
    to->run_count = parts.run_count;
    return done;
}

/* Rotates from y up (z toward the viewer) to z up. */
static void turn(Shape *shape)
{
    for (int i = 0; i < shape->vertex_count; i++) {
        ShapeVertex *vertex = &shape->vertices[i];
        float *vectors[] = {vertex->position, vertex->normal, vertex->tangentU, vertex->tangentV};
        for (int k = 0; k < 4; k++) {
            const float y = vectors[k][1];
            vectors[k][1] = -vectors[k][2];
            vectors[k][2] = y;
        }
    }
}

static bool is_readable(const ModelSource *source, char *error, size_t capacity)
{
    struct stat info;
    const char *path = source->path, *outside = root_refuses(source->root, path);
    if (outside)
        return message_fail(error, capacity, "%s", outside);
    if (find_ending(path) < 0)
        return message_fail(error, capacity, "a mesh is a file .obj, .gltf, .glb or .ply");
    if (stat(path, &info))
        return message_fail(error, capacity, "%s", text_error(errno));
    if (!S_ISREG(info.st_mode))
        return message_fail(error, capacity, "not a file");
    return info.st_size <= (off_t)MODEL_FILE_MIB << 20 ||
           message_fail(error, capacity, "larger than %d MiB", MODEL_FILE_MIB);
}

typedef const char *Complete(Shape *shape, const ModelRun *runs, int run_count);

static bool read_and_complete(const ModelSource *source, Complete *complete, Import *to)
{
    if (!is_readable(source, to->error, to->capacity))
        return false;
    bool done = import(source, to);
    if (done && endings[find_ending(source->path)].y_up)
        turn(&to->shape);
    const char *fault = done ? complete(&to->shape, to->runs, to->run_count) : NULL;
    if (fault)
        done = message_fail(to->error, to->capacity, "%s", fault);
    if (!done)
        shape_free(&to->shape);
    return done;
}

static bool read_whole(const ModelSource *source, Complete *complete, Shape *made, Import *to)
{
    const bool done = read_and_complete(source, complete, to);
    free(to->runs);
    *made = to->shape;
    return done;
}

bool model_read(const char *path, Shape *made, char *error, size_t capacity)
{
    return read_whole(&(ModelSource){.path = path}, model_complete_runs, made,
                      &(Import){.error = error, .capacity = capacity});
}

bool model_read_in_place(const char *path, Shape *made, char *error, size_t capacity)
{
    return read_whole(&(ModelSource){.path = path}, model_complete_runs_in_place, made,
                      &(Import){.error = error, .capacity = capacity});
}

static bool make_whole(const ModelSource *source, ModelPart **made, int *count, Import *to)
{
    ModelPart part = {.material = -1};
    if (!read_whole(source, model_complete_runs_in_place, &part.shape, to))
        return false;
    *made = memory_checked(malloc(sizeof **made));
    **made = part;
    *count = 1;
    return true;
}

bool model_read_source(const ModelSource *source, ModelPart **made, int *count, char *error,
                       size_t capacity)
{
    Import imported = {.error = error, .capacity = capacity};
    *count = 0;
    *made = NULL;
    if (source->whole)
        return make_whole(source, made, count, &imported);
    bool done = read_and_complete(source, model_complete_runs_in_place, &imported);
    if (done && !model_divide(&imported.shape, imported.runs, imported.run_count, made, count))
        done = message_fail(error, capacity, "out of memory");
    shape_free(&imported.shape);
    free(imported.runs);
    return done;
}

bool model_read_parts(const char *path, ModelPart **made, int *count, char *error, size_t capacity)
{
    return model_read_source(&(ModelSource){.path = path}, made, count, error, capacity);
}
