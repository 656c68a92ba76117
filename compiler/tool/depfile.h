/* Depfiles for GNU make and ninja. */
#ifndef MATC_DEPFILE_H
#define MATC_DEPFILE_H

/* Returns `target: files...`, from malloc. Returns NULL if a name cannot be written for both
 * programs; `*bad` is that name. */
char *depfile_text(const char *target, const char *const *files, int count, const char **bad);
/* Message about a name that a depfile cannot contain. */
extern const char depfile_why[];
#endif
