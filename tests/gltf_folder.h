/* A folder of glTF files for a test, and the expected corners of their meshes. */
#ifndef TESTS_GLTF_FOLDER_H
#define TESTS_GLTF_FOLDER_H
#include "tests/scene_text.h"
#include <stdlib.h>
#include <unistd.h>

static char folder[] = "/tmp/matc_gltfXXXXXX";

static inline const char *path_of(const char *name, char path[128])
{
    snprintf(path, 128, "%s/%s", folder, name);
    return path;
}

static inline void write_file(const char *name, const void *bytes, size_t size)
{
    char path[128];
    FILE *file = fopen(path_of(name, path), "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    assert_int_equal(fclose(file), 0);
}

/* Three triangles of different materials: the second, the first, none. */
static const struct {
    float positions[9][3];
} corners = {{{0, 0, 0},
              {1, 0, 0},
              {0, 0, -1},
              {2, 0, 0},
              {3, 0, 0},
              {2, 0, -1},
              {4, 0, 0},
              {5, 0, 0},
              {4, 0, -1}}};
#endif
