/* The vertex program that matches a fragment program: it computes only the varyings in use. */
#include "compiler/emit/emit.h"
#include "compiler/emit/emit_declare.h"
#include "compiler/emit/vertex.h"
#include "compiler/emit/attribute.h"
#include "compiler/emit/move.h"
#include "compiler/base/json_write.h"
#include "compiler/ir/std140.h"
#include <string.h>

/* Source of a varying: the attribute and uniform that it reads, and its expression. */
typedef struct {
    Input input;
    const char *attribute; /* declaration of the attribute; NULL: none */
    const char *uniform;
    const char *expression;
} Feed;

static const Feed feeds[] = {
    {INPUT_P, "vec3 position", "mat4 matc_worldFromLocal",
     "(matc_worldFromLocal * vec4(position, 1.0)).xyz"},
    {INPUT_N, "vec3 normal", "mat3 matc_worldNormalFromLocal",
     "matc_worldNormalFromLocal * normal"},
    {INPUT_DU, "vec3 tangentU", "mat4 matc_worldFromLocal",
     "(matc_worldFromLocal * vec4(tangentU, 0.0)).xyz"},
    {INPUT_DV, "vec3 tangentV", "mat4 matc_worldFromLocal",
     "(matc_worldFromLocal * vec4(tangentV, 0.0)).xyz"},
    {INPUT_U, "vec2 texcoord", NULL, "texcoord"},
    {INPUT_X, "vec3 position", NULL, "position"},
    {INPUT_XU, "vec3 tangentU", NULL, "tangentU"},
    {INPUT_XV, "vec3 tangentV", NULL, "tangentV"},
    {INPUT_eyeN, "vec3 normal", "mat3 matc_eyeNormalFromLocal", "matc_eyeNormalFromLocal * normal"},
};
enum { FEED_COUNT = sizeof feeds / sizeof *feeds };

/* Attribute of an already displaced mesh: maps read the position before displacement. */
static const char base_attribute[] = "vec3 basePosition";
enum { BASE_LOCATION = ATTRIBUTE_FIRST_LOCATION - 1 };
static const Feed base_feeds[] = {
    {INPUT_P, base_attribute, "mat4 matc_worldFromLocal",
     "(matc_worldFromLocal * vec4(basePosition, 1.0)).xyz"},
    {INPUT_X, base_attribute, NULL, "basePosition"},
};

static const Feed *feed_of(const Job *job, int i)
{
    for (int k = 0; job->moved && k < 2; k++)
        if (base_feeds[k].input == feeds[i].input)
            return &base_feeds[k];
    return &feeds[i];
}

/* Attribute locations are fixed, so that an engine binds a mesh once for all programs. */
static const char *const attributes[] = {"vec3 position", "vec3 normal", "vec2 texcoord",
                                         "vec3 tangentU", "vec3 tangentV"};
static const char *const uniforms[] = {"mat4 matc_worldFromLocal", "mat4 matc_clipFromWorld",
                                       "mat3 matc_worldNormalFromLocal",
                                       "mat3 matc_eyeNormalFromLocal"};
static const char *const screen_uniforms[] = {"mat4 matc_worldFromClip"};
enum {
    ATTRIBUTE_COUNT = 5,
    UNIFORM_normal = 2,
    UNIFORM_eye_normal = 3,
    UNIFORM_COUNT = 4,
    FIRST_MOVE_LOCATION = ATTRIBUTE_COUNT + 1
};

static void put_attributes(Text *out, Target target, const bool *used)
{
    for (int i = 0; i < ATTRIBUTE_COUNT; i++)
        if (used[i] && !target_table[target].in_out)
            text_format(out, "attribute %s;\n", attributes[i]);
        else if (used[i])
            text_format(out, "layout(location = %d) in %s;\n", i, attributes[i]);
}

static void put_uniforms(Text *out, Target target, const bool *used, const char *const *names,
                         int count)
{
    bool block = target_table[target].locations;
    if (block)
        text_format(out, "layout(std140, binding = %d) uniform Draw {\n", DRAW_BLOCK);
    for (int i = 0; i < count; i++)
        if (used[i])
            text_format(out, "%s%s;\n", block ? "    " : "uniform ", names[i]);
    if (block)
        text_put(out, "};\n");
}

