/* The document as typed values: every name resolved, every parameter present (given or defaulted),
 * no cycles. resolve() makes it from a Tree; lower() makes IR of it; the oracle evaluates it. */
#ifndef MATC_GRAPH_H
#define MATC_GRAPH_H
#include "grammar/tables.h"
#include "compiler/base/names.h"
#include "compiler/base/source.h"
#include <stddef.h>

typedef struct Node Node;
typedef struct Wave Wave;

typedef enum {
    VALUE_none,      /* not there */
    VALUE_number,    /* number, of `type` */
    VALUE_uniform,   /* uniform, of `type`; number holds its default */
    VALUE_node,      /* node: a map or a material */
    VALUE_wave,      /* wave */
    VALUE_transform, /* transform */
    VALUE_image,     /* image */
    VALUE_items,     /* items; of PARAM_Maps too, those that the formula reads, in its order */
    VALUE_formula,   /* formula */
} ValueKind;

/* A named value that is set at run time. Equal names of one document are one uniform. */
typedef struct {
    const char *name;
    Type type;         /* of its default, as written; the slot it stands in may make it an int */
    double initial[4]; /* the default */
    Span span;
    int index; /* in the document's list of uniforms */
} Uniform;

/* An attribute of the mesh's vertices, by name. Equal names of one document are one attribute. */
typedef struct {
    const char *name;
    Type type;         /* float, vec2, vec3 or vec4 */
    double initial[4]; /* where a mesh has none of the name */
    Span span;
    int index; /* in the document's list of attributes */
} MeshAttribute;

typedef struct {
    const char *path; /* as written, joined to the document's folder */
    int width, height;
    int bits;     /* of a lane: 8 or 16, over the greatest number; 32: floats, any number */
    void *texels; /* RGBA, uint8_t, uint16_t or float, row 0 is the bottom row; NULL: not read */
    bool opaque;  /* the file has no alpha: it is 1 everywhere */
    bool halves;  /* of floats: half floats hold them */
    int index;    /* in the document's list of images */
} Image;

typedef struct Value {
    ValueKind kind;
    Type type;  /* of a number or uniform, before any conversion */
    bool given; /* stands in the document; false: the default */
    /* a number that is written as a colour: "#ff8800", red; so is the default of a param */
    bool color;
    /* of a material of another model: 1 + the author's parameter that it was made of; 0: it is the
     * author's own */
    int16_t written;
    Span span;
    union {
        double number[4]; /* lanes of the type; bool and int too */
        const Uniform *uniform;
        const Node *node;
        const Wave *wave;
        const struct Transform *transform;
        const Image *image;
        const struct Items *items;
        const struct Formula *formula; /* checked */
    };
} Value;

/* A map or a material. params[i] belongs to param_table[kind_table[kind].first + i]. */
struct Node {
    Kind kind;
    int index; /* in the document's list of nodes: dense, inputs before users */
    Span span;
    const Value *params;
    int depth;         /* of the graph below it, 0 for a node without inputs; bounded */
    int filters;       /* most filters on a way down from here, this one included; bounded */
    const char *name;  /* the author's: its key under `defs:`, or its anchor; NULL: none */
    const char *owner; /* whose part it is: the name nearest above it, or the slot; NULL: neither */
    bool steps;        /* it, or a map below, has a STEP row: it jumps or is a picture */
    int8_t width;      /* lanes of its value as a formula reads it: 1 to 4; 0 of a material */
    Kind written; /* what the author wrote: its kind, or that of another model which became it */
};

/* The author's name of a material or map, and of its parameter of that place: for messages. */
static inline const char *node_written_name(const Node *node)
{
    return kind_table[node->written].name;
}
static inline const char *node_written_param(const Node *node, int i)
{
    const int written = node->params[i].written;
    return param_table[written ? written - 1 : kind_table[node->kind].first + i].name;
}

