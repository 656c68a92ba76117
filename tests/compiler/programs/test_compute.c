/* Compute programs that displace the vertices of a buffer, run under OSMesa: positions against
 * the oracle's, normals against the oracle's and against closed forms of curved shapes, for
 * meshes with any arrangement in memory; other memory stays unchanged. Uniforms are at the
 * places that the reflection reports. */
#include "tests/test.h"
#include "tests/rig_state.h"
#include "tests/draw/curved.h"
#include "tests/value/move.h"
#include "tests/value/read_whole.h"
#include "tests/draw/vertices.h"
#include <cjson/cJSON.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT = 200, BEYOND = 7, MAX_NUMBERS = 60 * (COUNT + BEYOND), COMPONENTS = 3 };
static const double position_bound = 4e-6, /* in the world, of positions about 2 in size */
    angle_bound = 1e-3;                    /* degrees: floats, of steep slopes */
static const float untouched = -77;

static const char *const names[] = {"position",    "normal",     "texcoord",  "tangentU",
                                    "tangentV",    "normalByU",  "normalByV", "tangentUByU",
                                    "tangentUByV", "tangentVByV"};
enum { NAMES = sizeof names / sizeof *names };

/* Vertices in the object's space, and what they are in the world. */
typedef struct {
    float at[COUNT][COMPONENTS * NAMES]; /* by the order of `names` */
    Surface surface[COUNT];
    Space space;
} Mass;

/* How it lies in the buffer, and what is asked for. */
typedef struct {
    bool sections, local, normals,
        /* an attribute behind the other; written in the object's space; normals; slopes of the base
         * are one zero for all */
        flat;
    int groups[2];
} Way;

typedef struct {
    const MatcDocument *document;
    int material;
    const Mass *mass;
    const Way *way;
} Task;

typedef struct {
    float position[COUNT + BEYOND][COMPONENTS], normal[COUNT + BEYOND][COMPONENTS];
} Result;

/* "displacementTangentU" is tangentU here. */
static int number_of(const char *name)
{
    char plain[40];
    snprintf(plain, sizeof plain, "%s", name);
    if (!strncmp(name, "displacement", 12)) {
        snprintf(plain, sizeof plain, "%s", name + 12);
        plain[0] = (char)(plain[0] - 'A' + 'a');
    }
    for (int i = 0; i < NAMES; i++)
        if (!strcmp(names[i], plain))
            return i;
    fail_msg("no attribute is called %s", name);
    return -1;
}

typedef struct {
    const cJSON *compute;
    unsigned char block[1024];
} Reflection;

static void put(Reflection *r, const char *prefix, const char *name, const void *bytes, size_t size)
{
    char whole[60];
    const cJSON *member;
    snprintf(whole, sizeof whole, "%s%s", prefix, name);
    cJSON_ArrayForEach(
        member,
        cJSON_GetObjectItem(
            r->compute, "vertices")) if (!strcmp(cJSON_GetObjectItem(member, "name")->valuestring,
                                                 whole))
    {
        memcpy(r->block + cJSON_GetObjectItem(member, "offset")->valueint, bytes, size);
        return;
    }
    fail_msg("no member is called %s", whole);
}

static int whole_at(const cJSON *object, const char *name, const char *member)
{
    return cJSON_GetObjectItem(cJSON_GetObjectItem(object, name), member)->valueint;
}

/* The buffer's numbers, and where each attribute is. */
static int lay_out(const Mass *mass, const Way *way, Reflection *r, float *numbers)
{
    const cJSON *attribute, *list = cJSON_GetObjectItem(r->compute, "attributes");
    int size = 0, step = 0;
    cJSON_ArrayForEach(attribute, list) step += COMPONENTS;
    cJSON_ArrayForEach(attribute, list)
    {
        const char *name = cJSON_GetObjectItem(attribute, "name")->valuestring;
        const int of = number_of(name), count = way->flat && of >= 5 ? 1 : COUNT;
        const uint32_t at[2] = {(uint32_t)size, count == 1      ? 0
                                                : way->sections ? COMPONENTS
                                                                : (uint32_t)step};
        for (int i = 0; i < count; i++)
            memcpy(&numbers[at[0] + at[1] * (uint32_t)i], &mass->at[i][COMPONENTS * of],
                   COMPONENTS * sizeof(float));
        put(r, "matc_at_", name, at, sizeof at);
        size += way->sections ? COMPONENTS * count : COMPONENTS;
    }
    return way->sections ? size : step * COUNT;
}

