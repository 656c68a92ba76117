/* libFuzzer's entry for pictures: any bytes as the file that a document names. A picture that is
 * read must have as many texels as its size states. */
#include "fuzz.h"
#include "compiler/matc.h"
#include <stdlib.h>
#include <string.h>

typedef struct {
    const uint8_t *bytes;
    size_t size;
} File;

static char *give_file(void *user, const char *path, size_t *size, const char **why)
{
    const File *file = user;
    (void)path, (void)why;
    char *copy = malloc(file->size + 1);
    if (!copy)
        abort();
    if (file->size)
        memcpy(copy, file->bytes, file->size);
    copy[file->size] = 0;
    *size = file->size;
    return copy;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    static const char text[] =
        "colors: srgb\nmaterial: Phong\ndiffuse: { map: ImageMap, image: picture }\n";
    File file = {bytes, size};
    MatcOptions options;
    matc_options_init(&options);
    options.read_file = give_file;
    options.user = &file;
    for (int pixels = 0; pixels < 2; pixels++) {
        options.pixels = pixels;
        MatcDocument *document = matc_read("fuzz.yaml", text, sizeof text - 1, &options);
        const char *fault;
        if (pixels && matc_material_count(document))
            free(matc_eval(document, 0, "u=0.99 v=0.99", &options, &fault));
        matc_document_free(document);
    }
    return 0;
}
