/* Depfiles, which GNU make and ninja both read. */
#ifndef MATC_DEPFILE_H
#define MATC_DEPFILE_H

/* `target: files...`, from malloc. NULL: `*bad` is the target or the file whose name cannot be
 * written so that both read it. */
char *depfile_text(const char *target, const char *const *files, int count, const char **bad);
/* Message about such a name. */
extern const char depfile_why[];
#endif
