#include "runtime/mesh_import/ply_read.h"
#include "compiler/base/memory.h"
#include "runtime/gl/message.h"
#include "runtime/mesh_import/model_join.h"
#include "runtime/mesh_import/model_text.h"
#include "runtime/mesh_import/ply_header.h"
#include "runtime/mesh_import/polygon.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROLES = 12, COLOR = 8 };

typedef struct {
    PlyHeader header;
    ModelParts *parts;
    ModelJoin join;
    Polygon polygon;
    const char *text, *at, *end;
    int64_t *list; /* indices of the current face */
    size_t list_capacity, index_capacity;
    bool has[ROLES];
    int vertices; /* vertices of the file, before equal ones are welded */
    char *error;
    size_t capacity;
} Reader;

/* Reports a fault at the current place: a line of a text, else a byte. */
static bool fail(const Reader *r, const char *why)
{
    size_t line = 1;
    if (r->header.format != PLY_ascii)
        return message_fail(r->error, r->capacity, "byte %zu: %s", (size_t)(r->at - r->text), why);
    for (const char *at = r->text; at < r->at; at++)
        line += *at == '\n';
    return message_fail(r->error, r->capacity, "line %zu: %s", line, why);
}

static double decode(PlyType type, uint64_t bits)
{
    const uint32_t word = (uint32_t)bits;
    float single;
    double real;
    memcpy(&single, &word, sizeof single);
    memcpy(&real, &bits, sizeof real);
    switch (type) {
    case PLY_char:
        return (int8_t)bits;
    case PLY_short:
        return (int16_t)bits;
    case PLY_int:
        return (int32_t)bits;
    case PLY_float:
        return single;
    case PLY_double:
        return real;
    default:
        return (double)bits;
    }
}

static bool read_value(Reader *r, PlyType type, double *value)
{
    const size_t size = ply_header_size(type);
    uint64_t bits = 0;
    if (r->header.format == PLY_ascii) {
        r->at += strspn(r->at, " \t\r\n");
        return model_text_number(&r->at, value) || fail(r, "a number is expected");
    }
    if ((size_t)(r->end - r->at) < size)
        return fail(r, "the file ends too early");
    for (size_t i = 0; i < size; i++)
        bits |= (uint64_t)(unsigned char)r->at[r->header.format == PLY_big ? size - 1 - i : i]
                << 8 * i;
    r->at += size;
    *value = decode(type, bits);
    return true;
}

/* Maps colors stored as integers to [0, 1]. */
static double scale_of(PlyType type, int role)
{
    return role < COLOR ? 1 : type == PLY_uchar ? 255 : type == PLY_ushort ? 65535 : 1;
}

/* Reads a list into r->list. */
static bool read_list(Reader *r, const PlyProperty *property, int *count)
{
    double number, value;
    if (!read_value(r, property->count, &number))
        return false;
    if (!(number >= 0 && number <= (double)(r->end - r->at)))
        return fail(r, "a list is longer than the file");
    *count = (int)number;
    for (int i = 0; i < *count; i++) {
        if (!read_value(r, property->type, &value))
            return false;
        r->list = model_text_grow(r->list, (size_t)i, &r->list_capacity, sizeof *r->list);
        r->list[i] = fabs(value) < 1e15 ? (int64_t)value : INT64_MAX;
    }
    return true;
}

static float as_float(double value) { return isfinite((float)value) ? (float)value + 0.f : 0; }

static bool put_vertex(Reader *r, const double *values)
{
    Shape *shape = r->join.shape;
    ShapeVertex *vertex = &shape->vertices[shape->vertex_count];
    *vertex = (ShapeVertex){0};
    for (int k = 0; k < 3; k++) {
        vertex->position[k] = (float)values[k] + 0.f;
        vertex->normal[k] = as_float(values[3 + k]);
    }
    vertex->uv[0] = (float)values[6] + 0.f, vertex->uv[1] = (float)values[7] + 0.f;
    if (shape->extra[SHAPE_EXTRA_color])
        for (int k = 0; k < 4; k++)
            shape->extra[SHAPE_EXTRA_color][shape->vertex_count][k] = as_float(values[COLOR + k]);
    return model_join_add(&r->join, (unsigned)r->vertices++) || fail(r, "it has too many vertices");
}

static bool read_vertex(Reader *r, const PlyElement *element)
{
    double values[ROLES] = {[COLOR] = 1, 1, 1, 1}, value;
    int count;
    for (int i = 0; i < element->property_count; i++) {
        const PlyProperty *property = &element->properties[i];
        if (property->count) {
            if (!read_list(r, property, &count))
                return false;
        } else if (!read_value(r, property->type, &value))
            return false;
        else if (property->role >= 0)
            values[property->role] = value / scale_of(property->type, property->role);
    }
    return put_vertex(r, values);
}

