#include "runtime/mesh_import/obj_read.h"
#include "compiler/base/hash_index.h"
#include "compiler/base/memory.h"
#include "runtime/gl/message.h"
#include "runtime/mesh_import/model_text.h"
#include "runtime/mesh_import/obj_parse.h"
#include "runtime/mesh_import/polygon.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    ObjFile file;
    ModelParts *parts;
    Polygon polygon;
    HashIndex index;    /* triples of the current run */
    ObjCorner *triples; /* indexed by vertex */
    size_t vertex_capacity, color_capacity, triple_capacity, index_capacity;
    char *error;
    size_t capacity;
} Reader;

static uint32_t mix(uint32_t hash, int number)
{
    hash = (hash ^ (uint32_t)number) * 0x9E3779B1u;
    return hash ^ hash >> 15;
}

static bool is_outside(int index, size_t count)
{
    return index != OBJ_NONE && (size_t)index >= count;
}

/* Checks that all corners exist, which a file may list behind its faces. */
static bool check_corners(const Reader *r)
{
    const ObjFile *file = &r->file;
    for (size_t f = 0; f < file->face_count; f++)
        for (int i = 0; i < file->faces[f].count; i++) {
            const ObjCorner *corner = &file->corners[file->faces[f].first + (size_t)i];
            if (is_outside(corner->v, file->position_count) ||
                is_outside(corner->t, file->coordinate_count) ||
                is_outside(corner->n, file->normal_count))
                return message_fail(r->error, r->capacity,
                                    "line %d: a face names a corner that is not there",
                                    file->faces[f].line);
        }
    return true;
}

/* Copies a face's positions into the polygon. Returns its corners. */
static ObjCorner *gather(Reader *r, const ObjFace *face)
{
    ObjCorner *corners = &r->file.corners[face->first];
    polygon_reserve(&r->polygon, (size_t)face->count);
    for (int i = 0; i < face->count; i++)
        memcpy(r->polygon.points[i], r->file.positions[corners[i].v], sizeof *r->polygon.points);
    return corners;
}

/* Returns the normal of a position and a smoothing group, added at its first use. */
static int normal_of(Reader *r, HashIndex *index, ObjCorner **keys, size_t *capacity,
                     const ObjCorner *key)
{
    const uint32_t hash = mix(mix(0, key->v), key->t);
    HashProbe probe = hash_probe(index, hash);
    while (hash_probe_next(&probe))
        if ((*keys)[probe.number].v == key->v && (*keys)[probe.number].t == key->t)
            return (*keys)[probe.number].n;
    ObjFile *file = &r->file;
    file->normals = model_text_grow(file->normals, file->normal_count, &file->normal_capacity,
                                    sizeof *file->normals);
    memset(file->normals[file->normal_count], 0, sizeof *file->normals);
    *keys = model_text_grow(*keys, index->count, capacity, sizeof **keys);
    (*keys)[index->count] = (ObjCorner){key->v, key->t, (int)file->normal_count};
    hash_index_add(NULL, index, hash, index->count);
    return (int)file->normal_count++;
}

/* Returns a factor for areas that makes them independent of the mesh's size. */
static double unit_of(const ObjFile *file)
{
    double extent = 0;
    for (size_t i = 0; i < file->position_count; i++)
        for (int k = 0; k < 3; k++)
            extent = fmax(extent, fabs((double)file->positions[i][k] - file->positions[0][k]));
    return extent > 0 ? 1 / (extent * extent) : 1;
}

/* Adds normals for the corners that lack one. A flat face has a key of its own. */
static void make_normals(Reader *r)
{
    HashIndex index = {0};
    ObjCorner *keys = NULL;
    size_t capacity = 0;
    const double unit = unit_of(&r->file);
    for (size_t f = 0; f < r->file.face_count; f++) {
        const ObjFace *face = &r->file.faces[f];
        ObjCorner *corners = gather(r, face);
        double area[3] = {0};
        if (face->count > 2)
            polygon_area(&r->polygon, face->count, area);
        for (int i = 0; i < face->count; i++) {
            if (corners[i].n != OBJ_NONE)
                continue;
            const bool flat = face->smoothing == OBJ_FLAT;
            const ObjCorner key = {flat ? -2 - (int)f : corners[i].v, face->smoothing, 0};
            corners[i].n = normal_of(r, &index, &keys, &capacity, &key);
            for (int k = 0; k < 3; k++)
                r->file.normals[corners[i].n][k] += (float)(area[k] * unit);
        }
    }
    hash_index_free(&index);
    free(keys);
}

