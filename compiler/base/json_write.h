/* Strings of JSON, the same in every file that matc writes: manifest, reflection, diagnostics,
 * schemas, and the quoted texts of YAML. */
#ifndef MATC_JSON_WRITE_H
#define MATC_JSON_WRITE_H
#include "compiler/base/text.h"

/* With quotes. Whatever the bytes are, the result is JSON and moves no terminal: quotes,
 * backslashes and control characters (below U+0020, and U+007F to U+009F) are escaped, and read
 * back as they were; each byte that is not UTF-8 becomes U+FFFD. */
void json_string(Text *out, const char *string);
void json_bytes(Text *out, const char *bytes, size_t size);
/* "key": */
void json_key(Text *out, const char *key);
/* "key": "value" */
void json_member(Text *out, const char *key, const char *value);
/* A further member, with a comma before it. */
void json_next(Text *out, const char *key, const char *value);
#endif
