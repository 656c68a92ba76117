/* Functions for hand-written stages, without a main(): the displaced position of a point, and
 * the solid ranges of a volume. */
#include "compiler/emit/move.h"
#include "compiler/emit/vertex.h"

static void put_displaced_head(Text *out, const char *name)
{
    text_format(out, "%s(vec3 position", name);
    for (int i = 0; i < MOVE_ATTRIBUTES; i++)
        text_format(out, ", %s", move_attributes[i]);
    text_put(out, ") {\n");
}

/* Writes a function that displaces a point, callable from any stage; its arguments have the
 * names of the vertex program's attributes. */
const char *emit_displace(Session *session, const Job *job, const Interface *interface)
{
    const VertexMove *move = interface->move;
    Text out = text_new(session->arena);
    text_format(&out,
                "// matc " MATC_VERSION ": where points of a displaced surface are, of pass %s\n",
                pass_table[job->pass].name);
    emit_place_uniforms(&out, job->target, move != NULL);
    if (move)
        text_format(&out, "%s\n%s", move->declarations, move->text);
    text_put(&out, move ? "" : "\n");
    if (move && move->volume) {
        put_displaced_head(
            &out,
            "// What is solid along the unit normal in the world, of attributes in the object's "
            "space: "
            "from x to y, and from z to w; nothing where the second is no more.\nvec4 matc_solid");
        move_put_inputs(&out, move);
        text_put(&out, "    return matc_displacement();\n}\n\n");
    }
    put_displaced_head(
        &out, "// The point in the world of attributes in the object's space. All vertices of one "
              "position take the same ones, so that none tears off.\nvec3 matc_displaced");
    if (move)
        move_put(&out, move);
    text_format(&out, "    return %s;\n}\n",
                move ? "matc_worldPosition" : "(matc_worldFromLocal * vec4(position, 1.0)).xyz");
    return out.at;
}