static void put_places(const Mass *mass, const Way *way, Reflection *r)
{
    const uint32_t count = COUNT, to_position[2] = {0, COMPONENTS},
                   to_normal[2] = {COMPONENTS * (COUNT + BEYOND), way->normals ? COMPONENTS : 0};
    Mat4 out = mat4_identity();
    float padded[12] = {0};
    if (way->local)
        assert_true(mat4_inverse(&mass->space.world_from_local, &out));
    for (int i = 0; i < 9;
         /* the inverse transpose: of the way to the object's space, the transpose of its matrix */
         i++)
        padded[4 * (i / 3) + i % 3] =
            way->local ? mass->space.world_from_local.m[4 * (i % 3) + i / 3] : i % 4 == 0;
    put(r, "", "matc_outFromWorld", out.m, sizeof out.m);
    put(r, "", "matc_outNormalFromWorld", padded, sizeof padded);
    put(r, "", "matc_count", &count, sizeof count);
    put(r, "matc_to_", "position", to_position, sizeof to_position);
    put(r, "matc_to_", "normal", to_normal, sizeof to_normal);
}

static void run(Rig *rig, const Task *task, Result *result)
{
    static float numbers[MAX_NUMBERS];
    const Mass *mass = task->mass;
    const Way *way = task->way;
    GlContext *gl = rig->gl;
    GLuint buffers[2];
    MatcOptions options;
    Material made;
    Reflection r = {0};
    matc_options_init(&options);
    options.target = "glsl450";
    options.pixels = true;
    MatcProgram *program =
        matc_compile(task->document, task->material, MATC_COMPUTE | MATC_REFLECT, &options);
    if (!matc_ok(program))
        fail_msg("%s", matc_program_diagnostics(program, MATC_TEXT));
    cJSON *json = cJSON_Parse(matc_output(program, MATC_REFLECT, NULL));
    r.compute = cJSON_GetObjectItem(json, "compute");
    const int count = lay_out(mass, way, &r, numbers);
    put_places(mass, way, &r);
    for (int i = 0; i < COUNT + BEYOND; i++)
        for (int k = 0; k < COMPONENTS; k++)
            result->position[i][k] = result->normal[i][k] = untouched;
    assert_true(gl_use(gl));
    if (!material_make(rig->store, program,
                       &(ProgramText){.compute = {matc_output(program, MATC_COMPUTE, NULL)}},
                       &made))
        fail_msg("%s", gl->error);
    spaces_set(&mass->space, &made);
    assert_true(material_write(&made, "Vertices", r.block,
                               (size_t)whole_at(r.compute, "verticesBlock", "size")));
    material_use(&made);
    gl->GenBuffers(2, buffers);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffers[0]);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)((size_t)count * sizeof *numbers), numbers,
                   GL_STATIC_DRAW);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffers[1]);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, sizeof *result, result, GL_STATIC_DRAW);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, (GLuint)whole_at(r.compute, "read", "binding"),
                       buffers[0]);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, (GLuint)whole_at(r.compute, "written", "binding"),
                       buffers[1]);
    assert_int_equal(cJSON_GetObjectItem(r.compute, "localSize")->valueint, 64);
    gl->DispatchCompute((GLuint)way->groups[0], (GLuint)way->groups[1], 1);
    gl->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffers[1]);
    gl->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, sizeof *result, result);
    gl->DeleteBuffers(2, buffers);
    assert_true(gl_check(gl, "displacing"));
    material_delete(&made);
    cJSON_Delete(json);
    matc_program_free(program);
}

static const Way ways[] = {{.normals = true, .groups = {4, 1}},
                           {.sections = true, .normals = true, .groups = {2, 2}},
                           {.local = true, .normals = true, .groups = {1, 4}},
                           {.sections = true, .groups = {9, 1}}};
enum { WAYS = sizeof ways / sizeof *ways };

/* Points with any lengths and angles, where the camera does not matter. */
static void scatter(Mass *mass)
{
    Vertices *vertices = calloc(1, sizeof *vertices);
    mass->space = space_camera((float[3]){2.5f, -2, 2}, (float[3]){0.1f, 0, 0}, 0.5f);
    space_place(&mass->space);
    vertices_make(vertices, &mass->space, SIDE);
    for (int i = 0; i < COUNT; i++) {
        const ShapeVertex *v = &vertices->vertex[i % VERTICES];
        const float *const from[] = {v->position, v->normal, v->uv, v->tangentU, v->tangentV};
        mass->surface[i] = vertices->surface[i % VERTICES];
        for (int k = 0; k < 5; k++)
            memcpy(&mass->at[i][COMPONENTS * k], from[k],
                   (k == 2 ? 2 : COMPONENTS) * sizeof(float));
        for (int component = 0; component < COMPONENTS; component++) {
            mass->surface[i].local_u[component] = v->tangentU[component];
            mass->surface[i].local_v[component] = v->tangentV[component];
        }
    }
    free(vertices);
}

