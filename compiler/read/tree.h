/* The document as parsed: objects, lists and scalars, each with its position. Aliases share the
 * node of their anchor. */
#ifndef MATC_TREE_H
#define MATC_TREE_H
#include "compiler/base/session.h"

typedef enum {
    TREE_scalar, /* a scalar, with `text` and `plain` */
    TREE_list,   /* a list, with `items` and `count` */
    TREE_object, /* an object, with `members` and `count` */
} TreeKind;

/* Result of resolving a subtree, so that a shared subtree is resolved once. */
typedef enum { MADE_nothing, MADE_node, MADE_wave, MADE_items, MADE_list } Made;

typedef struct Tree Tree;
typedef struct {
    const char *key; /* text of the key, zero-terminated */
    Tree *value;
    Span span;     /* position of the key */
    uint32_t size; /* size of the key in bytes */
} Member;

/* Documents have up to LIMIT_TREE_NODES trees: each byte of the struct counts in
 * docs/reference/stability.md, Memory. */
struct Tree {
    uint8_t kind; /* kind of the value, a TreeKind */
    uint8_t made; /* Made: selects the last union; MADE_nothing: `name` may be set */
    bool plain;   /* the scalar is unquoted, so it may be a number, a boolean or null */
    bool open;    /* the tree is being read or resolved; another visit means a cycle */
    bool shared;  /* an alias refers to the tree */
    bool failed;  /* a fault in the tree was reported while it was resolved */
    bool printed; /* tree_print has printed the tree */
    bool scoped;  /* the tree is a scalar and a ScopedTree */
    Span span;
    uint32_t count; /* number of items or members; bytes of a scalar */
    union {
        const char *text; /* text of a scalar, zero-terminated */
        Tree **items;
        Member *members; /* followed by a hash table if there are many: tree_set_members */
    };
    union {
        const struct Node *node;
        const struct Wave *wave;
        const struct Items *items_made;
        const char *name; /* author's name, its key under `defs:` or its anchor; NULL: unnamed */
    };
};

/* A formula inside a definition, with the arguments of the parameters that the formula uses:
 * members of an object. */
typedef struct {
    Tree tree;
    const Tree *arguments;
} ScopedTree;

/* Parses a YAML, JSON or glTF source. Returns NULL after reporting faults. `source` is an index
 * into session->sources. */
Tree *read_document(Session *session, uint32_t source);
uint32_t tree_hash(const char *key, size_t size);
/* Sets the object's members to a copy of the array. For duplicate keys tree_find() returns the
 * first. */
void tree_set_members(Session *session, Tree *object, const Member *members, size_t count);
/* Returns the first member with this key; NULL: none. */
const Member *tree_find(const Tree *object, const char *key);
const Member *tree_find_bytes(const Tree *object, const char *key, size_t size);
bool tree_is_null(const Tree *tree);
/* Returns true for a plain scalar that is a finite number. */
bool tree_number(const Tree *tree, double *value);
/* Maps a byte range of a scalar's text to its source, through quotes, escapes and folded lines.
 * tree_place.c */
Span tree_place(const Session *session, const Tree *scalar, uint32_t start, uint32_t end);
/* Describes a value for messages: "a list", "the number 3", "'text'". */
const char *tree_describe(Session *session, const Tree *tree);
/* Prints the tree as indented YAML-like text with positions; a shared subtree is printed once. */
void tree_print(Text *out, Tree *tree);
#endif
