/* Documents drawn over a grid of pixels with footprints: every varying is linear over the grid,
 * so that a pixel's footprint is a parallelogram that is known exactly in floats. Also the C
 * reference's values at points within a footprint. */
#ifndef MATC_VALUE_SHEET_H
#define MATC_VALUE_SHEET_H
#include "tests/value/documents.h"
#include "draw.h"

enum { SHEET_WIDTH = GRID_WIDTH, SHEET_HEIGHT = GRID_HEIGHT, SHEET_PIXELS = POINT_COUNT };

/* The varyings at the middle of the lower left pixel, and how they change to the right and to the
 * upper neighbour. */
typedef struct {
    Point at, right, up;
} ContactSheet;

/* Flat: front side, the normal (0, 0, 1), the tangents the x and y axes, all coordinates 0 and
 * without change. */
void sheet_init(ContactSheet *sheet);
/* Position, in the world as in the object, and texture coordinate alike: component `component` is
 * `middle` in the middle of the sheet. */
void contact_sheet_set(ContactSheet *sheet, int component, double middle, double right, double up);
/* Part of the way to the right and upper neighbour from the middle of a pixel. */
void sheet_surface(const ContactSheet *sheet, int pixel, double right, double up, Surface *surface);

/* How a map is compiled, NULL being the default of MatcOptions, and what came of it. */
typedef struct {
    const char *map, *slot, *target, *aa, *noise; /* the map as YAML */
    Job job;
    Document document;
    MatcProgram *program;
    Shading shading;
    Drawer *drawer;
    Material material;
    char text[1024], error[4096];
} Filtered;

/* Contexts for OpenGL 3.3 and for 2.1, which glsl110 is for. */
typedef struct {
    Drawer core, old;
} Drawers;
/* NULL, or what went wrong; close them in any case. */
const char *drawers_open(Drawers *drawers);
void drawers_close(Drawers *drawers);

/* False: see error. Close it in any case. */
bool filtered_open(Filtered *filtered, Drawers *drawers);
void filtered_close(Filtered *filtered);
/* Oracle of the program without --aa, with its noise. */
Oracle *filtered_oracle(const Filtered *filtered);
/* The value of the slot for each pixel. */
bool filtered_draw(Filtered *filtered, const ContactSheet *sheet, float (*rgba)[4]);
#endif
