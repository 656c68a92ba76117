/* Builds a Tree for the YAML and JSON parsers. Items and members of unfinished collections are
 * kept on two stacks. The arena therefore receives each list or object once, in its final size,
 * and texts without gaps. */
#ifndef MATC_TREE_BUILD_H
#define MATC_TREE_BUILD_H
#include "compiler/read/tree.h"

typedef struct {
    Session *session;
    uint32_t file;  /* index of the source file */
    uint32_t start; /* offset of the text after a byte order mark */
    int values;
    Tree *values_left; /* preallocated values, and their number */
    int values_left_count;
    char *text, *text_end; /* preallocated space for texts */
    Tree **items;          /* stack of the items of unfinished lists */
    size_t item_count, item_capacity;
    Member *members; /* stack of the members of unfinished objects */
    size_t member_count, member_capacity;
    Span zero; /* the first text that contains a zero byte; empty: none */
} TreeBuilder;

/* Creates a value without content. Returns NULL and reports a diagnostic when LIMIT_TREE_NODES
 * is reached. */
Tree *tree_build_value(TreeBuilder *b, TreeKind kind, Span span);
/* Allocates a text of `size` bytes, which the caller fills, with a terminating zero. */
char *tree_build_text(TreeBuilder *b, size_t size);
/* Records the first text that contains a zero byte. */
void tree_build_check_text(TreeBuilder *b, const char *text, size_t size, Span span);
void tree_build_item(TreeBuilder *b, Tree *item);
void tree_build_member(TreeBuilder *b, Member member);
/* Pops the items or members from index `from` on, and makes them the content of a list or
 * object. */
void tree_build_list(TreeBuilder *b, Tree *list, size_t from);
/* Builds an object like tree_build_list(), and reports duplicate keys. */
void tree_build_object(TreeBuilder *b, Tree *object, size_t from);
/* Appends the members of `bases` that the object lacks. Returns false after reporting a base
 * that is no object, or an exceeded limit. */
bool tree_build_merge(TreeBuilder *b, Tree *object, Tree *const *bases, size_t count);
void tree_build_done(TreeBuilder *b);
/* Ensures that a malloc'ed stack has capacity for one element more than `count`, doubling its
 * capacity. */
void *tree_build_capacity(void *stack, size_t count, size_t *capacity, size_t size);
#endif
