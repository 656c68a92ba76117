/* The G-buffer programs of matc, with outputs turned into variables and followed by the
 * renderer's own surface model. Their layout stores every slot as unchanged floats, so packing
 * and unpacking cost nothing. A fragment program is
 *
 *   #version 450 core
 *   #define main surfaceMain
 *   ...                        matc's text; `uvec4 fragment0;` without its layout qualifier and
 *   `out`
 *   #undef main
 *   ...                        unpackTexels, surfaceLobe
 *   #define FORWARD_TEXELS fragment0, fragment1, fragment2
 *   ...                        main() below */
#include "render_forward.h"
#include "runtime/gpu_scene/view_space.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "runtime/tessellate/scene_solid.h"
#include "runtime/surface/surface_model.h"
#include <stdlib.h>
#include <string.h>

enum {
    MAX_LIGHTS = 1024,
    LIGHT_FLOATS = 8,
    LIGHTS_BYTES = MAX_LIGHTS * LIGHT_FLOATS * (int)sizeof(float)
};

static const char layout_text[] =
    "layout: forward\ntargets: [RGBA32UI, RGBA32UI, RGBA32UI, RGBA32UI]\nfields:\n"
    "- { slot: normal, encoding: full }\n- { slot: shininess, encoding: full }\n"
    "- { slot: diffuse, encoding: full }\n- { slot: specular, encoding: full }\n"
    "- { slot: ambient, encoding: full }\n";

static const char head[] = "#version 450 core\n#define main surfaceMain\n";
static const char tail[] =
    "#define FORWARD_TEXELS fragment0, fragment1, fragment2, fragment3\n"
    "layout(std140) uniform Forward {\n"
    "    vec4 forward_ray, forward_view, forward_ambient;\n"
    "    ivec4 forward_count;\n"
    "};\n"
    "layout(std140) uniform ForwardLights { vec4 forward_lights[2 * 1024]; };\n"
    "layout(location = 0) out vec4 forward_light;\n"
    "void main()\n"
    "{\n"
    "    surfaceMain();\n"
    "    vec3 point = vec3((2.0 * gl_FragCoord.xy - forward_ray.zw) * forward_ray.xy, -1.0) * "
    "(forward_view.x / "
    "gl_FragCoord.z);\n"
    "    Lit m = surfaceLit(unpackTexels(FORWARD_TEXELS), -normalize(point));\n"
    "    vec3 sum = surfaceOwn(m) + surfaceAmbient(m, forward_ambient.xyz);\n"
    "    for (int i = 0; i < forward_count.x; i++) {\n"
    "        vec4 place = forward_lights[2 * i];\n"
    "        vec3 way = place.xyz - place.w * point;\n"
    "        float square = max(dot(way, way), 1e-30);\n"
    "        sum += forward_lights[2 * i + 1].xyz / (place.w > 0.0 ? square : 1.0) *\n"
    "            surfaceLobe(m, way * inversesqrt(square));\n"
    "    }\n"
    "    forward_light = vec4(sum, 1.0);\n"
    "}\n";

/* The block Forward. */
typedef struct {
    float ray[4], view[4], ambient[4];
    int count[4];
} ForwardBlock;

struct Forward {
    GlContext *gl;
    const Scene *scene;
    Store *store;
    MatcLayout *layout;
    MatcOptions compile;
    ViewSpace space;
    Framebuffer target;
    ForwardBlock block;
    float *lights;       /* the block ForwardLights */
    Material *materials; /* for each material of the scene */
    Mesh *meshes;        /* for each object; equal meshes are shared */
    int *mesh_of;
};

/* Turns outputs into variables by removing `layout(location = 0) out `. */
static void make_variables(char *text)
{
    static const char begin[] = "layout(location = ", out[] = " out ";
    for (char *at = strstr(text, begin); at; at = strstr(at + 1, begin)) {
        char *word = strchr(at, ')');
        if (word && !strncmp(word + 1, out, sizeof out - 1))
            memset(at, ' ', (size_t)(word - at) + sizeof out);
    }
}

