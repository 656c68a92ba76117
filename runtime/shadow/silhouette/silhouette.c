/* Silhouette shadows: puts edges of meshes into a buffer, once; for each view, writes crossings
 * into an integer buffer, and from there into a texture. */
#include "gen/render_text.h"
#include "runtime/shadow/silhouette/silhouette.h"
#include "runtime/gpu_scene/instances.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/frame_graph/transparency_draw.h"
#include "runtime/gpu_scene/edge_list.h"
#include <stdlib.h>
#include <string.h>

enum {
    PLACES_BINDING = 1,
    EDGES_BINDING,
    EXTENTS_BINDING,
    GROUP = 64,
    SQUARE = 8,
    MAX_GROUPS = 65535
};
enum { MAX_EDGES = MAX_GROUPS * GROUP /* max edges of one dispatch */ };

int silhouette_layer(const Renderer *renderer, int view)
{
    int count = 0;
    for (int i = 0; i < view; i++)
        count += renderer->shadows->views.views[i].crossed;
    return count;
}

int silhouette_layers(const Renderer *renderer)
{
    return silhouette_layer(renderer, renderer->shadows->views.count);
}

/* -- edges of meshes */

static void put_edge(const MeshEdge *from, int face, SilhouetteEdge edge)
{
    memcpy(edge[0], from->ends[0], sizeof edge[0]);
    memcpy(edge[1], from->ends[1], sizeof edge[1]);
    memcpy(edge[2], from->apexes[face], sizeof edge[2]);
    memcpy(edge[3], from->apexes[from->open ? face : 1], sizeof edge[3]);
}

/* Stores a mesh's edges. An open edge is stored once for each face. If an edge has more than two
 * faces, the first and the last one are stored. */
static int put_edges(const EdgeMesh *mesh, SilhouetteEdge *edges)
{
    int count = 0;
    for (int i = 0; i < mesh->count; i++) {
        const MeshEdge *edge = &mesh->edges[i];
        put_edge(edge, 0, edges[count++]);
        if (edge->open && memcmp(edge->apexes[0], edge->apexes[1], sizeof edge->apexes[0]) != 0)
            put_edge(edge, 1, edges[count++]);
    }
    return count;
}

/* Appends a mesh's edges. */
static bool add_mesh(Silhouettes *made, const EdgeMesh *mesh, int number, SilhouetteEdge **edges)
{
    const size_t most = (size_t)made->edge_count + 2 * (size_t)mesh->count;
    SilhouetteEdge *grown = most <= MAX_EDGES ? realloc(*edges, most * sizeof *grown + 1) : NULL;
    if (!grown)
        return false;
    *edges = grown;
    made->meshes[number] =
        (SilhouetteMesh){made->edge_count, put_edges(mesh, grown + made->edge_count)};
    made->edge_count += made->meshes[number].count;
    return true;
}

static bool gather_edges(const Renderer *renderer, Silhouettes *made, SilhouetteEdge **edges)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    bool fine = true;
    for (int i = 0; fine && i < gpu_scene->place_count && !gpu_scene->places[i].transparent; i++) {
        const GpuScenePlace *place = &gpu_scene->places[i];
        EdgeMesh mesh;
        if (made->meshes[place->mesh].count)
            continue;
        fine = edge_list_mesh(renderer->scene, &renderer->scene->objects[place->object], &mesh);
        if (fine) {
            fine = add_mesh(made, &mesh, place->mesh, edges);
            edge_mesh_free(&mesh);
        }
    }
    return fine;
}

/* -- resources */

static GLuint make_buffer(Renderer *renderer, const void *from, size_t bytes)
{
    const GlContext *gl = renderer->gl;
    GLuint buffer = 0;
    if (bytes > transparency_most_bytes(renderer)) {
        gl_fail(renderer->gl,
                "shadows: silhouette takes %lu bytes in a buffer, and there may be %lu",
                (unsigned long)bytes, (unsigned long)transparency_most_bytes(renderer));
        return 0;
    }
    gl->GenBuffers(1, &buffer);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)bytes, from, GL_STATIC_DRAW);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    return buffer;
}