static void to_space(const Mass *mass, const Way *way, const float in[COMPONENTS],
                     double world[COMPONENTS])
{
    double given[COMPONENTS] = {in[0], in[1], in[2]}, to[4];
    const Mat4 place = way->local ? mass->space.world_from_local : mat4_identity();
    space_transform(&place, given, 1, to);
    memcpy(world, to, COMPONENTS * sizeof *world);
}

/* A normal that was written, in the world again: by the inverse transpose of the matrix, up to its
 * length. */
static void normal_to_world(const Mass *mass, const Way *way, const float in[COMPONENTS],
                            double world[COMPONENTS])
{
    Mat4 local;
    assert_true(mat4_inverse(&mass->space.world_from_local, &local));
    for (int i = 0; i < COMPONENTS; i++) {
        world[i] = way->local ? 0 : in[i];
        for (int k = 0; k < COMPONENTS && way->local; k++)
            world[i] += (double)local.m[4 * i + k] * in[k];
    }
}

static MatcDocument *open_text(const char *name, const char *text)
{
    MatcOptions options;
    matc_options_init(&options);
    options.pixels = true;
    MatcDocument *document = matc_read(name, text, strlen(text), &options);
    if (!matc_material_count(document))
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    return document;
}

typedef struct {
    const char *path;
    int material;
    double position[COUNT][3], normal[COUNT][3];
    double worst[2];
} Wanted;

static void check_vertex(const Mass *mass, const Way *way, const Result *result, int i,
                         Wanted *wanted)
{
    const double *want = wanted->position[i];
    /* which bends what is shaded, and no shape */
    const bool bumped = strstr(wanted->path, "Bumped") != NULL;
    double is[3], turned[3];
    to_space(mass, way, result->position[i], is);
    const double off =
        sqrt(pow(is[0] - want[0], 2) + pow(is[1] - want[1], 2) + pow(is[2] - want[2], 2));
    wanted->worst[0] = fmax(wanted->worst[0], off);
    if (!(off <= position_bound))
        fail_msg("%s, vertex %d: %g %g %g, not %g %g %g", wanted->path, i, is[0], is[1], is[2],
                 want[0], want[1], want[2]);
    if (!way->normals || bumped)
        return;
    normal_to_world(mass, way, result->normal[i], turned);
    const double angle = curved_angle(turned, wanted->normal[i]);
    wanted->worst[1] = fmax(wanted->worst[1], angle);
    if (!(angle <= angle_bound))
        fail_msg("%s, material %d, vertex %d: a normal is %g degrees off", wanted->path,
                 wanted->material, i, angle);
}

static void check_material(Rig *rig, const MatcDocument *document, const Mass *mass, Wanted *wanted)
{
    static Result result;
    const MovePoints points = {mass->surface, COUNT};
    assert_true(move_points(wanted->path, wanted->material, &points, wanted->position) &&
                move_normals(wanted->path, wanted->material, &points, wanted->normal));
    for (int w = 0; w < WAYS; w++) {
        run(rig, &(Task){document, wanted->material, mass, &ways[w]}, &result);
        for (int i = 0; i < COUNT; i++)
            check_vertex(mass, &ways[w], &result, i, wanted);
        for (int i = 0; i < COUNT + BEYOND; i++)
            for (int k = 0; k < COMPONENTS; k++)
                assert_true((result.position[i][k] == untouched) == (i >= COUNT) &&
                            (result.normal[i][k] == untouched) == (i >= COUNT || !ways[w].normals));
    }
}

/* A vertex that is not displaced is written unchanged. */
static void vertices_are_the_oracles(void **state)
{
    static const char *const documents[] = {"displacement.yaml",
                                            "channels/displacementVector.yaml",
                                            "channels/displacementPicture.yaml",
                                            "channels/displacementBound.yaml",
                                            "channels/displacementSwitch.yaml",
                                            "channels/displacementBumped.yaml",
                                            "channels/displacementVolume.yaml",
                                            "checker.yaml"};
    static Mass mass;
    static Wanted wanted;
    scatter(&mass);
    for (size_t i = 0; i < sizeof documents / sizeof *documents; i++) {
        char path[300];
        size_t size;
        snprintf(path, sizeof path, "%s/examples/%s", SOURCE_FOLDER, documents[i]);
        char *text = read_whole(path, &size);
        MatcDocument *document = open_text(path, text);
        wanted.path = path;
        for (wanted.material = 0; wanted.material < matc_material_count(document);
             wanted.material++)
            check_material(RIG, document, &mass, &wanted);
        matc_document_free(document);
        free(text);
    }
    print_message("positions within %.1e, normals within %.1e degrees\n", wanted.worst[0],
                  wanted.worst[1]);
}

