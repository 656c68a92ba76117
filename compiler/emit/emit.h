/* Code generation: Ir -> GLSL. */
#ifndef MATC_EMIT_H
#define MATC_EMIT_H
#include "compiler/ir/ir.h"
#include "compiler/emit/chunks.h"
#include "compiler/graph/graph_sky.h"

/* Declarations of the fragment program, on which the vertex program and the reflection depend. */
typedef struct {
    bool inputs[INPUT_COUNT];
    bool attributes[LIMIT_ATTRIBUTES]; /* mesh attributes in use, by index in the graph */
    /* Attributes whose screen-space derivatives are read. */
    bool attribute_changes[LIMIT_ATTRIBUTES];
    const Ir *ir;   /* the program's IR */
    bool instances; /* program draws instances */
    bool *uniforms; /* uniforms in use, by index in the graph */
    bool *counts;   /* uniforms that have the type int */
    bool *textures; /* textures in use, by index in the Ir */
    /* bytes of the declarations, at the beginning of the fragment program */
    size_t declarations;
    /* library functions in use, and the uniforms that they declare */
    Chunks chunks;
    bool members;                  /* the program reads the uniform block of constants */
    const struct VertexMove *move; /* NULL: no displacement in the vertex stages */
    /* Displacement with normals for the compute program; may be NULL. */
    const struct VertexMove *compute;
    /* Textures of the fragment program, if the vertex stages have others. */
    const bool *fragment_textures;
    Chunks fragment_chunks; /* chunks of the fragment program, if the vertex stages have others */
} Interface;

/* Code of the vertex stages for a material with displacement, without attributes and main(). */
typedef struct VertexMove {
    bool inputs[INPUT_COUNT]; /* inputs of source `vertex` that main() sets */
    /* The function returns a vec3 along dP/du, dP/dv and the normal; otherwise a float along the
     * normal. */
    bool along_tangents;
    /* The displacement returns a vec4: two ranges along the normal where the volume is solid. */
    bool volume;
    bool turns; /* the program has matc_displacedNormal() */
    /* inputs that main() sets before it calls matc_displacedNormal() */
    bool normal_inputs[INPUT_COUNT];
    const char *declarations; /* uniforms and textures, shared with the fragment program */
    /* Variables that main() sets, library functions, and matc_displacement(). */
    const char *text;
} VertexMove;

/* Returns the fragment program. *interface describes all stages together, except inputs that are
 * varyings or built-in variables. */
const char *emit_fragment(Session *session, const Ir *ir, const Job *job, Interface *interface,
                          size_t *size);
/* Returns the matching vertex program, with only the varyings in use. */
const char *emit_vertex(Session *session, const Job *job, const Interface *interface);
/* Returns functions that displace a point, without main(), for hand-written stages. */
const char *emit_displace(Session *session, const Job *job, const Interface *interface);
/* The tessellation programs, which replace the vertex program. tessellation.c */
typedef enum {
    TESSELLATION_vertex,
    TESSELLATION_control,
    TESSELLATION_eval,
    TESSELLATION_COUNT
} TessellationStage;
const char *emit_tessellation(Session *session, const Job *job, const Interface *interface,
                              TessellationStage stage);
/* The geometry program that subdivides triangles, and its vertex program. geometry.c */
typedef enum { GEOMETRY_vertex, GEOMETRY_geometry, GEOMETRY_COUNT } GeometryStage;
const char *emit_geometry(Session *session, const Job *job, const Interface *interface,
                          GeometryStage stage);
/* Returns the compute program, which displaces vertices from one buffer into another. compute.c */
const char *emit_compute(Session *session, const Job *job, const Interface *interface);
/* Returns GLSL that unpacks the layout: struct Surface, unpackTexels() for texel values,
 * unpackSurface() for a position. */
const char *emit_unpack(Session *session, const Job *job);
/* A generated program in the form that the reflection describes. */
typedef struct {
    const Interface *interface;
    const char *material, *opacity; /* the material's name, and its opacity class */
    const char *fragment;           /* text of the fragment program, for the hash */
    const GraphSky *sky;            /* the sky's light; NULL: not a sky */
    double bound;                   /* max displacement; INFINITY: unknown */
} Reflected;

/* Returns the reflection as JSON: inputs, uniforms with defaults, textures, outputs, opacity
 * class, source files, content hash. */
const char *emit_reflection(Session *session, const Ir *ir, const Job *job,
                            const Reflected *program);

/* Returns the texture's name in the shader. */
const char *emit_texture_name(Session *session, const Ir *ir, int texture);
/* Returns the location of a varying, equal in both programs. */
int emit_input_location(Input input);
/* Writes the #version line and, for ES, default precisions. */
void emit_version(Text *out, Target target);
#endif
