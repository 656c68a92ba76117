/* Error messages: the GL layer and the viewer print nothing and never exit; they write the
 * reason into the caller's buffer. */
#ifndef MATC_GL_MESSAGE_H
#define MATC_GL_MESSAGE_H
#include <stdbool.h>
#include <stddef.h>

/* Formats into `error`, truncated to `capacity` bytes; `error` may be NULL. Returns false, for
 * guards such as `return message_fail(...)`. */
__attribute__((format(printf, 3, 4))) bool message_fail(char *error, size_t capacity,
                                                        const char *format, ...);
#endif