typedef struct {
    Value value;       /* Float */
    const Node *input; /* NULL reads the surface */
    Span span;
    int8_t width; /* lanes in which a formula reads the input; 0: the input's own */
    /* of a material of another model: its parameter is no colour, whatever the formula makes of
     * it */
    bool numbers;
} Item;
typedef struct Items {
    int count;
    const Item *item;
} Items;

/* v -> second(factor * first(v) + shift) for a Chain; otherwise one of waves.def. */
struct Wave {
    WaveKind kind;
    const Wave *first, *second; /* Chain only; NULL is the identity */
    Value factor, shift;        /* Chain only; Float */
    int length;                 /* waves that v is sent through, one after the other; bounded */
};

typedef enum {
    TRANSFORM_scale,
    TRANSFORM_translation,
    TRANSFORM_matrix,
    TRANSFORM_components
} TransformKind;
/* q -> M q. scale: uniform; translation; matrix: 16 numbers by rows, the last row is (0, 0, 0, 1);
 * components: M = T Rz Ry Rx S H, angles in radians, H unit upper triangular with H01, H02, H12 =
 * shear. */
typedef struct Transform {
    TransformKind kind;
    Value scale;       /* Float for TRANSFORM_scale, Vec3 for components */
    Value translation; /* Vec3 */
    Value rotation;    /* Vec3 */
    Value shear;       /* Vec3 */
    double matrix[16];
} Transform;

typedef struct {
    const char *name; /* under `materials:`, or the file's stem */
    const Node *node;
} NamedMaterial;

typedef struct {
    const NamedMaterial *materials;
    int material_count;
    struct Tree **defs; /* `defs:` objects: the document's, then those of its includes */
    int def_count;
    int node_count;
    /* by node's index: 1 << Model of the surface model that a material shows, MODEL_LOBE of the
     * lobes that it may have, MODEL_EMITS and MODEL_RELIEF */
    unsigned *models;
    Uniform *const *uniforms; /* their defaults may change: matc_set_default */
    int uniform_count;
    Names uniform_names;              /* theirs, in the same order */
    MeshAttribute *const *attributes; /* LIMIT_ATTRIBUTES at most */
    int attribute_count;
    Names attribute_names; /* theirs, in the same order */
    const Image *const *images;
    int image_count;
} Graph;

/* The texels as what they are made of; NULL: they are made of something else. */
static inline const uint8_t *image_bytes(const Image *image)
{
    return image->bits == 8 ? (const uint8_t *)image->texels : NULL;
}
static inline const uint16_t *image_words(const Image *image)
{
    return image->bits == 16 ? (const uint16_t *)image->texels : NULL;
}
static inline const float *image_floats(const Image *image)
{
    return image->bits == 32 ? (const float *)image->texels : NULL;
}

/* Displacement of a material's surface: the parameters of DISPLACEMENT_PARAMS. */
typedef struct {
    const Value *height, *vector, *scale, *bound, *volume, *threshold;
} Displacement;
Displacement graph_displacement(const Node *material);
/* It has a map that moves the surface, or puts a volume in its place. */
bool graph_displaces(const Node *material);
/* It puts a volume in its place: `height` and `vector` do not count. */
bool graph_displaces_volume(const Node *material);
/* It is 0 everywhere. */
bool value_is_zero(const Value *value);
/* Fills graph->models, which has room: of nodes, inputs before users. A missing material is a grey
 * Phong. */
void graph_find_models(Graph *graph, const Node *const *nodes, size_t count);
/* Whether the coat of a Principled or a Layer has the normal of what it lies on: both have the
 * surface's, or the same map gives them. */
bool graph_coat_follows(const Graph *graph, const Node *coated);

/* The parameter that P_<kind>_<name> of tables.h names. */
static inline const Value *node_param(const Node *node, int param)
{
    return &node->params[param - kind_table[node->kind].first];
}
/* A number's or uniform's (default) lanes, converted to `want` by the conversion table. */
void value_number(const Value *value, Type want, double result[4]);
/* The conversion table on numbers: `lanes_from` numbers to `lanes_to`. */
void graph_convert(int lanes_from, const double *from, int lanes_to, double *to);
#endif
