/* Offsets of uniform block members: OpenGL 4.6, 7.6.2.2. */
#include "compiler/ir/std140.h"
#include <string.h>

int std140_offset(const char *type, int *size)
{
    static const struct {
        const char *name;
        int align, size;
    } rows[] = {{"int", 4, 4},    {"uint", 4, 4},  {"uvec2", 8, 8},  {"uvec4", 16, 16},
                {"float", 4, 4},  {"vec2", 8, 8},  {"vec3", 16, 12}, {"vec4", 16, 16},
                {"mat3", 16, 48}, {"mat4", 16, 64}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        size_t length = strlen(rows[i].name);
        if (strncmp(type, rows[i].name, length) != 0 || (type[length] && type[length] != ' '))
            continue;
        int offset = (*size + rows[i].align - 1) / rows[i].align * rows[i].align;
        *size = offset + rows[i].size;
        return offset;
    }
    return *size;
}

int std140_size(int end)
{
    enum { VECTOR = 16 };
    return (end + VECTOR - 1) / VECTOR * VECTOR;
}
