/* The vertex program's parts. The programs that tessellate are made of them, too. So are the
 * geometry program and the compute program. Private to vertex.c, tessellation.c, geometry.c,
 * compute.c and displace.c. */
#ifndef MATC_VERTEX_H
#define MATC_VERTEX_H
#include "compiler/emit/emit.h"

typedef struct {
    const char *declaration; /* "vec3 position" */
    int location;
} VertexAttribute;
enum { VERTEX_ATTRIBUTES = 10 + LIMIT_ATTRIBUTES };
/* Attributes that it reads from the mesh. Returns how many. */
int emit_vertex_attributes(const Job *job, const Interface *interface,
                           VertexAttribute list[VERTEX_ATTRIBUTES]);
/* "vec3 position": position. */
const char *emit_vertex_name(const VertexAttribute *attribute);
/* On its way from one stage to the next, as number `number` of them: "out %.*s matc_vertex_%s;\n"
 * gets its type and its name. */
void emit_vertex_between(Text *out, const Job *job, int number, const VertexAttribute *attribute,
                         const char *form);
/* Uniforms, varyings, and the functions that displace, ended by an empty line. */
void emit_vertex_declarations(Text *out, const Job *job, const Interface *interface);
/* The body of main() for attributes of these names, and its end. */
void emit_vertex_body(Text *out, const Job *job, const Interface *interface);
/* Matrices from the object's space to the world: of points, and of normals. */
void emit_place_uniforms(Text *out, Target target, bool normal);
/* "vec3 position" as {"name": "position", "type": "vec3", key: value}; without the key, where the
 * value is below 0. */
void emit_describe_part(Text *out, const char *declaration, const char *key, int value);
#endif
