/* The compute program: reads vertices from a buffer, and writes their displaced positions and
 * normals. It belongs to no pass: run it once to refit an acceleration structure, to bake a
 * mesh, or to fill a vertex buffer for all passes.
 *
 * A mesh is a buffer of floats, interleaved or with separate attributes. A uvec2 per attribute
 * has the index of its first float, and its stride in floats; stride 0: all vertices share the
 * value. The output buffer has the same form; normals with stride 0 are not written.
 *
 *     position, normal and texture coordinate, interleaved:  matc_at_position (0, 8),
 *                                                            matc_at_normal (3, 8),
 *                                                            matc_at_texcoord (6, 8)
 *
 * A position is displaced by attributes of displacement, as in the vertex program. The normal
 * equals that of the fragment program at this vertex. It is computed from the shading attributes
 * and from the derivatives of the normal by u and v, which fragments compute themselves and
 * vertices need as attributes. */
#include "compiler/emit/vertex.h"
#include "compiler/emit/compute.h"
#include "compiler/emit/emit_declare.h"
#include "compiler/emit/move.h"
#include "compiler/base/json_write.h"
#include "compiler/ir/std140.h"
#include <string.h>

/* The uniform block has the binding of other stages' own blocks. Vulkan numbers bindings of all
 * types together, OpenGL per type, with at least eight buffer bindings. */
enum {
    VERTICES_BLOCK = 83,
    READ_BUFFER = 0,
    WRITTEN_BUFFER = 1,
    VULKAN_READ_BUFFER = 84,
    VULKAN_WRITTEN_BUFFER = 85,
    LOCAL_SIZE = 64
};

/* An input from which the normal is computed, with its attribute and expression. */
typedef struct {
    Input input;
    const char *attribute, *expression;
} NormalFeed;
static const NormalFeed normal_feeds[] = {
    {INPUT_cornerP, "vec3 position", "(matc_worldFromLocal * vec4(position, 1.0)).xyz"},
    {INPUT_cornerN, "vec3 normal", "matc_worldNormalFromLocal * normal"},
    {INPUT_cornerU, "vec2 texcoord", "texcoord"},
    {INPUT_cornerDU, "vec3 tangentU", "(matc_worldFromLocal * vec4(tangentU, 0.0)).xyz"},
    {INPUT_cornerDV, "vec3 tangentV", "(matc_worldFromLocal * vec4(tangentV, 0.0)).xyz"},
    {INPUT_cornerX, "vec3 position", "position"},
    {INPUT_cornerXU, "vec3 tangentU", "tangentU"},
    {INPUT_cornerXV, "vec3 tangentV", "tangentV"},
    {INPUT_cornerNU, "vec3 normalByU", "matc_worldNormalFromLocal * normalByU"},
    {INPUT_cornerNV, "vec3 normalByV", "matc_worldNormalFromLocal * normalByV"},
    {INPUT_cornerDUU, "vec3 tangentUByU", "(matc_worldFromLocal * vec4(tangentUByU, 0.0)).xyz"},
    {INPUT_cornerDUV, "vec3 tangentUByV", "(matc_worldFromLocal * vec4(tangentUByV, 0.0)).xyz"},
    {INPUT_cornerDVV, "vec3 tangentVByV", "(matc_worldFromLocal * vec4(tangentVByV, 0.0)).xyz"},
};
enum {
    NORMAL_FEEDS = sizeof normal_feeds / sizeof *normal_feeds,
    MAX_READ = MOVE_ATTRIBUTES + NORMAL_FEEDS
};

static const char position[] = "vec3 position", normal[] = "vec3 normal";
static const char *const written[] = {position, normal};
enum { WRITTEN = 2 };

static const char *name_of(const char *declaration) { return strchr(declaration, ' ') + 1; }

static int with(const char **list, int count, const char *declaration)
{
    for (int i = 0; i < count; i++)
        if (!strcmp(list[i], declaration))
            return count;
    list[count] = declaration;
    return count + 1;
}

/* Lists the declarations of the attributes that are read, such as "vec3 position". Returns their
 * number. */
