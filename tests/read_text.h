/* Reads a text with the reader alone, as any value, not only as a material. */
#ifndef MATC_READ_TEXT_H
#define MATC_READ_TEXT_H
#include "compiler/read/tree.h"

typedef struct {
    Arena arena;
    MatcOptions options;
    Session session;
    Tree *tree; /* NULL: the text was refused */
} ReadText;

/* Reads a text, which must be followed by a zero byte like every source. */
static inline void read_text(ReadText *r, const char *name, const char *text, size_t size)
{
    *r = (ReadText){0};
    matc_options_init(&r->options);
    r->session = (Session){.options = &r->options, .arena = &r->arena};
    Source source = {.name = name, .text = text, .size = size};
    ARENA_PUSH(&r->arena, r->session.sources, r->session.source_count, r->session.source_capacity,
               source);
    r->tree = read_document(&r->session, 0);
}

static inline void read_text_done(ReadText *r) { arena_free(&r->arena); }
#endif
