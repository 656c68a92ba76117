/* Reading below a folder. Whoever compiles the documents of others names a root; nothing outside it
 * is opened.
 *
 *     root /srv/docs, a document /srv/docs/a/rock.yaml
 *         include: ../maps.yaml       /srv/docs/maps.yaml, read
 *         include: ../../key.yaml     "it lies outside the root folder", and the disk is not asked
 *         include: link.yaml a link to /etc/passwd: the same, after the link is resolved */
#ifndef MATC_ROOT_H
#define MATC_ROOT_H
#include <stddef.h>

extern const char root_outside[]; /* the reason why a file is refused */

/* Removes `.`, `//` and `a/..` from a path, in place, by its text alone. */
void root_normalize(char *path);
/* Opens a file for reading: a regular one, which lies below `root` after links are resolved. No
 * link is followed while it is opened, so that a link made in between leads nowhere. A root of NULL
 * stands for the whole disk. -1: *why. */
int root_open(const char *root, const char *path, const char **why);
/* The bytes of such a file, as file_read() returns them. */
char *root_read(const char *root, const char *path, size_t *size, const char **why);
/* NULL, or the reason why a path may not be opened; a file that is absent is none. */
const char *root_refuses(const char *root, const char *path);
#endif
