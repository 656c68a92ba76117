/* Waits for changes of files. A watched file, and its folder, may be replaced, vanish, or not
 * exist yet. */
#ifndef MATC_WATCH_H
#define MATC_WATCH_H
#include <stdbool.h>

typedef struct Watch Watch;

/* Files to watch, in the order of discovery; from malloc. */
typedef struct WatchList {
    char **at;
    int count, capacity;
} WatchList;
void watch_list_add(WatchList *list, const char *file);
void watch_list_free(WatchList *list);

Watch *watch_open(void);
/* Disables notifications, as on systems without them: files are polled five times a second. */
void watch_poll_only(Watch *watch);
/* Sets the files to watch; the list is copied. Changes of an already watched file count from the
 * last watch_wait. A new file is changed if its modification time is later than that. A file
 * that changes while it is being read is therefore not missed. */
void watch_set(Watch *watch, const char *const *files, int count);
/* Waits until files have changed and then been quiet for a moment. Returns the number of changed
 * files; 0 at the timeout (in milliseconds; negative: none), or after a signal. */
int watch_wait(Watch *watch, int timeout_ms);
/* Waits without a timeout. Returns 0 when files have changed, otherwise the signal (SIGINT,
 * SIGTERM, SIGHUP) that asks the process to end. Outside the wait, signals have their usual
 * effect. */
int watch_next(Watch *watch);
/* Returns true if the last watch_wait reported the file with this index of the list. */
bool watch_changed(const Watch *watch, int file);
void watch_close(Watch *watch);
#endif
