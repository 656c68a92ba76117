#include "runtime/mesh_import/obj_parse.h"
#include "runtime/mesh_import/model_text.h"
#include <stdlib.h>
#include <string.h>

enum { MAX_NUMBERS = 7 };

/* Appends a zeroed element to one of the file's arrays. */
#define PUSH(array, count, capacity)                                                               \
    ((array) = model_text_grow(array, count, &(capacity), sizeof *(array)),                        \
     memset(&(array)[count], 0, sizeof *(array)), &(array)[(count)++])

typedef struct {
    ObjFile *file;
    const char *at, *end;
    int smoothing;
} Parser;

static bool fail(Parser *p, const char *why)
{
    p->file->fault = why;
    return false;
}

/* Skips white space within a statement, and line ends behind a backslash. */
static void skip_space(Parser *p)
{
    for (;; p->at++) {
        const size_t line_end = p->at[0] != '\\'                       ? 0
                                : p->at[1] == '\n'                     ? 1
                                : p->at[1] == '\r' && p->at[2] == '\n' ? 2
                                                                       : 0;
        if (line_end) {
            p->at += line_end;
            p->file->line++;
        } else if (!*p->at || !strchr(" \t\r\v\f", *p->at))
            return;
    }
}

static bool has_ended(Parser *p)
{
    skip_space(p);
    return p->at >= p->end || *p->at == '\n' || *p->at == '#';
}

/* Moves to the next line; a comment ends with its line. */
static void skip_line(Parser *p)
{
    while (p->at < p->end && *p->at != '\n') {
        const char first = *p->at;
        skip_space(p);
        if (first == '#')
            while (p->at < p->end && *p->at != '\n')
                p->at++;
        else if (p->at < p->end && *p->at != '\n' && *p->at != '#')
            p->at++;
    }
    p->at += p->at < p->end;
}

/* Reads the numbers of a statement, at least `least` of them. */
static bool read_numbers(Parser *p, int least, double numbers[MAX_NUMBERS], int *count)
{
    for (*count = 0; *count < MAX_NUMBERS && !has_ended(p); ++*count)
        if (!model_text_number(&p->at, &numbers[*count]))
            return fail(p, "a number is expected");
    return *count >= least || fail(p, "numbers are missing");
}

static void put(float *to, const double *from, int count)
{
    for (int i = 0; i < count; i++)
        to[i] = (float)from[i] + 0.f; /* -0 becomes 0 */
}

/* Colors begin with the first position that has one; earlier positions are white. */
static void put_color(ObjFile *file, const double *color, int components)
{
    static const double white[] = {1, 1, 1, 1};
    if (!color && !file->has_colors)
        return;
    for (size_t count = file->has_colors ? file->position_count - 1 : 0;
         count < file->position_count; count++) {
        file->colors =
            model_text_grow(file->colors, count, &file->color_capacity, sizeof *file->colors);
        put(file->colors[count], white, 4);
    }
    file->has_colors = true;
    if (color)
        put(file->colors[file->position_count - 1], color, components);
}

/* v x y z, v x y z w (a weight of curves, which is ignored), v x y z r g b, v x y z r g b a. */
static bool read_position(Parser *p)
{
    ObjFile *file = p->file;
    double numbers[MAX_NUMBERS];
    int count;
    if (!read_numbers(p, 3, numbers, &count))
        return false;
    if (file->position_count >= MODEL_VERTICES)
        return fail(p, "the file has too many positions");
    put(*PUSH(file->positions, file->position_count, file->position_capacity), numbers, 3);
    put_color(file, count >= 6 ? numbers + 3 : NULL, count - 3);
    return true;
}

static bool read_coordinates(Parser *p)
{
    ObjFile *file = p->file;
    double numbers[MAX_NUMBERS] = {0};
    int count;
    if (!read_numbers(p, 1, numbers, &count))
        return false;
    put(*PUSH(file->coordinates, file->coordinate_count, file->coordinate_capacity), numbers, 2);
    return true;
}

