/* A layout of the user's own, as the library's surface holds it: layout_api.c and auto_layout.c make it. */
#ifndef MATC_CUSTOM_H
#define MATC_CUSTOM_H
#include "compiler/base/session.h"
#include "grammar/tables.h"

struct MatcLayout {
    Arena arena;
    MatcOptions options;
    Session session;
    const LayoutRow *row; /* NULL: faults */
    const char *text, *report;
};
/* Makes the text and the page of a layout whose row is there. layout_api.c */
void layout_describe(MatcLayout *layout);
#endif
