/* A thread-safe set of keys. */
#include "compiler/emit/linked.h"
#include "compiler/base/sets.h"
#include <pthread.h>
#include <stdlib.h>

struct MatcLinked {
    pthread_mutex_t mutex;
    KeySet keys;
};

MatcLinked *matc_linked_new(void)
{
    MatcLinked *linked = sets_resize(NULL, sizeof *linked);
    *linked = (MatcLinked){.keys = {0}};
    pthread_mutex_init(&linked->mutex, NULL);
    return linked;
}

void matc_linked_free(MatcLinked *linked)
{
    if (!linked)
        return;
    pthread_mutex_destroy(&linked->mutex);
    key_set_free(&linked->keys);
    free(linked);
}

bool linked_before(MatcLinked *linked, Key interface)
{
    if (!linked)
        return false;
    pthread_mutex_lock(&linked->mutex);
    bool known = key_set_find(&linked->keys, interface) >= 0;
    pthread_mutex_unlock(&linked->mutex);
    return known;
}

void linked_add(MatcLinked *linked, Key interface)
{
    if (!linked)
        return;
    pthread_mutex_lock(&linked->mutex);
    key_set_add(&linked->keys, interface, NULL);
    pthread_mutex_unlock(&linked->mutex);
}
