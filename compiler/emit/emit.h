/* Ir -> GLSL. */
#ifndef MATC_EMIT_H
#define MATC_EMIT_H
#include "compiler/ir/ir.h"
#include "compiler/emit/chunks.h"
#include "compiler/graph/graph_sky.h"

/* Declarations of the fragment program; the vertex program and the reflection follow them. */
typedef struct {
    bool inputs[INPUT_COUNT];
    bool attributes[LIMIT_ATTRIBUTES]; /* of the mesh, by index in the graph */
    /* of them: those whose changes to the next pixels are read */
    bool attribute_changes[LIMIT_ATTRIBUTES];
    const Ir *ir;                  /* it goes with */
    bool instances;                /* of a draw of instances */
    bool *uniforms;                /* by index in the graph */
    bool *counts;                  /* of them: those that are ints */
    bool *textures;                /* by index in the Ir */
    size_t declarations;           /* bytes of them, at the beginning of the fragment program */
    Chunks chunks;                 /* library functions, and the uniforms they declare */
    bool members;                  /* it reads numbers from the buffer */
    const struct VertexMove *move; /* NULL: the vertex stages move no point */
    /* of a compute program, which has normals as well; NULL as well */
    const struct VertexMove *compute;
    /* of `textures`, those of the fragment program; where a vertex stage has others */
    const bool *fragment_textures;
    Chunks fragment_chunks; /* the same of `chunks` */
} Interface;

/* Text of the vertex stages for a material that displaces its surface, without attributes and
 * main(). */
typedef struct VertexMove {
    bool inputs[INPUT_COUNT]; /* that main() sets: those of the source `vertex` */
    /* the function gives a vec3, along dP/du, dP/dv and the normal; else a float along the
     * normal, */
    bool along_tangents;
    /* or a vec4, from where to where along it a volume is solid, twice */
    bool volume;
    bool turns;                      /* there is matc_displacedNormal(), */
    bool normal_inputs[INPUT_COUNT]; /* before which main() sets these */
    const char *declarations;        /* uniforms and textures, shared with the fragment program */
    /* variables that main() sets, library functions, matc_displacement() */
    const char *text;
} VertexMove;

/* The fragment program. The interface is that of all stages together, but for inputs that are
 * varyings or system's. */
const char *emit_fragment(Session *session, const Ir *ir, const Job *job, Interface *interface,
                          size_t *size);
/* The vertex program that feeds it: only the varyings in use. */
const char *emit_vertex(Session *session, const Job *job, const Interface *interface);
/* No program, but the function that says where a displaced point is: for stages that are written
 * around it. */
const char *emit_displace(Session *session, const Job *job, const Interface *interface);
/* The programs that tessellate, in the vertex program's stead. tessellation.c */
typedef enum {
    TESSELLATION_vertex,
    TESSELLATION_control,
    TESSELLATION_eval,
    TESSELLATION_COUNT
} TessellationStage;
const char *emit_tessellation(Session *session, const Job *job, const Interface *interface,
                              TessellationStage stage);
/* The geometry program that divides triangles, and the vertex program before it. geometry.c */
typedef enum { GEOMETRY_vertex, GEOMETRY_geometry, GEOMETRY_COUNT } GeometryStage;
const char *emit_geometry(Session *session, const Job *job, const Interface *interface,
                          GeometryStage stage);
/* The compute program that displaces vertices of a buffer into another. compute.c */
const char *emit_compute(Session *session, const Job *job, const Interface *interface);
/* GLSL that reads the layout back: struct Surface, unpackTexels() of what the targets hold,
 * unpackSurface() of where. */
const char *emit_unpack(Session *session, const Job *job);
/* A program that is made, as its reflection tells of it. */
typedef struct {
    const Interface *interface;
    const char *material, *opacity; /* its name, and the class of its opacity */
    const char *fragment;           /* the text, for its hash */
    const GraphSky *sky;            /* the light that it is; NULL: it is none */
    double bound;                   /* of what its vertices move; INFINITY: it is not known */
} Reflected;

/* JSON: inputs, uniforms with defaults, textures, outputs, opacity class, source files, content
 * hash. */
const char *emit_reflection(Session *session, const Ir *ir, const Job *job,
                            const Reflected *program);

/* Names in the shader. */
const char *emit_texture_name(Session *session, const Ir *ir, int texture);
/* Location of a varying, equal in both programs. */
int emit_input_location(Input input);
/* "version" and, for ES, precisions. */
void emit_version(Text *out, Target target);
#endif
