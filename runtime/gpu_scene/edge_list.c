/* Objects of equal solids share their edges. Silhouettes are found with the eye in each object's
 * local space; visible edges are projected into the picture. */
#include "runtime/gpu_scene/edge_list.h"
#include "compiler/base/hash.h"
#include "compiler/base/hash_index.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/tessellate/scene_solid.h"
#include <math.h>
#include <stdlib.h>

typedef struct {
    const Scene *scene;
    const ViewSpace *space;
    const int *size;
    double pixels; /* pixels per unit of the ray's x and y */
    HashIndex solids;
    Key *keys;
    EdgeMesh *meshes;
    int mesh_count;
    EdgeList *made;
    float crease; /* value of EdgeEnd.crease for added lines */
    bool fine;
} EdgeLister;

static bool is_orthographic(const EdgeLister *l)
{
    return l->scene->camera.kind == SCENE_Orthographic;
}

/* -- lines of the picture */

static void push(EdgeLister *l, const double from[3], const double to[3])
{
    EdgeList *list = l->made;
    if (list->count == list->capacity) {
        const int capacity = list->capacity ? 2 * list->capacity : 256;
        void *more = realloc(list->lines, (size_t)capacity * sizeof *list->lines);
        if (!more) {
            l->fine = false;
            return;
        }
        list->lines = more;
        list->capacity = capacity;
    }
    EdgeEnd *line = list->lines[list->count++];
    line[0] = (EdgeEnd){(float)from[0], (float)from[1], (float)from[2], l->crease};
    line[1] = (EdgeEnd){(float)to[0], (float)to[1], (float)to[2], l->crease};
}

/* Returns the part of a segment from parameter s to t. */
static void part_of(const double from[3], const double to[3], const double st[2], double part[2][3])
{
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++)
            part[k][i] = from[i] + st[k] * (to[i] - from[i]);
}

/* Clips the parameters [s, t] to low <= from + u (to - from) <= high. Returns false if none are
 * left. */
static bool clip(double from, double to, const double range[2], double st[2])
{
    const double step = to - from;
    if (step == 0)
        return from >= range[0] && from <= range[1];
    const double u[2] = {(range[step > 0 ? 0 : 1] - from) / step,
                         (range[step > 0 ? 1 : 0] - from) / step};
    st[0] = fmax(st[0], u[0]);
    st[1] = fmin(st[1], u[1]);
    return st[0] < st[1];
}

/* Adds a line of the picture, clipped to one pixel around the picture, in pieces. */
static void add_line(EdgeLister *l, const double from[3], const double to[3])
{
    double st[2] = {0, 1}, part[2][3], piece[2][3];
    for (int i = 0; i < 2; i++)
        if (!clip(from[i], to[i], (const double[]){-1, l->size[i] + 1.0}, st))
            return;
    part_of(from, to, st, part);
    const double longer = fmax(fabs(part[1][0] - part[0][0]), fabs(part[1][1] - part[0][1]));
    const int pieces = (int)ceil(longer / EDGE_LIST_PIECE);
    for (int i = 0; i < pieces; i++) {
        part_of(part[0], part[1], (const double[]){(double)i / pieces, (double)(i + 1) / pieces},
                piece);
        push(l, piece[0], piece[1]);
    }
}

/* -- projection */

/* Projects an eye-space point to x and y in pixels, and depth. */
static void project(const EdgeLister *l, const double at[3], double out[3])
{
    const SceneCamera *camera = &l->scene->camera;
    const double w = is_orthographic(l) ? 1 : -at[2];
    for (int i = 0; i < 2; i++)
        out[i] = at[i] / w * l->pixels + l->size[i] * 0.5;
    out[2] = is_orthographic(l) ? 1 + at[2] / camera->depth : camera->near / w;
}

static void add_edge(EdgeLister *l, double from[3], double to[3])
{
    const SceneCamera *camera = &l->scene->camera;
    double st[2] = {0, 1}, part[2][3], seen[2][3];
    const double near = is_orthographic(l) ? 0 : -camera->near,
                 far = is_orthographic(l) ? -camera->depth : -INFINITY;
    if (!clip(from[2], to[2], (const double[]){far, near}, st))
        return;
    part_of(from, to, st, part);
    for (int k = 0; k < 2; k++)
        project(l, part[k], seen[k]);
    add_line(l, seen[0], seen[1]);
}

/* -- objects */

static void transform(const double m[16], const double v[3], double out[3])
{
    for (int i = 0; i < 3; i++)
        out[i] = m[i] * v[0] + m[4 + i] * v[1] + m[8 + i] * v[2] + m[12 + i];
}

/* Computes the eye's position in local space, or the direction to it if orthographic. By
 * Cramer's rule; a negative determinant flips all faces alike, which does not matter. */
static void eye_of(const EdgeLister *l, const SceneMatrix *m, double eye[3])
{
    const SceneCamera *camera = &l->scene->camera;
    const double determinant = scene_matrix_determinant(m);
    double cross[3], way[3];
    for (int i = 0; i < 3; i++)
        way[i] = is_orthographic(l) ? camera->back[i] : camera->position[i] - m->m[12 + i];
    for (int i = 0; i < 3; i++) {
        vec3_cross(m->m + 4 * ((i + 1) % 3), m->m + 4 * ((i + 2) % 3), cross);
        eye[i] = vec3_dot(way, cross) / determinant;
    }
}

/* Reports whether a silhouette is concave. Concave silhouettes of a solid are hidden from
 * outside: the back face is nearer than the front face, and a part of the solid before both. */
static bool is_concave(const MeshEdge *edge, int front)
{
    double before = 0;
    for (int i = 0; i < 3; i++)
        before += (double)edge->normals[front][i] *
                  ((double)edge->apexes[!front][i] - (double)edge->ends[0][i]);
    return before > 0;
}

