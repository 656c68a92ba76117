/* Documents drawn over a grid of pixels with footprints: every varying is linear over the grid,
 * so that a pixel's footprint is a parallelogram that is known exactly in floats. Also the C
 * reference's values at points within a footprint. */
#ifndef MATC_VALUE_SHEET_H
#define MATC_VALUE_SHEET_H
#include "tests/value/documents.h"
#include "draw.h"

enum { SHEET_WIDTH = GRID_WIDTH, SHEET_HEIGHT = GRID_HEIGHT, SHEET_PIXELS = POINT_COUNT };

/* The varyings at the center of the lower left pixel, and their changes to the right and to the
 * upper neighbor. */
typedef struct {
    Point at, right, up;
} ContactSheet;

/* A flat sheet: front side, the normal (0, 0, 1), tangents along x and y, all coordinates
 * constant 0. */
void sheet_init(ContactSheet *sheet);
/* Sets local position, world position and texture coordinate alike: component `component` is
 * `middle` at the center of the sheet. */
void contact_sheet_set(ContactSheet *sheet, int component, double middle, double right, double up);
/* Surface point at a pixel's center plus the given fractions of the steps to the right and upper
 * neighbor. */
void sheet_surface(const ContactSheet *sheet, int pixel, double right, double up, Surface *surface);

/* Compile options of a map, NULL for the defaults of MatcOptions, and the compiled program. */
typedef struct {
    const char *map, *slot, *target, *aa, *noise; /* the map is YAML */
    Job job;
    Document document;
    MatcProgram *program;
    Shading shading;
    Drawer *drawer;
    Material material;
    char text[1024], error[4096];
} Filtered;

/* Contexts of OpenGL 3.3 and of 2.1; the latter for glsl110. */
typedef struct {
    Drawer core, old;
} Drawers;
/* Returns NULL or an error message; close the drawers in any case. */
const char *drawers_open(Drawers *drawers);
void drawers_close(Drawers *drawers);

/* Returns false with a message in `error`. Close it in any case. */
bool filtered_open(Filtered *filtered, Drawers *drawers);
void filtered_close(Filtered *filtered);
/* Oracle of the unfiltered program, with its noise. */
Oracle *filtered_oracle(const Filtered *filtered);
/* Draws the slot's value for each pixel. */
bool filtered_draw(Filtered *filtered, const ContactSheet *sheet, float (*rgba)[4]);
#endif
