/* Parts of the vertex program, also used for the tessellation, geometry and compute programs.
 * Private to vertex.c, tessellation.c, geometry.c, compute.c and displace.c. */
#ifndef MATC_VERTEX_H
#define MATC_VERTEX_H
#include "compiler/emit/emit.h"

typedef struct {
    const char *declaration; /* declaration by type and name: "vec3 position" */
    int location;
} VertexAttribute;
enum { VERTEX_ATTRIBUTES = 10 + LIMIT_ATTRIBUTES };
/* Lists the attributes that are read from the mesh. Returns their number. */
int emit_vertex_attributes(const Job *job, const Interface *interface,
                           VertexAttribute list[VERTEX_ATTRIBUTES]);
/* Returns the name in a declaration: "vec3 position" -> "position". */
const char *emit_vertex_name(const VertexAttribute *attribute);
/* Declares an attribute with index `number` passed between two stages: "out %.*s matc_vertex_%s;
 * " gets its type and its name. */
void emit_vertex_between(Text *out, const Job *job, int number, const VertexAttribute *attribute,
                         const char *form);
/* Writes uniforms, varyings, and the functions of displacement, ended by an empty line. */
void emit_vertex_declarations(Text *out, const Job *job, const Interface *interface);
/* Writes the body and the end of main(), for attributes with these names. */
void emit_vertex_body(Text *out, const Job *job, const Interface *interface);
/* Declares the matrices from object to world space: of points, and of normals. */
void emit_place_uniforms(Text *out, Target target, bool normal);
/* Writes "vec3 position" as {"name": "position", "type": "vec3", key: value}; without the key if
 * the value is negative. */
void emit_describe_part(Text *out, const char *declaration, const char *key, int value);
#endif