/* Allocates the vertices of an element; a file has one. */
static bool open_vertices(Reader *r, const PlyElement *element)
{
    Shape *shape = &r->parts->shape;
    if (shape->vertices)
        return fail(r, "it has two elements `vertex`");
    if (element->count > MODEL_VERTICES)
        return message_fail(r->error, r->capacity, "it has %lld vertices; at most %d are drawn",
                            (long long)fmin(element->count, 1e18), MODEL_VERTICES);
    if (element->count > (double)(r->end - r->at))
        return fail(r, "it has fewer bytes than vertices");
    for (int i = 0; i < element->property_count; i++)
        if (element->properties[i].role >= 0 && !element->properties[i].count)
            r->has[element->properties[i].role] = true;
    if (!r->has[0] || !r->has[1] || !r->has[2])
        return fail(r, "its vertices lack x, y or z");
    const size_t count = (size_t)element->count;
    shape->vertices = memory_checked(calloc(count + 1, sizeof *shape->vertices));
    if (r->has[COLOR] && r->has[COLOR + 1] && r->has[COLOR + 2])
        shape->extra[SHAPE_EXTRA_color] =
            memory_checked(calloc(count + 1, sizeof *shape->extra[SHAPE_EXTRA_color]));
    return model_join_open(&r->join, shape, (unsigned)count) || fail(r, "out of memory");
}

static bool add_triangle(Reader *r, const int64_t corners[3])
{
    Shape *shape = &r->parts->shape;
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        return true;
    if (shape->index_count > MODEL_INDICES - 3)
        return fail(r, "it has too many triangles");
    for (int k = 0; k < 3; k++) {
        shape->indices = model_text_grow(shape->indices, (size_t)shape->index_count,
                                         &r->index_capacity, sizeof *shape->indices);
        shape->indices[shape->index_count++] = r->join.joined[corners[k]];
    }
    return true;
}

static bool add_polygon(Reader *r, int count)
{
    polygon_reserve(&r->polygon, (size_t)count);
    for (int i = 0; i < count; i++)
        memcpy(r->polygon.points[i], r->join.shape->vertices[r->join.joined[r->list[i]]].position,
               sizeof *r->polygon.points);
    if (!polygon_split(&r->polygon, count))
        return fail(r, "faces that are not convex have too many corners");
    for (int i = 0; i + 2 < count; i++) {
        const int *from = &r->polygon.triangles[3 * i];
        if (!add_triangle(r,
                          (const int64_t[]){r->list[from[0]], r->list[from[1]], r->list[from[2]]}))
            return false;
    }
    return true;
}

/* Adds a strip, which -1 restarts; every second triangle is turned. */
static bool add_strip(Reader *r, int count)
{
    for (int i = 0, start = 0; i < count; i++) {
        if (r->list[i] < 0)
            start = i + 1;
        const int64_t *c = r->list + i;
        if (i - start < 2)
            continue;
        const int odd = (i - start) % 2;
        if (!add_triangle(r, (const int64_t[]){c[odd ? -1 : -2], c[odd ? -2 : -1], c[0]}))
            return false;
    }
    return true;
}

static bool add_list(Reader *r, bool is_strip, int count)
{
    for (int i = 0; i < count; i++)
        if (r->list[i] >= r->vertices || r->list[i] < (is_strip ? -1 : 0))
            return fail(r, "a face names a vertex that is not there");
    if (is_strip)
        return add_strip(r, count);
    return count < 3 || add_polygon(r, count);
}

static bool read_row(Reader *r, const PlyElement *element)
{
    double value;
    int count;
    for (int i = 0; i < element->property_count; i++) {
        const PlyProperty *property = &element->properties[i];
        if (!property->count) {
            if (!read_value(r, property->type, &value))
                return false;
        } else if (!read_list(r, property, &count) ||
                   (property->role == PLY_INDICES && !add_list(r, element->is_strip, count)))
            return false;
    }
    return true;
}

static bool read_elements(Reader *r)
{
    for (int e = 0; e < r->header.element_count; e++) {
        const PlyElement *element = &r->header.elements[e];
        if (element->is_vertex && !open_vertices(r, element))
            return false;
        for (double i = 0; i < element->count && element->property_count; i++)
            if (!(element->is_vertex ? read_vertex : read_row)(r, element))
                return false;
    }
    return true;
}

static bool read_text(Reader *r, size_t size)
{
    if (!ply_header_read(r->text, size, &r->header))
        return message_fail(r->error, r->capacity, "line %d: %s", r->header.line, r->header.fault);
    r->at = r->text + r->header.size;
    r->end = r->text + size;
    if (!read_elements(r))
        return false;
    const Shape *shape = &r->parts->shape;
    r->parts->runs = memory_checked(calloc(1, sizeof *r->parts->runs));
    r->parts->run_count = 1;
    *r->parts->runs = (ModelRun){.material = MODEL_NO_MATERIAL,
                                 .index_count = shape->index_count,
                                 .vertex_count = shape->vertex_count,
                                 .has_normals = r->has[3] && r->has[4] && r->has[5],
                                 .has_coordinates = r->has[6] && r->has[7]};
    return true;
}

bool ply_read(const ModelSource *source, ModelParts *parts, char *error, size_t capacity)
{
    size_t size;
    Reader r = {.parts = parts, .error = error, .capacity = capacity};
    *parts = (ModelParts){0};
    char *text = model_text_read(source, &size, error, capacity);
    r.text = text;
    const bool done = text && read_text(&r, size);
    model_join_close(&r.join);
    polygon_free(&r.polygon);
    free(r.list);
    free(text);
    return done;
}
