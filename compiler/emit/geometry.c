/* The geometry program, and the vertex program that passes attributes to it. It subdivides a
 * triangle into matc_rows^2 triangles, output as one strip per row. Attributes are interpolated
 * at each point of the rows and then processed as in the vertex program.
 *
 *     matc_rows = 2:       0            two strips: 2 0 1 of the first row, whose upper
 *                         / \           point is 0 alone; then alternating points of
 *                        *---*          the second row and the first.
 *                       / \ / \
 *                      2---*---1
 *
 * Drivers guarantee only 1024 output components per input triangle: matc_rowsMost is the max
 * number of rows within this limit. Finer subdivision first divides the triangle into
 * matc_parts^2 parts, again by rows; each draw instance subdivides one part. Points of an edge
 * are weighted by integers over their sum, so they equal those of the adjacent triangle. */
#include "compiler/emit/vertex.h"
#include "compiler/emit/emit_declare.h"

/* ROWS_BLOCK: the last binding that every driver supports, shared with the tessellation levels
 * of other programs. Others: guaranteed output limits per input triangle. */
enum { ROWS_BLOCK = 83, GEOMETRY_COMPONENTS = 1024, VERTICES = 256, POSITION_COMPONENTS = 4 };

static int vertices_most(const Interface *interface)
{
    int components = POSITION_COMPONENTS;
    for (int i = 0; i < INPUT_COUNT; i++)
        if (interface->inputs[i] && input_table[i].source == SOURCE_varying)
            components += type_table[input_table[i].type].components;
    for (int i = 0; i < LIMIT_ATTRIBUTES; i++)
        if (interface->attributes[i])
            components += type_table[interface->ir->graph->attributes[i]->type].components;
    return GEOMETRY_COMPONENTS / components < VERTICES ? GEOMETRY_COMPONENTS / components
                                                       : VERTICES;
}

/* A strip set of n rows has n^2 + 2 n vertices. */
static int rows_most(int vertices)
{
    int rows = 1;
    while ((rows + 1) * (rows + 3) <= vertices)
        rows++;
    return rows;
}

static void put_first(Text *out, const Job *job, const VertexAttribute *list, int count)
{
    for (int i = 0; i < count; i++)
        text_format(out, "layout(location = %d) in %s;\n", list[i].location, list[i].declaration);
    for (int i = 0; i < count; i++)
        emit_vertex_between(out, job, i, &list[i], "out %.*s matc_vertex_%s;\n");
    emit_vertex_between(out, job, count, &(VertexAttribute){"int part", 0},
                        "flat out %.*s matc_vertex_%s;\n");
    text_put(out, "\nvoid main() {\n");
    for (int i = 0; i < count; i++)
        text_format(out, "    matc_vertex_%s = %s;\n", emit_vertex_name(&list[i]),
                    emit_vertex_name(&list[i]));
    text_format(out, "    matc_vertex_part = %s;\n}\n",
                target_table[job->target].spirv ? "gl_InstanceIndex" : "gl_InstanceID");
}

static void put_uniforms(Text *out, const Job *job)
{
    if (target_table[job->target].locations)
        text_format(out,
                    "layout(std140, binding = %d) uniform Rows {\n    int matc_rows;\n    int "
                    "matc_parts;\n};\n",
                    ROWS_BLOCK);
    else
        text_put(out, "uniform int matc_rows;\nuniform int matc_parts;\n");
}

/* Writes matc_point(): a point by integer weights of the corners. */
static void put_point(Text *out, const Job *job, const Interface *interface,
                      const VertexAttribute *list, int count)
{
    text_put(out, "void matc_point(ivec3 weights) {\n    vec3 w = vec3(weights) / float(weights.x "
                  "+ weights.y + weights.z);\n");
    for (int i = 0; i < count; i++) {
        const char *name = emit_vertex_name(&list[i]);
        text_format(out,
                    "    %s = matc_vertex_%s[0] * w.x + matc_vertex_%s[1] * w.y + "
                    "matc_vertex_%s[2] * w.z;\n",
                    name, name, name, name);
    }
    emit_vertex_body(out, job, interface);
}

static void put_rows(Text *out, int rows)
{
    text_format(out, "\nconst int matc_rowsMost = %d;\n\n", rows);
    text_put(out, "void main() {\n"
                  "    int row = 0, part = matc_vertex_part[0];\n"
                  "    while ((row + 1) * (row + 1) <= part)\n"
                  "        row++;\n"
                  "    int place = part - row * row, column = place / 2;\n"
                  "    ivec3 a = ivec3(matc_parts - row, column, row - column), b = a + ivec3(-1, "
                  "1, 0), c = a + "
                  "ivec3(-1, 0, 1);\n"
                  "    if (place % 2 == 1) {\n"
                  "        a = ivec3(matc_parts - row - 1, column + 1, row - column);\n"
                  "        b = a + ivec3(1, -1, 0);\n"
                  "        c = a + ivec3(1, 0, -1);\n"
                  "    }\n"
                  "    int rows = min(matc_rows, matc_rowsMost);\n"
                  "    for (int i = 0; i < rows; i++) {\n"
                  "        for (int j = 0; j <= i; j++) {\n"
                  "            matc_point(a * (rows - i - 1) + b * j + c * (i + 1 - j));\n"
                  "            EmitVertex();\n"
                  "            matc_point(a * (rows - i) + b * j + c * (i - j));\n"
                  "            EmitVertex();\n"
                  "        }\n"
                  "        matc_point(a * (rows - i - 1) + b * (i + 1));\n"
                  "        EmitVertex();\n"
                  "        EndPrimitive();\n"
                  "    }\n"
                  "}\n");
}

static void put_geometry(Text *out, const Job *job, const Interface *interface)
{
    VertexAttribute list[VERTEX_ATTRIBUTES];
    const int count = emit_vertex_attributes(job, interface, list),
              rows = rows_most(vertices_most(interface));
    text_format(out, "layout(triangles) in;\nlayout(triangle_strip, max_vertices = %d) out;\n",
                rows * (rows + 2));
    for (int i = 0; i < count; i++)
        emit_vertex_between(out, job, i, &list[i], "in %.*s matc_vertex_%s[];\n");
    emit_vertex_between(out, job, count, &(VertexAttribute){"int part", 0},
                        "flat in %.*s matc_vertex_%s[];\n");
    for (int i = 0; i < count; i++)
        text_format(out, "%s%s;\n", target_table[job->target].number >= 400 ? "precise " : "",
                    list[i].declaration);
    put_uniforms(out, job);
    emit_vertex_declarations(out, job, interface);
    put_point(out, job, interface, list, count);
    put_rows(out, rows);
}

const char *emit_geometry(Session *session, const Job *job, const Interface *interface,
                          GeometryStage stage)
{
    VertexAttribute list[VERTEX_ATTRIBUTES];
    const int count = emit_vertex_attributes(job, interface, list);
    Text out = text_new(session->arena);
    emit_version(&out, job->target);
    text_format(&out, "// matc " MATC_VERSION ": %s of pass %s\n\n",
                stage == GEOMETRY_vertex ? "vertex program before the geometry program"
                                         : "geometry program",
                pass_table[job->pass].name);
    if (stage == GEOMETRY_vertex)
        put_first(&out, job, list, count);
    else
        put_geometry(&out, job, interface);
    return out.at;
}