void emit_place_uniforms(Text *out, Target target, bool normal)
{
    put_uniforms(out, target, (bool[UNIFORM_COUNT]){[0] = true, [UNIFORM_normal] = normal},
                 uniforms, UNIFORM_COUNT);
}

static void mark(const char *const *list, int count, const char *name, bool *used)
{
    for (int i = 0; name && i < count; i++)
        used[i] |= !strcmp(list[i], name);
}

/* Marks the attributes and uniforms that the varyings in use read; the position is always read. */
static void mark_used(const Interface *interface, bool *attribute, bool *uniform)
{
    attribute[0] = uniform[0] = uniform[1] = true;
    uniform[UNIFORM_normal] = interface->move != NULL;
    for (int i = 0; i < FEED_COUNT; i++) {
        if (!interface->inputs[feeds[i].input])
            continue;
        mark(attributes, ATTRIBUTE_COUNT, feeds[i].attribute, attribute);
        mark(uniforms, UNIFORM_COUNT, feeds[i].uniform, uniform);
    }
}

/* Declares the instance buffer, and the block of view matrices that all instances share. */
static void put_instances(Text *out, bool random)
{
    text_format(out, "layout(location = %d) in uint matc_instance;\n", ATTRIBUTE_COUNT);
    text_put(out, "struct Instance {\n    mat4 worldFromLocal;\n    mat3 worldNormalFromLocal;\n   "
                  " uint material;\n");
    text_put(out, random ? "    float object;\n};\n" : "};\n");
    text_format(out,
                "layout(std140, binding = %d) readonly buffer Instances {\n    Instance "
                "matc_instances[];\n};\n",
                INSTANCE_BUFFER);
    text_format(out, "layout(std140, binding = %d) uniform View {\n", DRAW_BLOCK);
    text_put(out, "    mat4 matc_clipFromWorld;\n    mat3 matc_eyeNormalFromWorld;\n};\n");
    text_format(out, "layout(location = %d) flat out uint matc_material;\n",
                emit_input_location(INPUT_COUNT));
    if (random)
        text_format(out, "layout(location = %d) flat out float %s;\n", emit_object_location(),
                    input_table[INPUT_object].glsl);
}

/* Returns a varying's expression. With instancing eye-space normals need two matrices, since no
 * buffer depends on both object and view. */
static const char *expression_of(const Feed *feed, const Job *job)
{
    return job->instances && feed->input == INPUT_eyeN
               ? "matc_eyeNormalFromWorld * (matc_worldNormalFromLocal * normal)"
               : feed->expression;
}

/* Declares locals for an instance's matrices, under the names of the uniforms of other programs. */
static void put_own(Text *out, const bool *used, bool random)
{
    text_put(out, "    mat4 matc_worldFromLocal = matc_instances[matc_instance].worldFromLocal;\n");
    if (used[UNIFORM_normal] || used[UNIFORM_eye_normal])
        text_put(out, "    mat3 matc_worldNormalFromLocal = "
                      "matc_instances[matc_instance].worldNormalFromLocal;\n");
    text_put(out, "    matc_material = matc_instances[matc_instance].material;\n");
    if (random)
        text_format(out, "    %s = matc_instances[matc_instance].object;\n",
                    input_table[INPUT_object].glsl);
}

int emit_vertex_attributes(const Job *job, const Interface *interface,
                           VertexAttribute list[VERTEX_ATTRIBUTES])
{
    bool attribute[ATTRIBUTE_COUNT] = {0}, uniform[UNIFORM_COUNT] = {0},
         move[MOVE_ATTRIBUTES] = {0};
    int count = 0;
    mark_used(interface, attribute, uniform);
    for (int i = 0; i < ATTRIBUTE_COUNT; i++)
        if (attribute[i])
            list[count++] = (VertexAttribute){attributes[i], i};
    if (interface->move)
        move_mark(interface->move, move);
    for (int i = 0; i < MOVE_ATTRIBUTES; i++)
        if (move[i])
            list[count++] = (VertexAttribute){move_attributes[i], FIRST_MOVE_LOCATION + i};
    if (job->moved && (interface->inputs[INPUT_P] || interface->inputs[INPUT_X]))
        list[count++] = (VertexAttribute){base_attribute, BASE_LOCATION};
    for (int i = 0; i < LIMIT_ATTRIBUTES; i++)
        if (interface->attributes[i])
            list[count++] = (VertexAttribute){attribute_declaration(interface->ir, i),
                                              ATTRIBUTE_FIRST_LOCATION + i};
    return count;
}

