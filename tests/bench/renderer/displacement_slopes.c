/* matbench displacement, table of slopes: error of the normals on a displaced curved surface,
 * with the base normal taken as constant and with its derivatives. */
#include "displacement.h"
#include "tests/bench/matbench.h"
#include "tests/draw/curved.h"
#include "tests/value/documents.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { POINTS = 4000, TEXT = 300, PARTS = 4 };

/* Error in degrees: root mean square, and maximum. */
typedef struct {
    double mean, most;
} Off;

/* Height or vector displacement relative to the radius; with constant base normals, or tangents,
 * as the approximation. */
typedef struct {
    CurvedBody body;
    double part;
    bool vector;
} Case;

static Off off_truth(Oracle *oracle, const Node *material, const Case *c, bool stays)
{
    const double scale = c->part * curved_radius[c->body];
    Off off = {0, 0};
    for (int i = 0; i < POINTS; i++) {
        Surface surface;
        SlotValues values;
        double want[3];
        curved_surface(c->body, fmod(i * 0.61803398874989485, 1), (i + 0.5) / POINTS, &surface);
        if (c->vector)
            curved_vector_normal(c->body, scale, &surface.root[channel_id(GROUP_P, 0)], want);
        else
            curved_normal(c->body, scale, &surface.root[channel_id(GROUP_P, 0)], false, want);
        if (stays && c->vector)
            memset(surface.tangent_slopes, 0, sizeof surface.tangent_slopes);
        for (int component = 0; component < 3 && stays && !c->vector; component++)
            surface.normal_u[component] = surface.normal_v[component] = 0;
        oracle_material(oracle, material, &surface, &values);
        const double angle = curved_angle(values.component[SLOT_normal], want);
        off.mean += angle * angle / POINTS;
        off.most = fmax(off.most, angle);
    }
    off.mean = sqrt(off.mean);
    return off;
}

static bool print_row(const Case *c)
{
    static const char *const names[CURVED_COUNT] = {"ball", "torus"};
    char text[TEXT];
    Document d;
    snprintf(text, sizeof text, "material: Phong\ndisplacement%s\ndisplacementScale: %.17g\n",
             c->vector ? "Vector: " CURVED_VECTOR : ": " CURVED_HEIGHT,
             c->part * curved_radius[c->body]);
    const bool fine = document_open_text(&d, text);
    if (fine) {
        Oracle *oracle = oracle_open(d.graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
        const Off stay = off_truth(oracle, d.graph->materials[0].node, c, true),
                  turn = off_truth(oracle, d.graph->materials[0].node, c, false);
        printf("%-8s %8.2f %12.3f %8.2f %14.1e %10.1e\n", names[c->body], c->part, stay.mean,
               stay.most, turn.mean, turn.most);
        oracle_close(oracle);
    }
    document_close(&d);
    return fine;
}

static bool print_table(bool vector)
{
    bool fine = true;
    printf("%-8s %8s %21s %25s\n", "body", vector ? "x / r" : "h / r",
           vector ? "tangents do not turn" : "the base's stay", "they turn");
    for (CurvedBody body = 0; body < CURVED_COUNT; body++)
        for (int i = 0; fine && i < PARTS; i++)
            fine = print_row(&(Case){body, 0.05 * (1 << i), vector});
    return fine;
}

bool displacement_slopes(void)
{
    printf("\nnormals of curved bodies that rise and fall: degrees off the closed form, in the "
           "mean square and at most\n");
    if (!print_table(false))
        return false;
    printf("\nthe same of bodies that vectors move\n");
    return print_table(true);
}
