#include "tests/value/workers.h"
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

enum { MOST = 8 };

void workers_run(void *(*work)(void *user), void *user)
{
    pthread_t threads[MOST];
    long count = sysconf(_SC_NPROCESSORS_ONLN);
    count = count < 1 ? 1 : count > MOST ? MOST : count;
    for (long i = 0; i < count; i++)
        if (pthread_create(&threads[i], NULL, work, user))
            abort();
    for (long i = 0; i < count; i++)
        pthread_join(threads[i], NULL);
}