static int list_read(const VertexMove *move, const char *list[MAX_READ])
{
    bool moves[MOVE_ATTRIBUTES] = {0};
    int count = with(list, 0, position);
    if (move)
        move_mark(move, moves);
    for (int i = 0; i < MOVE_ATTRIBUTES; i++)
        if (moves[i])
            count = with(list, count, move_attributes[i]);
    if (!move || !move->turns)
        return with(list, count, normal);
    for (int i = 0; i < NORMAL_FEEDS; i++)
        if (move->normal_inputs[normal_feeds[i].input])
            count = with(list, count, normal_feeds[i].attribute);
    return count;
}

/* Lists the declarations of the block's members in order. Returns their number. */
static int list_members(Arena *arena, const VertexMove *move,
                        const char *list[MAX_READ + WRITTEN + 3])
{
    const char *read[MAX_READ];
    const int reads = list_read(move, read);
    int count = 0;
    list[count++] = "mat4 matc_outFromWorld";
    list[count++] = "mat3 matc_outNormalFromWorld";
    list[count++] = "uint matc_count";
    for (int i = 0; i < reads + WRITTEN; i++) {
        Text member = text_new(arena);
        text_format(&member, i < reads ? "uvec2 matc_at_%s" : "uvec2 matc_to_%s",
                    name_of(i < reads ? read[i] : written[i - reads]));
        list[count++] = member.at;
    }
    return count;
}

static void put_buffers(Text *out, Arena *arena, const Job *job, const VertexMove *move)
{
    const char *members[MAX_READ + WRITTEN + 3];
    const int count = list_members(arena, move, members);
    const bool vulkan = target_table[job->target].spirv;
    text_format(out,
                "layout(local_size_x = %d) in;\nlayout(std140, binding = %d) uniform Vertices {\n",
                LOCAL_SIZE, VERTICES_BLOCK);
    for (int i = 0; i < count; i++)
        text_format(out, "    %s;\n", members[i]);
    text_format(
        out,
        "};\nlayout(std430, binding = %d) readonly buffer Read {\n    float matc_read[];\n};\n",
        vulkan ? VULKAN_READ_BUFFER : READ_BUFFER);
    text_format(
        out,
        "layout(std430, binding = %d) writeonly buffer Written {\n    float matc_written[];\n};\n",
        vulkan ? VULKAN_WRITTEN_BUFFER : WRITTEN_BUFFER);
}

static void put_helpers(Text *out, bool coordinates)
{
    if (coordinates)
        text_put(out, "vec2 matc_vec2(uvec2 at, uint vertex) {\n    uint i = at.x + at.y * "
                      "vertex;\n    return "
                      "vec2(matc_read[i], matc_read[i + 1u]);\n}\n\n");
    text_put(
        out,
        "vec3 matc_vec3(uvec2 at, uint vertex) {\n    uint i = at.x + at.y * vertex;\n    return "
        "vec3(matc_read[i], matc_read[i + 1u], matc_read[i + 2u]);\n}\n\n"
        "void matc_write(uvec2 at, uint vertex, vec3 value) {\n    uint i = at.x + at.y * vertex;\n"
        "    matc_written[i] = value.x;\n    matc_written[i + 1u] = value.y;\n    matc_written[i + "
        "2u] = "
        "value.z;\n}\n\n");
}

static void put_normal(Text *out, const VertexMove *move)
{
    const bool turns = move && move->turns;
    text_put(out, "    if (matc_to_normal.y == 0u)\n        return; // nobody wants normals\n");
    for (int i = 0; turns && i < NORMAL_FEEDS; i++)
        if (move->normal_inputs[normal_feeds[i].input])
            text_format(out, "    %s = %s;\n", input_table[normal_feeds[i].input].glsl,
                        normal_feeds[i].expression);
    text_format(out, "    vec3 matc_turned = matc_outNormalFromWorld * %s;\n",
                turns ? "matc_displacedNormal()" : "(matc_worldNormalFromLocal * normal)");
    text_put(
        out,
        "    matc_write(matc_to_normal, vertex, matc_turned / max(length(matc_turned), 1e-30));\n");
}

