/* Declarations of a program; shared by emit*.c and interface.c. */
#ifndef MATC_EMIT_DECLARE_H
#define MATC_EMIT_DECLARE_H
#include "compiler/emit/emit.h"

/* Declarations of one stage, and of all stages together, which share blocks and binding points. */
typedef struct {
    const Interface *own, *all;
} Declared;
void emit_declarations(Session *session, Text *out, const Ir *ir, const Job *job,
                       Declared declared);
/* Writes the uniforms and textures that a vertex stage needs for displacement. */
void emit_move_declarations(Session *session, Text *out, const Ir *ir, const Job *job,
                            Declared declared);
/* Binding points, for targets that have them: a block of plain uniforms per program; textures
 * use the remaining points. */
enum { MATERIAL_BLOCK = 0, FIRST_TEXTURE_BINDING = 1, DRAW_BLOCK = 16, CONSTANT_BLOCK = 17 };
/* Storage buffers of instanced programs: matrices, and the constants of all materials that share
 * the program. */
enum { INSTANCE_BUFFER = 0, NUMBER_BUFFER = 1 };
/* The uniform block of constants by which materials of one program differ (constants.h). */
#define CONSTANT_BLOCK_NAME "Constants"
/* Returns the binding point of the program's texture with this number. */
int emit_texture_binding(int index);
/* Returns the binding point of a library table, after the document's textures; -1: the program
 * does not use it. */
int emit_table_binding(const Ir *ir, const Interface *interface, const char *name);
/* Writes the vertex program's attributes and uniforms as members of a JSON object. vertex.c */
void emit_describe_vertex(Text *out, const Job *job, const Interface *interface);
/* Returns true if the input is a uniform in this program. */
bool emit_is_uniform(const Interface *interface, Input input);
/* Returns the location of an instance's random number. */
int emit_object_location(void);
/* Declares a varying in either stage: `word` is "in" or "out". */
void emit_varying(Text *out, Target target, Input input, const char *word);
#endif
