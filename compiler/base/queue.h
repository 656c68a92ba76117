/* A thread pool for documents that consist of parts. The parts of one document run in parallel;
 * at most as many documents are open at a time as there are threads. */
#ifndef MATC_QUEUE_H
#define MATC_QUEUE_H

typedef struct {
    int documents, threads;
    int (*open)(void *user, int document);            /* returns the document's number of parts */
    void (*work)(void *user, int document, int part); /* called on any thread, in any order */
    /* Called after the last part, also for a document without parts. */
    void (*close)(void *user, int document);
    void *user;
} Queue;

enum { MAX_THREADS = 256 };

/* Returns when all documents are closed. With a single thread no thread is started, and
 * documents and parts run in order. */
void queue_run(const Queue *queue);
/* Returns the number of online processors, at least 1, at most MAX_THREADS. */
int queue_processors(void);
#endif
