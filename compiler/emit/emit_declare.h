/* Declarations of a program; between emit.c and interface.c. */
#ifndef MATC_EMIT_DECLARE_H
#define MATC_EMIT_DECLARE_H
#include "compiler/emit/emit.h"

/* Declarations of one stage, and of all stages together, which share blocks and binding points. */
typedef struct {
    const Interface *own, *all;
} Declared;
void emit_declarations(Session *session, Text *out, const Ir *ir, const Job *job,
                       Declared declared);
/* Uniforms and textures that a vertex stage needs to displace. */
void emit_move_declarations(Session *session, Text *out, const Ir *ir, const Job *job,
                            Declared declared);
/* Bindings of targets that have them: one block of plain uniforms for each program, and the
 * textures where no block is. */
enum { MATERIAL_BLOCK = 0, FIRST_TEXTURE_BINDING = 1, DRAW_BLOCK = 16, CONSTANT_BLOCK = 17 };
/* Storage buffers of programs that draw instances: matrices, and the numbers of all materials that
 * share the program. */
enum { INSTANCE_BUFFER = 0, NUMBER_BUFFER = 1 };
/* The block of numbers that tell materials of one program apart (constants.h). */
#define CONSTANT_BLOCK_NAME "Constants"
/* Binding point of the program's texture of that number. */
int emit_texture_binding(int index);
/* Binding point of a table of the library, behind the document's textures; -1: the program has none
 * of that name. */
int emit_table_binding(const Ir *ir, const Interface *interface, const char *name);
/* The vertex program's attributes and uniforms, as members of a JSON object. vertex.c */
void emit_describe_vertex(Text *out, const Job *job, const Interface *interface);
/* An input that is a uniform, of this program. */
bool emit_is_uniform(const Interface *interface, Input input);
/* Location of an instance's random number. */
int emit_object_location(void);
/* A varying, on either side: `word` is "in" or "out". */
void emit_varying(Text *out, Target target, Input input, const char *word);
#endif
