/* Values for a document's params, parsed from the command line. */
#ifndef MATC_VIEWER_PARAM_H
#define MATC_VIEWER_PARAM_H
#include "compiler/matc.h"

enum {
    PARAM_NAME = 64,
    PARAM_CAPACITY = 8192, /* size of a message buffer */
    PARAM_LIMIT = 64       /* max count on one command line */
};

typedef struct {
    char name[PARAM_NAME];
    int components; /* 1 to 4 */
    /* [0]: for documents with linear colors, [1]: for sRGB documents; the first `components` of
     * each are set */
    float values[2][16];
} Param;

/* Parses "tint=#c04020", "gloss=0.7", "offset=[0, 1, 0]": a name, then any value that a document
 * accepts as a param's default. Returns NULL, or an error message stored in `capacity`. */
const char *param_read(const char *text, Param *param, char reason[PARAM_CAPACITY]);

/* Returns the index into Param.values for a document: 1 if the document sets `colors: srgb`,
 * else 0. */
int param_colors(MatcDocument *document);

/* Converts the values to a uniform of `components` components. A scalar fills all components; RGB
 * gets alpha 1 in a vec4. Returns false for any other size mismatch. */
bool param_fit(Param *param, int components);
#endif
