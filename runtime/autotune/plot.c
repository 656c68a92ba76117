/* Formats plots as SVG text. */
#include "runtime/autotune/plot.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    PANEL_WIDTH = 440,
    PANEL_HEIGHT = 330,
    LEFT = 62,
    RIGHT = 16,
    TOP = 34,
    BOTTOM = 48,
    HEAD = 62,
    LABELS = 256
};

/* Legend of lines, one row at the top of the panel: length of a line sample, gap, width of a
 * character, height. */
enum { KEY_SAMPLE = 14, KEY_GAP = 4, KEY_LETTER = 6, KEY_HEIGHT = 18 };

static const char style[] =
    "text{font-family:DejaVu Sans,Verdana,sans-serif;font-size:11px;fill:#333}"
    ".title{font-size:17px;font-weight:bold;fill:#111}.note{font-size:11.5px;fill:#666}"
    ".panel{font-size:12.5px;font-weight:bold;fill:#111}.tick{font-size:10px;fill:#666}"
    ".label{font-size:10px;fill:#1f4e79}.paper{fill:#ffffff}.field{fill:#f7f8fa;stroke:#c9ced6}"
    ".grid{stroke:#e1e5ea;stroke-width:1}.front{fill:none;stroke:#1f77b4;stroke-width:2;stroke-"
    "linejoin:round}"
    ".on{fill:#1f77b4;stroke:#ffffff;stroke-width:1}.off{fill:#9aa3ad;fill-opacity:0.75}"
    ".line{fill:none;stroke-width:2;stroke-linejoin:round}.line1{stroke:#8a94a0}.line2{stroke:#"
    "1f77b4}"
    ".line3{stroke:#d1600f}.line4{stroke:#2c9048}.line5{stroke:#8a56c2}"
    "@media "
    "(prefers-color-scheme:dark){text{fill:#d0d7de}.title,.panel{fill:#f0f6fc}.note,.tick{fill:#"
    "9aa4b0}"
    ".label{fill:#a5d0f5}.paper{fill:#0d1117}.field{fill:#151b23;stroke:#3d444d}.grid{stroke:#"
    "262c36}"
    ".line2{stroke:#58a6ff}.front{stroke:#58a6ff}.on{fill:#58a6ff;stroke:#0d1117}.off{fill:#6e7681}"
    "}";

typedef struct {
    double low, high; /* log10 of the limits */
} Axis;

typedef struct {
    double x, y, width, height;
} Box;

typedef struct {
    FILE *out;
    Box field; /* data area of the panel */
    Axis x, y;
    Box taken[LABELS]; /* boxes occupied by labels and points */
    int taken_count;
} Canvas;

static void put_text(FILE *out, const char *text)
{
    for (; *text; text++)
        switch (*text) {
        case '<':
            fputs("&lt;", out);
            break;
        case '>':
            fputs("&gt;", out);
            break;
        case '&':
            fputs("&amp;", out);
            break;
        default:
            fputc(*text, out);
        }
}

/* Position of a text and its SVG anchor: start, middle or end. */
typedef struct {
    double x, y;
    const char *anchor;
} TextAnchor;

static void text_at(FILE *out, const char *kind, TextAnchor at, const char *text)
{
    fprintf(out, "<text class=\"%s\" x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", kind, at.x, at.y,
            at.anchor);
    put_text(out, text);
    fputs("</text>\n", out);
}

static bool is_shown(const PlotPoint *point) { return !isnan(point->x) && !isnan(point->y); }

static bool has_lines(const PlotPanel *panel)
{
    for (int i = 0; i < panel->count; i++)
        if (panel->points[i].line)
            return true;
    return false;
}

/* Returns the nearest value of 1, 2 or 5 times a power of ten as log10: the greatest not above
 * `decade`, or the least not below. */