static void put_vertex(Reader *r, const ObjCorner *corner)
{
    Shape *shape = &r->parts->shape;
    const size_t to = (size_t)shape->vertex_count;
    shape->vertices =
        model_text_grow(shape->vertices, to, &r->vertex_capacity, sizeof *shape->vertices);
    ShapeVertex *vertex = &shape->vertices[to];
    *vertex = (ShapeVertex){0};
    memcpy(vertex->position, r->file.positions[corner->v], sizeof vertex->position);
    memcpy(vertex->normal, r->file.normals[corner->n], sizeof vertex->normal);
    if (corner->t != OBJ_NONE)
        memcpy(vertex->uv, r->file.coordinates[corner->t], sizeof vertex->uv);
    float(**colors)[4] = &shape->extra[SHAPE_EXTRA_color];
    if (r->file.has_colors) {
        *colors = model_text_grow(*colors, to, &r->color_capacity, sizeof **colors);
        memcpy((*colors)[to], r->file.colors[corner->v], sizeof **colors);
    }
    r->triples = model_text_grow(r->triples, to, &r->triple_capacity, sizeof *r->triples);
    r->triples[shape->vertex_count++] = *corner;
}

/* Returns the vertex of a corner, shared by equal corners of the run. */
static uint32_t vertex_of(Reader *r, const ObjCorner *corner)
{
    const uint32_t hash = mix(mix(mix(0, corner->v), corner->t), corner->n);
    HashProbe probe = hash_probe(&r->index, hash);
    while (hash_probe_next(&probe))
        if (!memcmp(&r->triples[probe.number], corner, sizeof *corner))
            return probe.number;
    hash_index_add(NULL, &r->index, hash, (uint32_t)r->parts->shape.vertex_count);
    put_vertex(r, corner);
    return (uint32_t)r->parts->shape.vertex_count - 1;
}

static bool is_full(const Reader *r, int corners)
{
    const Shape *shape = &r->parts->shape;
    return shape->vertex_count > MODEL_VERTICES - 3 || shape->index_count > MODEL_INDICES - corners;
}

/* Adds a triangle, unless two of its corners are one position. */
static bool add_triangle(Reader *r, const ObjCorner *corners, const int *triangle)
{
    Shape *shape = &r->parts->shape;
    const ObjCorner *a = &corners[triangle[0]], *b = &corners[triangle[1]],
                    *c = &corners[triangle[2]];
    if (a->v == b->v || b->v == c->v || c->v == a->v)
        return true;
    if (is_full(r, 3))
        return message_fail(r->error, r->capacity, "it has more than %d vertices or %d triangles",
                            MODEL_VERTICES, MODEL_INDICES / 3);
    for (int k = 0; k < 3; k++) {
        shape->indices = model_text_grow(shape->indices, (size_t)shape->index_count,
                                         &r->index_capacity, sizeof *shape->indices);
        shape->indices[shape->index_count++] = vertex_of(r, &corners[triangle[k]]);
    }
    return true;
}

static bool add_face(Reader *r, const ObjFace *face)
{
    if (face->count < 3)
        return true;
    const ObjCorner *corners = gather(r, face);
    if (!polygon_split(&r->polygon, face->count))
        return message_fail(r->error, r->capacity,
                            "line %d: faces that are not convex have too many corners", face->line);
    for (int i = 0; i + 2 < face->count; i++)
        if (!add_triangle(r, corners, &r->polygon.triangles[3 * i]))
            return false;
    return true;
}

/* Adds the faces with or without texture coordinates as a run. */
static bool add_run(Reader *r, bool has_coordinates)
{
    Shape *shape = &r->parts->shape;
    const int vertices = shape->vertex_count, indices = shape->index_count;
    for (size_t f = 0; f < r->file.face_count; f++)
        if (r->file.faces[f].has_coordinates == has_coordinates && !add_face(r, &r->file.faces[f]))
            return false;
    hash_index_free(&r->index);
    r->index = (HashIndex){0};
    if (shape->index_count > indices)
        r->parts->runs[r->parts->run_count++] =
            (ModelRun){.material = MODEL_NO_MATERIAL,
                       .index_count = shape->index_count - indices,
                       .vertex_count = shape->vertex_count - vertices,
                       .has_normals = true,
                       .has_coordinates = has_coordinates};
    return true;
}

static bool read_text(Reader *r, const char *text, size_t size)
{
    if (!obj_parse(text, size, &r->file))
        return message_fail(r->error, r->capacity, "line %d: %s", r->file.line, r->file.fault);
    if (!check_corners(r))
        return false;
    make_normals(r);
    r->parts->runs = memory_checked(calloc(2, sizeof *r->parts->runs));
    return add_run(r, true) && add_run(r, false);
}

bool obj_read(const ModelSource *source, ModelParts *parts, char *error, size_t capacity)
{
    size_t size;
    Reader r = {.parts = parts, .error = error, .capacity = capacity};
    *parts = (ModelParts){0};
    char *text = model_text_read(source, &size, error, capacity);
    const bool done = text && read_text(&r, text, size);
    obj_parse_free(&r.file);
    polygon_free(&r.polygon);
    hash_index_free(&r.index);
    free(r.triples);
    free(text);
    return done;
}
