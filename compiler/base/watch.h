/* Waits for changes of files. A file may be replaced by another of its name, vanish, and not be
 * there yet; so may its folder. */
#ifndef MATC_WATCH_H
#define MATC_WATCH_H
#include <stdbool.h>

typedef struct Watch Watch;

/* Files to watch, as they are met; from malloc. */
typedef struct WatchList {
    char **at;
    int count, room;
} WatchList;
void watch_list_add(WatchList *list, const char *file);
void watch_list_free(WatchList *list);

Watch *watch_open(void);
/* Goes without the system's notices, as where there are none: files are looked at five times a
 * second. */
void watch_poll_only(Watch *watch);
/* The files to watch from now on; the list is copied. Of one that was watched already, changes
 * since the last watch_wait count; of a new one, those since then that show in its time. So a file
 * that changes while it is being read is not missed. */
void watch_set(Watch *watch, const char *const *files, int count);
/* Waits until files have changed and then been left alone for a moment. The number of files that
 * changed; 0 when the time is over (milliseconds; below 0: none), or a signal came. */
int watch_wait(Watch *watch, int timeout_ms);
/* Waits for as long as it takes. 0 when files have changed, else the signal (SIGINT, SIGTERM,
 * SIGHUP) that asks the process to end; while it does not wait, signals do what they always do. */
int watch_next(Watch *watch);
/* Whether that file of the list, by its index, is among those that the last watch_wait found. */
bool watch_changed(const Watch *watch, int file);
void watch_close(Watch *watch);
#endif
