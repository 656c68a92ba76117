/* Work on many documents of many parts, by several threads: parts of one document are worked on
 * side by side, and only as many documents are open at a time as there are threads. */
#ifndef MATC_QUEUE_H
#define MATC_QUEUE_H

typedef struct {
    int documents, threads;
    int (*open)(void *user, int document);            /* how many parts it has */
    void (*work)(void *user, int document, int part); /* on any thread, in any order */
    /* after the last part; also when it has none */
    void (*close)(void *user, int document);
    void *user;
} Queue;

enum { MOST_THREADS = 256 };

/* Returns when all is done. With one thread nothing is started, and the order is that of the
 * documents and parts. */
void queue_run(const Queue *queue);
/* Processors at hand, at least 1. */
int queue_processors(void);
#endif