const char *emit_vertex_name(const VertexAttribute *attribute)
{
    return attribute->declaration + strcspn(attribute->declaration, " ") + 1;
}

void emit_vertex_between(Text *out, const Job *job, int number, const VertexAttribute *attribute,
                         const char *form)
{
    if (target_table[job->target].locations)
        text_format(out, "layout(location = %d) ", number);
    text_format(out, form, (int)strcspn(attribute->declaration, " "), attribute->declaration,
                emit_vertex_name(attribute));
}

void emit_vertex_declarations(Text *out, const Job *job, const Interface *interface)
{
    bool attribute[ATTRIBUTE_COUNT] = {0}, uniform[UNIFORM_COUNT] = {0};
    mark_used(interface, attribute, uniform);
    if (job->instances)
        put_instances(out, interface->inputs[INPUT_object]);
    else
        put_uniforms(out, job->target, uniform, uniforms, UNIFORM_COUNT);
    for (int i = 0; i < FEED_COUNT; i++)
        if (interface->inputs[feeds[i].input])
            emit_varying(out, job->target, feeds[i].input, "out");
    attribute_put_varyings(out, job, interface, "out");
    if (interface->move)
        text_format(out, "%s\n%s", interface->move->declarations, interface->move->text);
    else
        text_char(out, '\n');
}

void emit_vertex_body(Text *out, const Job *job, const Interface *interface)
{
    bool attribute[ATTRIBUTE_COUNT] = {0}, uniform[UNIFORM_COUNT] = {0};
    mark_used(interface, attribute, uniform);
    if (job->instances)
        put_own(out, uniform, interface->inputs[INPUT_object]);
    for (int i = 0; i < FEED_COUNT; i++)
        if (interface->inputs[feeds[i].input])
            text_format(out, "    %s = %s;\n", input_table[feeds[i].input].glsl,
                        expression_of(feed_of(job, i), job));
    attribute_hand_on(out, interface);
    if (interface->move)
        move_put(out, interface->move);
    text_put(out, interface->move
                      ? "    gl_Position = matc_clipFromWorld * vec4(matc_worldPosition, 1.0);\n}\n"
                      : "    gl_Position = matc_clipFromWorld * (matc_worldFromLocal * "
                        "vec4(position, 1.0));\n}\n");
}

static void rasterised(Text *out, const Job *job, const Interface *interface)
{
    VertexAttribute list[VERTEX_ATTRIBUTES];
    const int count = emit_vertex_attributes(job, interface, list);
    for (int i = 0; i < count; i++)
        if (target_table[job->target].in_out)
            text_format(out, "layout(location = %d) in %s;\n", list[i].location,
                        list[i].declaration);
        else
            text_format(out, "attribute %s;\n", list[i].declaration);
    emit_vertex_declarations(out, job, interface);
    text_put(out, "void main() {\n");
    emit_vertex_body(out, job, interface);
}

/* Writes a triangle that covers the screen. The ray is the direction in which clip-space z
 * changes at a corner, scaled to be linear over the screen even with an oblique near plane; it
 * points away from the eye for either direction of z. */
static void full_screen(Text *out, const Job *job, const Interface *interface)
{
    const char *index = target_table[job->target].index;
    bool ray = interface->inputs[INPUT_ray];
    if (!index)
        put_attributes(out, job->target, (bool[ATTRIBUTE_COUNT]){true});
    if (ray) {
        put_uniforms(out, job->target, (bool[]){true}, screen_uniforms, 1);
        emit_varying(out, job->target, INPUT_ray, "out");
    }
    text_put(out, "\nvoid main() {\n");
    if (index)
        text_format(out, "    vec2 corner = vec2(%s == 1 ? 3.0 : -1.0, %s == 2 ? 3.0 : -1.0);\n",
                    index, index);
    else
        text_put(out, "    vec2 corner = position.xy;\n");
    if (ray)
        text_put(out, "    vec4 point = matc_worldFromClip * vec4(corner, 0.0, 1.0);\n"
                      "    vec4 ahead = matc_worldFromClip[2];\n"
                      "    worldRay = (ahead.xyz * point.w - point.xyz * ahead.w) * (ahead.w > 0.0 "
                      "? -1.0 : 1.0);\n");
    text_put(out, "    gl_Position = vec4(corner, 0.0, 1.0);\n}\n");
}

