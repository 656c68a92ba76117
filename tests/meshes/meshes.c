/* Finds mesh files by name, in any format. */
#include "tests/meshes/meshes.h"
#include "runtime/mesh_import/model.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SKIPPED = 77 };

char *meshes_path(const char *name)
{
    static const char *const endings[] = {"obj", "ply"};
    const size_t capacity = strlen(MESHES_FOLDER) + strlen(name) + 8;
    char *path = malloc(capacity);
    for (size_t i = 0; path && i < sizeof endings / sizeof *endings; i++) {
        snprintf(path, capacity, "%s/%s.%s", MESHES_FOLDER, name, endings[i]);
        if (!strchr(name, '/') && !access(path, R_OK))
            return path;
    }
    free(path);
    return NULL;
}

Shape meshes_read(const char *name)
{
    char *path = meshes_path(name), error[4096] = "";
    Shape made;
    if (!path) {
        printf("SKIPPED: the mesh %s is not there: sh tests/meshes/fetch.sh with the build folder "
               "fetches it\n",
               name);
        exit(SKIPPED);
    }
    const bool fine = model_read(path, &made, error, sizeof error);
    free(path);
    if (fine)
        return made;
    fprintf(stderr, "%s\n", error);
    exit(EXIT_FAILURE);
}
