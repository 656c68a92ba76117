/* Plots of error against time: small panels with two logarithmic axes and the Pareto front as a
 * line, or with several lines. */
#ifndef MATC_AUTOTUNE_PLOT_H
#define MATC_AUTOTUNE_PLOT_H
#include <stdbool.h>
#include <stddef.h>

enum { PLOT_LINES = 5 };

typedef struct {
    double x, y; /* values <= 0 are drawn on the axis; NaN: not drawn */
    bool front;  /* the point is on the Pareto front: joined to the line and labeled */
    /* the point is labeled even if not on the front; a line is listed in the legend */
    bool named;
    const char *label; /* text at the point; NULL or "": no label */
    /* Line number from 1 to PLOT_LINES: points of the same number are joined in the order of x.
     * 0: no line. */
    int line;
} PlotPoint;

typedef struct {
    const char *title, *x, *y; /* title and axis labels */
    const PlotPoint *points;
    int count;
} PlotPanel;

typedef struct {
    const char *title, *note; /* `note` is the subtitle; NULL: none */
    const PlotPanel *panels;
    int count, columns; /* number of panels, and of columns in the grid */
} Plot;

/* Draws the plot as SVG that follows the reader's light or dark color scheme. Returns a string
 * from malloc. */
char *plot_svg(const Plot *plot);

/* Renders SVG to a PNG file at `scale` times its size with librsvg and cairo, which are loaded
 * at run time. Returns false with the reason in `error`. */
bool plot_png(const char *svg, double scale, const char *path, char *error, size_t capacity);
#endif