static bool read_normal(Parser *p)
{
    ObjFile *file = p->file;
    double numbers[MAX_NUMBERS];
    int count;
    if (!read_numbers(p, 3, numbers, &count))
        return false;
    put(*PUSH(file->normals, file->normal_count, file->normal_capacity), numbers, 3);
    return true;
}

/* Reads an index: from 1, or from the end if it is negative. */
static bool read_index(Parser *p, size_t count, int *index)
{
    int64_t number;
    if (!model_text_integer(&p->at, &number) || !number)
        return fail(p, "a face's corner is expected as v, v/vt, v//vn or v/vt/vn, from 1");
    if (number < 0 && (size_t)-number > count)
        return fail(p, "a face names a corner before the first");
    *index = (int)(number < 0 ? (int64_t)count + number : number - 1);
    return true;
}

static bool read_corner(Parser *p, ObjCorner *corner)
{
    const ObjFile *file = p->file;
    *corner = (ObjCorner){OBJ_NONE, OBJ_NONE, OBJ_NONE};
    if (!read_index(p, file->position_count, &corner->v))
        return false;
    if (*p->at != '/')
        return true;
    if (*++p->at != '/' && !has_ended(p) && (*p->at == '-' || (*p->at >= '0' && *p->at <= '9')) &&
        !read_index(p, file->coordinate_count, &corner->t))
        return false;
    return *p->at != '/' || (p->at++, read_index(p, file->normal_count, &corner->n));
}

static bool read_face(Parser *p)
{
    ObjFile *file = p->file;
    ObjFace face = {.first = file->corner_count,
                    .line = file->line,
                    .smoothing = p->smoothing,
                    .has_coordinates = true};
    for (; !has_ended(p); face.count++) {
        ObjCorner corner;
        if (!read_corner(p, &corner))
            return false;
        if (file->corner_count >= MODEL_INDICES)
            return fail(p, "the file has too many faces");
        *PUSH(file->corners, file->corner_count, file->corner_capacity) = corner;
        face.has_coordinates &= corner.t != OBJ_NONE;
    }
    *PUSH(file->faces, file->face_count, file->face_capacity) = face;
    return true;
}

static bool read_smoothing(Parser *p)
{
    int64_t number = OBJ_FLAT; /* of `s off` */
    if (!has_ended(p))
        model_text_integer(&p->at, &number);
    p->smoothing = number > 0 ? (int)number : OBJ_FLAT;
    return true;
}

static const struct {
    const char *keyword;
    bool (*read)(Parser *p);
} statements[] = {{"v", read_position}, {"vt", read_coordinates}, {"vn", read_normal},
                  {"f", read_face},     {"fo", read_face},        {"s", read_smoothing}};

static bool read_statement(Parser *p)
{
    const char *word = p->at;
    while (p->at < p->end && !strchr(" \t\r\n\v\f\\#", *p->at))
        p->at++;
    const size_t size = (size_t)(p->at - word);
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        if (strlen(statements[i].keyword) == size && !memcmp(statements[i].keyword, word, size))
            return statements[i].read(p);
    return true;
}

bool obj_parse(const char *text, size_t size, ObjFile *file)
{
    static const char mark[] = "\xEF\xBB\xBF";
    *file = (ObjFile){0};
    Parser p = {file, text, text + size, OBJ_SMOOTH};
    if (size >= 3 && !memcmp(text, mark, 3))
        p.at += 3;
    while (p.at < p.end) {
        file->line++;
        if (!has_ended(&p) && !read_statement(&p))
            return false;
        skip_line(&p);
    }
    return true;
}

void obj_parse_free(ObjFile *file)
{
    free(file->positions);
    free(file->colors);
    free(file->coordinates);
    free(file->normals);
    free(file->corners);
    free(file->faces);
}
