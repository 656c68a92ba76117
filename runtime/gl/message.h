/* Messages of faults: the GL layer and the view print nothing and never exit, they say why into a
 * buffer of the caller's. */
#ifndef MATC_GL_MESSAGE_H
#define MATC_GL_MESSAGE_H
#include <stdbool.h>
#include <stddef.h>

/* Formats into `error`, cut to `room` bytes; `error` may be NULL. Returns false: a guard is `return
 * message_fail(...)`. */
__attribute__((format(printf, 3, 4))) bool message_fail(char *error, size_t room,
                                                        const char *format, ...);
#endif