static bool make_edges(Renderer *renderer, Silhouettes *made)
{
    SilhouetteEdge *edges = NULL;
    made->meshes = calloc((size_t)renderer->gpu_scene.mesh_count + 1, sizeof *made->meshes);
    if (!made->meshes || !gather_edges(renderer, made, &edges)) {
        free(edges);
        return gl_fail(renderer->gl, "out of memory, or more than %d edges for shadows: silhouette",
                       (int)MAX_EDGES);
    }
    made->edges = make_buffer(renderer, edges, (size_t)made->edge_count * sizeof *edges + 1);
    free(edges);
    return made->edges != 0;
}

static size_t extents_bytes(const Renderer *renderer)
{
    const size_t size = (size_t)renderer->scene->shadow_size;
    return size * size * 2 * sizeof(GLuint);
}

static bool make_textures(Renderer *renderer, Silhouettes *made)
{
    const GlContext *gl = renderer->gl;
    const int size = renderer->scene->shadow_size;
    gl->GenTextures(1, &made->crossings);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, made->crossings);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    gl->TexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RG8, size, size, silhouette_layers(renderer), 0,
                   GL_RG, GL_UNSIGNED_BYTE, NULL);
    made->extents = make_buffer(renderer, NULL, extents_bytes(renderer));
    gl->GenBuffers(1, &made->places);
    return made->extents && gl_check(renderer->gl, "making crossings of silhouettes");
}

bool silhouette_make(Renderer *renderer)
{
    static const char head[] = "#version 450 core\n";
    Silhouettes *made = silhouette_state(renderer);
    if (!silhouette_layers(renderer))
        return true;
    if (!renderer->gpu_scene.instances || !renderer->gl->DispatchCompute)
        return gl_fail(renderer->gl,
                       "shadows: silhouette takes OpenGL 4.5, and the driver has %d.%d",
                       renderer->gl->major, renderer->gl->minor);
    return make_edges(renderer, made) && make_textures(renderer, made) &&
           material_make(renderer->store, NULL,
                         &(ProgramText){.compute = {head, render_text_silhouette_find}},
                         &made->find) &&
           material_make(renderer->store, NULL,
                         &(ProgramText){.compute = {head, render_text_silhouette_pack}},
                         &made->pack);
}

void silhouette_delete(Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    Silhouettes *made = silhouette_state(renderer);
    gl->DeleteTextures(1, &made->crossings); /* GL ignores the name 0 */
    gl->DeleteBuffers(3, (GLuint[]){made->extents, made->edges, made->places});
    free(made->meshes);
    if (made->find.store)
        material_delete(&made->find);
    if (made->pack.store)
        material_delete(&made->pack);
    *made = (Silhouettes){.crossings = 0};
}

/* -- a view */

/* Sets a matrix whose columns are the three rows, and (near, the map's size, its number). */
static void set_view(const Renderer *renderer, int number, Material *material)
{
    const ShadowView *view = &renderer->shadows->views.views[number];
    float m[16] = {0};
    for (int i = 0; i < 12; i++)
        m[i] = (float)view->rows[i / 4][i % 4];
    m[12] = (float)view->near;
    m[13] = (float)renderer->scene->shadow_size;
    m[14] = (float)number;
    material_set(material, &(MaterialValue){"silhouette_view", 16, m});
}

/* Lists the opaque objects in a view, sorted by mesh, those drawn by depth only first. Returns
 * their number. */
