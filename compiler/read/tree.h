/* The document as it was written: objects, lists and scalars, each with its position. Aliases share
 * their anchor's node. */
#ifndef MATC_TREE_H
#define MATC_TREE_H
#include "compiler/base/session.h"

typedef enum {
    TREE_scalar, /* text, plain */
    TREE_list,   /* items, count */
    TREE_object, /* members, count */
} TreeKind;

/* Result of resolving a subtree, so that a shared one is resolved once. */
typedef enum { MADE_nothing, MADE_node, MADE_wave, MADE_items, MADE_list } Made;

typedef struct Tree Tree;
typedef struct {
    const char *key; /* zero-terminated */
    Tree *value;
    Span span;     /* of the key */
    uint32_t size; /* bytes of the key */
} Member;

/* Documents have up to LIMIT_TREE_NODES of these: every byte here is one of
 * docs/reference/stability.md, Memory. */
struct Tree {
    uint8_t kind; /* TreeKind */
    uint8_t made; /* Made: which of the last pointers is set; MADE_nothing: the name may be */
    bool plain;   /* scalar: unquoted, so that it may be a number, a truth value or null */
    bool open;    /* being read, or being resolved: met again, it contains itself */
    bool shared;  /* an alias stands for it */
    bool failed;  /* resolve: has a fault that was reported */
    bool printed; /* tree_print has shown it */
    bool scoped;  /* scalar: a ScopedTree */
    Span span;
    uint32_t count; /* items or members; bytes of a scalar */
    union {
        const char *text; /* zero-terminated */
        Tree **items;
        Member *members; /* with a hash table behind them where they are many: tree_set_members */
    };
    union {
        const struct Node *node;
        const struct Wave *wave;
        const struct Items *items_made;
        const char *name; /* the author's, NULL for none: its key under `defs:`, else its anchor */
    };
};

/* A formula of a definition, and the arguments of those parameters that it names: members of an
 * object. */
typedef struct {
    Tree tree;
    const Tree *arguments;
} ScopedTree;

/* Text -> Tree, for YAML and JSON; NULL: see the diagnostics. `source` is an index into
 * c->sources. */
Tree *read_document(Session *session, uint32_t source);
uint32_t tree_hash(const char *key, size_t size);
/* The object's members are a copy of these. Of those with one key tree_find gives the first. */
void tree_set_members(Session *session, Tree *object, const Member *members, size_t count);
/* The first member of that key, or NULL. */
const Member *tree_find(const Tree *object, const char *key);
const Member *tree_find_bytes(const Tree *object, const char *key, size_t size);
bool tree_is_null(const Tree *tree);
/* A plain scalar that is a finite number. */
bool tree_number(const Tree *tree, double *value);
/* Where bytes of a scalar's text stand in its source, through quotes, escapes and folded lines.
 * tree_place.c */
Span tree_place(const Session *session, const Tree *scalar, uint32_t start, uint32_t end);
/* Description of a value, for messages: "a list", "the number 3", "'text'". */
const char *tree_describe(Session *session, const Tree *tree);
/* The tree as indented YAML-like text, with positions; a shared subtree is printed once. */
void tree_print(Text *out, Tree *tree);
#endif
