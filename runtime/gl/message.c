/* Formats error messages, truncated to the buffer. */
#include "runtime/gl/message.h"
#include <stdarg.h>
#include <stdio.h>

bool message_fail(char *error, size_t capacity, const char *format, ...)
{
    if (!error || capacity == 0)
        return false; /* the caller ignores the message */
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(error, capacity, format, arguments);
    va_end(arguments);
    return false;
}
