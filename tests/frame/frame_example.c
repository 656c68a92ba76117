#include "runtime/scene_reader/scene_read.h"
#include "tests/frame/frame_example.h"
#include "compiler/base/file.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

char *frame_example_text(const char *name)
{
    char path[256];
    size_t size;
    const char *why;
    snprintf(path, sizeof path, "examples/scenes/%s.yaml", name);
    char *text = file_read(path, &size, &why);
    if (!text) {
        fprintf(stderr, "%s: %s\n", path, why);
        abort();
    }
    return text;
}

Scene *frame_example_of(const char *name, const char *text, const FrameExample *how,
                        MatcDocument **document)
{
    char path[256];
    Scene *scene = NULL;
    snprintf(path, sizeof path, "examples/scenes/%s.yaml", name);
    *document = scene_read(path, text, strlen(text), how->options, &scene);
    if (!scene) {
        fprintf(stderr, "%s\n", matc_diagnostics(*document, MATC_TEXT));
        abort();
    }
    scene->height = scene->height * how->width / scene->width / 2 * 2;
    scene->width = how->width;
    return scene;
}

Scene *frame_example(const char *name, int width, const MatcOptions *options,
                     MatcDocument **document)
{
    char *text = frame_example_text(name);
    Scene *scene = frame_example_of(name, text, &(FrameExample){width, options}, document);
    free(text);
    return scene;
}
