/* The document as it was written: objects, lists and scalars, each with its place. Aliases share their anchor's node. */
#ifndef MATC_TREE_H
#define MATC_TREE_H
#include "compile.h"

typedef enum {
    TREE_scalar, /* text, plain */
    TREE_list,   /* items, count */
    TREE_object, /* members, count */
} TreeKind;

typedef struct Tree Tree;
typedef struct {
    const char *key;
    Span span; /* of the key */
    Tree *value;
} Member;

struct Tree {
    TreeKind kind;
    bool plain;   /* scalar: unquoted, so that it may be a number, a truth value or null */
    bool open;    /* being read, or being resolved: met again, it contains itself */
    bool shared;  /* an alias stands for it */
    bool failed;  /* resolve: has a fault that was reported */
    bool printed; /* tree_print has shown it */
    Span span;
    uint32_t count; /* items or members; bytes of a scalar */
    union {
        const char *text; /* zero-terminated */
        Tree **items;
        Member *members;
    };
    uint32_t *table;         /* of an object with many members: hash table of member numbers from 1, for tree_find */
    uint32_t mask;           /* its size less one */
    const Wave *wave;        /* resolve: the wave this subtree became */
    const Items *items_made; /* resolve: the blend items it became */
    const Node *node;        /* resolve: the node this subtree became, so that a shared one is made once */
};

/* Text -> Tree, for YAML and JSON; NULL: see the diagnostics. `source` is an index into c->sources. */
Tree *read_document(Compile *c, uint32_t source);
uint32_t tree_hash(const char *key);
/* Makes tree_find fast for an object with many members, once it is read. */
void tree_index(Compile *c, Tree *object);
/* The first member of that key, or NULL. */
const Member *tree_find(const Tree *object, const char *key);
bool tree_is_null(const Tree *tree);
/* A plain scalar that is a finite number. */
bool tree_number(const Tree *tree, double *value);
/* What a value is, for messages: "a list", "the number 3", "'text'". */
const char *tree_describe(Compile *c, const Tree *tree);
/* The tree as indented YAML-like text, with places; a shared subtree is printed once. */
void tree_print(Text *out, Tree *tree);
#endif