static void from_body(CurvedBody body, Mass *mass)
{
    mass->space = space_flat();
    mass->space.world_from_local = mat4_identity();
    for (int i = 0; i < COUNT; i++) {
        Surface *s = &mass->surface[i];
        curved_surface(body, fmod(i * 0.61803398874989485, 1), (i + 0.5) / COUNT, s);
        const double *const from[] = {&s->root[channel_id(GROUP_P, 0)],
                                      &s->root[channel_id(GROUP_N, 0)],
                                      &s->root[channel_id(GROUP_U, 0)],
                                      &s->root[channel_id(GROUP_DU, 0)],
                                      &s->root[channel_id(GROUP_DV, 0)],
                                      s->normal_u,
                                      s->normal_v,
                                      s->tangent_slopes[0][0],
                                      s->tangent_slopes[0][1],
                                      s->tangent_slopes[1][1]};
        for (int k = 0; k < NAMES; k++)
            for (int component = 0; component < COMPONENTS; component++)
                mass->at[i][COMPONENTS * k + component] = (float)from[k][component];
    }
}

/* Kinds of displacement: heights, heights that keep the base's normals, vectors. */
typedef enum { HEIGHTS, HEIGHTS_STAYING, VECTORS, MOVED } Carried;

static double off_body(Rig *rig, CurvedBody body, Carried by)
{
    static Mass mass;
    static Result result;
    char text[300];
    double most = 0;
    const double scale = curved_radius[body] / 4;
    const Way way = {
        .flat = by == HEIGHTS_STAYING, .sections = true, .normals = true, .groups = {4, 1}};
    snprintf(text, sizeof text, "material: Phong\ndisplacement%s\ndisplacementScale: %g\n",
             by == VECTORS ? "Vector: " CURVED_VECTOR : ": " CURVED_HEIGHT, scale);
    MatcDocument *document = open_text("curved.yaml", text);
    from_body(body, &mass);
    for (int i = 0; i < COUNT && way.flat; i++)
        memset(&mass.at[i][COMPONENTS * 5], 0, 5 * COMPONENTS * sizeof(float));
    run(rig, &(Task){document, 0, &mass, &way}, &result);
    for (int i = 0; i < COUNT; i++) {
        double want[3], is[3] = {result.normal[i][0], result.normal[i][1], result.normal[i][2]};
        const double *place = &mass.surface[i].root[channel_id(GROUP_P, 0)];
        if (by == VECTORS)
            curved_vector_normal(body, scale, place, want);
        else
            curved_normal(body, scale, place, by == HEIGHTS_STAYING, want);
        most = fmax(most, curved_angle(is, want));
    }
    matc_document_free(document);
    return most;
}

static void normals_are_those_of_curved_bodies(void **state)
{
    double worst = 0;
    for (CurvedBody body = 0; body <= CURVED_twisted; body++)
        for (Carried by = 0; by < MOVED; by++)
            worst = fmax(worst, off_body(RIG, body, by));
    print_message("normals of curved bodies within %.1e degrees\n", worst);
    assert_true(worst < 2e-4);
}

static void who_has_none_says_so(void **state)
{
    (void)state;
    static const char text[] = "material: Phong\n";
    static const char *const cases[][2] = {
        {"glsl330", "gbuffer"}, {"essl300", "depth"}, {"glsl450", "plane"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcOptions options;
        matc_options_init(&options);
        options.target = cases[i][0];
        options.pass = cases[i][1];
        MatcDocument *document = matc_read("rock.yaml", text, strlen(text), &options);
        MatcProgram *program = matc_compile(document, 0, MATC_COMPUTE, &options);
        assert_true(!matc_ok(program) && strstr(matc_program_diagnostics(program, MATC_TEXT),
                                                "compute programs are not supported"));
        matc_program_free(program);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(vertices_are_the_oracles),
                                       cmocka_unit_test(normals_are_those_of_curved_bodies),
                                       cmocka_unit_test(who_has_none_says_so)};
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
