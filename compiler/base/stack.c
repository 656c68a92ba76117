/* Runs a function on a thread with a large stack; the caller waits meanwhile. */
#include "compiler/base/stack.h"
#include "compiler/base/memory.h"
#include "compiler/base/session.h"
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>

enum { MIN_KIB = 256 }; /* stack of functions that do not recurse */

typedef struct {
    void (*run)(void *user);
    void *user;
} Call;

static void *run_call(void *user)
{
    const Call *call = user;
    call->run(call->user);
    return NULL;
}

static bool start(pthread_t *thread, Call *call, size_t size)
{
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes))
        return false;
    bool made = !pthread_attr_setstacksize(&attributes, size) &&
                !pthread_create(thread, &attributes, run_call, call);
    pthread_attr_destroy(&attributes);
    return made;
}

void stack_run(int depth, void (*run)(void *user), void *user)
{
    if (depth <= LIMIT_SHALLOW) {
        run(user);
        return;
    }
    Call call = {run, user};
    pthread_t thread;
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before); /* The new thread inherits the signal mask. */
    if (!start(&thread, &call, (MIN_KIB + (size_t)depth * LIMIT_LEVEL_KIB) * 1024))
        memory_exhausted();
    pthread_join(thread, NULL);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
}
