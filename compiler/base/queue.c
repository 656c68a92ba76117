/* Thread pool: a thread takes a chunk of an open document's parts if one is left, otherwise it
 * opens the next document.
 *
 *     Two threads, a document of 6 parts and one of 1: thread A opens the first document
 *         and takes its parts 0 to 3; thread B takes 4 and 5, then opens the second document.
 *         The thread that finishes a document's last part closes the document. */
#include "compiler/base/queue.h"
#include <pthread.h>
#include <stdbool.h>
#include <unistd.h>

enum { CHUNK = 4 };

typedef struct {
    int document, parts, next, left; /* `left` is the number of unfinished parts */
} Open;

typedef struct {
    const Queue *queue;
    pthread_mutex_t mutex;
    pthread_cond_t changed;
    Open open[MAX_THREADS];
    int open_count, next_document, opening;
} Run;

typedef struct {
    int document, first, last; /* Empty (last < first): the document has not been opened yet. */
} Task;

static bool take_parts(Run *run, Task *task)
{
    for (int i = 0; i < run->open_count; i++) {
        Open *open = &run->open[i];
        if (open->next == open->parts)
            continue;
        int last = open->next + CHUNK < open->parts ? open->next + CHUNK : open->parts;
        *task = (Task){open->document, open->next, last - 1};
        open->next = last;
        return true;
    }
    return false;
}

/* Takes a task; waits while parts may still appear. Returns false when no work is left. */
static bool take(Run *run, Task *task)
{
    pthread_mutex_lock(&run->mutex);
    bool found = false;
    for (;;) {
        if ((found = take_parts(run, task)))
            break;
        if (run->next_document < run->queue->documents) {
            *task = (Task){run->next_document++, 0, -1};
            run->opening++;
            found = true;
            break;
        }
        if (!run->opening)
            break;
        pthread_cond_wait(&run->changed, &run->mutex);
    }
    pthread_mutex_unlock(&run->mutex);
    return found;
}

static void open_document(Run *run, int document)
{
    const Queue *queue = run->queue;
    int parts = queue->open(queue->user, document);
    if (parts == 0)
        queue->close(queue->user, document);
    pthread_mutex_lock(&run->mutex);
    run->opening--;
    if (parts > 0)
        run->open[run->open_count++] = (Open){document, parts, 0, parts};
    pthread_cond_broadcast(&run->changed);
    pthread_mutex_unlock(&run->mutex);
}

/* Counts finished parts. Returns true if they were the document's last. */
static bool done(Run *run, int document, int count)
{
    bool last = false;
    pthread_mutex_lock(&run->mutex);
    for (int i = 0; i < run->open_count; i++) {
        Open *open = &run->open[i];
        if (open->document != document)
            continue;
        last = !(open->left -= count);
        if (last)
            *open = run->open[--run->open_count];
        break;
    }
    pthread_mutex_unlock(&run->mutex);
    return last;
}

static void *work(void *user)
{
    Run *run = user;
    const Queue *queue = run->queue;
    Task task;
    while (take(run, &task)) {
        if (task.last < task.first) {
            open_document(run, task.document);
            continue;
        }
        for (int part = task.first; part <= task.last; part++)
            queue->work(queue->user, task.document, part);
        if (done(run, task.document, task.last - task.first + 1))
            queue->close(queue->user, task.document);
    }
    return NULL;
}

static void run_alone(const Queue *queue)
{
    for (int d = 0; d < queue->documents; d++) {
        int parts = queue->open(queue->user, d);
        for (int part = 0; part < parts; part++)
            queue->work(queue->user, d, part);
        queue->close(queue->user, d);
    }
}

void queue_run(const Queue *queue)
{
    int threads = queue->threads < MAX_THREADS ? queue->threads : MAX_THREADS, started = 0;
    if (threads <= 1) {
        run_alone(queue);
        return;
    }
    Run run = {.queue = queue};
    pthread_t thread[MAX_THREADS];
    pthread_mutex_init(&run.mutex, NULL);
    pthread_cond_init(&run.changed, NULL);
    while (started < threads - 1 && !pthread_create(&thread[started], NULL, work, &run))
        started++;
    work(&run); /* a failure to start threads only slows the run down */
    for (int i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
    pthread_cond_destroy(&run.changed);
    pthread_mutex_destroy(&run.mutex);
}

int queue_processors(void)
{
    long count = sysconf(_SC_NPROCESSORS_ONLN);
    return count < 1 ? 1 : count < MAX_THREADS ? (int)count : MAX_THREADS;
}
