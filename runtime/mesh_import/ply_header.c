#include "runtime/mesh_import/ply_header.h"
#include "runtime/mesh_import/model_text.h"
#include <stdio.h>
#include <string.h>

enum { WORDS = 5, WORD = 64 };
typedef char Words[WORDS][WORD];

static const struct {
    const char *name;
    PlyType type;
} types[] = {
    {"char", PLY_char},   {"int8", PLY_char},     {"uchar", PLY_uchar},   {"uint8", PLY_uchar},
    {"short", PLY_short}, {"int16", PLY_short},   {"ushort", PLY_ushort}, {"uint16", PLY_ushort},
    {"int", PLY_int},     {"int32", PLY_int},     {"uint", PLY_uint},     {"uint32", PLY_uint},
    {"float", PLY_float}, {"float32", PLY_float}, {"double", PLY_double}, {"float64", PLY_double}};

static const struct {
    const char *name;
    int role;
} roles[] = {{"x", 0},   {"y", 1},     {"z", 2},         {"nx", 3},
             {"ny", 4},  {"nz", 5},    {"s", 6},         {"t", 7},
             {"u", 6},   {"v", 7},     {"texture_u", 6}, {"texture_v", 7},
             {"red", 8}, {"green", 9}, {"blue", 10},     {"alpha", 11}};

size_t ply_header_size(PlyType type)
{
    static const size_t sizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[type];
}

static PlyType type_of(const char *name)
{
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (!strcmp(types[i].name, name))
            return types[i].type;
    return PLY_none;
}

static int role_of(const char *name)
{
    for (size_t i = 0; i < sizeof roles / sizeof *roles; i++)
        if (!strcmp(roles[i].name, name))
            return roles[i].role;
    return PLY_NO_ROLE;
}

static bool fail(PlyHeader *header, const char *why)
{
    header->fault = why;
    return false;
}

/* Splits a line into its first words, each cut to WORD bytes, and moves behind its end. */
static int split(const char **at, const char *end, Words words)
{
    int count = 0;
    while (*at < end && **at != '\n' && **at != '\r') {
        size_t size = strcspn(*at, " \t\r\n");
        if (!size && !**at)
            size = 1; /* a zero byte */
        if (size && count < WORDS)
            snprintf(words[count++], WORD, "%.*s", (int)(size < WORD ? size : WORD - 1), *at);
        *at += size;
        *at += strspn(*at, " \t");
    }
    *at += *at < end && **at == '\r';
    *at += *at < end && **at == '\n';
    return count;
}

static bool add_element(PlyHeader *header, Words words, int count)
{
    const char *number = words[2];
    if (header->element_count == PLY_ELEMENTS)
        return fail(header, "the header has too many elements");
    PlyElement *element = &header->elements[header->element_count++];
    *element = (PlyElement){.is_vertex = !strcmp(words[1], "vertex"),
                            .is_strip = !strcmp(words[1], "tristrips")};
    return (count > 2 && model_text_number(&number, &element->count) && element->count >= 0) ||
           fail(header, "an element is expected as `element name count`");
}

static bool add_property(PlyHeader *header, Words words, int count)
{
    if (!header->element_count)
        return fail(header, "a property before the first element");
    PlyElement *element = &header->elements[header->element_count - 1];
    if (element->property_count == PLY_PROPERTIES)
        return fail(header, "an element has too many properties");
    const bool is_list = count > 1 && !strcmp(words[1], "list");
    if (count < (is_list ? 5 : 3))
        return fail(header, "a property is expected as `property type name`");
    const char *name = words[is_list ? 4 : 2];
    PlyProperty *property = &element->properties[element->property_count++];
    *property = (PlyProperty){.count = is_list ? type_of(words[2]) : PLY_none,
                              .type = type_of(words[is_list ? 3 : 1]),
                              .role = PLY_NO_ROLE};
    if (is_list && (!strcmp(name, "vertex_indices") || !strcmp(name, "vertex_index")))
        property->role = PLY_INDICES;
    else if (!is_list && element->is_vertex)
        property->role = role_of(name);
    return (property->type && (!is_list || property->count)) ||
           fail(header, "a property has an unknown type");
}

static bool set_format(PlyHeader *header, const char *name)
{
    static const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    for (int i = 0; i < 3; i++)
        if (!strcmp(names[i], name))
            return header->format = (PlyFormat)i, true;
    return fail(header, "its format is none of ascii, binary_little_endian, binary_big_endian");
}

static bool read_line(PlyHeader *header, Words words, int count)
{
    if (!strcmp(words[0], "format"))
        return set_format(header, words[1]);
    if (!strcmp(words[0], "element"))
        return add_element(header, words, count);
    if (!strcmp(words[0], "property"))
        return add_property(header, words, count);
    return !*words[0] || !strcmp(words[0], "comment") || !strcmp(words[0], "obj_info") ||
           fail(header, "the header has an unknown line");
}

bool ply_header_read(const char *text, size_t size, PlyHeader *header)
{
    const char *at = text, *end = text + size;
    *header = (PlyHeader){0};
    for (header->line = 1; at < end; header->line++) {
        Words words = {{0}};
        const int count = split(&at, end, words);
        if (header->line == 1 && strcmp(words[0], "ply") != 0)
            return fail(header, "it does not begin with `ply`");
        header->size = (size_t)(at - text);
        if (!strcmp(words[0], "end_header"))
            return true;
        if (header->line > 1 && !read_line(header, words, count))
            return false;
    }
    return fail(header, "its header has no end_header");
}