static char *variables_of(const char *text)
{
    const char *body = strchr(text, '\n') + 1; /* text after the #version line */
    char *copy = malloc(strlen(body) + 1);
    if (copy)
        make_variables(strcpy(copy, body));
    return copy;
}

static bool make_material(Forward *f, int number)
{
    const SceneMaterial *of = &f->scene->materials[number];
    MatcProgram *program = matc_compile(of->document, of->index,
                                        MATC_FRAGMENT | MATC_VERTEX | MATC_UNPACK, &f->compile);
    char *text = matc_ok(program) ? variables_of(matc_output(program, MATC_FRAGMENT, NULL)) : NULL;
    bool fine = text != NULL || gl_fail(f->gl, "%s", matc_program_diagnostics(program, MATC_TEXT));
    if (fine) {
        const ProgramText own = {.fragment = {head, text, "#undef main\n",
                                              matc_output(program, MATC_UNPACK, NULL),
                                              surface_model_phong.text, tail}};
        fine = material_make(f->store, program, &own, &f->materials[number]) &&
               material_write(&f->materials[number], "Forward", &f->block, sizeof f->block) &&
               material_write(&f->materials[number], "ForwardLights", f->lights, LIGHTS_BYTES);
    }
    free(text);
    matc_program_free(program);
    return fine;
}

static bool is_alike(const SceneObject *a, const SceneObject *b)
{
    return a->kind == b->kind && !memcmp(a->numbers, b->numbers, sizeof a->numbers);
}

/* Solids of the same kind and numbers share a mesh; few differ. */
static bool make_mesh(Forward *f, int object)
{
    const SceneObject *objects = f->scene->objects;
    Shape shape;
    for (int k = 0; k < object; k++)
        if (f->meshes[k].array && is_alike(&objects[k], &objects[object]))
            return f->mesh_of[object] = k, true;
    f->mesh_of[object] = object;
    if (!scene_solid(&objects[object], &shape))
        return gl_fail(f->gl, "out of memory");
    const bool fine = mesh_make_of(f->gl, &shape, &f->meshes[object]);
    shape_free(&shape);
    return fine;
}

/* Position of a light, or the direction to a directional one, in eye space, with w 1 or 0; its
 * light. */
static void put_light(const Forward *f, const SceneLight *light, float *to)
{
    const double *m = f->space.eye_from_world;
    const bool near = light->kind == SCENE_Point;
    for (int row = 0; row < 3; row++) {
        double sum = near ? m[12 + row] : 0;
        for (int k = 0; k < 3; k++)
            sum += m[4 * k + row] * (near ? light->position[k] : -light->direction[k]);
        to[row] = (float)sum;
        to[4 + row] = (float)light->light[row];
    }
    to[3] = near;
}

static bool make_blocks(Forward *f)
{
    ForwardBlock *block = &f->block;
    float around[VIEW_SPACE_AROUND][4];
    if (f->scene->light_count > MAX_LIGHTS)
        return gl_fail(f->gl, "the forward renderer has room for %d lights", MAX_LIGHTS);
    f->lights = calloc(1, LIGHTS_BYTES);
    if (!f->lights)
        return gl_fail(f->gl, "out of memory");
    for (int i = 0; i < f->scene->light_count; i++)
        if (light_from(&f->scene->lights[i]) != LIGHT_FROM_around)
            put_light(f, &f->scene->lights[i], f->lights + LIGHT_FLOATS * block->count[0]++);
    for (int k = 0; light_kind_table[k]; k++)
        if (view_space_around(&f->space, f->scene, light_kind_table[k], around))
            memcpy(block->ambient, around[1], sizeof block->ambient);
    memcpy(block->ray, f->space.ray, sizeof f->space.ray);
    memcpy(block->view, f->space.depth, sizeof f->space.depth);
    return true;
}

