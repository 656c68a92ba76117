/* Documents of a Phong with every slot, and sets of slot values: plain, hostile and random ones. */
#ifndef TESTS_LAYOUT_VALUES_H
#define TESTS_LAYOUT_VALUES_H
#include "tests/value/documents.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { SETS = 16, FIRST_RANDOM = 8 };

/* Every slot of a Phong and its number of components, in the order of the document below. */
static const struct {
    const char *key;
    int components;
} params[] = {{"diffuse", 4},   {"specular", 3},
              {"shininess", 1}, {"transparency", 3},
              {"ambient", 3},   {"diffuseTransparency", 3},
              {"emissive", 3},  {"transparencyShininess", 1}};
enum { PARAMS = sizeof params / sizeof *params };

static inline double random_number(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

/* Makes a set of values: the first set plain, then hostile ones, then random ones in [0, 1],
 * with emissive up to thousands. */
static inline void make_values(uint64_t *seed, int set, double values[PARAMS][4])
{
    static const double hostile[] = {0,     1,     -1,   2,      1e6,   -1e6,     65504,
                                     65519, 65520, 1e-6, 6e-5,   1e-30, 6e-8,     0.9999,
                                     1e30,  -0.0,  0.5,  1 / 3., 255,   1.0000001};
    enum { HOSTILE = sizeof hostile / sizeof *hostile };
    for (int i = 0; i < PARAMS; i++)
        for (int component = 0; component < 4; component++) {
            double r = random_number(seed);
            bool bright = !strcmp(params[i].key, "emissive") && set % 2;
            values[i][component] =
                set >= FIRST_RANDOM ? (bright ? exp(24 * r - 12) : r) : hostile[(int)(r * HOSTILE)];
            if (set == 0)
                values[i][component] = component == 3;
            if (component == 3) /* alpha: a huge alpha would leave no digits of the transparency */
                values[i][component] = set % 2 ? r : 1;
            values[i][component] = (float)values[i][component];
        }
}

/* Which slots the document omits. */
typedef enum { ALL, OPAQUE, CLEAR, GLOW, KEPT_COUNT } Kept;

static inline bool leaves_out(Kept kept, const char *key)
{
    if (kept == OPAQUE)
        return strstr(key, "ransparency") != NULL;
    if (kept == GLOW)
        return !strcmp(key, "diffuseTransparency");
    return kept == CLEAR && (!strcmp(key, "emissive") || !strcmp(key, "ambient"));
}

static inline void write_document(char *text, size_t capacity, double values[PARAMS][4],
                                  bool uniforms, Kept kept)
{
    int size = snprintf(text, capacity, "material: Phong\n");
    for (int i = 0; i < PARAMS; i++) {
        int components =
            /* alpha makes the diffuse color transparent */
            i == 0 && kept == OPAQUE ? 3 : params[i].components;
        if (leaves_out(kept, params[i].key))
            continue;
        size += snprintf(text + size, capacity - (size_t)size,
                         uniforms ? "%s: { param: p%d, default: " : "%s: ", params[i].key, i);
        for (int component = 0; component < components; component++)
            size += snprintf(text + size, capacity - (size_t)size, "%s%.17g",
                             component                  ? ", "
                             : params[i].components > 1 ? "["
                                                        : "",
                             values[i][component]);
        size += snprintf(text + size, capacity - (size_t)size, "%s%s\n", components > 1 ? "]" : "",
                         uniforms ? " }" : "");
    }
}

/* Writes the document to a file, because documents are opened by path. */
static inline void open_values(Document *d, double values[PARAMS][4], bool uniforms, Kept kept)
{
    char path[] = "/tmp/matc-layout-XXXXXX.yaml", text[8192];
    int file = mkstemps(path, 5);
    write_document(text, sizeof text, values, uniforms, kept);
    assert_true(file >= 0 && write(file, text, strlen(text)) == (ssize_t)strlen(text));
    close(file);
    bool good = document_open(d, path);
    remove(path);
    if (!good)
        fail_msg("%s\n%s", document_fault(d), text);
}

static inline void set_values(Document *d, double values[PARAMS][4])
{
    for (int i = 0; i < d->graph->uniform_count; i++)
        document_set_uniform(d, i, values[atoi(d->graph->uniforms[i]->name + 1)]);
}
#endif