static double step_beside(double decade, bool above)
{
    static const double steps[] = {0, 0.30103, 0.69897, 1};
    const double whole = floor(decade);
    int i = above ? 0 : 3;
    while (above ? whole + steps[i] < decade : whole + steps[i] > decade)
        i += above ? 1 : -1;
    return whole + steps[i];
}

/* Returns the limits of an axis: whole decades around all positive values, plus a decade below
 * if values <= 0 exist. For lines: tight limits of steps 1, 2, 5, plus space for the legend. */
static Axis find_axis(const PlotPanel *panel, bool vertical)
{
    Axis axis = {INFINITY, -INFINITY};
    bool zero = false;
    for (int i = 0; i < panel->count; i++) {
        double v = vertical ? panel->points[i].y : panel->points[i].x;
        if (!is_shown(&panel->points[i]))
            continue;
        zero |= v <= 0;
        if (v <= 0 || isinf(v))
            continue;
        axis.low = fmin(axis.low, log10(v));
        axis.high = fmax(axis.high, log10(v));
    }
    if (axis.low > axis.high)
        axis = (Axis){-1, 0};
    if (vertical && !zero && has_lines(panel)) {
        const double far = axis.high - axis.low;
        return (Axis){step_beside(axis.low - 0.05, false),
                      step_beside(axis.high + 0.05 + 0.1 * far, true)};
    }
    axis.low = floor(axis.low - 0.05) - zero;
    axis.high = fmax(ceil(axis.high + 0.05), axis.low + 1);
    return axis;
}

static double axis_share(const Axis *axis, double v)
{
    double decade = v <= 0 ? axis->low : isinf(v) ? axis->high : log10(v);
    return (decade - axis->low) / (axis->high - axis->low);
}

static double pixel_x(const Canvas *c, double v)
{
    return c->field.x + c->field.width * axis_share(&c->x, v);
}
static double pixel_y(const Canvas *c, double v)
{
    return c->field.y + c->field.height * (1 - axis_share(&c->y, v));
}

static void tick_text(double decade, char text[32])
{
    if (decade >= -2 && decade < 5)
        snprintf(text, 32, "%g", pow(10, decade));
    else
        snprintf(text, 32, "%ge%g", pow(10, decade - floor(decade)), floor(decade));
}

static void draw_level(const Canvas *c, double decade)
{
    char text[32];
    const double y = pixel_y(c, pow(10, decade));
    fprintf(c->out, "<path class=\"grid\" d=\"M%.1f %.1fH%.1f\"/>\n", c->field.x, y,
            c->field.x + c->field.width);
    tick_text(decade, text);
    text_at(c->out, "tick", (TextAnchor){c->field.x - 6, y + 3.5, "end"}, text);
}

/* Draws horizontal grid lines: per decade, every second one beyond 8 decades, and 1, 2, 5 per
 * decade up to 2 decades. */
static void draw_levels(const Canvas *c)
{
    const double near = 1e-6, far = c->y.high - c->y.low;
    for (double d = far > 2 ? ceil(c->y.low - near) : c->y.low; d <= c->y.high + near;)
        draw_level(c, d), d = far > 8 ? d + 2 : far > 2 ? d + 1 : step_beside(d + near, true);
}

static void draw_ticks(const Canvas *c)
{
    char text[32];
    for (double d = c->x.low; d <= c->x.high; d++) {
        double x = pixel_x(c, pow(10, d));
        fprintf(c->out, "<path class=\"grid\" d=\"M%.1f %.1fV%.1f\"/>\n", x, c->field.y,
                c->field.y + c->field.height);
        tick_text(d, text);
        text_at(c->out, "tick", (TextAnchor){x, c->field.y + c->field.height + 14, "middle"}, text);
    }
    draw_levels(c);
}

static int by_time(const void *a, const void *b)
{
    const PlotPoint *p = a, *q = b;
    return p->x != q->x ? (p->x > q->x) - (p->x < q->x) : (p->y < q->y) - (p->y > q->y);
}

