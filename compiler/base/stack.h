/* Room for what recurses down a tree of maps: library users run threads whose stacks are small. */
#ifndef MATC_STACK_H
#define MATC_STACK_H

/* Runs the function on what goes down a graph of that depth. Up to LIMIT_SHALLOW it takes the
 * caller's stack; beyond, that of a thread which is made for it, with LIMIT_LEVEL_KIB for each
 * level, and which has ended when the call returns. Signals do not reach it. Without memory for it:
 * memory_exhausted(). */
void stack_run(int depth, void (*run)(void *user), void *user);
#endif
