/* Worker threads that run one function: each takes the next part of the work at `user` by an
 * atomic counter. */
#ifndef MATC_VALUE_WORKERS_H
#define MATC_VALUE_WORKERS_H

/* Runs `work` in as many threads as the machine has processors, at most 8, and waits for them. */
void workers_run(void *(*work)(void *user), void *user);
#endif
