/* A layout of the user's own, as the library's surface holds it: layout_api.c makes it. */
#ifndef MATC_CUSTOM_H
#define MATC_CUSTOM_H
#include "compiler/base/session.h"
#include "grammar/layout_tables.h"

struct MatcLayout {
    Arena arena;
    MatcOptions options;
    Session session;
    const LayoutRow *row; /* NULL: faults */
    const char *text, *report;
};
#endif
