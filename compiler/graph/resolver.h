/* State of resolving a document: its definitions, params, pictures, and the nodes that are being
 * resolved. Hints and readers of pictures use it. */
#ifndef MATC_RESOLVER_H
#define MATC_RESOLVER_H
#include "compiler/base/hash_index.h"
#include "compiler/read/gltf_file.h"
#include "compiler/graph/graph.h"

/* An ImageMap that does not say all of how its texels are read, and where that will stand; NULL: it
 * says so. */
typedef struct {
    const Node *node;
    Value *colorspace, *texels;
} UndecidedPicture;

/* The `colors:` line of a file. Undeclared: hex colors are linear light, and the author is advised
 * to add a line. */
typedef enum { FILE_COLORS_undeclared, FILE_COLORS_linear, FILE_COLORS_srgb } FileColors;

/* Expansions of definitions with parameters. resolve_definition.c */
typedef struct Expansion Expansion;

/* State of resolving a document. */
typedef struct {
    Session *session;
    Tree **defs; /* `defs:` objects: the document's, then those of its includes */
    size_t def_count, def_room;
    /* a failed include or `defs:` was reported: unknown names may be defined there */
    bool lacks_file;
    Uniform **uniforms;
    size_t uniform_count, uniform_room;
    Names uniform_names;
    MeshAttribute **attributes;
    size_t attribute_count, attribute_room;
    Names attribute_names;
    const Image **images;
    size_t image_count, image_room, image_bytes; /* of all their texels */
    Names image_paths;
    GltfFiles gltf_files; /* that pictures lie in */
    Names broken_paths;   /* of pictures that cannot be had, and what is wrong with them */
    const char **broken;
    size_t broken_room;
    unsigned char *file_colors; /* FileColors by source; undeclared for sources outside the array */
    size_t file_color_room;
    UndecidedPicture *undecided;
    size_t undecided_count, undecided_room;
    int node_count;
    /* a map's default by its parameter; NULL until a node wants it */
    const Node *defaults[PARAM_COUNT];
    const Node **nodes; /* but for bare numbers */
    size_t named_count, named_room;
    Expansion **expansions;
    size_t expansion_count, expansion_room;
    HashIndex expansion_index;
    bool overgrown;           /* there are too many of these, and that was said */
    size_t copied;            /* nodes of trees that were made for them */
    const Member *definition; /* the one with parameters that is looked at; NULL: none */
    const char *param;        /* the parameter whose constant is looked at; NULL: none */
    bool one_number;          /* which reads one number */
    const char *owner;        /* of the maps that are resolved: Node.owner */
    /* of what is being resolved: maps and references within one another, and waves */
    int depth, wave_depth;
} Resolver;

/* How many lanes a value may have. */
typedef struct {
    int least, most;
} LaneCount;
#endif
