/* Many threads that do the same: each takes its next part of what `user` points to by an atomic
 * number. */
#ifndef MATC_VALUE_WORKERS_H
#define MATC_VALUE_WORKERS_H

/* Runs `work` in as many threads as the machine has processors, 8 at most, and waits for them. */
void workers_run(void *(*work)(void *user), void *user);
#endif
