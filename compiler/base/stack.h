/* Stack space for recursion over a tree of maps: hosts may call the library on threads with
 * small stacks. */
#ifndef MATC_STACK_H
#define MATC_STACK_H

/* Runs a function that recurses to a given graph depth. Up to LIMIT_SHALLOW the caller's stack
 * is used. A greater depth gets a temporary thread with LIMIT_LEVEL_KIB of stack per level, on
 * which signals are blocked; the thread has ended when the call returns. A failed thread
 * creation ends the process by memory_exhausted(). */
void stack_run(int depth, void (*run)(void *user), void *user);
#endif
