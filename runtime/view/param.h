/* Values for a document's params, as a command line gives them. */
#ifndef MATC_VIEW_PARAM_H
#define MATC_VIEW_PARAM_H
#include "compiler/matc.h"

enum {
    PARAM_NAME = 64,
    PARAM_ROOM = 8192, /* of a message */
    PARAM_LIMIT = 64   /* that a command line gives */
};

typedef struct {
    char name[PARAM_NAME];
    int lanes; /* 1 to 4 */
    /* the first lanes are set: first for documents whose colours are linear, then for sRGB */
    float values[2][16];
} Param;

/* Reads "tint=#c04020", "gloss=0.7", "offset=[0, 1, 0]": behind the name stands what a document may
 * give as a param's default. NULL, or what is wrong, in `room`. */
const char *param_read(const char *text, Param *param, char room[PARAM_ROOM]);

/* Which of the two a document means: 1 if its own `colors:` are sRGB. */
int param_colors(MatcDocument *document);

/* The values as a uniform of that many lanes holds them: one number fills all of them, a colour of
 * three has alpha 1 in four. False: it is of another width. */
bool param_fit(Param *param, int lanes);
#endif
