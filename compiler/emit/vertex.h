/* The vertex program's parts. The programs that tessellate are made of them, too. Private to vertex.c and tessellation.c. */
#ifndef MATC_VERTEX_H
#define MATC_VERTEX_H
#include "compiler/emit/emit.h"

typedef struct {
    const char *declaration; /* "vec3 position" */
    int location;
} VertexAttribute;
enum { VERTEX_ATTRIBUTES = 10 };
/* What it reads from the mesh; how many. */
int emit_vertex_attributes(const Job *job, const Interface *interface, VertexAttribute list[VERTEX_ATTRIBUTES]);
/* Uniforms, varyings, and the functions that displace, ended by an empty line. */
void emit_vertex_declarations(Text *out, const Job *job, const Interface *interface);
/* What main() does with attributes of these names, and its end. */
void emit_vertex_body(Text *out, const Job *job, const Interface *interface);
#endif
