/* Builds a Tree for the readers of YAML and of JSON. Parts of lists and objects that are still open
 * wait on two stacks, so that the arena gets each value once, in its final size, and texts without
 * gaps between them. */
#ifndef MATC_TREE_BUILD_H
#define MATC_TREE_BUILD_H
#include "compiler/read/tree.h"

typedef struct {
    Session *session;
    uint32_t file;  /* the source */
    uint32_t start; /* of its text, behind a byte order mark */
    int values;
    Tree *values_left; /* room for more values, and how many */
    int values_left_count;
    char *text, *text_end; /* room for more texts */
    Tree **items;          /* of the lists that are open */
    size_t item_count, item_room;
    Member *members; /* of the objects that are open */
    size_t member_count, member_room;
    Span zero; /* the first text with a zero byte in it; empty: none */
} TreeBuilder;

/* A value without its contents; NULL and a diagnostic where there are LIMIT_TREE_NODES already. */
Tree *tree_build_value(TreeBuilder *b, TreeKind kind, Span span);
/* Room for a text of that size, which is the caller's to write, and a zero behind it. */
char *tree_build_text(TreeBuilder *b, size_t size);
/* Notes a text that holds a zero byte. */
void tree_build_check_text(TreeBuilder *b, const char *text, size_t size, Span span);
void tree_build_item(TreeBuilder *b, Tree *item);
void tree_build_member(TreeBuilder *b, Member member);
/* Items, or members, above the first `from` of the stack become those of a list, or an object, and
 * leave the stack. */
void tree_build_list(TreeBuilder *b, Tree *list, size_t from);
/* A key that is given twice is a diagnostic. */
void tree_build_object(TreeBuilder *b, Tree *object, size_t from);
/* Members of `base` that the object lacks are appended to it; false and a diagnostic beyond the
 * limit. */
bool tree_build_merge(TreeBuilder *b, Tree *object, Tree *const *bases, size_t count);
void tree_build_done(TreeBuilder *b);
/* A stack of malloc's with room for one element more than `count`, doubled when it is full. */
void *tree_build_room(void *stack, size_t count, size_t *room, size_t size);
#endif
