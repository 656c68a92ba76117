/* Plots of error against time: small panels, both axes logarithmic, the Pareto front a line, or
 * several lines. */
#ifndef MATC_MEASURE_PLOT_H
#define MATC_MEASURE_PLOT_H
#include <stdbool.h>
#include <stddef.h>

enum { PLOT_LINES = 5 };

typedef struct {
    double x, y;       /* 0 and below stand on the axis; a NaN is left out */
    bool front;        /* on the line, and labelled */
    bool named;        /* labelled even if not; of a line, in a key at the top */
    const char *label; /* NULL or "": none */
    /* 1 to PLOT_LINES: joined with those of the same line in the order of x; 0: not */
    int line;
} PlotPoint;

typedef struct {
    const char *title, *x, *y; /* y: what the axis shows */
    const PlotPoint *points;
    int count;
} PlotPanel;

typedef struct {
    const char *title, *note; /* note: a line below the title, or NULL */
    const PlotPanel *panels;
    int count, columns; /* panels, and how many stand side by side */
} Plot;

/* The plot as SVG, in light and dark colours as the reader prefers them. From malloc. */
char *plot_svg(const Plot *plot);

/* An SVG text as a PNG of `scale` times its size, by librsvg and cairo, loaded when this is called.
 * False: see `error`. */
bool plot_png(const char *svg, double scale, const char *path, char *error, size_t room);
#endif