static void draw_front(const Canvas *c, const PlotPoint *sorted, int count)
{
    bool begun = false;
    fputs("<path class=\"front\" d=\"", c->out);
    for (int i = 0; i < count; i++) {
        if (!sorted[i].front || !is_shown(&sorted[i]))
            continue;
        fprintf(c->out, begun ? "H%.1fV%.1f" : "M%.1f %.1f", pixel_x(c, sorted[i].x),
                pixel_y(c, sorted[i].y));
        begun = true;
    }
    fputs(begun ? "\"/>\n" : "M0 0\"/>\n", c->out);
}

static void draw_line(const Canvas *c, const PlotPoint *sorted, int count, int line)
{
    const char *joint = "M";
    fprintf(c->out, "<path class=\"line line%d\" d=\"", line);
    for (int i = 0; i < count; i++)
        if (sorted[i].line == line && is_shown(&sorted[i])) {
            fprintf(c->out, "%s%.1f %.1f", joint, pixel_x(c, sorted[i].x), pixel_y(c, sorted[i].y));
            joint = "L";
        }
    fputs(*joint == 'L' ? "\"/>\n" : "M0 0\"/>\n", c->out);
}

static void draw_lines(const Canvas *c, const PlotPoint *sorted, int count)
{
    unsigned there = 0;
    for (int i = 0; i < count; i++)
        there |= 1u << sorted[i].line;
    for (int line = 1; line <= PLOT_LINES; line++)
        if (there >> line & 1)
            draw_line(c, sorted, count, line);
}

/* Draws the legend: a sample of each named line with its name. */
static void draw_key(const Canvas *c, const PlotPoint *points, int count)
{
    double x = c->field.x + KEY_GAP;
    for (int line = 1; line <= PLOT_LINES; line++)
        for (int i = 0; i < count; i++) {
            const PlotPoint *p = &points[i];
            if (p->line != line || !p->named || !p->label)
                continue;
            const double y = c->field.y + 0.5 * KEY_HEIGHT;
            fprintf(c->out, "<path class=\"line line%d\" d=\"M%.1f %.1fh%d\"/>\n", line, x, y,
                    KEY_SAMPLE);
            x += KEY_SAMPLE + KEY_GAP;
            text_at(c->out, "tick", (TextAnchor){x, y + 3.5, "start"}, p->label);
            x += KEY_LETTER * (double)strlen(p->label) + 2 * KEY_GAP;
            break;
        }
}

static bool is_free(const Canvas *c, const Box *box)
{
    const Box *f = &c->field;
    if (box->x < f->x || box->y < f->y || box->x + box->width > f->x + f->width ||
        box->y + box->height > f->y + f->height)
        return false;
    for (int i = 0; i < c->taken_count; i++) {
        const Box *t = &c->taken[i];
        if (box->x < t->x + t->width && t->x < box->x + box->width && box->y < t->y + t->height &&
            t->y < box->y + box->height)
            return false;
    }
    return true;
}

static void take(Canvas *c, Box box)
{
    if (c->taken_count < LABELS)
        c->taken[c->taken_count++] = box;
}

/* Draws a label near its point at the first free position, or no label if all are occupied. */
static void draw_label(Canvas *c, const PlotPoint *point)
{
    const double height = 11, gap = 7, width = 6.1 * (double)strlen(point->label);
    double x = pixel_x(c, point->x), y = pixel_y(c, point->y);
    for (int distance = 0; distance < 4; distance++)
        /* Try above and below, each to the right, to the left, and centered. */
        for (int side = 0; side < 6; side++) {
            double dx = side % 3 == 2 ? -width / 2 : side % 3 ? -gap - width : gap;
            double dy = (side < 3 ? -1 : 1) * (distance + 0.9) * height - height / 2;
            Box box = {x + dx, y + dy, width, height};
            if (!is_free(c, &box))
                continue;
            take(c, box);
            text_at(c->out, "label", (TextAnchor){box.x, box.y + height - 2, "start"},
                    point->label);
            return;
        }
}

