/* The tessellation programs: subdivide triangles in proportion to the screen-space length of
 * their edges. The evaluation program interpolates attributes and then processes them as the
 * vertex program does.
 *
 * Cracks are avoided in two ways. The level of an edge depends only on its two ends, by a
 * formula that is equal for both adjacent triangles. A point of an edge is the sum of two
 * products, whose order does not matter, and of a third that is 0 there; `precise` keeps
 * compilers from contracting either. */
#include "compiler/emit/vertex.h"
#include "compiler/emit/emit_declare.h"

/* Binding of the levels' uniforms, after all textures. */
enum { LEVEL_BLOCK = 83 };

static void put_vertex(Text *out, const Job *job, const VertexAttribute *list, int count)
{
    for (int i = 0; i < count; i++)
        text_format(out, "layout(location = %d) in %s;\n", list[i].location, list[i].declaration);
    for (int i = 0; i < count; i++)
        emit_vertex_between(out, job, i, &list[i], "out %.*s matc_vertex_%s;\n");
    text_put(out, "\nvoid main() {\n");
    for (int i = 0; i < count; i++)
        text_format(out, "    matc_vertex_%s = %s;\n", emit_vertex_name(&list[i]),
                    emit_vertex_name(&list[i]));
    text_put(out, "}\n");
}

/* matc_levels: number of segments of an edge whose length equals its distance from the eye. */
static void put_control(Text *out, const Job *job, const VertexAttribute *list, int count)
{
    text_put(out, "layout(vertices = 3) out;\n");
    for (int i = 0; i < count; i++)
        emit_vertex_between(out, job, i, &list[i], "in %.*s matc_vertex_%s[];\n");
    for (int i = 0; i < count; i++)
        emit_vertex_between(out, job, i, &list[i], "out %.*s matc_corner_%s[];\n");
    text_format(out, "layout(std140, binding = %d) uniform Levels {\n", LEVEL_BLOCK);
    text_put(
        out,
        "    mat4 matc_levelFromLocal;\n    vec3 matc_levelEye;\n    float matc_levels;\n};\n\n"
        "// By what both of its triangles know of an edge.\n"
        "float matc_level(vec3 a, vec3 b) {\n"
        "    precise vec3 middle = 0.5 * (a + b);\n"
        "    precise float parts = matc_levels * distance(a, b) / max(distance(middle, "
        "matc_levelEye), 1e-30);\n"
        "    return clamp(parts, 1.0, 64.0);\n}\n\nvoid main() {\n");
    for (int i = 0; i < count; i++)
        text_format(out, "    matc_corner_%s[gl_InvocationID] = matc_vertex_%s[gl_InvocationID];\n",
                    emit_vertex_name(&list[i]), emit_vertex_name(&list[i]));
    text_put(
        out,
        "    if (gl_InvocationID == 0) {\n        vec3 corner[3];\n"
        "        for (int i = 0; i < 3; i++)\n"
        "            corner[i] = (matc_levelFromLocal * vec4(matc_vertex_position[i], 1.0)).xyz;\n"
        "        for (int i = 0; i < 3; i++)\n"
        "            gl_TessLevelOuter[i] = matc_level(corner[(i + 1) % 3], corner[(i + 2) % 3]);\n"
        "        gl_TessLevelInner[0] = max(max(gl_TessLevelOuter[0], gl_TessLevelOuter[1]), "
        "gl_TessLevelOuter[2]);\n"
        "    }\n}\n");
}

static void put_eval(Text *out, const Job *job, const Interface *interface)
{
    VertexAttribute list[VERTEX_ATTRIBUTES];
    const int count = emit_vertex_attributes(job, interface, list);
    text_put(out, "layout(triangles, equal_spacing, ccw) in;\n");
    for (int i = 0; i < count; i++)
        emit_vertex_between(out, job, i, &list[i], "in %.*s matc_corner_%s[];\n");
    for (int i = 0; i < count; i++)
        text_format(out, "precise %s;\n", list[i].declaration);
    emit_vertex_declarations(out, job, interface);
    text_put(out, "void main() {\n");
    for (int i = 0; i < count; i++) {
        const char *name = emit_vertex_name(&list[i]);
        text_format(
            out,
            "    %s = matc_corner_%s[0] * gl_TessCoord.x + matc_corner_%s[1] * gl_TessCoord.y + "
            "matc_corner_%s[2] * gl_TessCoord.z;\n",
            name, name, name, name);
    }
    emit_vertex_body(out, job, interface);
}

const char *emit_tessellation(Session *session, const Job *job, const Interface *interface,
                              TessellationStage stage)
{
    static const char *const names[] = {"first program that tessellates", "control program",
                                        "evaluation program"};
    VertexAttribute list[VERTEX_ATTRIBUTES];
    const int count = emit_vertex_attributes(job, interface, list);
    Text out = text_new(session->arena);
    emit_version(&out, job->target);
    text_format(&out, "// matc " MATC_VERSION ": %s of pass %s\n\n", names[stage],
                pass_table[job->pass].name);
    if (stage == TESSELLATION_vertex)
        put_vertex(&out, job, list, count);
    else if (stage == TESSELLATION_control)
        put_control(&out, job, list, count);
    else
        put_eval(&out, job, interface);
    return out.at;
}