static void put_main(Text *out, const VertexMove *move)
{
    const char *read[MAX_READ];
    const int reads = list_read(move, read);
    text_format(out,
                "// Groups may lie in two rows and more: one row has 65,535 at most.\nvoid main() "
                "{\n    uint vertex = "
                "gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * %du;\n",
                LOCAL_SIZE);
    text_put(out, "    if (vertex >= matc_count)\n        return;\n");
    for (int i = 0; i < reads; i++)
        text_format(out, "    %s = matc_%.4s(matc_at_%s, vertex);\n", read[i], read[i],
                    name_of(read[i]));
    if (move)
        move_put(out, move);
    text_format(out, "    matc_write(matc_to_position, vertex, (matc_outFromWorld * %s).xyz);\n",
                move ? "vec4(matc_worldPosition, 1.0)"
                     : "(matc_worldFromLocal * vec4(position, 1.0))");
    put_normal(out, move);
    text_put(out, "}\n");
}

static bool has_coordinates(const VertexMove *move)
{
    const char *read[MAX_READ];
    for (int i = list_read(move, read); i-- > 0;)
        if (!strncmp(read[i], "vec2", 4))
            return true;
    return false;
}

const char *emit_compute(Session *session, const Job *job, const Interface *interface)
{
    const VertexMove *move = interface->compute;
    Text out = text_new(session->arena);
    emit_version(&out, job->target);
    text_put(&out, "// matc " MATC_VERSION ": compute program that displaces vertices\n\n");
    put_buffers(&out, session->arena, job, move);
    emit_place_uniforms(&out, job->target, true);
    text_format(&out, "%s\n%s", move ? move->declarations : "", move ? move->text : "");
    put_helpers(&out, has_coordinates(move));
    put_main(&out, move);
    return out.at;
}

static void describe_members(Text *out, const char *key, const char *const *list, int count,
                             int *size)
{
    text_put(out, ", ");
    json_key(out, key);
    text_put(out, "[");
    for (int i = 0; i < count; i++) {
        text_put(out, i ? ", " : "");
        emit_describe_part(out, list[i], "offset", std140_offset(list[i], size));
    }
    text_put(out, "]");
}

static void describe_block(Text *out, const char *key, const char *name, int binding, int size)
{
    text_put(out, ", ");
    json_key(out, key);
    text_put(out, "{");
    json_member(out, "name", name);
    text_format(out, ", \"binding\": %d", binding);
    text_format(out, size ? ", \"size\": %d}" : "}", size);
}

void compute_describe(Text *out, const Job *job, const Interface *interface)
{
    static const char *const places[] = {"mat4 matc_worldFromLocal",
                                         "mat3 matc_worldNormalFromLocal"};
    const char *read[MAX_READ], *members[MAX_READ + WRITTEN + 3];
    const int reads = list_read(interface->compute, read),
              count = list_members(out->arena, interface->compute, members);
    const bool vulkan = target_table[job->target].spirv;
    int size = 0, place = 0;
    text_format(out, ",\n  \"compute\": {\"localSize\": %d, \"attributes\": [", LOCAL_SIZE);
    for (int i = 0; i < reads; i++) {
        text_put(out, i ? ", " : "");
        emit_describe_part(out, read[i], "", -1);
    }
    text_put(out, "]");
    describe_members(out, "vertices", members, count, &size);
    describe_block(out, "verticesBlock", "Vertices", VERTICES_BLOCK, std140_size(size));
    describe_members(out, "uniforms", places, 2, &place);
    describe_block(out, "block", "Draw", DRAW_BLOCK, std140_size(place));
    describe_block(out, "read", "Read", vulkan ? VULKAN_READ_BUFFER : READ_BUFFER, 0);
    describe_block(out, "written", "Written", vulkan ? VULKAN_WRITTEN_BUFFER : WRITTEN_BUFFER, 0);
    text_put(out, "}");
}