static bool choose_layout(Forward *f)
{
    f->compile.layout = NULL;
    f->compile.pass = "gbuffer";
    f->compile.target = "glsl450";
    f->compile.validate = false; /* the driver validates */
    f->layout = matc_layout_read("forward.yaml", layout_text, sizeof layout_text - 1, &f->compile);
    f->compile.custom = f->layout;
    return matc_layout_ok(f->layout) ||
           gl_fail(f->gl, "%s", matc_layout_diagnostics(f->layout, MATC_TEXT));
}

static bool make(Forward *f)
{
    const int size[2] = {f->target.spec.width, f->target.spec.height}, none[2] = {0, 0};
    const FramebufferSpec spec = {size[0], size[1], 1, GL_RGBA16F, true};
    const size_t objects = (size_t)f->scene->object_count;
    view_space_make(&f->scene->camera, size, true, &f->space);
    view_space_place(&f->space, size, none);
    f->store = store_new(f->gl);
    f->materials = calloc((size_t)f->scene->material_count, sizeof *f->materials);
    f->meshes = calloc(objects, sizeof *f->meshes);
    f->mesh_of = calloc(objects, sizeof *f->mesh_of);
    if (!f->store || !f->materials || !f->meshes || !f->mesh_of)
        return gl_fail(f->gl, "out of memory");
    bool fine = framebuffer_make(f->gl, &spec, &f->target) && choose_layout(f) && make_blocks(f);
    for (int i = 0; fine && i < f->scene->material_count; i++)
        fine = make_material(f, i);
    for (int i = 0; fine && i < f->scene->object_count; i++)
        fine = make_mesh(f, i);
    return fine;
}

Forward *forward_open(GlContext *gl, const ForwardSource *source)
{
    Forward *forward = calloc(1, sizeof *forward);
    if (!forward)
        return gl_fail(gl, "out of memory"), NULL;
    *forward = (Forward){.gl = gl, .scene = source->scene, .compile = *source->compile};
    forward->target.spec.width = source->width;
    forward->target.spec.height = source->height;
    if (make(forward))
        return forward;
    forward_close(forward);
    return NULL;
}

void forward_close(Forward *f)
{
    if (!f)
        return;
    for (int i = 0; f->materials && i < f->scene->material_count; i++)
        if (f->materials[i].store)
            material_delete(&f->materials[i]);
    for (int i = 0; f->meshes && i < f->scene->object_count; i++)
        mesh_delete(f->gl, &f->meshes[i]);
    framebuffer_delete(f->gl, &f->target);
    matc_layout_free(f->layout);
    store_free(f->store);
    free(f->materials);
    free(f->meshes);
    free(f->mesh_of);
    free(f->lights);
    free(f);
}

static void draw_object(Forward *f, int number)
{
    const SceneObject *object = &f->scene->objects[number];
    Material *material = &f->materials[object->material];
    Spaces spaces = f->space.spaces;
    for (int i = 0; i < 16; i++)
        spaces.world_from_local.m[i] = (float)object->world_from_local.m[i];
    spaces_set(&spaces, material);
    material_use(material);
    mesh_draw(f->gl, &f->meshes[f->mesh_of[number]]);
}

void forward_draw(Forward *f)
{
    static const float nothing[4];
    GlContext *gl = f->gl;
    framebuffer_use(gl, &f->target);
    gl->ClearBufferfv(GL_COLOR, 0, nothing);
    gl->ClearBufferfv(GL_DEPTH, 0, nothing);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_GREATER);
    gl->ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    for (int i = 0; i < f->scene->object_count; i++)
        draw_object(f, i);
    gl->ClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    gl->DepthFunc(GL_LESS);
    gl->Disable(GL_DEPTH_TEST);
}

bool forward_read(Forward *f, float *rgba) { return framebuffer_read(f->gl, &f->target, 0, rgba); }
