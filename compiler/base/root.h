/* Restricts reading to a root folder. A host that compiles documents of other people sets a
 * root; no file outside the root is opened.
 *
 *     root /srv/docs, a document /srv/docs/a/rock.yaml
 *         include: ../maps.yaml       reads /srv/docs/maps.yaml
 *         include: ../../key.yaml     "it lies outside the root folder"; no disk access
 *         include: link.yaml          a link to /etc/passwd: refused once the link is resolved */
#ifndef MATC_ROOT_H
#define MATC_ROOT_H
#include <stddef.h>

extern const char root_outside[]; /* reason for refusing a file outside the root */

/* Removes `.`, `//` and `a/..` from a path in place, without accessing the disk. */
void root_normalize(char *path);
/* Opens a regular file for reading that is below `root` after links are resolved. The open
 * itself follows no link, so that a link created meanwhile has no effect. A NULL root allows any
 * file. Returns a descriptor, or -1 and *why. */
int root_open(const char *root, const char *path, const char **why);
/* Reads a file below the root; results are those of file_read(). */
char *root_read(const char *root, const char *path, size_t *size, const char **why);
/* Returns NULL if a path may be opened, otherwise the reason. A missing file is allowed. */
const char *root_refuses(const char *root, const char *path);
#endif