static void draw_points(Canvas *c, const PlotPoint *sorted, int count)
{
    for (int front = 0; front < 2; front++)
        for (int i = 0; i < count; i++) {
            double x = pixel_x(c, sorted[i].x), y = pixel_y(c, sorted[i].y), r = front ? 4.5 : 3;
            if (!is_shown(&sorted[i]) || sorted[i].front != front)
                continue;
            fprintf(c->out, "<circle class=\"%s\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\">",
                    front ? "on" : "off", x, y, r);
            fputs("<title>", c->out);
            put_text(c->out, sorted[i].label ? sorted[i].label : "");
            fprintf(c->out, ": %.3g, %.3g</title></circle>\n", sorted[i].x, sorted[i].y);
            if (front || sorted[i].named)
                take(c, (Box){x - r, y - r, 2 * r, 2 * r});
        }
}

static void draw_panel(FILE *out, const PlotPanel *panel, double x, double y)
{
    Canvas *c = calloc(1, sizeof *c);
    PlotPoint *sorted = calloc((size_t)panel->count + 1, sizeof *sorted);
    if (!c || !sorted)
        abort();
    memcpy(sorted, panel->points, (size_t)panel->count * sizeof *sorted);
    qsort(sorted, (size_t)panel->count, sizeof *sorted, by_time);
    *c = (Canvas){.out = out, .x = find_axis(panel, false), .y = find_axis(panel, true)};
    c->field = (Box){x + LEFT, y + TOP, PANEL_WIDTH - LEFT - RIGHT, PANEL_HEIGHT - TOP - BOTTOM};
    fprintf(out, "<rect class=\"field\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n",
            c->field.x, c->field.y, c->field.width, c->field.height);
    draw_ticks(c);
    text_at(out, "panel", (TextAnchor){c->field.x, y + TOP - 10, "start"}, panel->title);
    text_at(out, "tick",
            (TextAnchor){c->field.x + c->field.width / 2, y + PANEL_HEIGHT - 16, "middle"},
            panel->x);
    fprintf(out,
            "<text class=\"tick\" text-anchor=\"middle\" transform=\"translate(%.1f %.1f) "
            "rotate(-90)\">",
            x + 16, c->field.y + c->field.height / 2);
    put_text(out, panel->y);
    fputs("</text>\n", out);
    draw_front(c, sorted, panel->count);
    draw_lines(c, sorted, panel->count);
    draw_points(c, sorted, panel->count);
    draw_key(c, sorted, panel->count);
    for (int i = 0; i < panel->count; i++)
        if ((sorted[i].front || (sorted[i].named && !sorted[i].line)) && is_shown(&sorted[i]) &&
            sorted[i].label && *sorted[i].label)
            draw_label(c, &sorted[i]);
    free(sorted);
    free(c);
}

char *plot_svg(const Plot *plot)
{
    char *text = NULL;
    size_t size;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        abort();
    int columns = plot->count < plot->columns ? plot->count : plot->columns;
    int rows = (plot->count + columns - 1) / (columns ? columns : 1);
    int width = columns * PANEL_WIDTH, height = HEAD + rows * PANEL_HEIGHT;
    fprintf(out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d "
            "%d\">\n"
            "<style>%s</style>\n<rect class=\"paper\" width=\"%d\" height=\"%d\"/>\n",
            width, height, width, height, style, width, height);
    text_at(out, "title", (TextAnchor){16, 30, "start"}, plot->title);
    if (plot->note)
        text_at(out, "note", (TextAnchor){16, 49, "start"}, plot->note);
    for (int i = 0; i < plot->count; i++)
        draw_panel(out, &plot->panels[i], i % columns * PANEL_WIDTH,
                   HEAD + i / columns * PANEL_HEIGHT);
    fputs("</svg>\n", out);
    fclose(out);
    return text;
}