static int list_places(Renderer *renderer, const ShadowView *view)
{
    GpuScene *gpu_scene = &renderer->gpu_scene;
    const GlContext *gl = renderer->gl;
    const CullVolume volume = shadow_views_volume(view);
    uint32_t *list =
        gpu_scene->list + (size_t)(GPU_SCENE_LISTS - 1) * (size_t)gpu_scene->place_count;
    int count = 0;
    for (int i = 0; i < gpu_scene->cast_count; i++) {
        const GpuScenePlace *place = &gpu_scene->places[gpu_scene->cast_order[i]];
        if (!place->transparent &&
            cull_sees(&volume, &gpu_scene->boxes[place->mesh],
                      &renderer->scene->objects[place->object].world_from_local))
            list[count++] = gpu_scene->cast_order[i];
    }
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, silhouette_state(renderer)->places);
    gl->BufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)sizeof *list * count, list,
                   GL_DYNAMIC_DRAW);
    gl->BindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    return count;
}

static void find_of_mesh(Renderer *renderer, const SilhouetteMesh *mesh, int first, int count)
{
    Silhouettes *made = silhouette_state(renderer);
    const GLuint groups = ((GLuint)mesh->count + GROUP - 1) / GROUP;
    for (int done = 0; groups && done < count; done += MAX_GROUPS) {
        const int next = count - done < MAX_GROUPS ? count - done : MAX_GROUPS;
        const float run[3] = {(float)mesh->first, (float)mesh->count, (float)(first + done)};
        material_set(&made->find, &(MaterialValue){"silhouette_run", 3, run});
        material_use(&made->find);
        renderer->gl->DispatchCompute(groups, (GLuint)next, 1);
    }
}

static void bind(const Renderer *renderer)
{
    const GlContext *gl = renderer->gl;
    const Silhouettes *made = silhouette_state(renderer);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D_ARRAY, renderer->shadows->maps);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, INSTANCE_MATRICES, renderer->gpu_scene.matrices);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, PLACES_BINDING, made->places);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, EDGES_BINDING, made->edges);
    gl->BindBufferBase(GL_SHADER_STORAGE_BUFFER, EXTENTS_BINDING, made->extents);
    gl->ClearBufferSubData(GL_SHADER_STORAGE_BUFFER, GL_R32UI, 0,
                           (GLsizeiptr)extents_bytes(renderer), GL_RED_INTEGER, GL_UNSIGNED_INT,
                           (GLuint[]){0});
}

static void pack(Renderer *renderer, int layer)
{
    const GlContext *gl = renderer->gl;
    Silhouettes *made = silhouette_state(renderer);
    const GLuint groups = ((GLuint)renderer->scene->shadow_size + SQUARE - 1) / SQUARE;
    gl->MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    material_use(&made->pack);
    gl->BindImageTexture(0, made->crossings, 0, GL_FALSE, layer, GL_WRITE_ONLY, GL_RG8);
    gl->DispatchCompute(groups, groups, 1);
    gl->MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

static void find_in_view(Renderer *renderer, int number, int layer)
{
    const GpuScene *gpu_scene = &renderer->gpu_scene;
    Silhouettes *made = silhouette_state(renderer);
    const int count = list_places(renderer, &renderer->shadows->views.views[number]);
    const uint32_t *list =
        gpu_scene->list + (size_t)(GPU_SCENE_LISTS - 1) * (size_t)gpu_scene->place_count;
    set_view(renderer, number, &made->find);
    set_view(renderer, number, &made->pack);
    bind(renderer);
    for (int first = 0, end; first < count; first = end) {
        const int mesh = gpu_scene->places[list[first]].mesh;
        for (end = first + 1; end < count && gpu_scene->places[list[end]].mesh == mesh;)
            end++;
        find_of_mesh(renderer, &made->meshes[mesh], first, end - first);
    }
    pack(renderer, layer);
}

void silhouette_find(Renderer *renderer)
{
    for (int i = 0, layer = 0; i < renderer->shadows->views.count; i++)
        if (renderer->shadows->views.views[i].crossed)
            find_in_view(renderer, i, layer++);
}
