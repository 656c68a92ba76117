/* A user-defined layout of the public API, created by layout_api.c. */
#ifndef MATC_CUSTOM_H
#define MATC_CUSTOM_H
#include "compiler/base/session.h"
#include "grammar/layout_tables.h"

struct MatcLayout {
    Arena arena;
    MatcOptions options;
    Session session;
    const LayoutRow *row; /* row of the layout; NULL: the text has faults */
    const char *text, *report;
};
#endif