/* Returns true for passes that draw a full-screen triangle. */
static bool is_screen(const Job *job) { return job->pass == PASS_plane || job->pass == PASS_sky; }

const char *emit_vertex(Session *session, const Job *job, const Interface *interface)
{
    Text out = text_new(session->arena);
    emit_version(&out, job->target);
    text_format(&out, "// matc " MATC_VERSION ": vertex program of pass %s\n\n",
                pass_table[job->pass].name);
    if (is_screen(job))
        full_screen(&out, job, interface);
    else
        rasterised(&out, job, interface);
    return out.at;
}

/* Writes "vec3 position" as {"name": "position", "type": "vec3", key: value}. */
void emit_describe_part(Text *out, const char *declaration, const char *key, int value)
{
    int type = (int)strcspn(declaration, " ");
    text_put(out, "{");
    json_member(out, "name", declaration + type + 1);
    json_next(out, "type", arena_string(out->arena, declaration, (size_t)type));
    if (value >= 0) {
        text_put(out, ", ");
        json_key(out, key);
        text_int(out, value);
    }
    text_char(out, '}');
}

/* Describes the attributes: the mesh's own, those of displacement, the base position, and those
 * that the document names. */
static void describe_attributes(Text *out, const Job *job, const Interface *interface,
                                const bool attribute[ATTRIBUTE_COUNT])
{
    const bool screen = is_screen(job), in_out = target_table[job->target].in_out;
    bool moves[MOVE_ATTRIBUTES] = {0};
    if (interface->move && !screen)
        move_mark(interface->move, moves);
    for (int i = 0, first = 1; i < ATTRIBUTE_COUNT; i++)
        if (attribute[i]) {
            text_put(out, first ? "" : ", ");
            emit_describe_part(out, attributes[i], "location", in_out ? i : -1);
            first = 0;
        }
    for (int i = 0; i < MOVE_ATTRIBUTES; i++)
        if (moves[i]) {
            text_put(out, ", ");
            emit_describe_part(out, move_attributes[i], "location",
                               in_out ? FIRST_MOVE_LOCATION + i : -1);
        }
    if (job->moved && !screen && (interface->inputs[INPUT_P] || interface->inputs[INPUT_X])) {
        text_put(out, ", ");
        emit_describe_part(out, base_attribute, "location", in_out ? BASE_LOCATION : -1);
    }
    for (int i = 0; i < LIMIT_ATTRIBUTES && !screen; i++)
        if (interface->attributes[i]) {
            text_put(out, ", ");
            emit_describe_part(out, attribute_declaration(interface->ir, i), "location",
                               in_out ? ATTRIBUTE_FIRST_LOCATION + i : -1);
            out->at[--out->size] = 0; /* removes the closing brace to append members */
            attribute_describe(out, interface->ir->graph->attributes[i]);
        }
}

/* Describes the uniforms. Returns the size of their block in bytes. */
static int describe_uniforms(Text *out, const Job *job, const bool uniform[UNIFORM_COUNT])
{
    const bool screen = is_screen(job), offsets = target_table[job->target].locations;
    const char *const *names = screen ? screen_uniforms : uniforms;
    int size = 0;
    for (int i = 0, first = 1; i < (screen ? 1 : UNIFORM_COUNT); i++)
        if (uniform[i]) {
            text_put(out, first ? "" : ", ");
            emit_describe_part(out, names[i], "offset",
                               offsets ? std140_offset(names[i], &size) : -1);
            first = 0;
        }
    return size;
}

void emit_describe_vertex(Text *out, const Job *job, const Interface *interface)
{
    const TargetRow *target = &target_table[job->target];
    const bool screen = is_screen(job);
    bool attribute[ATTRIBUTE_COUNT] = {screen && !target->index},
         uniform[UNIFORM_COUNT] = {screen && interface->inputs[INPUT_ray]};
    if (!screen)
        mark_used(interface, attribute, uniform);
    text_put(out, ",\n  \"vertex\": {\"attributes\": [");
    describe_attributes(out, job, interface, attribute);
    text_put(out, "], \"uniforms\": [");
    const int size = describe_uniforms(out, job, uniform);
    text_put(out, "]");
    if (target->locations && size)
        text_format(out, ", \"block\": {\"name\": \"Draw\", \"binding\": %d, \"size\": %d}",
                    DRAW_BLOCK, std140_size(size));
    text_put(out, "}");
}