/* Reports whether the eye is outside the solid's bounding box, so that only front faces are
 * visible. */
static bool sees_fronts(const EdgeLister *l, const EdgeMesh *mesh, const double eye[3])
{
    bool outside = is_orthographic(l);
    for (int i = 0; i < 3; i++)
        outside |= eye[i] < mesh->low[i] || eye[i] > mesh->high[i];
    return mesh->solid && outside;
}

/* Reports whether an edge is a silhouette; with `fronts` back faces are invisible. */
static bool is_outline(const EdgeLister *l, const MeshEdge *edge, const double eye[3], bool fronts)
{
    double facing[2] = {0};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++)
            facing[k] +=
                edge->normals[k][i] * (eye[i] - (is_orthographic(l) ? 0 : edge->ends[0][i]));
    return (facing[0] > 0) != (facing[1] > 0) && !(fronts && is_concave(edge, facing[1] > 0));
}

static void add_solid(EdgeLister *l, const SceneObject *object, const EdgeMesh *mesh)
{
    double eye[3], world[3], ends[2][3];
    eye_of(l, &object->world_from_local, eye);
    const bool fronts = sees_fronts(l, mesh, eye);
    for (int i = 0; i < mesh->count && l->fine; i++) {
        const MeshEdge *edge = &mesh->edges[i];
        const bool outline = edge->open || is_outline(l, edge, eye, fronts);
        if (!outline && !edge->crease)
            continue;
        l->crease = !outline;
        for (int k = 0; k < 2; k++) {
            transform(object->world_from_local.m,
                      (const double[]){edge->ends[k][0], edge->ends[k][1], edge->ends[k][2]},
                      world);
            transform(l->space->eye_from_world, world, ends[k]);
        }
        add_edge(l, ends[0], ends[1]);
    }
}

/* Adds the horizon of a plane, the rays (X, Y, -1) parallel to it: n.x X + n.y Y = n.z, n the
 * normal in eye space. The depth there is 0. */
static void add_horizon(EdgeLister *l, const SceneObject *object)
{
    const double *m = object->world_from_local.m, *e = l->space->eye_from_world;
    double world[3], n[3];
    vec3_cross(m, m + 4, world);
    vec3_normalize(world);
    for (int i = 0; i < 3; i++)
        n[i] = e[i] * world[0] + e[4 + i] * world[1] + e[8 + i] * world[2];
    const double square = n[0] * n[0] + n[1] * n[1], reach = 2.0 * (l->size[0] + l->size[1]);
    if (square < 1e-18)
        return; /* a circle viewed along its normal has no horizon */
    l->crease = 0;
    double ends[2][3] = {{0}};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 2; i++) {
            const double along = (i ? n[0] : -n[1]) / sqrt(square) * (k ? reach : -reach);
            ends[k][i] = n[i] * n[2] / square * l->pixels + l->size[i] * 0.5 + along;
        }
    add_line(l, ends[0], ends[1]);
}

bool edge_list_mesh(const Scene *scene, const SceneObject *object, EdgeMesh *made)
{
    Shape shape;
    if (object->kind == SCENE_Mesh)
        return edge_mesh_make(&scene->meshes[object->mesh].shape, made);
    if (!scene_solid(object, &shape))
        return false;
    const bool done = edge_mesh_make(&shape, made);
    shape_free(&shape);
    return done;
}

/* Returns the edges of an object; NULL if memory runs out. */
static const EdgeMesh *mesh_of(EdgeLister *l, const SceneObject *object)
{
    const Key key = scene_solid_key(object);
    HashProbe probe = hash_probe(&l->solids, (uint32_t)key.low);
    while (hash_probe_next(&probe))
        if (key_equal(l->keys[probe.number], key))
            return &l->meshes[probe.number];
    if (!edge_list_mesh(l->scene, object, &l->meshes[l->mesh_count]))
        return NULL;
    l->keys[l->mesh_count] = key;
    hash_index_add(NULL, &l->solids, (uint32_t)key.low, (uint32_t)l->mesh_count);
    return &l->meshes[l->mesh_count++];
}

static void add_objects(EdgeLister *l)
{
    for (int i = 0; i < l->scene->object_count && l->fine; i++) {
        const SceneObject *object = &l->scene->objects[i];
        if (object->hidden)
            continue;
        const bool plane = object->kind == SCENE_Plane;
        const EdgeMesh *mesh = plane ? NULL : mesh_of(l, object);
        l->fine = plane || mesh;
        if (mesh)
            add_solid(l, object, mesh);
        else if (plane && !is_orthographic(l))
            add_horizon(l, object);
    }
}

bool edge_list_make(const Scene *scene, const ViewSpace *space, const int size[2], EdgeList *made)
{
    const size_t count = (size_t)scene->object_count + 1;
    const int shorter = size[0] < size[1] ? size[0] : size[1];
    EdgeLister l = {.scene = scene,
                    .space = space,
                    .size = size,
                    .pixels = shorter / (2 * scene->camera.half),
                    .keys = calloc(count, sizeof *l.keys),
                    .meshes = calloc(count, sizeof *l.meshes),
                    .made = made};
    *made = (EdgeList){0};
    l.fine = l.keys && l.meshes;
    if (l.fine)
        add_objects(&l);
    for (int i = 0; i < l.mesh_count; i++)
        edge_mesh_free(&l.meshes[i]);
    hash_index_free(&l.solids);
    free(l.keys);
    free(l.meshes);
    if (!l.fine)
        edge_list_free(made);
    return l.fine;
}

void edge_list_free(EdgeList *list)
{
    free(list->lines);
    *list = (EdgeList){0};
}
