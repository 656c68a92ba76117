/* State of resolving a document: its definitions, params, images, and the nodes being resolved.
 * Also used by hints and image readers. */
#ifndef MATC_RESOLVER_H
#define MATC_RESOLVER_H
#include "compiler/base/hash_index.h"
#include "compiler/read/gltf_file.h"
#include "compiler/graph/graph.h"

/* An ImageMap with an undetermined color space or texel filter, and the values to be filled in;
 * NULL: given in the document. */
typedef struct {
    const Node *node;
    Value *colorspace, *texels;
} UndecidedPicture;

/* The `colors:` line of a file. Undeclared: hex colors are linear light, and the author is
 * advised to add the line. */
typedef enum { FILE_COLORS_undeclared, FILE_COLORS_linear, FILE_COLORS_srgb } FileColors;

/* Instances of definitions with parameters. resolve_definition.c */
typedef struct Expansion Expansion;

/* State of resolving a document. */
typedef struct {
    Session *session;
    Tree **defs; /* `defs:` objects: the document's, then those of its includes */
    size_t def_count, def_capacity;
    /* A failed include or `defs:` was reported: unknown names may be defined there. */
    bool lacks_file;
    Uniform **uniforms;
    size_t uniform_count, uniform_capacity;
    Names uniform_names;
    MeshAttribute **attributes;
    size_t attribute_count, attribute_capacity;
    Names attribute_names;
    const Image **images;
    size_t image_count, image_capacity, image_bytes; /* `image_bytes` is the size of all texels */
    Names image_paths;
    GltfFiles gltf_files; /* glTF files that contain images */
    Names broken_paths;   /* paths of unreadable images; `broken` holds the reasons */
    const char **broken;
    size_t broken_capacity;
    unsigned char *file_colors; /* FileColors by source; undeclared for sources outside the array */
    size_t file_color_capacity;
    UndecidedPicture *undecided;
    size_t undecided_count, undecided_capacity;
    int node_count;
    /* Per parameter: its default map; NULL until a node needs it. */
    const Node *defaults[PARAM_COUNT];
    const Node **nodes; /* all nodes of the document except plain numbers */
    size_t named_count, named_capacity;
    Expansion **expansions;
    size_t expansion_count, expansion_capacity;
    HashIndex expansion_index;
    bool overgrown;           /* there were too many expansions, which was reported */
    size_t copied;            /* tree nodes copied for expansions */
    const Member *definition; /* the definition with parameters being read; NULL: none */
    const char *param;        /* the parameter whose constant is being read; NULL: none */
    bool one_number;          /* `param` is a single number */
    const char *owner;        /* owner of the maps being resolved: Node.owner */
    /* Current nesting depth of maps and references, and of waves. */
    int depth, wave_depth;
} Resolver;

/* Allowed range of a value's number of components. */
typedef struct {
    int least, most;
} ComponentCount;
#endif
