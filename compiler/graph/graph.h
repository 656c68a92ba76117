/* The document as typed values: every name resolved, every parameter present (given or
 * defaulted), no cycles. resolve() builds it from a Tree; lower() translates it to IR; the
 * oracle evaluates it. */
#ifndef MATC_GRAPH_H
#define MATC_GRAPH_H
#include "grammar/tables.h"
#include "compiler/base/names.h"
#include "compiler/base/source.h"
#include <stddef.h>

typedef struct Node Node;
typedef struct Wave Wave;

typedef enum {
    VALUE_none,      /* the parameter is absent */
    VALUE_number,    /* number with the components of `type` */
    VALUE_uniform,   /* uniform of type `type`; `number` holds its default */
    VALUE_node,      /* map or material, which `node` holds */
    VALUE_wave,      /* wave, which `wave` holds */
    VALUE_transform, /* transform */
    VALUE_image,     /* image */
    /* items; for PARAM_Maps the maps that the formula reads, in the order of its inputs */
    VALUE_items,
    VALUE_formula, /* formula */
} ValueKind;

/* A uniform by its name: a value that the host sets at run time. Equal names in a document are
 * one uniform. */
typedef struct {
    const char *name;
    Type type;         /* the default's type as written; the slot may convert it to int */
    double initial[4]; /* default value of the uniform */
    Span span;
    int index; /* index in the document's list of uniforms */
} Uniform;

/* A vertex attribute of the mesh, by name. Equal names in a document are one attribute. */
typedef struct {
    const char *name;
    Type type;         /* type of the attribute: float, vec2, vec3 or vec4 */
    double initial[4]; /* default for meshes without the attribute */
    Span span;
    int index; /* index in the document's list of attributes */
} MeshAttribute;

typedef struct {
    const char *path; /* path as written, joined to the document's folder */
    int width, height;
    int bits;     /* bits of a component: 8 or 16 (normalized), or 32 (float) */
    void *texels; /* RGBA, uint8_t, uint16_t or float; row 0 is the bottom row; NULL: not read */
    bool opaque;  /* the file has no alpha channel: alpha is 1 */
    bool halves;  /* float image whose values are exact as half floats */
    int index;    /* index in the document's list of images */
} Image;

typedef struct Value {
    ValueKind kind;
    Type type;  /* type of a number or uniform, before any conversion */
    bool given; /* the value is written in the document; false: the default */
    /* A number written as a color: "#ff8800", red; also such a default of a param. */
    bool color;
    /* Set in a material translated from another model: 1 + the author's parameter from which the
     * value was made; 0: the author's own value. */
    int16_t written;
    Span span;
    union {
        double number[4]; /* components of the number; also holds a bool or int */
        const Uniform *uniform;
        const Node *node;
        const Wave *wave;
        const struct Transform *transform;
        const Image *image;
        const struct Items *items;
        const struct Formula *formula; /* a formula that passed the check */
    };
} Value;

/* A map or a material. params[i] belongs to param_table[kind_table[kind].first + i]. */
struct Node {
    Kind kind;
    int index; /* position in the document's list of nodes: dense, inputs before users */
    Span span;
    const Value *params;
    int depth;         /* depth of the graph below the node, 0 for a node without inputs; limited */
    int filters;       /* max number of filters on a path below, including this node; limited */
    const char *name;  /* author's name: its key under `defs:`, or its anchor; NULL: unnamed */
    const char *owner; /* nearest enclosing name, or the slot; NULL: neither */
    /* this map or a map below is discontinuous (has a STEP row) or is an image */
    bool steps;
    int8_t width; /* components of its value when a formula reads it: 1 to 4; 0: a material */
    /* the author's kind, which differs for a material translated from another model */
    Kind written;
};

/* Returns the author's name for the material or map, and for its i-th parameter: for messages. */
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
    Value value;       /* position in the blend, a Float */
    const Node *input; /* input of the map; NULL: the surface itself */
    Span span;
    int8_t width; /* components in which a formula reads the input; 0: the input's own */
    /* Set in a material translated from another model: the parameter is no color, whatever the
     * type of the formula. */
    bool numbers;
} Item;
typedef struct Items {
    int count;
    const Item *item;
} Items;

/* A Chain maps v to second(factor * first(v) + shift); other kinds are functions of waves.def. */
struct Wave {
    WaveKind kind;
    const Wave *first, *second; /* waves of a Chain; NULL: identity */
    Value factor, shift;        /* numbers of a Chain, each a Float */
    int length;                 /* number of waves applied to v in sequence; limited */
};

typedef enum {
    TRANSFORM_scale,
    TRANSFORM_translation,
    TRANSFORM_matrix,
    TRANSFORM_components
} TransformKind;
/* q -> M q. scale: uniform scale; translation; matrix: 16 numbers by rows, the last row is (0,
 * 0, 0, 1); components: M = T Rz Ry Rx S H, angles in radians, H unit upper triangular with H01,
 * H02, H12 = shear. */
typedef struct Transform {
    TransformKind kind;
    Value scale;       /* a Float for TRANSFORM_scale, a Vec3 for components */
    Value translation; /* translation, a Vec3 */
    Value rotation;    /* Euler angles in radians; a Vec3 */
    Value shear;       /* shear, a Vec3 */
    double matrix[16];
} Transform;

typedef struct {
    const char *name; /* key under `materials:`, or the file's stem */
    const Node *node;
} NamedMaterial;

typedef struct {
    const NamedMaterial *materials;
    int material_count;
    struct Tree **defs; /* `defs:` objects: the document's, then those of its includes */
    int def_count;
    int node_count;
    /* Per node index: 1 << Model of the material's surface model, MODEL_LOBE of its possible
     * lobes, MODEL_EMITS and MODEL_RELIEF. */
    unsigned *models;
    Uniform *const *uniforms; /* matc_set_default may change the uniforms' defaults */
    int uniform_count;
    Names uniform_names;              /* names in the order of `uniforms` */
    MeshAttribute *const *attributes; /* at most LIMIT_ATTRIBUTES attributes */
    int attribute_count;
    Names attribute_names; /* names in the order of `attributes` */
    const Image *const *images;
    int image_count;
} Graph;

/* Returns the texels in their type; NULL if the image has another type. */
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
/* Returns true if a map displaces the surface or replaces it by a volume. */
bool graph_displaces(const Node *material);
/* Returns true if a volume replaces the surface; `height` and `vector` are then ignored. */
bool graph_displaces_volume(const Node *material);
/* Returns true if the value is 0 everywhere. */
bool value_is_zero(const Value *value);
/* Fills graph->models (allocated by the caller). `nodes` are in topological order: a node's inputs
 * precede it. A missing material is a gray Phong. */
void graph_find_models(Graph *graph, const Node *const *nodes, size_t count);
/* Returns true if the coat of a Principled or a Layer has the normal of its base: both use the
 * surface's normal, or the same map. */
bool graph_coat_follows(const Graph *graph, const Node *coated);

/* Returns the parameter P_<kind>_<name> of tables.h. */
static inline const Value *node_param(const Node *node, int param)
{
    return &node->params[param - kind_table[node->kind].first];
}
/* Returns a number's or a uniform's (default) components, converted to `want` by the table of
 * conversions. */
void value_number(const Value *value, Type want, double result[4]);
/* Converts `components_from` numbers to `components_to` by the table of conversions. */
void graph_convert(int components_from, const double *from, int components_to, double *to);
#endif
