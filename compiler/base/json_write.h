/* JSON strings for every file that matc writes: manifest, reflection, diagnostics, schemas, and
 * the quoted strings of YAML. */
#ifndef MATC_JSON_WRITE_H
#define MATC_JSON_WRITE_H
#include "compiler/base/text.h"

/* Appends a string in quotes. The result is valid JSON for any bytes and contains no terminal
 * escape sequences. Quotes, backslashes and control characters (below U+0020, and U+007F to
 * U+009F) are escaped and read back unchanged. Each byte that is not UTF-8 becomes U+FFFD. */
void json_string(Text *out, const char *string);
void json_bytes(Text *out, const char *bytes, size_t size);
/* Appends a key, as in `"key":`. */
void json_key(Text *out, const char *key);
/* Appends "key": "value" */
void json_member(Text *out, const char *key, const char *value);
/* Appends another member, preceded by a comma. */
void json_next(Text *out, const char *key, const char *value);
#endif
